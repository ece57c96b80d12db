//! A sweep into a folder of parts.

use std::ops::ControlFlow;
use std::path::Path;

use towermodes_report::wording::counted;
use towermodes_sweep::{DEFAULT_ROWS_PER_PART, PartOptions, Parts, PartsProgress, Shard};

use super::picture;
use super::planned::Planned;
use super::progress::SweepProgress;
use super::warned;
use crate::args::SweepArguments;
use crate::failure::{Failure, note_texts, report};
use crate::output::deliver;
use crate::table;

/// Computes the parts that are missing, then summary and picture if they are requested.
pub(super) fn run(
    planned: &Planned,
    folder: &Path,
    arguments: &SweepArguments,
) -> Result<(), Failure> {
    check(folder)?;
    picture::check(folder, arguments)?;
    let options = PartOptions {
        format: arguments.part_format(),
        rows_per_part: planned
            .results
            .rows_per_part
            .unwrap_or(DEFAULT_ROWS_PER_PART),
        force: arguments.force,
        shard: arguments.shard.unwrap_or(Shard::ALL),
    };
    let parts = Parts::open(&planned.sweep, &planned.source, folder, options);
    let parts = parts.map_err(Failure::Parts)?;
    let missing = parts.missing().map_err(Failure::Parts)?;
    let done = solved(&parts, &missing, arguments)?;
    let is_complete = parts.finish().map_err(Failure::Parts)?;
    report(&account(
        &parts,
        &missing,
        &done,
        is_complete,
        options.shard,
    ));
    if done.failures > 0 {
        let verb = if done.failures == 1 { "has" } else { "have" };
        note_texts(&[format!(
            "{} of {} computed now {verb} no complete result; the column error has the reason",
            done.failures,
            counted(done.rows, "row")
        )]);
    }
    warned::report([&done.warnings, &done.shared], done.rows);
    let is_shown = arguments.summary || arguments.plot.is_some();
    if is_shown && !is_complete {
        return Err(Failure::Refused(format!(
            "the results in {} are not complete: run the other shards, and then this command again for --summary and --plot",
            folder.display()
        )));
    }
    if arguments.summary {
        summarize(planned, &parts)?;
    }
    picture::run(planned, &parts, arguments)
}

/// Prints the results in numbers, with the resonance check of the base's rotor if it has one.
fn summarize(planned: &Planned, parts: &Parts<'_>) -> Result<(), Failure> {
    let check = planned.sweep.margin_check();
    let summary = parts.summary(check.as_ref()).map_err(Failure::Parts)?;
    let tower = planned.input.tower().map_err(Failure::Input)?;
    deliver(
        table::sweep_summary(&tower, &summary, check.as_ref()).as_bytes(),
        None,
    )
}

/// Refuses a file in place of a folder.
fn check(folder: &Path) -> Result<(), Failure> {
    let has_ending = folder.extension().is_some_and(|ending| {
        ["csv", "parquet"]
            .iter()
            .any(|known| ending.eq_ignore_ascii_case(known))
    });
    match folder.is_file() || (has_ending && !folder.is_dir()) {
        true => Err(Failure::Usage(
            "--output is a folder for a sweep; without --output the results are one CSV table on standard output",
        )),
        false => Ok(()),
    }
}

fn solved(
    parts: &Parts<'_>,
    missing: &[u64],
    arguments: &SweepArguments,
) -> Result<PartsProgress, Failure> {
    let rows_of = |part: &u64| {
        let rows = parts.rows_of(*part);
        rows.end - rows.start
    };
    let mut progress = SweepProgress::new(missing.iter().map(rows_of).sum());
    let done = parts.solve(missing, arguments.threads(), &mut |now| {
        progress.set(now.rows);
        ControlFlow::Continue(())
    });
    drop(progress);
    done.map_err(Failure::Parts)
}

/// "results: 1000000 rows in 62 parts are complete; 31 parts computed now".
fn account(
    parts: &Parts<'_>,
    missing: &[u64],
    done: &PartsProgress,
    is_complete: bool,
    shard: Shard,
) -> String {
    let folder = parts.folder().display();
    let (rows, count) = (parts.rows(), parts.count());
    let now = match missing.len() {
        0 => "nothing to compute".to_owned(),
        _ => format!("{} computed now", counted(done.parts, "part")),
    };
    let [rows, all] = [counted(rows, "row"), counted(count, "part")];
    match is_complete {
        true => format!("{folder}: complete, {rows} in {all}; {now}\n"),
        false => {
            format!("{folder}: shard {shard} is complete, other shards are missing; {now}\n")
        }
    }
}
