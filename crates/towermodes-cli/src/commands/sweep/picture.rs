//! The picture of a sweep.

use towermodes_report::figures::{
    self, ModeColumn, SweepBand, SweepBands, SweepColumns, VariedColumn, ViolatedShare,
};
use towermodes_report::svg::Figure;
use towermodes_sweep::{
    MarginCheck, MarginCounts, MarginSummary, Results, RowSource, Slices, TableError,
};

use super::super::plot::deliver_picture;
use super::arguments::SweepArguments;
use super::planned::Planned;
use super::selection::Selection;
use crate::failure::Failure;
use crate::output::check_place;

/// If there are more rows, a random selection is drawn.
const MOST_ROWS: u64 = 1_000_000;

/// Checks that the picture can be written, before hours are spent on the results.
pub(super) fn check(arguments: &SweepArguments) -> Result<(), Failure> {
    match arguments.picture() {
        Some((path, _)) => check_place(path),
        None => Ok(()),
    }
}

/// Draws the picture.
pub(super) fn run(
    planned: &Planned,
    slices: &Slices<'_>,
    arguments: &SweepArguments,
) -> Result<(), Failure> {
    let Some(file) = arguments.picture() else {
        return Ok(());
    };
    let tower = planned.input.tower()?;
    deliver_picture(figure(planned, slices)?, &tower, file)
}

fn figure(planned: &Planned, slices: &Slices<'_>) -> Result<Figure, Failure> {
    let sweep = &planned.sweep;
    let labels: Vec<String> = sweep.modes().iter().map(|mode| mode.label()).collect();
    let varied = sweep.changes().iter().map(|change| VariedColumn {
        name: change.name(),
        unit: change.unit(),
        values: Vec::new(),
    });
    let modes = labels.iter().map(|label| ModeColumn {
        label,
        frequency_hz: Vec::new(),
    });
    let mut columns = SweepColumns {
        rows: slices.rows(),
        varied: varied.collect(),
        modes: modes.collect(),
        bands: SweepBands::default(),
    };
    let selection = Selection::of(slices.rows(), MOST_ROWS);
    let check = sweep.margin_check();
    let mut counts = MarginCounts::new(labels.len(), check.as_ref());
    let mut added = Ok(());
    let read = slices.each(&mut |results| {
        counts.add(&results);
        if added.is_ok() {
            added = add(&mut columns, slices, &results, selection);
        }
    });
    read?;
    added?;
    if let Some(check) = &check {
        columns.bands = bands(check, counts.counts(), slices.source().is_independent());
    }
    Ok(figures::sweep(&columns))
}

/// Adds the selected rows of some results, with the values of these rows.
fn add(
    columns: &mut SweepColumns<'_>,
    slices: &Slices<'_>,
    results: &Results,
    selection: Selection,
) -> Result<(), TableError> {
    let rows = results.first_row..results.first_row + results.rows() as u64;
    let block = slices.source().block(rows.clone())?;
    let mut values = vec![0.0; columns.varied.len()];
    for (place, _) in rows.enumerate().filter(|(_, row)| selection.has(*row)) {
        block.row(place as u64, &mut values);
        for (column, value) in columns.varied.iter_mut().zip(&values) {
            column.values.push(*value);
        }
        let first = place * columns.modes.len();
        for (index, mode) in columns.modes.iter_mut().enumerate() {
            mode.frequency_hz.push(results.frequency_hz[first + index]);
        }
    }
    Ok(())
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
