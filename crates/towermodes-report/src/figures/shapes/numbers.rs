//! The figure of the mode shapes as text and as a table.

use towermodes::{Mode, ShapePoint, Solution, Tower};

use super::curves::{Part, coupled_parts};
use crate::number::{four_digits, length, short};
use crate::svg::DataTable;

/// The number of heights in the table.
const HEIGHTS: usize = 11;
/// The largest number of modes in the description.
const MOST_MODES: usize = 6;

/// The figure as text.
pub(super) fn description(tower: &Tower, solution: &Solution) -> String {
    let modes = &solution.modes;
    let named = modes.iter().take(MOST_MODES);
    let named: Vec<String> = named
        .map(|mode| format!("{} at {} Hz", mode.label(), four_digits(mode.frequency_hz)))
        .collect();
    let more = match modes.len().saturating_sub(MOST_MODES) {
        0 => String::new(),
        more => format!(", and {more} more"),
    };
    format!(
        "Mode shapes of the tower from z = {} m to z = {} m, each normalised to its maximum: {}{more}.",
        length(tower.base_m()),
        length(tower.top_m()),
        if named.is_empty() {
            "none".to_owned()
        } else {
            named.join(", ")
        }
    )
}

/// Every mode's curve at a few heights.
pub(super) fn table(solution: &Solution) -> DataTable {
    let points = solution.modes.first().map_or(0, |mode| mode.shape.len());
    let chosen = chosen(points);
    let mut header = vec![
        "mode".to_owned(),
        "frequency (Hz)".to_owned(),
        "motion".to_owned(),
    ];
    if let Some(first) = solution.modes.first() {
        let heights = chosen.iter().filter_map(|index| first.shape.get(*index));
        header.extend(heights.map(|point| format!("z = {} m", length(point.height_m))));
    }
    DataTable {
        header,
        rows: solution
            .modes
            .iter()
            .flat_map(|mode| rows(mode, &chosen))
            .collect(),
    }
}

fn rows(mode: &Mode, chosen: &[usize]) -> Vec<Vec<String>> {
    let parts = match mode.is_coupled() {
        true => coupled_parts(mode),
        false => vec![Part::main(mode.family)],
    };
    let row = |part: &Part| {
        // Values far below the largest, 1, are zero; a rotation per metre has no such scale.
        let is_share = *part == Part::main(mode.family) || *part != Part::RotationZ;
        let cell = |point: &ShapePoint| match part.of(point) {
            value if is_share && value.abs() < 5e-4 => short(0.0, 3),
            value => short(value, 3),
        };
        let points = chosen.iter().map(|index| mode.shape.get(*index));
        let first = [
            mode.label(),
            four_digits(mode.frequency_hz),
            part.name().to_owned(),
        ];
        first
            .into_iter()
            .chain(points.map(|point| point.map_or_else(String::new, cell)))
            .collect()
    };
    parts.iter().map(row).collect()
}

/// The indices of at most [`HEIGHTS`] of `count` points at about equal distances, including the
/// first and the last.
fn chosen(points: usize) -> Vec<usize> {
    if points <= HEIGHTS {
        return (0..points).collect();
    }
    (0..HEIGHTS)
        .map(|k| k * (points - 1) / (HEIGHTS - 1))
        .collect()
}
