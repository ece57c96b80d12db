//! The program `towermodes`: natural frequencies and mode shapes of wind turbine towers.
//!
//! The program is one function, [`run`], which the binary and the Python package call, the tables
//! that it prints, [`table`], and its [`studies`].
//!
//! Results go to standard output, messages to standard error. Exit codes: 0 done; 1 the
//! computation, a check or the output failed; 2 wrong usage or wrong input.

mod args;
mod commands;
mod explained;
mod failure;
mod found;
mod input;
mod messages;
mod output;
mod progress;
mod recipe;
mod side_by_side;
pub mod studies;
pub mod table;
mod terminal;

use std::ffi::OsString;
use std::path::Path;

use clap::Parser;
use clap::error::ErrorKind;

use commands::Arguments;

/// Runs the program with the arguments of a command line, the name of the program first, and
/// returns its exit code.
///
/// # Example
/// ```
/// let code = towermodes_cli::run(["towermodes", "solve", "missing.toml"]);
/// assert_eq!(code, 2);
/// ```
pub fn run(command_line: impl IntoIterator<Item = impl Into<OsString>>) -> u8 {
    let words: Vec<OsString> = command_line.into_iter().map(Into::into).collect();
    let arguments = match Arguments::try_parse_from(&words) {
        Ok(arguments) => arguments,
        Err(error) => return report(&error, &words),
    };
    match arguments.command.run(&words) {
        Ok(()) => 0,
        Err(failure) => failure.report(),
    }
}

/// Prints the help or the error of the command line. If a file is given instead of a command, the
/// message shows the `solve` command for it; if two are given to `compare`, which compares methods,
/// the command `check`. Returns the exit code.
fn report(error: &clap::Error, command_line: &[OsString]) -> u8 {
    let _ = error.print();
    let file = command_line.get(1);
    let file = file.filter(|name| Path::new(name).is_file());
    if let (ErrorKind::InvalidSubcommand, Some(file)) = (error.kind(), file) {
        anstream::eprintln!(
            "\nto solve it: towermodes solve {}",
            Path::new(file).display()
        );
    }
    let is_compare = command_line.get(1).is_some_and(|word| word == "compare");
    if is_compare && error.kind() == ErrorKind::UnknownArgument {
        anstream::eprintln!("\nto compare two files: towermodes check FILE OTHER");
    }
    u8::try_from(error.exit_code()).unwrap_or(2)
}
