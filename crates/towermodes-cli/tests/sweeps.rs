//! Sweeps that are killed, interrupted, run twice at once, or run out of disk: a file is whole or
//! not there, and the next run succeeds. Slices have the rows of the whole run.

#![cfg(unix)]

use std::fs;

use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::thread;
use std::time::Duration;
use towermodes_testing::{Says, number, rows};

use crate::pages::root;
use crate::sandbox::PROGRAM;

const ROWS: usize = 6000;

/// A folder that is gone when the test is, with a study.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path =
            std::env::temp_dir().join(format!("towermodes-sweep-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).expect("a folder");
        fs::copy(
            root().join("examples/nrel-5mw.toml"),
            path.join("tower.toml"),
        )
        .expect("copied");
        let folder = Self(path);
        folder.write_study(ROWS, 1);
        folder
    }

    fn write_study(&self, rows: usize, seed: usize) {
        let text = format!(
            "[sweep]\nbase = \"tower.toml\"\nsampling = \"random\"\nrows = {rows}\nseed = {seed}\n\
             [sweep.vary]\n\"rna.mass\" = {{ uniform = [3e5, 4e5] }}\n\
             [sweep.results]\nmodes = 2\n"
        );
        fs::write(self.0.join("study.toml"), text).expect("written");
    }

    /// The sweep of the study, with further arguments.
    fn command(&self, more: &[&str]) -> Command {
        let mut command = Command::new(PROGRAM);
        command
            .current_dir(&self.0)
            .args(["sweep", "study.toml"])
            .args(more)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        command
    }

    #[track_caller]
    fn done(&self, more: &[&str]) -> Output {
        let done = self.command(more).output().expect("the program runs");
        let said = String::from_utf8_lossy(&done.stderr);
        assert!(done.status.success(), "{said}");
        done
    }

    /// What a run says that ends with an exit code.
    #[track_caller]
    fn refused(&self, more: &[&str], code: i32) -> String {
        let done = self.command(more).output().expect("the program runs");
        let said = String::from_utf8_lossy(&done.stderr).into_owned();
        assert_eq!(done.status.code(), Some(code), "{said}");
        said
    }

    fn started(&self, output: &str) -> Child {
        let mut command = with_ctrl_c(&self.command(&["--output", output, "--threads", "1"]));
        command.stdout(Stdio::null()).stderr(Stdio::null());
        command.spawn().expect("the program runs")
    }

    fn text(&self, file: &str) -> String {
        fs::read_to_string(self.0.join(file)).expect("a file")
    }

    /// Names of files that have not got their name yet, and their lengths.
    fn temporary(&self) -> Vec<(PathBuf, u64)> {
        let entries = fs::read_dir(&self.0).expect("the folder").flatten();
        let files = entries.filter_map(|entry| Some((entry.path(), entry.metadata().ok()?.len())));
        let is_temporary = |path: &Path| path.extension().is_some_and(|ending| ending == "tmp");
        files.filter(|(path, _)| is_temporary(path)).collect()
    }

    /// Starts a run and ends it by a signal when it has written rows. On a busy machine a run can
    /// end before the signal comes: then there is another.
    #[track_caller]
    fn killed(&self, output: &str, signal: &str) {
        const ATTEMPTS: usize = 50;
        for _ in 0..ATTEMPTS {
            let _ = fs::remove_file(self.0.join(output));
            let mut run = self.started(output);
            let has_written = || self.temporary().iter().any(|(_, bytes)| *bytes > 10_000);
            while !has_written() && run.try_wait().expect("a process").is_none() {
                thread::sleep(Duration::from_millis(1));
            }
            // The program `kill` sends it as a user or a scheduler does.
            let id = run.id().to_string();
            // There may be no such process any more.
            let _ = Command::new("kill")
                .args([signal, &id])
                .stderr(Stdio::null())
                .status();
            let ended = run.wait().expect("a process");
            for (left, _) in self.temporary() {
                fs::remove_file(left).expect("removed");
            }
            if ended.code() == Some(0) {
                continue;
            }
            // No exit code: the help says that the signal ends the program.
            let by_signal = ended.code().is_none() && ended.signal().is_some();
            assert!(by_signal, "{ended}");
            return;
        }
        panic!("{signal}: each of {ATTEMPTS} runs ended before the signal");
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// The same command, which Ctrl-C ends even if whoever runs the tests ignores it, as a background
/// job does.
fn with_ctrl_c(command: &Command) -> Command {
    let mut with = match cfg!(target_os = "linux") {
        true => {
            let mut with = Command::new("env");
            with.arg("--default-signal=INT").arg(command.get_program());
            with
        }
        false => Command::new(command.get_program()),
    };
    with.args(command.get_args());
    if let Some(folder) = command.get_current_dir() {
        with.current_dir(folder);
    }
    with
}

/// The lines of the rows of a file, which has each row once.
#[track_caller]
fn data_rows(text: &str) -> Vec<&str> {
    text.begins("# towermodes ");
    text.lines().skip(2).collect()
}

/// A row would put the mass of the RNA back without its inertia.
#[test]
fn a_column_of_an_omitted_rna_is_refused() {
    let folder = Folder::new("no-rna");
    fs::write(folder.0.join("values.csv"), "rna.mass\n350000\n").expect("written");
    let mut command = Command::new(PROGRAM);
    let words = ["sweep", "tower.toml", "values.csv", "--no-rna"];
    let done = command.current_dir(&folder.0).args(words).output();
    let done = done.expect("the program runs");
    let said = String::from_utf8_lossy(&done.stderr);
    assert_eq!(done.status.code(), Some(2), "{said}");
    said.says("a column changes an input value of the RNA");
    let study = fs::read_to_string(folder.0.join("study.toml")).expect("the study");
    let without = format!("{study}[sweep.reading]\nno_rna = true\n");
    fs::write(folder.0.join("study.toml"), without).expect("written");
    folder.refused(&[], 2).says("[sweep.reading] no_rna");
}

#[test]
fn a_killed_sweep_leaves_no_file_and_the_next_run_succeeds() {
    let folder = Folder::new("killed");
    folder.done(&["--output", "whole.csv"]);
    let whole = folder.text("whole.csv");
    assert_eq!(data_rows(&whole).len(), ROWS);
    for signal in ["-KILL", "-INT", "-TERM"] {
        folder.killed("results.csv", signal);
        assert!(!folder.0.join("results.csv").exists(), "{signal}");
        folder.done(&["--output", "results.csv"]);
        assert!(folder.text("results.csv") == whole, "{signal}");
    }
    // A file that is there stays until it is replaced by a whole one.
    fs::write(folder.0.join("old.csv"), "old").expect("written");
    let mut run = folder.started("old.csv");
    while folder.temporary().is_empty() && run.try_wait().expect("a process").is_none() {
        thread::sleep(Duration::from_millis(1));
    }
    let _ = run.kill();
    let _ = run.wait();
    let left = folder.text("old.csv");
    assert!(left == "old" || left == whole);
}

#[test]
fn threads_slices_and_simultaneous_runs_give_the_same_rows() {
    let folder = Folder::new("same");
    let printed = folder.done(&["--threads", "1"]).stdout;
    let whole = String::from_utf8(printed).expect("text");
    assert_eq!(data_rows(&whole).len(), ROWS);
    folder.done(&["--output", "threads.csv", "--threads", "3"]);
    assert!(folder.text("threads.csv") == whole);
    let ranges = ["4000..9999", "0..1", "1..4000"];
    let names = ["c.csv", "a.csv", "b.csv"];
    for (range, name) in ranges.into_iter().zip(names) {
        folder.done(&["--rows", range, "--output", name]);
    }
    let texts = ["a.csv", "b.csv", "c.csv"].map(|name| folder.text(name));
    let joined: Vec<&str> = texts.iter().flat_map(|text| data_rows(text)).collect();
    assert!(joined == data_rows(&whole));
    // Together they are the whole sweep, and have its numbers.
    let summary = |files: &[&str]| {
        let check = [&["--summary", "--check"], files].concat();
        folder.done(&check).stdout
    };
    assert!(summary(&names) == summary(&["threads.csv"]));
    let mut runs = [folder.started("both.csv"), folder.started("both.csv")];
    for run in &mut runs {
        assert!(run.wait().expect("a process").success());
    }
    assert!(folder.text("both.csv") == whole && folder.temporary().is_empty());
}

#[test]
fn a_mixture_of_slices_is_refused_and_missing_rows_are_named() {
    let folder = Folder::new("mixture");
    folder.write_study(400, 1);
    folder.done(&["--rows", "0..100", "--output", "a.csv"]);
    folder.done(&["--rows", "150..400", "--output", "b.csv"]);
    let said = folder.refused(&["--check", "a.csv", "b.csv"], 1);
    said.says_all("do not have the rows 100..150 & --rows FIRST..END");
    // Those that are asked for are there.
    folder.done(&["--rows", "150..400", "--check", "b.csv"]);
    let said = folder.refused(&["--check", "a.csv", "b.csv", "a.csv"], 2);
    said.says("both have the rows 0..100");
    folder.write_study(400, 2);
    folder.done(&["--rows", "100..150", "--output", "c.csv"]);
    let said = folder.refused(&["--check", "c.csv", "a.csv"], 2);
    let expected = "a.csv is a slice of another sweep: the values of the rows differ";
    said.says(expected);
    // What a killed command has printed.
    let half: Vec<String> = folder
        .text("c.csv")
        .lines()
        .take(9)
        .map(str::to_owned)
        .collect();
    fs::write(folder.0.join("c.csv"), half.join("\n")).expect("written");
    let said = folder.refused(&["--rows", "100..150", "--check", "c.csv"], 1);
    said.says("c.csv is incomplete: it ends before row 107");
}

/// Files cannot become longer than two blocks: as on a full disk a write fails.
#[test]
fn a_write_that_fails_ends_the_sweep_and_leaves_nothing() {
    let folder = Folder::new("limit");
    folder.write_study(400, 1);
    let script = "trap '' XFSZ; ulimit -f 2; exec \"$0\" \"$@\"";
    let failed = Command::new("sh")
        .current_dir(&folder.0)
        .args(["-c", script, PROGRAM, "sweep", "study.toml"])
        .args(["--output", "results.csv"])
        .output()
        .expect("a shell");
    let said = String::from_utf8_lossy(&failed.stderr).into_owned();
    assert_eq!(failed.status.code(), Some(1), "{said}");
    said.says("error: results.csv: ");
    assert!(!folder.0.join("results.csv").exists() && folder.temporary().is_empty());
    folder.done(&["--output", "results.csv"]);
    assert_eq!(data_rows(&folder.text("results.csv")).len(), 400);
}

/// A disk of its own that is smaller than the results; only root can have one.
#[test]
fn a_full_disk_is_an_error_with_the_path() {
    let folder = Folder::new("disk");
    folder.write_study(2000, 1);
    let disk = folder.0.join("disk");
    fs::create_dir_all(&disk).expect("a folder");
    let Some(_mounted) = Mounted::new(&disk, "100k") else {
        eprintln!("skipped: a file system of the test's own cannot be mounted");
        return;
    };
    let said = folder.refused(&["--output", "disk/results.csv"], 1);
    let is_named = said.contains("error: disk/results.csv: No space left");
    assert!(is_named, "{said}");
    assert_eq!(fs::read_dir(&disk).expect("the disk").count(), 0);
    let grown = Command::new("mount")
        .args(["-o", "remount,size=20m"])
        .arg(&disk)
        .status();
    assert!(grown.expect("mount").success());
    folder.done(&["--output", "disk/results.csv"]);
    assert_eq!(data_rows(&folder.text("disk/results.csv")).len(), 2000);
}

/// A file system in memory, gone when the test is.
struct Mounted(PathBuf);

impl Mounted {
    fn new(path: &Path, size: &str) -> Option<Self> {
        let option = format!("size={size}");
        let mut command = Command::new("mount");
        command
            .args(["-t", "tmpfs", "-o", &option, "tmpfs"])
            .arg(path);
        let done = command.stderr(Stdio::null()).status().ok()?;
        done.success().then(|| Self(path.to_path_buf()))
    }
}

impl Drop for Mounted {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(&self.0).status();
    }
}

#[test]
fn a_reader_that_has_enough_ends_the_sweep() {
    let folder = Folder::new("pipe");
    folder.write_study(1_000_000, 1);
    let script = "\"$0\" sweep study.toml | head -n 3; echo \"${PIPESTATUS[0]}\"";
    let mut command = Command::new("bash");
    command.current_dir(&folder.0).args(["-c", script, PROGRAM]);
    let done = command.output().expect("a shell");
    let lines = String::from_utf8_lossy(&done.stdout).into_owned();
    let lines: Vec<&str> = lines.lines().collect();
    assert!(lines.len() == 4 && lines[3] == "0", "{lines:?}");
}

#[test]
fn pictures_of_a_sweep_are_written() {
    let folder = Folder::new("picture");
    folder.write_study(400, 1);
    folder.done(&["--output", "results.csv", "--plot", "curves.svg"]);
    let curves = folder.text("curves.svg");
    assert!(curves.contains("rna.mass (kg)") && curves.contains("1st fore-aft bending"));
    // Of a file that is there only the picture is made.
    folder.done(&["--check", "results.csv", "--plot", "curves.png"]);
    let picture = fs::read(folder.0.join("curves.png")).expect("a picture");
    assert!(picture.starts_with(b"\x89PNG"));
}

/// A path that cannot be written is refused before anything is computed.
#[test]
fn what_cannot_be_written_is_refused_first() {
    let folder = Folder::new("no-picture");
    let table = r#"
        --plot | curves.pdf | 2 | FILE.svg or FILE.png
        --plot | curves | 2 | FILE.svg or FILE.png
        --plot | missing/curves.svg | 1 | the folder missing does not exist
        --output | missing/results.csv | 1 | the folder missing does not exist
        --output | results.xlsx | 2 | use .csv, .parquet
        --output | study.toml | 2 | unknown file extension .toml
        --output | . | 1 | this is a folder
        "#;
    for [option, path, code, words] in rows(table) {
        let code = number(code);
        let mut arguments = vec![option, path];
        if option == "--plot" {
            arguments.extend(["--output", "results.csv"]);
        }
        folder.refused(&arguments, code).says(words);
        assert!(!folder.0.join("results.csv").exists(), "{path}");
    }
}

/// Options of readers that contradict the tower or `--set` have the names of the study's keys.
#[test]
fn reading_options_of_a_study_are_checked_under_their_names() {
    let folder = Folder::new("reading");
    let study = fs::read_to_string(folder.0.join("study.toml")).expect("the study");
    let table = r#"
        tower_height = 80.0 | rna.center[2]=2 | [sweep.reading] tower_height applies only
        no_rna = true | rna.center[2]=2 | contradicts [sweep.reading] no_rna;
        no_gravity = false | rna.mass=3e5 | the column `rna.mass` sets rna.mass in each row
        "#;
    for [key, set, words] in rows(table) {
        let text = format!("{study}[sweep.reading]\n{key}\n");
        fs::write(folder.0.join("study.toml"), text).expect("written");
        folder.refused(&["--set", set], 2).says(words);
    }
}

/// Hints name options that `sweep` has.
#[test]
fn a_hint_names_options_of_the_command() {
    let folder = Folder::new("hint");
    let said = folder.refused(&["--modes", "5000"], 2);
    said.says("increase --segments or reduce --modes");
    assert!(!said.contains("--degree"), "{said}");
}
