//! `solve` with several files gives what it gives for each file.

use std::process::Command;

use serde_json::Value;

use crate::pages::root;
use crate::sandbox::PROGRAM;

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
        assert_eq!(
            format!("file,{}", of_file.next().expect("a header")),
            header
        );
        for line in of_file {
            assert_eq!(lines.next(), Some(format!("{file},{line}").as_str()));
        }
    }
    assert_eq!(lines.next(), None);
}
