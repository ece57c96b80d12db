//! Texts about the program that a test can compare with it.

#[allow(dead_code)]
#[path = "../../../recorded-runs/src/plan.rs"]
mod plan;

use crate::program::commands;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

fn text(name: &str) -> String {
    let path = Path::new(ROOT).join(name);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn recorded_runs_cover_every_command() {
    let runs = plan::runs(Path::new(ROOT));
    let is_help = |run: &&plan::Run| run.arguments.contains(&"--help".to_owned());
    let names = runs.iter().filter(|run| !is_help(run));
    let names = names.filter_map(|run| run.arguments.first().cloned());
    let mut covered: BTreeSet<String> = names.collect();
    const PLAN: &str = "recorded-runs/src/plan.rs";
    for name in plan::NOT_RUN {
        let is_new = covered.insert((*name).to_owned());
        assert!(is_new, "`{name}` is run: remove it from NOT_RUN in {PLAN}");
    }
    let commands = commands();
    let missing: Vec<_> = commands.difference(&covered).collect();
    assert!(
        missing.is_empty(),
        "add a run of {missing:?} to SOLVES or OTHERS in {PLAN}"
    );
    let gone: Vec<_> = covered.difference(&commands).collect();
    assert!(
        gone.is_empty(),
        "{PLAN} runs {gone:?}, which the help does not list"
    );
}

/// The cells of the row of a table that begins with a cell.
fn row<'t>(text: &'t str, first: &str) -> Vec<&'t str> {
    let cells = |line: &'t str| -> Vec<&'t str> {
        let line = line.trim_matches('|');
        line.split('|').map(str::trim).collect()
    };
    let mut rows = text.lines().filter(|l| l.starts_with('|')).map(cells);
    rows.find(|row| row[0] == first)
        .unwrap_or_else(|| panic!("no row {first}"))
}

#[test]
fn the_times_of_the_readme_are_those_of_the_book() {
    let (readme, book) = (text("README.md"), text("book/src/performance.md"));
    let (readme, book) = (
        readme.split("## Speed").nth(1).expect("a section"),
        book.split("## One solve").nth(1).expect("a section"),
    );
    let (segments, methods) = (row(readme, "segments"), row(book, "segments"));
    for method in ["`rmje-exact`", "`bmodes`"] {
        let column = methods.iter().position(|name| *name == method);
        let column = column.expect("a method of the book");
        for (number, time) in segments.iter().zip(row(readme, method)).skip(1) {
            let found = row(book, number)[column];
            assert_eq!(found, time, "{method}, {number} segments");
        }
    }
}

#[test]
fn a_page_of_the_report_is_as_large_as_the_book_says() {
    let report = Command::new(env!("CARGO_BIN_EXE_towermodes"))
        .args(["report", "examples/reference-tower.toml", "--output", "-"])
        .current_dir(ROOT)
        .output();
    let bytes = report.expect("the program runs").stdout.len();
    let book = text("book/src/performance.md");
    let least = book.split("its pages have ").nth(1).expect("the sentence");
    let least: f64 = least
        .split(' ')
        .next()
        .expect("a number")
        .parse()
        .expect("MB");
    let megabytes = bytes as f64 / 1e6;
    let holds = (megabytes - least).abs() < 0.05;
    assert!(holds, "{megabytes} MB, the book says {least} MB");
}
