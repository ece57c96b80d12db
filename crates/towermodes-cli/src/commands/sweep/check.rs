//! Existing slices of one sweep: checks whether they contain all of its rows.

use std::ops::Range;

use towermodes_report::wording::counted;
use towermodes_sweep::Slices;

use super::arguments::SweepArguments;
use super::planned::Planned;
use crate::failure::Failure;
use crate::messages::{report, warn_texts};

/// Largest number of ranges of missing rows that the message lists.
const MOST_RANGES: usize = 10;

/// Reads all slices; a missing row is an error.
pub(super) fn run(
    planned: &Planned,
    rows: Range<u64>,
    arguments: &SweepArguments,
) -> Result<(), Failure> {
    let slices = Slices::open(&planned.sweep, &planned.source, &arguments.slices)?;
    let mut failed = 0;
    slices.each(&mut |results| failed += results.failures.len() as u64)?;
    let missing = slices.missing(rows.clone());
    if !missing.is_empty() {
        let missing = listed(&missing);
        return Err(
            Failure::failed(format!("the slices do not have the rows {missing}"))
                .hint("--rows FIRST..END with --output computes a slice of them"),
        );
    }
    let files = counted(arguments.slices.len() as u64, "slice");
    report(&format!(
        "complete: {} in {files}\n",
        counted(slices.rows(), "row")
    ));
    if failed > 0 {
        let verb = if failed == 1 { "has" } else { "have" };
        warn_texts(&[format!(
            "{failed} of {} {verb} no complete result; the column `error` states the reason",
            counted(slices.rows(), "row")
        )]);
    }
    Ok(())
}

/// "1000..2000, 5000..6000".
fn listed(missing: &[Range<u64>]) -> String {
    let ranges = missing.iter().take(MOST_RANGES);
    let ranges = ranges.map(|rows| format!("{}..{}", rows.start, rows.end));
    let more = match missing.len() > MOST_RANGES {
        true => ", …",
        false => "",
    };
    ranges.collect::<Vec<_>>().join(", ") + more
}
