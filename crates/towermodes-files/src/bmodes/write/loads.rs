//! The loads along a tower as tables of a deck: mass of water, and springs of soil.

use std::ops::Range;

use towermodes::Tower;
use towermodes::number::Rounded;
use towermodes::tower::Piece;

use super::base::Hub;
use super::error::BmodesWriteError;
use super::layout::Layout;
use super::number::rounded;
use super::section::section_of;
use super::sections::STEP;
use crate::note::Note;

/// Between rows the linear interpolation may differ from the mass of the water by this fraction of
/// the largest mass.
const OFF: f64 = 1e-5;
/// Springs in x and y may differ by this fraction.
const ROUND: f64 = 1e-6;
/// Shorter parts of the length are not divided.
const SHORTEST: f64 = 1e-5;

/// The tables, each with rows of height above the base (m) and value, and the springs that have no
/// table.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Loads {
    /// Added mass, kg/m.
    pub(super) added_mass: Vec<(f64, f64)>,
    /// Stiffness, N/m².
    pub(super) stiffness: Vec<(f64, f64)>,
    /// The sum of the vertical springs along the tower, N/m, if the base can move vertically;
    /// otherwise zero.
    pub(super) vertical_n_per_m: f64,
    /// The sum of the torsional springs along the tower, N m, if the base can rotate about z;
    /// otherwise zero.
    pub(super) torsion_n_m: f64,
}

pub(super) fn loads(
    tower: &Tower,
    layout: &Layout,
    hub: Hub,
    notes: &mut Vec<Note>,
) -> Result<Loads, BmodesWriteError> {
    check_round(tower, layout)?;
    notes.extend(rotation_note(tower));
    let (vertical_n_per_m, torsion_n_m) = axial_springs(tower, layout);
    let mut loads = Loads {
        added_mass: table(tower, layout, |piece, height_m, _| {
            section_of(piece, height_m).masses.water_kg_per_m
        }),
        stiffness: table(tower, layout, |piece, height_m, middle_m| {
            let spread = layout.spread_at(middle_m).horizontal_n_per_m2;
            section_of(piece, height_m).soil.x_n_per_m2 + spread
        }),
        ..Loads::default()
    };
    if vertical_n_per_m == 0.0 && torsion_n_m == 0.0 {
        return Ok(loads);
    }
    let is_free = hub == Hub::Free;
    if is_free {
        (loads.vertical_n_per_m, loads.torsion_n_m) = (vertical_n_per_m, torsion_n_m);
    }
    notes.push(axial_note(vertical_n_per_m, torsion_n_m, is_free));
    Ok(loads)
}

/// The note on springs against rotation along a tower.
fn rotation_note(tower: &Tower) -> Option<Note> {
    let ends = tower
        .pieces()
        .iter()
        .filter_map(|piece| piece.environment.soil);
    let springs = ends
        .flatten()
        .flat_map(|soil| [soil.rotation_x_n, soil.rotation_y_n]);
    let largest_n = springs.fold(0.0, f64::max);
    (largest_n > 0.0).then(|| {
        Note::left_out(format!(
            "BModes has no springs against rotation along a tower: the rotational springs of the soil, up to {} N m per radian and metre, are left out",
            Rounded(largest_n)
        ))
    })
}

/// The note on vertical and torsional springs along a tower, which become springs of a free base.
fn axial_note(vertical_n_per_m: f64, torsion_n_m: f64, is_free: bool) -> Note {
    let what = format!(
        "BModes has no vertical and no torsional springs along a tower: their sums, {} N/m and {} N m,",
        Rounded(vertical_n_per_m),
        Rounded(torsion_n_m)
    );
    match is_free {
        true => Note::approximation(format!("{what} are written as springs of the base")),
        false => Note::left_out(format!("{what} are left out")),
    }
}

fn check_round(tower: &Tower, layout: &Layout) -> Result<(), BmodesWriteError> {
    for (from_m, to_m) in layout.intervals_m() {
        let piece = tower.piece_at(0.5 * (from_m + to_m));
        for height_m in [from_m, to_m] {
            let soil = section_of(piece, height_m).soil;
            let (x, y) = (soil.x_n_per_m2, soil.y_n_per_m2);
            if (x - y).abs() > ROUND * x.max(y) {
                return Err(BmodesWriteError::UnequalSoil {
                    height_m,
                    x_n_per_m2: x,
                    y_n_per_m2: y,
                });
            }
        }
    }
    Ok(())
}

/// The sums of vertical and of torsional springs; soil springs are linear between cuts.
fn axial_springs(tower: &Tower, layout: &Layout) -> (f64, f64) {
    let mut sum = (0.0, 0.0);
    for (from_m, to_m) in layout.intervals_m() {
        let piece = tower.piece_at(0.5 * (from_m + to_m));
        let ends = [from_m, to_m].map(|height_m| section_of(piece, height_m).soil);
        let mean = 0.5 * (to_m - from_m);
        sum.0 += mean * (ends[0].z_n_per_m2 + ends[1].z_n_per_m2);
        sum.1 += mean * (ends[0].torsion_n + ends[1].torsion_n);
    }
    sum.0 += layout
        .attached
        .spreads
        .iter()
        .map(|s| s.vertical_n_per_m)
        .sum::<f64>();
    sum
}

/// The rows of a quantity from the lowest to the highest cut where it is not zero; `value` gives it
/// at a height of a piece, at a cut on the side of a given middle.
fn table(
    tower: &Tower,
    layout: &Layout,
    value: impl Fn(&Piece, f64, f64) -> f64,
) -> Vec<(f64, f64)> {
    let between = |(from_m, to_m): (f64, f64)| {
        let middle_m = 0.5 * (from_m + to_m);
        let piece = tower.piece_at(middle_m);
        let at = |height_m: f64| (height_m, value(piece, height_m, middle_m));
        [at(from_m), at(middle_m), at(to_m)]
    };
    let parts: Vec<_> = layout.intervals_m().map(between).collect();
    let values = parts.iter().flatten().map(|row| row.1);
    let largest = values.fold(0.0_f64, f64::max);
    let fine = (SHORTEST * layout.length_m(), OFF * largest);
    let mut rows: Vec<(f64, f64)> = Vec::new();
    for [low, middle, high] in &parts[used(&parts)] {
        let piece = tower.piece_at(middle.0);
        match rows.last() {
            Some(before) if before.1 == low.1 => {}
            Some(_) => rows.push((low.0 + STEP * layout.length_m(), low.1)),
            None => rows.push(*low),
        }
        let at = |height_m: f64| value(piece, height_m, middle.0);
        divide(*low, *high, fine, &at, &mut rows);
        rows.push(*high);
    }
    let row = |(height_m, value)| (above_base(layout, height_m), rounded(value));
    rows.into_iter().map(row).collect()
}

/// The range from the first to the last part that is not zero everywhere.
fn used(parts: &[[(f64, f64); 3]]) -> Range<usize> {
    let is_used = |part: &[(f64, f64); 3]| part.iter().any(|row| row.1 != 0.0);
    let first = parts.iter().position(is_used);
    let last = parts.iter().rposition(is_used);
    first
        .zip(last)
        .map_or(0..0, |(first, last)| first..last + 1)
}

/// Adds the rows between two rows that linear interpolation needs, down to a negligible length or
/// difference.
fn divide(
    low: (f64, f64),
    high: (f64, f64),
    fine: (f64, f64),
    at: &impl Fn(f64) -> f64,
    rows: &mut Vec<(f64, f64)>,
) {
    let middle_m = 0.5 * (low.0 + high.0);
    let middle = (middle_m, at(middle_m));
    let is_straight = (0.5 * (low.1 + high.1) - middle.1).abs() <= fine.1;
    if high.0 - low.0 < fine.0 || is_straight {
        return;
    }
    divide(low, middle, fine, at, rows);
    rows.push(middle);
    divide(middle, high, fine, at, rows);
}

/// A height above the base, m, never above the top, not even by rounding.
fn above_base(layout: &Layout, height_m: f64) -> f64 {
    let above_m = rounded(height_m - layout.base_m);
    let candidates = [above_m, height_m - layout.base_m];
    let is_inside = |above_m: &f64| layout.base_m + above_m <= layout.top_m;
    let inside = candidates.into_iter().find(is_inside);
    inside.unwrap_or((height_m - layout.base_m).next_down())
}
