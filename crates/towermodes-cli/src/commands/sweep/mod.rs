//! `towermodes sweep`.

mod arguments;
mod check;
mod first_order;
mod picture;
mod planned;
mod progress;
mod selection;
mod solve;

pub(crate) use arguments::SweepArguments;

use towermodes_sweep::Slices;

use crate::failure::Failure;
use crate::output::Finished;
use crate::table;
use planned::Planned;

/// Solves the rows of a table or of a study and writes them as one slice, or reads existing slices;
/// with `--first-order` it solves no rows and uses derivatives.
pub(crate) fn run(arguments: &SweepArguments) -> Result<(), Failure> {
    arguments.check()?;
    let format = arguments.slice_format()?;
    picture::check(arguments)?;
    let planned = Planned::of(arguments)?;
    if arguments.first_order {
        return first_order::run(&planned, arguments);
    }
    let rows = planned.rows(arguments)?;
    let paths = match arguments.output() {
        _ if !arguments.slices.is_empty() => {
            check::run(&planned, rows, arguments)?;
            arguments.slices.clone()
        }
        output => {
            solve::run(&planned, (rows, format), arguments)?;
            Vec::from_iter(output.map(Into::into))
        }
    };
    if !arguments.summary && arguments.plot.is_none() {
        return Ok(());
    }
    let slices = Slices::open(&planned.sweep, &planned.source, &paths)?;
    if arguments.summary {
        summarize(&planned, &slices)?;
    }
    picture::run(&planned, &slices, arguments)
}

/// Prints the results as numbers, with the resonance check if the base tower has a rotor.
fn summarize(planned: &Planned, slices: &Slices<'_>) -> Result<(), Failure> {
    let check = planned.sweep.margin_check();
    let summary = slices.summary(check.as_ref())?;
    let tower = planned.input.tower()?;
    let text = table::sweep_summary(&tower, &summary, check.as_ref());
    Finished::Text(text).deliver(None)
}
