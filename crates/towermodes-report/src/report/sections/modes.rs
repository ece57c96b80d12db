//! The mode shapes as a picture and animated.

use towermodes::Support;

use super::super::content::ReportContent;
use super::super::document::Block;
use super::{paragraph, picture};
use crate::figures;

/// The largest number of animated modes, to limit the size of the page.
const MOST_ANIMATED: usize = 100;

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let (tower, solution) = (&content.tower, &content.solution);
    let mut animated = figures::animation_data(&content.description, tower, solution);
    let count = animated.modes.len();
    animated.modes.truncate(MOST_ANIMATED);
    let mut blocks = vec![
        paragraph(
            "Each shape is scaled to a largest deflection of 1, for torsion to a largest rotation of 1, because the amplitude of a mode is \
             arbitrary. x is fore-aft (downwind), y side-side, z up along the tower.",
        ),
        picture(
            figures::shapes(&content.description, tower, solution),
            "shapes",
        ),
    ];
    let stands_on_more = match content.description.foundation.support() {
        Support::Frame(_) | Support::Floating(_) => true,
        Support::Clamped | Support::Stiffness(_) | Support::Springs(_) | Support::Form(_) => false,
    };
    if stands_on_more {
        let whole = figures::structure(&content.description, tower, solution);
        blocks.push(picture(whole, "structure"));
    }
    blocks.push(Block::Animation(animated));
    if count > MOST_ANIMATED {
        blocks.push(paragraph(format!(
            "Only the lowest {MOST_ANIMATED} of the {count} modes are animated."
        )));
    }
    blocks
}
