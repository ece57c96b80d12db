//! The mode shapes, still and moving.

use super::super::content::ReportContent;
use super::super::document::Block;
use super::{paragraph, picture};
use crate::figures;

/// More modes than this do not move: a page should not be megabytes.
const MOST_MOVING: usize = 100;

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let (tower, solution) = (&content.tower, &content.solution);
    let mut moving = figures::animation_data(&content.description, tower, solution);
    let count = moving.modes.len();
    moving.modes.truncate(MOST_MOVING);
    let mut blocks = vec![
        paragraph(
            "Each shape is scaled so that its largest deflection, or for torsion its largest rotation, is 1: a natural mode has no size of \
             its own. x is fore-aft (downwind), y side-side, z up along the tower.",
        ),
        picture(
            figures::shapes(&content.description, tower, solution),
            "shapes",
        ),
        Block::Animation(moving),
    ];
    if count > MOST_MOVING {
        blocks.push(paragraph(format!(
            "Of the {count} modes the lowest {MOST_MOVING} move here."
        )));
    }
    blocks
}
