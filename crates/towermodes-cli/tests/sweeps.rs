//! Sweeps into folders that are killed, interrupted, run twice at once, or run out of disk:
//! afterwards every row is there once, and nothing is half-written.

#![cfg(unix)]

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use crate::pages::root;
use crate::sandbox::PROGRAM;

const ROWS: usize = 6000;
const PART: usize = 200;

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
             [sweep.results]\nrows_per_part = {PART}\nmodes = 2\n"
        );
        fs::write(self.0.join("study.toml"), text).expect("written");
    }

    fn command(&self, output: &str, more: &[&str]) -> Command {
        let mut command = Command::new(PROGRAM);
        command
            .current_dir(&self.0)
            .args(["sweep", "study.toml", "--format", "csv", "--output", output])
            .args(more)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        command
    }

    #[track_caller]
    fn done(&self, output: &str, more: &[&str]) -> Output {
        let done = self
            .command(output, more)
            .output()
            .expect("the program runs");
        let said = String::from_utf8_lossy(&done.stderr);
        assert!(done.status.success(), "{said}");
        done
    }

    fn started(&self, output: &str) -> Child {
        let mut command = with_ctrl_c(&self.command(output, &["--threads", "1"]));
        command.stdout(Stdio::null()).stderr(Stdio::null());
        command.spawn().expect("the program runs")
    }

    /// The files of a folder of results by name.
    fn files(&self, output: &str) -> BTreeMap<String, Vec<u8>> {
        let entries = fs::read_dir(self.0.join(output)).expect("the folder");
        let file = |entry: std::io::Result<fs::DirEntry>| {
            let path = entry.expect("an entry").path();
            let name = path
                .file_name()
                .expect("a name")
                .to_string_lossy()
                .into_owned();
            (name, fs::read(path).expect("a file"))
        };
        entries.map(file).collect()
    }

    fn parts(&self, output: &str) -> usize {
        let Ok(entries) = fs::read_dir(self.0.join(output)) else {
            return 0;
        };
        let names = entries.flatten().map(|entry| entry.file_name());
        names
            .filter(|name| name.to_string_lossy().starts_with("part-"))
            .count()
    }

    /// Waits until a run has written a number of parts.
    #[track_caller]
    fn wait_for_parts(&self, output: &str, parts: usize, run: &mut Child) {
        let begun = Instant::now();
        while self.parts(output) < parts {
            assert!(
                begun.elapsed() < Duration::from_secs(60),
                "no parts are written"
            );
            assert!(
                run.try_wait().expect("a process").is_none(),
                "the run has ended"
            );
            thread::sleep(Duration::from_millis(2));
        }
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

impl Folder {
    /// Starts a run and ends it by a signal after its first parts; returns what it left. On a busy
    /// machine a run can end before the signal comes: then there is another.
    #[track_caller]
    fn killed(&self, output: &str, name: &str) -> BTreeMap<String, Vec<u8>> {
        const ATTEMPTS: usize = 50;
        for _ in 0..ATTEMPTS {
            let _ = fs::remove_dir_all(self.0.join(output));
            let mut run = self.started(output);
            while self.parts(output) < 3 && run.try_wait().expect("a process").is_none() {
                thread::sleep(Duration::from_millis(1));
            }
            // The program `kill` sends it as a user or a scheduler does.
            let id = run.id().to_string();
            // There may be no such process any more.
            let _ = Command::new("kill")
                .args([name, &id])
                .stderr(Stdio::null())
                .status();
            let ended = run.wait().expect("a process");
            let left = self.files(output);
            if left.contains_key("_SUCCESS") || ended.code() == Some(0) {
                continue;
            }
            // No exit code: the help says that the signal ends the program.
            assert!(
                ended.code().is_none() && ended.signal().is_some(),
                "{ended}"
            );
            return left;
        }
        panic!("{name}: each of {ATTEMPTS} runs ended before the signal");
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Every row once, in whole parts, and nothing besides.
#[track_caller]
fn check_complete(files: &BTreeMap<String, Vec<u8>>, rows: usize) {
    assert!(files.contains_key("_SUCCESS") && files.contains_key("_sweep.json"));
    let temporary = files.keys().find(|name| name.ends_with(".tmp"));
    assert_eq!(temporary, None);
    let parts = files.iter().filter(|(name, _)| name.starts_with("part-"));
    let mut next = 0;
    for (name, content) in parts {
        let text = std::str::from_utf8(content).expect("text");
        for line in text.lines().skip(1) {
            let row = line.split(',').next().expect("a cell");
            assert_eq!(row, next.to_string(), "{name}");
            next += 1;
        }
    }
    assert_eq!(next, rows);
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
    assert!(
        said.contains("a column changes a number of the RNA"),
        "{said}"
    );
    let study = fs::read_to_string(folder.0.join("study.toml")).expect("the study");
    let without = format!("{study}[sweep.reading]\nno_rna = true\n");
    fs::write(folder.0.join("study.toml"), without).expect("written");
    let done = folder
        .command("results", &[])
        .output()
        .expect("the program runs");
    let said = String::from_utf8_lossy(&done.stderr);
    assert_eq!(done.status.code(), Some(2), "{said}");
    assert!(said.contains("[sweep.reading] no_rna"), "{said}");
}

#[test]
fn a_killed_sweep_continues_and_has_the_same_bytes() {
    let folder = Folder::new("killed");
    folder.done("whole", &[]);
    let whole = folder.files("whole");
    check_complete(&whole, ROWS);
    for name in ["-KILL", "-INT", "-TERM"] {
        let output = format!("results{name}");
        let left = folder.killed(&output, name);
        // What is there is whole.
        for (part, content) in left.iter().filter(|(part, _)| part.starts_with("part-")) {
            assert_eq!(Some(content), whole.get(part), "{name}: {part}");
        }
        folder.done(&output, &[]);
        assert!(folder.files(&output) == whole, "{name}");
    }
}

#[test]
fn threads_shares_and_simultaneous_runs_give_the_same_bytes() {
    let folder = Folder::new("same");
    folder.done("whole", &["--threads", "1"]);
    let whole = folder.files("whole");
    check_complete(&whole, ROWS);
    folder.done("threads", &["--threads", "3"]);
    assert!(folder.files("threads") == whole);
    for share in ["2/3", "0/3"] {
        let done = folder.done("shares", &["--shard", share]);
        let said = String::from_utf8_lossy(&done.stderr).into_owned();
        assert!(said.contains("other shards are missing"), "{said}");
    }
    assert!(!folder.files("shares").contains_key("_SUCCESS"));
    folder.done("shares", &["--shard", "1/3"]);
    assert!(folder.files("shares") == whole);
    let mut runs = [folder.started("both"), folder.started("both")];
    for run in &mut runs {
        assert!(run.wait().expect("a process").success());
    }
    assert!(folder.files("both") == whole);
}

#[test]
fn another_sweep_is_refused_and_nothing_is_changed() {
    let folder = Folder::new("other");
    folder.write_study(400, 1);
    folder.done("results", &[]);
    let before = folder.files("results");
    folder.write_study(400, 2);
    let refused = folder
        .command("results", &[])
        .output()
        .expect("the program runs");
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert_eq!(refused.status.code(), Some(2), "{said}");
    assert!(
        said.contains("another sweep") && said.contains("--force"),
        "{said}"
    );
    assert!(folder.files("results") == before);
    folder.done("results", &["--force"]);
    check_complete(&folder.files("results"), 400);
}

/// Files cannot become longer than two blocks: as on a full disk a write fails.
#[test]
fn a_write_that_fails_ends_the_sweep_and_the_next_run_continues() {
    let folder = Folder::new("limit");
    folder.write_study(400, 1);
    // The plan is there, so that the first file that does not fit is a part.
    let mut run = folder.started("results");
    folder.wait_for_parts("results", 1, &mut run);
    let _ = run.wait();
    for name in folder
        .files("results")
        .keys()
        .filter(|name| *name != "_sweep.json")
    {
        fs::remove_file(folder.0.join("results").join(name)).expect("removed");
    }
    let script = "trap '' XFSZ; ulimit -f 2; exec \"$0\" \"$@\"";
    let failed = Command::new("sh")
        .current_dir(&folder.0)
        .args([
            "-c",
            script,
            PROGRAM,
            "sweep",
            "study.toml",
            "--format",
            "csv",
        ])
        .args(["--output", "results"])
        .output()
        .expect("a shell");
    let said = String::from_utf8_lossy(&failed.stderr).into_owned();
    assert_eq!(failed.status.code(), Some(1), "{said}");
    assert!(said.contains("results/part-0000"), "{said}");
    assert_eq!(folder.parts("results"), 0);
    folder.done("results", &[]);
    check_complete(&folder.files("results"), 400);
}

/// A disk of its own that is smaller than the results; only root can have one.
#[test]
fn a_full_disk_ends_the_sweep_and_the_next_run_continues() {
    let folder = Folder::new("disk");
    folder.write_study(2000, 1);
    let disk = folder.0.join("disk");
    fs::create_dir_all(&disk).expect("a folder");
    let Some(_mounted) = Mounted::new(&disk, "100k") else {
        eprintln!("skipped: a file system of the test's own cannot be mounted");
        return;
    };
    let failed = folder
        .command("disk/results", &[])
        .output()
        .expect("the program runs");
    let said = String::from_utf8_lossy(&failed.stderr).into_owned();
    assert_eq!(failed.status.code(), Some(1), "{said}");
    assert!(
        said.contains("disk/results/") && said.contains("No space left"),
        "{said}"
    );
    // What is there is whole.
    for (name, content) in folder.files("disk/results") {
        let lines = content.iter().filter(|byte| **byte == b'\n').count();
        assert!(
            !name.starts_with("part-") || lines == PART + 1,
            "{name}: {lines} lines"
        );
    }
    let grown = Command::new("mount")
        .args(["-o", "remount,size=20m"])
        .arg(&disk)
        .status();
    assert!(grown.expect("mount").success());
    folder.done("disk/results", &[]);
    check_complete(&folder.files("disk/results"), 2000);
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
fn pictures_of_a_sweep_are_written() {
    let folder = Folder::new("picture");
    folder.write_study(400, 1);
    folder.done("results", &["--plot", "curves.svg"]);
    let curves = fs::read_to_string(folder.0.join("curves.svg")).expect("a picture");
    assert!(curves.contains("rna.mass (kg)") && curves.contains("1st fore-aft bending"));
    // The folder is complete: only the picture is made.
    folder.done("results", &["--plot", "curves.png"]);
    let picture = fs::read(folder.0.join("curves.png")).expect("a picture");
    assert!(picture.starts_with(b"\x89PNG"));
}

/// A path of a picture that cannot be written is refused before anything is computed.
#[test]
fn a_picture_that_cannot_be_written_is_refused_first() {
    let folder = Folder::new("no-picture");
    for (path, code, words) in [
        ("curves.pdf", 2, "FILE.svg or FILE.png"),
        ("curves", 2, "FILE.svg or FILE.png"),
        ("missing/curves.svg", 1, "the folder missing does not exist"),
    ] {
        let refused = folder.command("results", &["--plot", path]).output();
        let refused = refused.expect("the program runs");
        let said = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert_eq!(refused.status.code(), Some(code), "{said}");
        assert!(said.contains(words), "{said}");
        assert!(!folder.0.join("results/_sweep.json").exists(), "{path}");
    }
    // The folder of the results need not exist.
    folder.write_study(2, 1);
    folder.done("results", &["--plot", "results/curves.svg"]);
    assert!(folder.0.join("results/curves.svg").is_file());
}

/// A part that another program removes during the run is not taken for that of another shard.
#[test]
fn a_part_that_is_lost_during_the_run_is_an_error() {
    let folder = Folder::new("lost");
    let mut command = folder.command("results", &["--threads", "1"]);
    let mut run = command.spawn().expect("the program runs");
    folder.wait_for_parts("results", 3, &mut run);
    fs::remove_file(folder.0.join("results/part-00000.csv")).expect("removed");
    let done = run.wait_with_output().expect("a process");
    let said = String::from_utf8_lossy(&done.stderr).into_owned();
    assert_eq!(done.status.code(), Some(1), "{said}");
    assert!(said.contains("part-00000.csv is missing"), "{said}");
    assert!(!folder.files("results").contains_key("_SUCCESS"));
    folder.done("results", &[]);
    check_complete(&folder.files("results"), ROWS);
}

/// Options of readers that contradict the tower or `--set` have the names of the study's keys.
#[test]
fn reading_options_of_a_study_are_checked_under_their_names() {
    let folder = Folder::new("reading");
    let study = fs::read_to_string(folder.0.join("study.toml")).expect("the study");
    for (key, set, words) in [
        (
            "tower_height = 80.0",
            "rna.center[2]=2",
            "[sweep.reading] tower_height applies only",
        ),
        (
            "no_rna = true",
            "rna.center[2]=2",
            "contradicts [sweep.reading] no_rna;",
        ),
        (
            "no_gravity = false",
            "rna.mass=3e5",
            "the column `rna.mass` sets rna.mass in each row",
        ),
    ] {
        let text = format!("{study}[sweep.reading]\n{key}\n");
        fs::write(folder.0.join("study.toml"), text).expect("written");
        let refused = folder.command("results", &["--set", set]).output();
        let refused = refused.expect("the program runs");
        let said = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert_eq!(refused.status.code(), Some(2), "{said}");
        assert!(said.contains(words), "{said}");
    }
}

/// Hints name options that `sweep` has.
#[test]
fn a_hint_names_options_of_the_command() {
    let folder = Folder::new("hint");
    let refused = folder.command("results", &["--modes", "5000"]).output();
    let said = String::from_utf8_lossy(&refused.expect("the program runs").stderr).into_owned();
    assert!(
        said.contains("increase --segments or reduce --modes"),
        "{said}"
    );
    assert!(!said.contains("--degree"), "{said}");
}
