//! `towermodes elastodyn`.

mod arguments;
mod deck;
mod patch;
mod tower;
mod validate;

pub(crate) use arguments::ElastoDynArguments;

use self::arguments::ElastoDynCommand;
use crate::failure::Failure;

/// Runs the subcommand.
pub(crate) fn run(arguments: &ElastoDynArguments) -> Result<(), Failure> {
    match &arguments.command {
        ElastoDynCommand::Tower(arguments) => tower::run(arguments),
        ElastoDynCommand::Patch(arguments) => patch::run(arguments),
        ElastoDynCommand::Validate(arguments) => validate::run(arguments),
    }
}
