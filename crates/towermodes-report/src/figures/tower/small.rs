//! The tower in a narrow column beside curves with the same axis of heights, without texts.

use super::view::View;
use super::{body, foundation, platform, rna, substructure, surroundings, wires};
use crate::figures::parts::Parts;
use crate::svg::{Colour, Drawing, Frame};

/// Size of the RNA's silhouette.
const RNA_SCALE: f64 = 0.6;
/// Room above the tower without an RNA.
const ABOVE: f64 = 14.0;
/// Room below the water of a floating tower.
const BELOW_FLOATING: f64 = 36.0;
/// Water deeper below the base than this fraction of the tower's height is not shown.
const NEAR: f64 = 0.5;
/// A substructure is shown down to this multiple of the tower's height below the base.
const FRAME: f64 = 2.0;

/// A height at which a line is drawn across all panels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::figures) struct Level {
    /// The height, m.
    pub height_m: f64,
    /// Its name.
    pub name: &'static str,
    /// Its colour.
    pub colour: Colour,
}

/// A view of the small tower in a column: from below its base to its RNA; the widest tube has at
/// most `widest` pixels.
pub(in crate::figures) fn small_view(frame: Frame, parts: Parts<'_>, widest: f64) -> View<'_> {
    let tower = parts.tower;
    let above = parts.rna().map_or(ABOVE, |_| rna::ABOVE * RNA_SCALE);
    let platform = parts.platform();
    let below = platform.map_or_else(|| foundation::below(&parts), |_| BELOW_FLOATING);
    let sea_m = platform.and_then(|platform| platform.surface_m());
    let depth_m = sea_m.map_or(0.0, |sea_m| tower.base_m() - sea_m);
    let is_near = (0.0..=NEAR * tower.height_m()).contains(&depth_m);
    let frame_m = tower.base_m() - parts.foot_m();
    let reach_m = if is_near { depth_m } else { 0.0 };
    let extent_m = tower.height_m() + frame_m.max(reach_m).min(FRAME * tower.height_m());
    let per_m = (frame.bottom - frame.top - above - below) / extent_m;
    let per_m = if per_m.is_finite() && per_m > 0.0 {
        per_m
    } else {
        1.0
    };
    let axis_x = 0.5 * (frame.left + frame.right);
    let scale = (tower.top_m() + above / per_m, per_m);
    View::new(parts, frame, axis_x, scale, widest)
}

/// The levels of water surface and ground, if they exist.
pub(in crate::figures) fn levels(parts: &Parts<'_>) -> impl Iterator<Item = Level> {
    let levels = [
        (parts.water_m(), "water", Colour::Series(0)),
        (parts.ground_m(), "ground", Colour::Muted),
    ];
    let level = |(height_m, name, colour): (Option<f64>, &'static str, Colour)| {
        height_m.map(|height_m| Level {
            height_m,
            name,
            colour,
        })
    };
    levels.into_iter().filter_map(level)
}

/// Draws the tower in the column of a view, with its axis of heights; `name` must be unique among
/// the clips of the sheet.
pub(in crate::figures) fn draw_small(
    drawing: &mut Drawing,
    view: &View<'_>,
    (name, ticks): (&str, usize),
) {
    surroundings::draw_water_and_ground(drawing, view);
    platform::draw_sea(drawing, view);
    view.draw_heights(drawing, ticks);
    drawing.clipped(name, view.frame.left_top(), view.frame.size(), |drawing| {
        wires::draw_wires(drawing, view);
        platform::draw_hull(drawing, view);
        foundation::draw_foundation(drawing, view);
        substructure::draw_members(drawing, view);
        substructure::draw_links(drawing, view, 1.2);
    });
    body::draw_body(drawing, view);
    body::draw_masses(drawing, view);
    rna::draw_rna(drawing, view, RNA_SCALE);
}
