//! The program `towermodes`: see [`towermodes_cli::run`].

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(towermodes_cli::run(std::env::args_os()))
}
