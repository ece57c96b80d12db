//! The tower small, in a column beside curves on the same axis of heights: its form without words.

use towermodes::{Tower, TowerDescription};

use super::view::View;
use super::{body, foundation, platform, rna, surroundings, wires};
use crate::svg::{Axes, Colour, Drawing, Frame};

/// Size of the RNA's silhouette.
const RNA_SCALE: f64 = 0.6;
/// Room above the tower without an RNA.
const ABOVE: f64 = 14.0;
/// Room below the water of a floating tower.
const BELOW_FLOATING: f64 = 36.0;
/// Water deeper below the base than this fraction of the tower's height is not shown.
const NEAR: f64 = 0.5;

/// A height that is worth a line across everything.
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
pub(in crate::figures) fn small_view(
    frame: Frame,
    (description, tower): (&TowerDescription, &Tower),
    widest: f64,
) -> View {
    let above = if !tower.rna().is_absent() {
        rna::ABOVE * RNA_SCALE
    } else {
        ABOVE
    };
    let platform = platform::platform(description);
    let below = match platform {
        Some(_) => BELOW_FLOATING,
        None => foundation::below(&description.foundation),
    };
    let sea_m = platform.and_then(platform::surface_m);
    let depth_m = sea_m.map_or(0.0, |sea_m| tower.base_m() - sea_m);
    let is_near = (0.0..=NEAR * tower.height_m()).contains(&depth_m);
    let extent_m = tower.height_m() + if is_near { depth_m } else { 0.0 };
    let per_m = (frame.bottom - frame.top - above - below) / extent_m;
    let per_m = if per_m.is_finite() && per_m > 0.0 {
        per_m
    } else {
        1.0
    };
    let axis_x = 0.5 * (frame.left + frame.right);
    let scale = (tower.top_m() + above / per_m, per_m);
    View::new(tower, frame, axis_x, scale, widest)
}

/// The surface of the water and the ground, as far as there are any.
pub(in crate::figures) fn levels(description: &TowerDescription, tower: &Tower) -> Vec<Level> {
    let water = surroundings::water_m(description).map(|height_m| Level {
        height_m,
        name: "water",
        colour: Colour::Series(0),
    });
    let ground = surroundings::ground_m(description, tower).map(|height_m| Level {
        height_m,
        name: "ground",
        colour: Colour::Muted,
    });
    water.into_iter().chain(ground).collect()
}

/// Draws the tower in the column of a view, with its axis of heights; `name` is no other clip's of
/// the sheet.
pub(in crate::figures) fn draw_small(
    drawing: &mut Drawing,
    view: &View,
    (description, tower): (&TowerDescription, &Tower),
    (name, ticks): (&str, usize),
) {
    let frame = view.frame;
    let size = (frame.right - frame.left, frame.bottom - frame.top);
    surroundings::draw_water_and_ground(drawing, view, description, tower);
    platform::draw_sea(drawing, view, description);
    let heights_m = [view.low_m(), view.high_m];
    let axes = Axes::new(frame, [0.0, 1.0], heights_m, [false, false]);
    axes.draw_y(drawing, "height z (m)", ticks);
    drawing.clipped(name, (frame.left, frame.top), size, |drawing| {
        wires::draw_wires(drawing, view, description, tower);
        if let Some(platform) = platform::platform(description) {
            platform::draw_hull(drawing, view, tower, platform);
        }
        foundation::draw_foundation(drawing, view, tower, &description.foundation);
    });
    let water = description.water.filter(|water| water.flooded);
    body::draw_body(drawing, view, tower, water.map(|water| water.level_m));
    body::draw_masses(drawing, view, description);
    rna::draw_rna(drawing, view, tower, RNA_SCALE);
}
