//! The widths of the panels and their rows.

use towermodes::Tower;

use super::panels::{COUPLED, Panel};
use crate::svg::{Axes, text_width};

/// Width of the sheet.
pub(super) const WIDTH: f64 = 900.0;
/// Its height with one row of panels.
const HEIGHT: f64 = 560.0;
/// Height of each row if there are more.
const ROW_HEIGHT: f64 = 420.0;
/// Room below the rows.
const FOOT: f64 = 22.0;
/// Right edge of the panels.
const RIGHT: f64 = 884.0;
/// Smallest room for the numbers of the axis of heights.
const NUMBERS: f64 = 54.0;
/// Approximate number of numbers along that axis.
pub(super) const TICKS: usize = 8;
/// Width of the tower's column.
const COLUMN: f64 = 152.0;
/// Distance between panels.
const GAP: f64 = 26.0;
/// Smallest width of a panel.
const NARROWEST: f64 = 96.0;
/// Size of the text of a legend, and distance between its lines.
pub(super) const LEGEND: (f64, f64) = (11.0, 14.5);
/// Width of the sample of a line in a legend, with the space after it.
pub(super) const SAMPLE: f64 = 28.0;
/// Size of a heading.
pub(super) const HEADING: f64 = 12.0;

/// A panel with its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Placed<'a> {
    /// The panel.
    pub panel: &'a Panel,
    /// Its left and right edge.
    pub edges: [f64; 2],
    /// Number of columns of its legend.
    pub columns: usize,
}

/// A row of panels on the sheet.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Strip<'a> {
    /// The panels.
    pub panels: Vec<Placed<'a>>,
    /// Its upper and lower edge.
    pub edges: [f64; 2],
    /// The left and right edge of the tower's column.
    pub column: [f64; 2],
}

impl Strip<'_> {
    /// Number of lines of the longest legend.
    pub fn legend_lines(&self) -> usize {
        let lines = self
            .panels
            .iter()
            .map(|placed| entries(placed.panel).div_ceil(placed.columns));
        lines.max().unwrap_or(0)
    }

    /// Whether a panel has a second line of heading.
    pub fn has_notes(&self) -> bool {
        self.panels.iter().any(|placed| placed.panel.note.is_some())
    }
}

/// The left and right edge of the tower's column, right of the numbers of its axis.
pub(super) fn column(tower: &Tower) -> [f64; 2] {
    let (base_m, top_m, height_m) = (tower.base_m(), tower.top_m(), tower.height_m());
    // The axis reaches beyond the tower, how far is not known before the panels are placed.
    let ranges = [
        [base_m, top_m],
        [base_m - 0.6 * height_m, top_m + 0.2 * height_m],
    ];
    let margins = ranges.map(|heights_m| Axes::left_margin(heights_m, false, TICKS));
    let left = margins.into_iter().fold(NUMBERS, f64::max);
    [left, left + COLUMN]
}

/// The panels row by row: the smallest number of rows with room for every legend, and about the
/// same number of panels in each.
pub(super) fn rows(panels: &[Panel], column: [f64; 2]) -> Vec<&[Panel]> {
    let fits = |row: &[Panel]| {
        let needed: f64 = row.iter().map(|panel| needed_width(panel) + GAP).sum();
        row.len() == 1 || needed <= RIGHT - column[1]
    };
    if fits(panels) {
        return vec![panels];
    }
    // The panels of coupled modes belong together.
    let mut each = panels.iter();
    let coupled = each.position(|panel| panel.heading.starts_with(COUPLED));
    let parts = coupled.map(|index| panels.split_at(index));
    let parts = parts.filter(|(above, below)| !above.is_empty() && fits(above) && fits(below));
    if let Some((above, below)) = parts {
        return vec![above, below];
    }
    let mut sizes = (2..=panels.len()).map(|rows| panels.len().div_ceil(rows));
    let size = sizes.find(|size| panels.chunks(*size).all(fits));
    panels.chunks(size.unwrap_or(1)).collect()
}

/// The height of a sheet with a number of rows.
pub(super) fn sheet_height(rows: usize) -> f64 {
    match rows {
        0 | 1 => HEIGHT,
        rows => rows as f64 * ROW_HEIGHT + FOOT,
    }
}

/// The rows on a sheet; one row without panels if there are none.
pub(super) fn strips<'a>(rows: &[&'a [Panel]], height: f64, column: [f64; 2]) -> Vec<Strip<'a>> {
    let count = rows.len().max(1);
    let each = (height - FOOT) / count as f64;
    let strip = |index: usize| Strip {
        panels: rows
            .get(index)
            .map_or_else(Vec::new, |row| placed(row, column[1] + GAP)),
        edges: [each * index as f64, each * (index + 1) as f64],
        column,
    };
    (0..count).map(strip).collect()
}

/// The panels of a row with their positions: each gets the width that it needs, and all share the
/// remaining width equally.
fn placed(row: &[Panel], from: f64) -> Vec<Placed<'_>> {
    let room = RIGHT - from - GAP * row.len().saturating_sub(1) as f64;
    let needed: f64 = row.iter().map(needed_width).sum();
    let spare = (room - needed).max(0.0) / row.len().max(1) as f64;
    let mut left = from;
    let place = |panel| {
        let width = needed_width(panel) + spare;
        let edges = [left, left + width];
        left += width + GAP;
        let columns = (width / (entry_width(panel) + 10.0)).floor().max(1.0) as usize;
        Placed {
            panel,
            edges,
            columns,
        }
    };
    row.iter().map(place).collect()
}

/// Number of lines of a legend, including the line "4 more" if not all modes are drawn.
pub(super) fn entries(panel: &Panel) -> usize {
    let labels = panel.curves.iter().map(|curve| curve.labels.len());
    labels.sum::<usize>() + usize::from(panel.more > 0)
}

fn needed_width(panel: &Panel) -> f64 {
    let heading = text_width(panel.heading, HEADING, true);
    let note = panel
        .note
        .map_or(0.0, |note| text_width(note, LEGEND.0, false));
    let axis = text_width(panel.axis[1], 12.0, false);
    [heading, note, axis, entry_width(panel)]
        .into_iter()
        .fold(NARROWEST, f64::max)
}

fn entry_width(panel: &Panel) -> f64 {
    let labels = panel.curves.iter().flat_map(|curve| &curve.labels);
    let widths = labels.map(|label| text_width(label, LEGEND.0, false));
    SAMPLE + widths.fold(0.0, f64::max)
}
