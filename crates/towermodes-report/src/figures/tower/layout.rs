//! The size of the sheet and the position of the tower on it.

use super::view::View;
use super::{foundation, rna};
pub(super) use crate::figures::chart::WIDTH;
use crate::figures::parts::Parts;
use crate::svg::{Axes, Frame};

/// The smallest and the largest height of the sheet.
const HEIGHTS: [f64; 2] = [400.0, 640.0];
/// The right edge of the field.
const RIGHT: f64 = 510.0;
/// Room above and below the field.
const MARGINS: [f64; 2] = [12.0, 34.0];
/// Largest drawn width of the tube.
const WIDEST: f64 = 120.0;
/// Approximate number of numbers along the axis of heights.
pub(super) const TICKS: usize = 8;
/// Parts farther from the tower than this fraction of its height are not drawn.
const NEAR: f64 = 1.0;

/// The view of a tower on a sheet, and the height of the sheet.
pub(super) fn sheet(parts: Parts<'_>) -> (View<'_>, f64) {
    let (low_m, high_m) = extent_m(&parts);
    let above = parts.rna().map_or(20.0, |_| rna::ABOVE);
    let below = foundation::below(&parts);
    let around = above + below + MARGINS[0] + MARGINS[1];
    let extent_m = high_m - low_m;
    let fits = |height: f64| (height - around) / extent_m;
    let left = Axes::left_margin([low_m, high_m], false, TICKS).min(0.2 * WIDTH);
    let axis_x = 0.5 * (left + RIGHT);
    let wires = reach_m(&parts).map_or(f64::INFINITY, |reach_m| {
        (0.5 * (RIGHT - left) - 46.0) / reach_m
    });
    let per_m = fits(HEIGHTS[1]).min(wires.max(fits(HEIGHTS[0])));
    let per_m = if per_m.is_finite() && per_m > 0.0 {
        per_m
    } else {
        1.0
    };
    let height = (around + per_m * extent_m).clamp(HEIGHTS[0], HEIGHTS[1]);
    let frame = Frame {
        left,
        top: MARGINS[0],
        right: RIGHT,
        bottom: height - MARGINS[1],
    };
    let scale = (high_m + above / per_m, per_m);
    (View::new(parts, frame, axis_x, scale, WIDEST), height)
}

/// The lowest and the highest height in the picture, m: of the tower and of parts near it.
fn extent_m(parts: &Parts<'_>) -> (f64, f64) {
    let (description, tower) = (parts.description, parts.tower);
    let top_m = tower.top_m();
    let platform = parts.platform();
    let heights_m = [
        description.water.map(|water| water.level_m),
        parts
            .rna()
            .map(|rna| top_m + rna.center_m[2] - 0.05 * tower.height_m()),
        parts.substructure().map(|frame| frame.heights_m()[1]),
        platform.and_then(|platform| platform.surface_m()),
    ];
    let most_m = top_m + NEAR * tower.height_m();
    let near = heights_m
        .into_iter()
        .flatten()
        .filter(|height_m| *height_m <= most_m);
    let low_m = platform.map_or(parts.foot_m(), |platform| platform.keel_m());
    (low_m, near.fold(top_m, f64::max))
}

/// Distance of the farthest wire anchor from the axis, m.
fn reach_m(parts: &Parts<'_>) -> Option<f64> {
    let ground_m = parts.wires_ground_m();
    let wires = parts.description.wires.iter();
    let reach = wires.map(|wires| (wires.height_m - ground_m) / wires.angle_deg.to_radians().tan());
    reach.reduce(f64::max).filter(|reach_m| *reach_m > 0.0)
}
