//! Completion scripts, manual pages and JSON schemas.

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Args, CommandFactory, Subcommand};
use clap_complete::Shell;
use towermodes_files::RESULTS;

use super::{Arguments, Command};
use crate::failure::Failure;
use crate::output::deliver;

/// The arguments of `completions`.
#[derive(Debug, Args)]
#[command(
    after_help = "Example:\n  towermodes completions bash > ~/.local/share/bash-completion/completions/towermodes"
)]
pub(crate) struct CompletionsArguments {
    /// The shell.
    shell: Shell,
}

/// The arguments of `schema`.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  towermodes schema solve > solve.schema.json")]
pub(crate) struct SchemaArguments {
    /// Name of the result
    #[arg(value_name = "RESULT", default_value = "solve", value_parser = results())]
    of: String,
}

/// The arguments of `man`.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  towermodes man solve | man -l -")]
pub(crate) struct ManArguments {
    /// The command [default: the program].
    #[arg(value_name = "COMMAND", value_parser = commands())]
    of: Option<String>,
}

/// The results that have a JSON schema.
fn results() -> PossibleValuesParser {
    let value = |name: &'static str, command: &str| match name == command {
        true => PossibleValue::new(name),
        false => PossibleValue::new(name).help(format!("result of `{command}`")),
    };
    let of_files = RESULTS.iter().map(|kind| value(kind.name, kind.command));
    PossibleValuesParser::new(of_files.chain([value("verify", "verify")]))
}

/// The commands that the help lists.
fn commands() -> PossibleValuesParser {
    let program = Command::augment_subcommands(clap::Command::new("towermodes"));
    let shown = program.get_subcommands().filter(|of| !of.is_hide_set());
    PossibleValuesParser::new(shown.map(|of| PossibleValue::new(of.get_name().to_owned())))
}

/// `towermodes completions SHELL`.
pub(crate) fn completions(arguments: &CompletionsArguments) -> Result<(), Failure> {
    let (mut program, mut script) = (Arguments::command(), Vec::new());
    clap_complete::generate(arguments.shell, &mut program, "towermodes", &mut script);
    deliver(&script, None)
}

/// `towermodes schema [RESULT]`.
pub(crate) fn schema(arguments: &SchemaArguments) -> Result<(), Failure> {
    let kind = RESULTS.iter().find(|kind| kind.name == arguments.of);
    let schema = kind.map_or(towermodes_verify::SCHEMA, |kind| kind.json_schema);
    deliver(schema.as_bytes(), None)
}

/// `towermodes man [COMMAND]`: the page of the program, or of one of its commands.
pub(crate) fn man(arguments: &ManArguments) -> Result<(), Failure> {
    let mut command = Arguments::command();
    command.build();
    let page_of = match &arguments.of {
        None => command,
        Some(name) => command.find_subcommand(name).cloned().unwrap_or(command),
    };
    let mut page = Vec::new();
    let man = clap_mangen::Man::new(page_of);
    man.render(&mut page)
        .map_err(|error| Failure::unwritable("the manual page", &error))?;
    deliver(&page, None)
}
