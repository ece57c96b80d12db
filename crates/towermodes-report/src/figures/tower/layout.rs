//! The size of the sheet and the position of the tower on it.

use towermodes::{Tower, TowerDescription};

use super::platform::{keel_m, platform, surface_m};
use super::view::View;
use super::wires::wires_ground_m;
use super::{foundation, rna};
use crate::svg::{Axes, Frame};

/// Width of the sheet.
pub(super) const WIDTH: f64 = 900.0;
/// The sheet's height lies between these.
const HEIGHTS: [f64; 2] = [400.0, 640.0];
/// The right edge of the field.
const RIGHT: f64 = 510.0;
/// Above and below the field.
const MARGINS: [f64; 2] = [12.0, 34.0];
/// Widest tube.
const WIDEST: f64 = 120.0;
/// Numbers along the axis of heights.
pub(super) const TICKS: usize = 8;
/// Parts farther from the tower than this fraction of its height are not drawn.
const NEAR: f64 = 1.0;

/// The view of a tower on a sheet, and the height of the sheet.
pub(super) fn sheet(description: &TowerDescription, tower: &Tower) -> (View, f64) {
    let (low_m, high_m) = extent_m(description, tower);
    let above = if !tower.rna().is_absent() {
        rna::ABOVE
    } else {
        20.0
    };
    let below = foundation::below(&description.foundation);
    let around = above + below + MARGINS[0] + MARGINS[1];
    let extent_m = high_m - low_m;
    let fits = |height: f64| (height - around) / extent_m;
    let left = Axes::left_margin([low_m, high_m], false, TICKS).min(0.2 * WIDTH);
    let axis_x = 0.5 * (left + RIGHT);
    let wires = reach_m(description, tower).map_or(f64::INFINITY, |reach_m| {
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
    (View::new(tower, frame, axis_x, scale, WIDEST), height)
}

/// The lowest and the highest height in the picture, m: of the tower and of parts near it.
fn extent_m(description: &TowerDescription, tower: &Tower) -> (f64, f64) {
    let (base_m, top_m) = (tower.base_m(), tower.top_m());
    let most_m = top_m + NEAR * tower.height_m();
    let mut high_m = top_m;
    let mut include = |height_m: f64| {
        if height_m <= most_m {
            high_m = high_m.max(height_m);
        }
    };
    if let Some(water) = &description.water {
        include(water.level_m);
    }
    if !tower.rna().is_absent() {
        include(top_m + tower.rna().center_m[2] - 0.05 * tower.height_m());
    }
    let mut low_m = base_m;
    if let Some(platform) = platform(description) {
        low_m = keel_m(platform, tower);
        if let Some(surface_m) = surface_m(platform) {
            include(surface_m);
        }
    }
    (low_m, high_m)
}

/// Distance of the farthest wire anchor from the axis, m.
fn reach_m(description: &TowerDescription, tower: &Tower) -> Option<f64> {
    let ground_m = wires_ground_m(description, tower);
    let reach = description
        .wires
        .iter()
        .map(|wires| (wires.height_m - ground_m) / wires.angle_deg.to_radians().tan());
    reach.reduce(f64::max).filter(|reach_m| *reach_m > 0.0)
}
