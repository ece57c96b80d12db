//! Completion scripts, manual pages and JSON schemas.

use clap::CommandFactory;
use clap_complete::Shell;
use towermodes_files::ResultKind;

use crate::args::Arguments;
use crate::failure::Failure;
use crate::output::deliver;

/// `towermodes completions SHELL`.
pub(crate) fn completions(shell: Shell) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "towermodes", &mut script);
    deliver(&script, None)
}

/// `towermodes schema [RESULT]`.
pub(crate) fn schema(of: &str) -> Result<(), Failure> {
    let schema = ResultKind::named(of).map_or(towermodes_verify::SCHEMA, ResultKind::json_schema);
    deliver(schema.as_bytes(), None)
}

/// `towermodes man [COMMAND]`: the page of the program, or of one of its commands.
pub(crate) fn man(of: Option<&str>) -> Result<(), Failure> {
    let mut command = Arguments::command();
    command.build();
    let page_of = match of {
        None => command,
        Some(name) => command.find_subcommand(name).cloned().unwrap_or(command),
    };
    let mut page = Vec::new();
    let man = clap_mangen::Man::new(page_of);
    man.render(&mut page)
        .map_err(|error| Failure::unwritable("the manual page", error))?;
    deliver(&page, None)
}
