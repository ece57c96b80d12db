//! `solve` with several files gives what it gives for each file.

use std::fs;
use std::process::Command;

use serde_json::Value;
use towermodes_testing::Says;

use crate::pages::root;
use crate::sandbox::{PROGRAM, Sandbox};

const FILES: [&str; 3] = [
    "examples/nrel-5mw.toml",
    "examples/nrel-5mw.bmi",
    "examples/floating.toml",
];

fn solved(files: &[&str], format: &str) -> String {
    let mut command = Command::new(PROGRAM);
    command.current_dir(root()).arg("solve").args(files);
    let done = command.args(["--modes", "3", "--format", format]).output();
    let done = done.expect("the program runs");
    assert!(done.status.success());
    String::from_utf8(done.stdout).expect("text")
}

#[test]
fn the_json_is_a_list_of_the_results_of_each_file() {
    let json = |files: &[&str]| serde_json::from_str::<Value>(&solved(files, "json"));
    let all = json(&FILES).expect("a list");
    let all = all.as_array().expect("a list");
    assert_eq!(all.len(), FILES.len());
    for (of_file, file) in all.iter().zip(FILES) {
        let mut alone = json(&[file]).expect("a document");
        alone["file"] = file.into();
        assert_eq!(*of_file, alone, "{file}");
    }
}

#[test]
fn the_csv_is_that_of_each_file_after_its_name() {
    let all = solved(&FILES, "csv");
    let mut lines = all.lines();
    let header = lines.next().expect("a header");
    for file in FILES {
        let alone = solved(&[file], "csv");
        let mut of_file = alone.lines();
        let found = format!("file,{}", of_file.next().expect("a header"));
        assert_eq!(found, header);
        for line in of_file {
            assert_eq!(lines.next(), Some(format!("{file},{line}").as_str()));
        }
    }
    assert_eq!(lines.next(), None);
}

/// A file that belongs to an input is not overwritten, also if the input itself fails.
#[test]
fn no_file_of_an_input_is_overwritten() {
    let sandbox = Sandbox::new("several-overwritten");
    let write = |name: &str, text: &str| fs::write(sandbox.path().join(name), text);
    let tower = "[material]\ndensity = 8500.0\nyoungs_modulus = 2.1e11\npoissons_ratio = 0.3\n";
    let table = "0,6,0.027\n87.6,3.87,0.019\n";
    write("stations.csv", table).expect("written");
    let with = format!("{tower}[tower]\nstations = \"stations.csv\"\n");
    write("with-table.toml", &with).expect("written");
    write("wrong.toml", "[tower]\nstation = 1\n").expect("written");
    for (input, output) in [
        ("with-table.toml", "stations.csv"),
        ("wrong.toml", "wrong.toml"),
        ("with-table.toml", "tower.toml"),
    ] {
        let before = fs::read(sandbox.path().join(output)).expect("a file");
        let mut command = Command::new(PROGRAM);
        command.current_dir(sandbox.path());
        command.args([
            "solve",
            input,
            "tower.toml",
            "--format",
            "csv",
            "--output",
            output,
        ]);
        let refused = command.output().expect("the program runs");
        let said = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert_eq!(refused.status.code(), Some(2), "{said}");
        said.says("is an input file");
        let after = fs::read(sandbox.path().join(output)).expect("a file");
        assert!(after == before, "{output} is overwritten");
    }
}

/// A wrong value of an option is shown for each file, with the name of the file.
#[test]
fn a_setting_that_is_wrong_for_a_file_names_the_file() {
    let mut command = Command::new(PROGRAM);
    command
        .current_dir(root())
        .args(["solve", FILES[0], FILES[2]]);
    let refused = command.args(["--set", "rna.mass=-3"]).output();
    let said = String::from_utf8_lossy(&refused.expect("the program runs").stderr).into_owned();
    said.says(&format!("error: {}: the mass is -3 kg", FILES[0]));
}
