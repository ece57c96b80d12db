//! The program as tests call it, and folders that are gone when the test is.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

use serde_json::Value;

pub use crate::pages::root;

/// A command of the program, in the folder of the repository.
pub fn towermodes(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_towermodes"));
    command.current_dir(root()).args(arguments);
    command
}

pub fn run(arguments: &[&str]) -> Output {
    towermodes(arguments).output().expect("the program runs")
}

/// The standard output of a command that must succeed.
#[track_caller]
pub fn done(arguments: &[&str]) -> String {
    let output = run(arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments:?}: {said}");
    String::from_utf8(output.stdout).expect("text")
}

#[track_caller]
pub fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&done(arguments)).expect("JSON")
}

/// The commands that the help lists.
pub fn commands() -> BTreeSet<String> {
    let help = done(&["--help"]);
    let list = help.split("Commands:\n").nth(1).expect("a list");
    let list = list.split("\n\n").next().expect("a list");
    // Names are two blanks from the left, the rest of a description is further to the right.
    let names = list.lines().filter_map(|line| line.strip_prefix("  "));
    let names = names.filter(|line| !line.starts_with(' '));
    let names = names.filter_map(|line| line.split(' ').next());
    names.map(str::to_owned).filter(|n| n != "help").collect()
}

/// A rotating blade: the tower of an example as a blade of BModes. Its path.
pub fn blade(folder: &Folder) -> String {
    let (tower, path) = ("examples/nrel-5mw-table.toml", folder.path("b.bmi"));
    let deck = done(&["convert", tower, "--to", "bmodes", "--output", &path]);
    assert!(deck.is_empty());
    let text = folder.text("b.bmi");
    let words = "2                      beam_type";
    let text = text.replacen(words, "1                      beam_type", 1);
    let words = "0.0                    rot_rpm";
    let text = text.replacen(words, "6.0                    rot_rpm", 1);
    folder.write("b.bmi", &text);
    path
}

/// Standard output and standard error.
pub fn texts(output: &Output) -> [String; 2] {
    [&output.stdout, &output.stderr].map(|text| String::from_utf8(text.clone()).expect("text"))
}

/// An empty folder that is gone when the test is.
pub struct Folder(pub PathBuf);

impl Folder {
    pub fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("towermodes-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).expect("a folder");
        Self(path)
    }

    pub fn path(&self, file: &str) -> String {
        self.0.join(file).display().to_string()
    }

    pub fn text(&self, file: &str) -> String {
        fs::read_to_string(self.0.join(file)).expect("a file")
    }

    pub fn write(&self, file: &str, text: &str) {
        fs::write(self.0.join(file), text).expect("written");
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}
