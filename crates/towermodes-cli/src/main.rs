//! The program `towermodes`: natural frequencies and mode shapes of wind turbine towers.
//!
//! Results go to standard output, messages to standard error. Exit codes: 0 done; 1 the
//! computation, a check or the output failed; 2 wrong usage or wrong input.

mod args;
mod campbell;
mod check;
mod compare;
mod converge;
mod convert;
mod elastodyn;
mod failure;
mod input;
mod output;
mod plot;
mod progress;
mod reference;
mod report;
mod shell;
mod side_by_side;
mod solve;
mod table;
mod terminal;
mod verify;

use std::process::ExitCode;

use clap::Parser;

use args::{Arguments, Command};

fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => return args::report(&error),
    };
    let done = match arguments.command {
        Command::Solve(arguments) => solve::run(&arguments),
        Command::Completions { shell } => shell::completions(shell),
        Command::Compare(arguments) => compare::run(&arguments),
        Command::Converge(arguments) => converge::run(&arguments),
        Command::Plot(arguments) => plot::run(&arguments),
        Command::Report(arguments) => report::run(&arguments),
        Command::Campbell(arguments) => campbell::run(&arguments),
        Command::Convert(arguments) => convert::run(&arguments),
        Command::Check(arguments) => check::run(&arguments),
        Command::Elastodyn(arguments) => elastodyn::run(&arguments),
        Command::Verify(arguments) => verify::run(&arguments),
        Command::Schema { of } => shell::schema(&of),
        Command::Reference => reference::run(),
        Command::Man { of } => shell::man(of.as_deref()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
