//! `towermodes converge`.

use towermodes::study::{Fineness, converge_with};
use towermodes_files::{write_convergence_csv, write_convergence_json};

use crate::args::{ConvergeArguments, Format};
use crate::failure::{Failure, note, warn};
use crate::input::tower;
use crate::output::{check_not_input, deliver};
use crate::progress::Progress;
use crate::table;

/// Reads the tower, solves it more and more finely, prints the errors.
pub(crate) fn run(arguments: &ConvergeArguments) -> Result<(), Failure> {
    let fineness = arguments.fineness().map_err(Failure::Usage)?;
    let output = arguments.destination.output();
    check_not_input(&arguments.input.file, output)?;
    let format = arguments.destination.format().map_err(Failure::Ending)?;
    let (tower, notes) = tower(&arguments.input)?;
    let progress = Progress::of_weighted(fineness.iter().copied().map(said));
    let (options, mut workspace) = (arguments.options(), progress.workspace());
    let done = converge_with(&tower, &options, &fineness, &mut workspace, |_| {
        progress.done()
    });
    drop((workspace, progress));
    let convergence = done.map_err(Failure::Unsolved)?;
    let mut result = Vec::new();
    match format {
        Format::Table => result.extend(table::convergence(&tower, &convergence).into_bytes()),
        Format::Json => write_convergence_json(&convergence, &mut result)?,
        Format::Csv => write_convergence_csv(&convergence, &mut result)?,
    }
    note(&notes);
    warn(&convergence.warnings);
    deliver(&result, output)
}

/// "80 segments", and how long these take beside others.
fn said(fineness: Fineness) -> (String, f64) {
    let text = match fineness {
        Fineness::Segments(segments) => format!("{segments} segments"),
        Fineness::Degree(degree) => format!("degree {degree}"),
    };
    (text, fineness.number() as f64)
}
