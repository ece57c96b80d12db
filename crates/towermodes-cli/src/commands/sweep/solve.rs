//! Solves rows and writes them as one slice.

use std::ops::{ControlFlow, Range};

use towermodes_report::wording::counted;
use towermodes_sweep::{RowRemarks, Slice, SliceError, SliceFormat, Solved};

use super::arguments::SweepArguments;
use super::planned::Planned;
use super::progress::SweepProgress;
use crate::failure::Failure;
use crate::messages::{report, warn_texts};
use crate::output::{Streamed, check_not_inputs};

/// Solves the rows into a file or to standard output.
pub(super) fn run(
    planned: &Planned,
    (rows, format): (Range<u64>, SliceFormat),
    arguments: &SweepArguments,
) -> Result<(), Failure> {
    let table = arguments.table.iter();
    let inputs = std::iter::once(&arguments.file).chain(table);
    check_not_inputs(inputs.filter_map(|path| path.to_str()), arguments.output())?;
    let slice = Slice {
        sweep: &planned.sweep,
        source: &planned.source,
        rows: rows.clone(),
        format,
    };
    let mut out = Streamed::to(arguments.output())?;
    let mut progress = SweepProgress::new(rows.end - rows.start, arguments.output().is_none());
    let solved = slice.write(&mut out, arguments.threads(), &mut |done| {
        progress.set(done);
        ControlFlow::Continue(())
    });
    drop(progress);
    let solved = match solved {
        Err(SliceError::Output(error)) => return Streamed::failed(out.name().to_owned(), &error),
        solved => solved?,
    };
    let name = out.name().to_owned();
    out.finish()?;
    if arguments.output().is_some() {
        report(&format!(
            "{name}: {}\n",
            account(&rows, planned.source.rows())
        ));
    }
    warn_texts(&Vec::from_iter(failures(&solved)));
    remark(&solved);
    Ok(())
}

/// "all 2000 rows", "rows 0..500 of 2000".
fn account(rows: &Range<u64>, all: u64) -> String {
    match *rows == (0..all) {
        true => format!("all {}", counted(all, "row")),
        false => format!("rows {}..{} of {all}", rows.start, rows.end),
    }
}

/// Number of rows without a complete result, and the first of them.
fn failures(solved: &Solved) -> Option<String> {
    let (row, sentence) = solved.first_failure.as_ref()?;
    let (count, rows) = (solved.failed, counted(solved.rows, "row"));
    let verb = if count == 1 { "has" } else { "have" };
    Some(format!(
        "{count} of {rows} {verb} no complete result (see the column `error`); the first is row {row}, counted from 0: {sentence}"
    ))
}

/// Prints how many of the rows have unusual input or coupled motions, with the first messages about
/// them.
fn remark(solved: &Solved) {
    let has = |of: &RowRemarks| if of.rows == 1 { "has" } else { "have" };
    let (warnings, shared) = (&solved.warnings, &solved.shared);
    let unusual = "unusual input that the base tower does not have";
    say(
        warnings,
        solved.rows,
        &format!("{} {unusual}", has(warnings)),
    );
    let coupled = "a mode that shares its motion with others: less than 60 % of its energy is in the \
                   type of motion that its name states (columns …_share). From one row to the next, two \
                   such modes may exchange their names, and then the frequencies in their columns jump";
    say(shared, solved.rows, &format!("{} {coupled}", has(shared)));
}

fn say(remarked: &RowRemarks, rows: u64, what: &str) {
    if remarked.rows == 0 {
        return;
    }
    let (count, rows) = (remarked.rows, counted(rows, "row"));
    let all = format!("{count} of {rows} {what}");
    let sentence =
        |(row, sentence): &(u64, String)| format!("row {row}, counted from 0: {sentence}");
    let sentences = remarked.first.iter().map(sentence);
    warn_texts(&Vec::from_iter(std::iter::once(all).chain(sentences)));
}
