//! The picture of a complete sweep.

use std::fs;
use std::path::Path;

use towermodes_report::figures::{
    self, ModeColumn, SweepBand, SweepBands, SweepColumns, VariedColumn, ViolatedShare,
};
use towermodes_report::svg::Figure;
use towermodes_sweep::{MarginCheck, MarginCounts, MarginSummary, Parts, RowSource};

use super::planned::Planned;
use super::selection::Selection;
use crate::args::SweepArguments;
use crate::failure::Failure;
use crate::output::check_place;
use crate::plot::deliver_picture;

/// Of more rows a random selection is drawn.
const MOST_ROWS: u64 = 1_000_000;

/// Checks that the picture can be written, before hours are spent on its results.
pub(super) fn check(folder: &Path, arguments: &SweepArguments) -> Result<(), Failure> {
    let Some((path, _)) = arguments.picture() else {
        return Ok(());
    };
    // The picture may be in the folder of the results.
    let made = fs::create_dir_all(folder);
    made.map_err(|error| Failure::Unwritable(folder.display().to_string(), error))?;
    check_place(path)
}

/// Draws the picture.
pub(super) fn run(
    planned: &Planned,
    parts: &Parts<'_>,
    arguments: &SweepArguments,
) -> Result<(), Failure> {
    let Some(file) = arguments.picture() else {
        return Ok(());
    };
    let tower = planned.input.tower().map_err(Failure::Input)?;
    deliver_picture(figure(planned, parts)?, &tower, file)
}

fn figure(planned: &Planned, parts: &Parts<'_>) -> Result<Figure, Failure> {
    let sweep = &planned.sweep;
    let labels: Vec<String> = sweep.modes().iter().map(|mode| mode.label()).collect();
    let changes = sweep.changes();
    let selection = Selection::of(parts.rows(), MOST_ROWS);
    let mut columns = SweepColumns {
        rows: parts.rows(),
        varied: changes
            .iter()
            .map(|change| VariedColumn {
                name: change.name(),
                unit: change.unit(),
                values: Vec::new(),
            })
            .collect(),
        modes: labels
            .iter()
            .map(|label| ModeColumn {
                label,
                frequency_hz: Vec::new(),
            })
            .collect(),
        bands: SweepBands::default(),
    };
    let check = sweep.margin_check();
    let mut counts = MarginCounts::new(labels.len(), check.as_ref());
    let mut row_values = vec![0.0; changes.len()];
    for part in 0..parts.count() {
        let results = parts.read(part).map_err(Failure::Parts)?;
        counts.add(&results);
        let rows = parts.rows_of(part);
        let block = planned.source.block(rows.clone());
        let block = block.map_err(Failure::Table)?;
        for row in rows.clone().filter(|row| selection.has(*row)) {
            let in_part = row - rows.start;
            block.row(in_part, &mut row_values);
            for (column, value) in columns.varied.iter_mut().zip(&row_values) {
                column.values.push(*value);
            }
            let first = in_part as usize * columns.modes.len();
            for (index, mode) in columns.modes.iter_mut().enumerate() {
                mode.frequency_hz.push(results.frequency_hz[first + index]);
            }
        }
    }
    if let Some(check) = &check {
        columns.bands = bands(check, counts.counts(), parts.source().is_independent());
    }
    Ok(figures::sweep(&columns))
}

/// The margins of 1P and of the blade passing frequency, with the rows that violate them.
fn bands(check: &MarginCheck, counts: &[Vec<MarginSummary>], are_random: bool) -> SweepBands {
    let strong = |multiple: usize| multiple == 1 || multiple == check.rotor.blades;
    let multiples = check.multiples.iter().enumerate();
    let bands = multiples.filter(|(_, multiple)| strong(**multiple));
    let band = |(index, multiple): (usize, &usize)| {
        let violated = counts.iter().map(|of_mode| {
            let margin = of_mode[index];
            (margin.count > 0).then(|| ViolatedShare {
                share: margin.probability(),
                interval: margin.interval(),
            })
        });
        let n = *multiple as f64 / 60.0;
        SweepBand {
            multiple: *multiple,
            operation_hz: [check.rotor.lowest_rpm, check.rotor.highest_rpm].map(|rpm| n * rpm),
            margin_hz: check.range_hz(*multiple),
            violated: violated.collect(),
        }
    };
    SweepBands {
        margin: check.margin,
        are_random,
        bands: bands.map(band).collect(),
    }
}
