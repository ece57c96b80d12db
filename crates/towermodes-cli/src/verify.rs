//! `towermodes verify`.

use towermodes_files::{write_records_csv, write_result_json};
use towermodes_verify::{Row, Verification, manual, markdown};

use crate::args::{VerifyArguments, VerifyFormat};
use crate::failure::Failure;
use crate::output::deliver;
use crate::progress::Progress;
use crate::table;

/// Runs the verification manual and prints it; an error if a value is outside its tolerance.
pub(crate) fn run(arguments: &VerifyArguments) -> Result<(), Failure> {
    let format = arguments.format()?;
    let mut cases = manual();
    cases.retain(|case| arguments.has(case.chapter.name));
    let progress = Progress::of(cases.iter().map(|case| case.name.to_string()));
    let mut rows: Vec<Row> = Vec::new();
    for case in cases {
        rows.extend(case.run());
        progress.done();
    }
    drop(progress);
    let verification = Verification::of(rows);
    let rows = &verification.rows;
    let mut result = Vec::new();
    match format {
        VerifyFormat::Table => result.extend(table::verification(rows).into_bytes()),
        VerifyFormat::Json => write_result_json(&verification, &mut result)?,
        VerifyFormat::Csv => {
            write_records_csv(Row::COLUMNS, rows.iter().map(Row::record), &mut result)?;
        }
        VerifyFormat::Markdown => result.extend(markdown(rows).into_bytes()),
    }
    deliver(&result, arguments.output())?;
    match verification.failures {
        0 => Ok(()),
        failures => Err(Failure::failed(format!(
            "{failures} of {} values are outside their tolerance",
            verification.values
        ))
        .hint("see the lines with FAIL above")),
    }
}
