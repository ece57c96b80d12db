//! The program `towermodes`: natural frequencies and mode shapes of wind turbine towers.
//!
//! The program is one function, [`run`], which the binary and the Python package call, the tables
//! that it prints, [`table`], and its [`studies`].
//!
//! Results go to standard output, messages to standard error. Exit codes: 0 done; 1 the
//! computation, a check or the output failed; 2 wrong usage or wrong input.

mod args;
mod calibrate;
mod campbell;
mod check;
mod compare;
mod converge;
mod convert;
mod damping;
mod design;
mod elastodyn;
mod explained;
mod explore;
mod failure;
mod found;
mod input;
mod messages;
mod output;
mod parameters;
mod plot;
mod progress;
mod reference;
mod report;
mod sensitivities;
mod shell;
mod side_by_side;
mod solve;
pub mod studies;
mod sweep;
pub mod table;
mod terminal;
mod verify;

use std::ffi::OsString;

use clap::Parser;

use args::{Arguments, Command};

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
        Err(error) => return args::report(&error, &words),
    };
    match done(arguments.command, &words) {
        Ok(()) => 0,
        Err(failure) => failure.report(),
    }
}

fn done(command: Command, words: &[OsString]) -> Result<(), failure::Failure> {
    match command {
        Command::Solve(arguments) => solve::run(&arguments),
        Command::Parameters(arguments) => parameters::run(&arguments),
        Command::Sensitivities(arguments) => sensitivities::run(&arguments),
        Command::Sweep(arguments) => sweep::run(&arguments),
        Command::Design(arguments) => design::run(&arguments),
        Command::Calibrate(arguments) => calibrate::run(&arguments),
        Command::Compare(arguments) => compare::run(&arguments),
        Command::Converge(arguments) => converge::run(&arguments),
        Command::Plot(arguments) => plot::run(&arguments),
        Command::Report(arguments) => report::run(&arguments, words),
        Command::Campbell(arguments) => campbell::run(&arguments),
        Command::Damping(arguments) => damping::run(&arguments),
        Command::Explore(arguments) => explore::run(&arguments),
        Command::Convert(arguments) => convert::run(&arguments),
        Command::Check(arguments) => check::run(&arguments),
        Command::Elastodyn(arguments) => elastodyn::run(&arguments),
        Command::Verify(arguments) => verify::run(&arguments),
        Command::Completions { shell } => shell::completions(shell),
        Command::Schema { of } => shell::schema(&of),
        Command::Reference => reference::run(),
        Command::Man { of } => shell::man(of.as_deref()),
    }
}
