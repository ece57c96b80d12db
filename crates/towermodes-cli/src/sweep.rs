//! `towermodes sweep`.

mod first_order;
mod folder;
mod memory;
mod picture;
mod planned;
mod progress;
mod selection;
mod warned;

use crate::args::SweepArguments;
use crate::failure::Failure;
use planned::Planned;

pub(crate) use memory::MOST_ROWS as MOST_ROWS_IN_MEMORY;

/// Solves the rows of a table or a study: into a folder, or to standard output; or none, to first
/// order.
pub(crate) fn run(arguments: &SweepArguments) -> Result<(), Failure> {
    arguments.check().map_err(Failure::Usage)?;
    let planned = Planned::of(arguments)?;
    if arguments.first_order {
        return first_order::run(&planned, arguments);
    }
    match arguments.folder() {
        Some(path) => folder::run(&planned, path, arguments),
        None => memory::run(&planned, arguments),
    }
}
