//! `towermodes converge`.

use towermodes_analysis::study::{Fineness, converge_with};
use towermodes_files::{write_convergence_csv, write_result_json};

use crate::args::{ConvergeArguments, Format};
use crate::explained::explained;
use crate::failure::Failure;
use crate::input::tower;
use crate::messages::{note, warn};
use crate::output::{check_not_input, check_not_inputs, deliver};
use crate::progress::Progress;
use crate::{table, terminal};

/// Reads the tower, solves it on finer and finer meshes and prints the errors.
pub(crate) fn run(arguments: &ConvergeArguments) -> Result<(), Failure> {
    let fineness = arguments.fineness()?;
    let output = arguments.destination.output();
    check_not_input(&arguments.input.file, output)?;
    let format = arguments.destination.format()?;
    let (tower, input) = tower(&arguments.input)?;
    check_not_inputs(input.files(), output)?;
    let progress = Progress::of_weighted(fineness.iter().copied().map(said));
    let (options, mut workspace) = (arguments.options(), progress.workspace());
    let done = converge_with(&tower, &options, &fineness, &mut workspace, |_| {
        progress.done();
    });
    drop((workspace, progress));
    let convergence = explained(done, (&tower, &input))?;
    let width = match output {
        None => terminal::width(),
        Some(_) => terminal::WIDTH_OF_FILES,
    };
    let mut result = Vec::new();
    match format {
        Format::Table => {
            result.extend(table::convergence(&tower, &convergence, width).into_bytes());
        }
        Format::Json => write_result_json(&convergence, &mut result)?,
        Format::Csv => write_convergence_csv(&convergence, &mut result)?,
    }
    note(&input.notes);
    warn(&convergence.warnings, &input);
    deliver(&result, output)
}

/// The label of a level, "80 segments", and its relative cost.
fn said(fineness: Fineness) -> (String, f64) {
    let text = match fineness {
        Fineness::Segments(segments) => format!("{segments} segments"),
        Fineness::Degree(degree) => format!("degree {degree}"),
    };
    (text, fineness.number() as f64)
}
