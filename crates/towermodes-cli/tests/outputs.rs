//! What is written: whole or not at all, in the format of its ending, with nothing ignored.

use crate::program::{Folder, root, run};
use std::fs;

use std::path::Path;
use std::process::{Command, Output, Stdio};
use towermodes_testing::{Says, arguments, rows};

use crate::sandbox::PROGRAM;

#[track_caller]
fn refused(arguments: &[&str], words: &str) {
    let output = run(arguments);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    assert!(said.contains(words), "{arguments:?}: {said}");
}

impl Folder {
    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("the folder");
        let names = entries.map(|entry| entry.expect("an entry").file_name());
        let mut names: Vec<String> = names.map(|n| n.to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }
}

const TOWER: &str = "examples/reference-tower.toml";

/// Every command that writes a file, with the file's name; each result is larger than a disk of
/// [`DISK`].
const WRITERS: [(&[&str], &str); 9] = [
    (&["solve", TOWER], "out.json"),
    (
        &["solve", TOWER, "--points", "11", "--format", "bmodes"],
        "out.out",
    ),
    (
        &[
            "compare",
            TOWER,
            "--modes",
            "4",
            "--segments",
            "9,10,11,12,13",
        ],
        "out.json",
    ),
    (
        &["converge", TOWER, "--segments", "4,5,6,7,8,9,10"],
        "out.json",
    ),
    (&["campbell", TOWER, "--rpm", "6,12"], "out.json"),
    (&["report", TOWER], "out.html"),
    (&["plot", TOWER], "out.svg"),
    (&["convert", "examples/nrel-5mw.yaml"], "out.bmi"),
    (&["elastodyn", "tower", TOWER], "out.dat"),
];

/// Bytes of the disk that is full: two blocks of 512 bytes.
const DISK: usize = 1024;

/// Runs a writer where no file may be longer than [`DISK`]: either the write fails as on a full
/// disk, or the process is killed in it.
#[cfg(unix)]
fn on_a_small_disk(arguments: &[&str], is_killed: bool) -> Output {
    let trap = if is_killed { "" } else { "trap '' XFSZ; " };
    let script = format!("{trap}ulimit -f 2; exec \"$0\" \"$@\"");
    Command::new("sh")
        .current_dir(root())
        .args(["-c", &script, PROGRAM])
        .args(arguments)
        .stdin(Stdio::null())
        .output()
        .expect("a shell")
}

#[cfg(unix)]
#[test]
fn a_full_disk_or_a_killed_process_leaves_the_old_file() {
    let folder = Folder::new("full-disk");
    for (arguments, name) in WRITERS {
        let path = folder.path(name);
        let arguments = [arguments, &["--output", &path]].concat();
        for is_killed in [false, true] {
            folder.write(name, "old");
            folder.write("out_sections.dat", "old");
            let output = on_a_small_disk(&arguments, is_killed);
            assert!(!output.status.success(), "{arguments:?}: {output:?}");
            assert_eq!(folder.text(name), "old", "{arguments:?}");
            assert_eq!(folder.text("out_sections.dat"), "old", "{arguments:?}");
            if !is_killed {
                assert_eq!(output.status.code(), Some(1), "{arguments:?}: {output:?}");
                let said = String::from_utf8_lossy(&output.stderr).into_owned();
                said.says(name);
                let left = folder.names();
                assert!(left.iter().all(|n| !n.ends_with(".tmp")), "{left:?}");
            }
            // What a killed process leaves does not stand in the way of the next one.
            let output = run(&arguments);
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            assert!(output.status.code() != Some(2), "{said}");
            assert!(!said.contains("os error"), "{said}");
            assert!(folder.text(name).len() > DISK, "{arguments:?}");
            fs::remove_dir_all(&folder.0).expect("ours");
            fs::create_dir_all(&folder.0).expect("a folder");
        }
    }
}

/// Both files of a BModes deck, or neither; nothing that is left of a broken conversion blocks the
/// next.
#[cfg(unix)]
#[test]
fn a_deck_of_two_files_is_written_together() {
    let folder = Folder::new("pair");
    let deck = folder.path("out.bmi");
    let arguments = ["convert", "examples/nrel-5mw.yaml", "--output", &deck];
    assert_eq!(on_a_small_disk(&arguments, false).status.code(), Some(1));
    assert!(folder.names().is_empty(), "{:?}", folder.names());
    assert!(run(&arguments).status.success());
    // The sections of a deck that is lost are this program's: they are written anew.
    fs::remove_file(folder.0.join("out.bmi")).expect("ours");
    assert!(run(&arguments).status.success());
    assert_eq!(folder.names(), ["out.bmi", "out_sections.dat"]);
    // Those of somebody else are not.
    fs::remove_file(folder.0.join("out.bmi")).expect("ours");
    folder.write("out_sections.dat", "mine");
    let output = run(&arguments);
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(folder.text("out_sections.dat"), "mine");
    let line = ["convert", TOWER, "--to", "bmodes", "--output", "-"];
    refused(&line, "consists of two files");
    let output = run(&["convert", TOWER, "--to", "bmodes", "--output", "/dev/null"]);
    assert_eq!(output.status.code(), Some(1), "{output:?}");
}

/// A deck and its sections are of one tower, whoever comes last.
#[test]
fn twenty_writers_at_once_leave_one_whole_result() {
    let folder = Folder::new("twenty");
    let towers = ["examples/nrel-5mw.toml", "examples/nrel-5mw-table.toml"];
    for (ending, companion) in [("json", None), ("bmi", Some("out_sections.dat"))] {
        let name = format!("out.{ending}");
        let path = folder.path(&name);
        let command = |tower: &str| -> Vec<String> {
            let verb = if ending == "bmi" { "convert" } else { "solve" };
            [verb, tower, "--output", &path].map(str::to_owned).to_vec()
        };
        let written = |folder: &Folder| {
            let second = companion.map(|companion| folder.text(companion));
            (folder.text(&name), second)
        };
        let expected = towers.map(|tower| {
            let words = command(tower);
            let words: Vec<&str> = words.iter().map(String::as_str).collect();
            assert!(run(&words).status.success());
            written(&folder)
        });
        assert_ne!(expected[0], expected[1]);
        let writers: Vec<_> = (0..20)
            .map(|i| {
                let mut process = Command::new(PROGRAM);
                process.current_dir(root()).args(command(towers[i % 2]));
                process.stderr(Stdio::null()).spawn().expect("it runs")
            })
            .collect();
        for mut writer in writers {
            assert!(writer.wait().expect("it ends").success());
        }
        assert!(expected.contains(&written(&folder)), "{name}");
    }
    let left = folder.names();
    assert_eq!(left, ["out.bmi", "out.json", "out_sections.dat"]);
}

/// Killed at any time: the old result or the new one.
#[cfg(unix)]
#[test]
fn a_writer_that_is_killed_leaves_the_old_or_the_new_file() {
    let folder = Folder::new("killed");
    let path = folder.path("out.json");
    let arguments = ["solve", TOWER, "--points", "20000", "--output", &path];
    assert!(run(&arguments).status.success());
    let new = folder.text("out.json");
    for step in 0..12 {
        folder.write("out.json", "old");
        let mut command = Command::new(PROGRAM);
        command.current_dir(root()).args(arguments);
        let mut child = command.spawn().expect("the program runs");
        std::thread::sleep(std::time::Duration::from_millis(12 * step));
        child.kill().expect("killed");
        child.wait().expect("it ends");
        let left = folder.text("out.json");
        assert!(left == "old" || left == new, "{} bytes", left.len());
    }
}

#[cfg(unix)]
#[test]
fn links_and_permissions_stay() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = Folder::new("links");
    folder.write("real.csv", "old");
    let private = fs::Permissions::from_mode(0o600);
    fs::set_permissions(folder.0.join("real.csv"), private).expect("set");
    symlink("real.csv", folder.0.join("link.csv")).expect("a link");
    assert!(
        run(&["solve", TOWER, "--output", &folder.path("link.csv")])
            .status
            .success()
    );
    folder.text("real.csv").begins("number,");
    let link = fs::symlink_metadata(folder.0.join("link.csv")).expect("there");
    assert!(link.is_symlink());
    let mode = fs::metadata(folder.0.join("real.csv"))
        .expect("there")
        .permissions()
        .mode();
    assert_eq!(mode & 0o777, 0o600);
}

/// What is no file is written to as it is, and what stands in it already stays.
#[cfg(target_os = "linux")]
#[test]
fn streams_are_written_directly() {
    let folder = Folder::new("streams");
    assert!(
        run(&["solve", TOWER, "--output", "/dev/null"])
            .status
            .success()
    );
    let full = run(&["solve", TOWER, "--output", "/dev/full"]);
    assert_eq!(full.status.code(), Some(1));
    let out = folder.path("all.txt");
    let script = format!("(echo first; '{PROGRAM}' solve {TOWER} -f csv -o /dev/stdout) > {out}");
    let done = Command::new("sh")
        .current_dir(root())
        .args(["-c", &script])
        .status();
    assert!(done.expect("a shell").success());
    let text = folder.text("all.txt");
    text.begins("first\nnumber,");
    let piped = run(&["solve", TOWER, "-f", "csv", "-o", "/dev/stdout"]);
    assert_eq!(piped.stdout, text.as_bytes()["first\n".len()..]);
}

#[test]
fn the_ending_of_an_output_is_its_format() {
    let folder = Folder::new("endings");
    let written = |arguments: &[&str], name: &str| {
        let path = folder.path(name);
        let output = run(&[arguments, &["--output", &path]].concat());
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success(), "{arguments:?} {name}: {said}");
        folder.text(name)
    };
    let solve = ["solve", TOWER];
    assert!(written(&solve, "m.json").starts_with('{'));
    written(&solve, "m.csv").begins("number,");
    written(&solve, "m.TXT").begins("Reference tower");
    written(&solve, "m").begins("Reference tower");
    written(&["solve", TOWER, "--format", "csv"], "m.data").begins("number,");
    assert!(written(&["converge", TOWER, "--segments", "4,8"], "c.csv").contains(','));
    written(&["verify", "springs"], "v.md").says("|---");
    written(&["convert", TOWER], "t.toml").says("[tower]");
    written(&["convert", TOWER], "t.yaml").says("windIO");
    let table = r#"
        solve TOWER | m.pdf | use .json, .csv, .txt, or give --format
        solve TOWER --format csv | x.json | --format csv contradicts
        report TOWER | r.pdf | use .html, .htm, .md, .markdown, or give --format
        report TOWER --format md | r.html | which means html
        convert TOWER --to toml | t.bmi | which means bmodes
        convert TOWER | t | give --to toml
    "#;
    for [line, name, words] in rows(table) {
        let path = folder.path(name);
        let line = format!("{line} --output {path}").replace("TOWER", TOWER);
        refused(&arguments(&line), words);
        assert!(!Path::new(&path).exists());
    }
}

#[test]
fn options_that_would_do_nothing_are_refused() {
    let table = r#"
        solve TOWER --points 5 | --points applies only to
        solve TOWER --points 5 --format csv | --points applies only to
        solve examples/nrel-5mw.bmi --points 5 --format bmodes | element boundaries of the deck
        compare TOWER --methods rmje --hinges 0.2 | --hinges applies only to
        compare TOWER --methods spectral --segments 9 | --segments does not apply to
        convert TOWER --to toml --from-height 5 | --from-height applies only to
        plot TOWER --what tower --no-limits | does not solve the tower
    "#;
    for [line, words] in rows(table) {
        refused(&arguments(&line.replace("TOWER", TOWER)), words);
    }
    let output = run(&["solve", TOWER, "--no-rna"]);
    assert!(output.status.success());
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    said.says("--no-rna has no effect");
    let output = run(&["solve", "examples/nrel-5mw.toml", "--no-rna"]);
    assert!(output.stderr.is_empty(), "{output:?}");
}

/// Marks that turn the direction of writing could make a terminal show what is not there.
#[test]
fn names_send_no_marks_to_the_terminal() {
    let folder = Folder::new("marks");
    let text = fs::read_to_string(root().join(TOWER)).expect("the example");
    let text = text.replacen("name = \"", "name = \"\\u202Egpj.\\u001B[2J", 1);
    folder.write("t.toml", &text);
    let tower = folder.path("t.toml");
    let bad = |bytes: &[u8]| {
        let text = String::from_utf8_lossy(bytes).into_owned();
        text.contains('\u{202e}') || text.contains("\u{1b}[2J")
    };
    for arguments in [
        &["solve", &tower][..],
        &["compare", &tower, "--modes", "2", "--segments", "4"],
        &["check", &tower],
        &["elastodyn", "tower", &tower],
    ] {
        let output = run(arguments);
        assert!(output.status.success(), "{output:?}");
        assert!(!bad(&output.stderr), "{arguments:?}");
    }
    assert!(!bad(&run(&["solve", &tower]).stdout));
    // A file by such a name, and an unknown key.
    let odd = folder.path("\u{202e}x.toml");
    fs::write(&odd, text.replacen("density", "\"d\u{202e}nsity\"", 1)).expect("written");
    let output = run(&["solve", &odd]);
    assert_eq!(output.status.code(), Some(2));
    let holds = !bad(&output.stderr);
    assert!(holds, "{}", String::from_utf8_lossy(&output.stderr));
    let missing = run(&["solve", &folder.path("\u{202e}y.toml")]);
    assert!(!bad(&missing.stderr));
}

/// A result that nobody gets is a failure; one that is thrown away on purpose is none.
#[cfg(target_os = "linux")]
#[test]
fn a_closed_standard_output_is_a_failure() {
    let run = |end: &str| {
        let script = format!("'{PROGRAM}' solve {TOWER} --modes 2 {end}; echo $?");
        let mut shell = Command::new("sh");
        let output = shell.current_dir(root()).args(["-c", &script]).output();
        let output = output.expect("a shell");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        (String::from_utf8_lossy(&output.stdout).into_owned(), said)
    };
    let (code, said) = run(">&-");
    assert_eq!(code, "1\n");
    said.says("standard output: it is closed");
    assert_eq!(run("> /dev/null"), ("0\n".to_owned(), String::new()));
    // Inherited from a shell whose own output goes there.
    let (code, said) = run("< /dev/null > /dev/null");
    assert_eq!((code.as_str(), said.as_str()), ("0\n", ""));
    // Opened for both by another program.
    let null = fs::OpenOptions::new()
        .read(true)
        .write(true)
        .open("/dev/null");
    let mut command = Command::new(PROGRAM);
    command.current_dir(root()).args(["solve", TOWER]);
    let done = command.stdout(null.expect("a device")).status();
    assert!(done.expect("it runs").success());
}
