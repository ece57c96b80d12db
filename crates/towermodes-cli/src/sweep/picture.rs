//! The picture of a complete sweep.

use std::path::Path;

use towermodes_report::figures::{self, ModeColumn, SweepColumns, TitleWords, VariedColumn};
use towermodes_report::raster;
use towermodes_report::svg::{Figure, Look, Theme};
use towermodes_sweep::{Parts, RowSource};

use super::memory::Values;
use super::planned::Planned;
use crate::args::SweepArguments;
use crate::failure::Failure;
use crate::output::deliver_bytes;

/// Of more rows every second, third, … is drawn.
const MOST_ROWS: u64 = 1_000_000;

/// Draws the picture.
pub(super) fn run(
    planned: &Planned,
    parts: &Parts<'_>,
    arguments: &SweepArguments,
) -> Result<(), Failure> {
    let Some(path) = &arguments.plot else {
        return Ok(());
    };
    let figure = figure(planned, parts)?;
    deliver_bytes(&drawn(&figure, path)?, Some(path))
}

fn figure(planned: &Planned, parts: &Parts<'_>) -> Result<Figure, Failure> {
    let sweep = &planned.sweep;
    let labels: Vec<String> = sweep.modes().iter().map(|mode| mode.label()).collect();
    let changes = sweep.changes();
    let mut columns = SweepColumns {
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
    };
    let values = Values::of(&planned.source, changes.len())?;
    let step = parts.rows().div_ceil(MOST_ROWS).max(1);
    let mut row_values = vec![0.0; changes.len()];
    for part in 0..parts.count() {
        let results = parts.read(part).map_err(Failure::Parts)?;
        let rows = parts.rows_of(part);
        for row in rows.clone().filter(|row| row % step == 0) {
            values.row(row, &mut row_values);
            for (column, value) in columns.varied.iter_mut().zip(&row_values) {
                column.values.push(*value);
            }
            let first = (row - rows.start) as usize * columns.modes.len();
            for (index, mode) in columns.modes.iter_mut().enumerate() {
                mode.frequency_hz.push(results.frequency_hz[first + index]);
            }
        }
    }
    let tower = planned.input.tower().map_err(Failure::Input)?;
    let words = TitleWords {
        title: None,
        computed: None,
        conclusion: &[],
    };
    Ok(figures::titled(figures::sweep(&columns), &tower, &words))
}

fn drawn(figure: &Figure, path: &Path) -> Result<Vec<u8>, Failure> {
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    match ending.to_str() {
        Some("svg") => Ok(figure.to_svg(Look::Standalone).into_bytes()),
        Some("png") => raster::png(figure, Theme::Light, 2.0).map_err(Failure::Picture),
        _ => Err(Failure::Usage(
            "unknown file extension for a picture; use --plot FILE.svg or FILE.png",
        )),
    }
}
