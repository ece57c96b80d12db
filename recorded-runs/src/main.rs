//! Runs towermodes hundreds of times and compares what two versions of it print.

mod compare;
mod plan;
mod record;

use std::path::Path;
use std::process::ExitCode;

const USAGE: &str = "usage:
  recorded-runs record PROGRAM FOLDER    run PROGRAM and keep what it prints in FOLDER
  recorded-runs compare BEFORE AFTER     compare two such folders
  recorded-runs list                     print the runs";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let result = match words[..] {
        ["record", program, folder] => record::record(Path::new(program), Path::new(folder)),
        ["compare", before, after] => compare::compare(Path::new(before), Path::new(after)),
        ["list"] => {
            plan::runs(&plan::root())
                .iter()
                .for_each(|run| println!("{}", run.name()));
            Ok(true)
        }
        _ => Err(USAGE.to_owned()),
    };
    match result {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::from(2)
        }
    }
}
