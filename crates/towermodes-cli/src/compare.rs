//! `towermodes compare`.

use std::time::{Duration, Instant};

use towermodes::{Options, Tower, Workspace, solve_with};
use towermodes_analysis::study::compare_with;
use towermodes_files::{write_comparison_csv, write_result_json};

use crate::args::{CompareArguments, Format};
use crate::explained::explained;
use crate::failure::Failure;
use crate::input::tower;
use crate::messages::{note, warn};
use crate::output::{check_not_input, check_not_inputs, deliver};
use crate::progress::Progress;
use crate::side_by_side::columns_in_words;
use crate::table;

/// A column is timed for at least this time …
const TIMING: Duration = Duration::from_millis(20);
/// … and at least this number of times …
const FEWEST_TIMINGS: usize = 3;
/// … unless this time is exceeded.
const LONG: Duration = Duration::from_secs(1);

/// Reads the tower, solves it with every method and prints the results.
pub(crate) fn run(arguments: &CompareArguments) -> Result<(), Failure> {
    let output = arguments.destination.output();
    check_not_input(&arguments.input.file, output)?;
    let format = arguments.destination.format()?;
    arguments.check()?;
    let (tower, input) = tower(&arguments.input)?;
    check_not_inputs(input.files(), output)?;
    let columns = arguments.columns();
    let progress = Progress::of(columns_in_words(&columns));
    let (options, mut workspace) = (arguments.options(), progress.workspace());
    let comparison = compare_with(
        &tower,
        &options,
        &columns,
        &mut workspace,
        |column, options| {
            column.seconds_per_solve = Some(time_of(&tower, options).as_secs_f64());
            progress.done();
        },
    );
    drop((workspace, progress));
    let comparison = explained(comparison, (&tower, &input))?;
    let mut result = Vec::new();
    match format {
        Format::Table => result.extend(table::comparison(&tower, &comparison).into_bytes()),
        Format::Json => write_result_json(&comparison, &mut result)?,
        Format::Csv => write_comparison_csv(&comparison, &mut result)?,
    }
    note(&input.notes);
    warn(&comparison.warnings, &input);
    deliver(&result, output)
}

/// The time of the fastest of several solves with reused memory.
fn time_of(tower: &Tower, options: &Options) -> Duration {
    let mut workspace = Workspace::default();
    let mut fastest = Duration::MAX;
    let started = Instant::now();
    let mut timings = 0;
    while (timings < FEWEST_TIMINGS && started.elapsed() < LONG) || started.elapsed() < TIMING {
        let start = Instant::now();
        // The same solve has succeeded before.
        let _ = solve_with(tower, options, &mut workspace);
        fastest = fastest.min(start.elapsed());
        timings += 1;
    }
    fastest
}
