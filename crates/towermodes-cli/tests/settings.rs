//! `--set` in every command that reads a tower.

use crate::program::{Folder, commands, done, run};

use std::process::Output;
use towermodes_testing::{Says, arguments, rows};

const TOWER: &str = "examples/nrel-5mw.toml";
const SET: [&str; 2] = ["--set", "stations[0].wall=0.036"];
const NOTE: &str = "stations[0].wall = 0.036 m by --set; the file has 0.0351";

/// Commands that need more than a tower, or have more than one form; all others are run with the
/// tower alone.
const OWN_LINES: &str = "
    compare TOWER --methods rmje,spectral --modes 2
    converge TOWER --modes 2 --segments 10,20,40
    check TOWER
    check TOWER examples/nrel-5mw.yaml
    convert TOWER --to toml
    convert TOWER --to windio
    design TOWER crates/towermodes-cli/tests/inputs/design/mass.toml
    calibrate TOWER crates/towermodes-cli/tests/inputs/measured/tower.toml
    sweep TOWER crates/towermodes-cli/tests/inputs/sweeps/failing.csv
    elastodyn tower TOWER
    plot TOWER --what tower
    report TOWER --format md
";

#[test]
fn every_command_that_reads_a_tower_sets_numbers() {
    let own = rows(OWN_LINES).map(|[line]| line.to_owned());
    let mut lines: Vec<String> = own.collect();
    for command in commands() {
        let has_line = lines
            .iter()
            .any(|line| line.split(' ').next() == Some(&command));
        let sets = || done(&[&command, "--help"]).contains("--set <NAME=VALUE>");
        // It serves a page until it is ended.
        if command != "explore" && !has_line && sets() {
            lines.push(format!("{command} TOWER"));
        }
    }
    for line in lines {
        let line = line.replace("TOWER", TOWER);
        let arguments = &arguments(&line)[..];
        let without = run(arguments);
        let with = run(&[arguments, &SET].concat());
        let said = String::from_utf8_lossy(&with.stderr).into_owned();
        let is_set = said.contains(NOTE);
        assert!(
            is_set,
            "{arguments:?} sets nothing; a command that needs other arguments has a line in OWN_LINES: {said}"
        );
        let is_done = |output: &Output| output.status.code() == Some(0);
        assert_eq!(is_done(&with), is_done(&without), "{arguments:?}: {said}");
        assert!(with.stdout != without.stdout, "{arguments:?} ignores --set");
    }
}

/// A reader of the report can repeat it: note, command and the changed value are there.
#[test]
fn a_report_shows_what_was_set() {
    let folder = Folder::new("set");
    let output = folder.path("set.md");
    let done = run(&["report", TOWER, SET[0], SET[1], "--output", &output]);
    assert!(done.status.success());
    let page = folder.text("set.md");
    // Markdown escapes the brackets of the name.
    page.says_all("= 0.036 m by --set; the file has 0.0351 & --set 'stations[0].wall=0.036'");
}

/// A number that is not listed is added to what the other filters select.
#[test]
fn filters_of_parameters_are_a_union() {
    let filters = ["rna.mass", "material.poissons_ratio", "mass"];
    let arguments = [&["parameters", TOWER, "--format", "csv"][..], &filters].concat();
    let listed = String::from_utf8(run(&arguments).stdout).expect("text");
    let count = |name: &str| listed.matches(&format!("{name},")).count();
    let counts = ["rna.mass", "material.poissons_ratio", "density"].map(count);
    assert_eq!(counts, [1, 1, 0], "{listed}");
    let wrong = run(&[&arguments[..], &["rna.mas.s"]].concat());
    assert_eq!(wrong.status.code(), Some(2));
}
