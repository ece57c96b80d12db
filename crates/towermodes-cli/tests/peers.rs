//! Files of other programs, and what these programs say of them. They are not in this repository:
//! the tests run where `TOWERMODES_PEER_DATA` names a folder with them, and say so where it does
//! not.

use std::path::{Path, PathBuf};

use std::process::{Command, Output};
use towermodes_testing::{Close, Says, arguments};

/// The folder with the files of other programs, if there is one.
fn data() -> Option<PathBuf> {
    let folder = std::env::var_os("TOWERMODES_PEER_DATA").map(PathBuf::from);
    if folder.is_none() {
        eprintln!("skipped: TOWERMODES_PEER_DATA names no folder with files of other programs");
    }
    // The test runs in the folder of its crate, the variable is set in that of the repository.
    folder.map(|folder| match folder.is_absolute() {
        true => folder,
        false => Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../..")
            .join(folder),
    })
}

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_towermodes"))
        .args(arguments)
        .output()
        .expect("the program runs")
}

/// What a run prints that must succeed.
#[track_caller]
fn printed(arguments: &[&str]) -> String {
    let output = run(arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments:?}: {said}");
    String::from_utf8(output.stdout).expect("text")
}

fn path(folder: &Path, file: &str) -> String {
    let path = folder.join(file);
    assert!(path.is_file(), "{} is missing", path.display());
    path.display().to_string()
}

/// The frequencies in the CSV of a solution.
fn frequencies(arguments: &[&str]) -> Vec<f64> {
    let mut all = vec!["solve"];
    all.extend(arguments);
    all.extend(["--format", "csv"]);
    let csv = printed(&all);
    let column = csv
        .lines()
        .next()
        .expect("a header")
        .split(',')
        .position(|c| c == "frequency_hz");
    let column = column.expect("a column of frequencies");
    let rows = csv.lines().skip(1);
    rows.map(|row| {
        row.split(',')
            .nth(column)
            .expect("a frequency")
            .parse()
            .expect("a number")
    })
    .collect()
}

/// A mode of a file in the layout of BModes: its frequency, and its shape without the places.
struct PrintedMode {
    frequency_hz: f64,
    shape: Vec<f64>,
}

fn modes_of(out: &str) -> Vec<PrintedMode> {
    let mut modes: Vec<PrintedMode> = Vec::new();
    for line in out.lines() {
        if let Some((_, rest)) = line.split_once("(freq =") {
            let number = rest.trim_end().trim_end_matches("Hz)").trim();
            modes.push(PrintedMode {
                frequency_hz: number.parse().expect("a frequency"),
                shape: Vec::new(),
            });
        }
        let numbers: Result<Vec<f64>, _> = line.split_whitespace().map(str::parse).collect();
        if let (Ok(numbers), Some(mode)) = (numbers, modes.last_mut())
            && numbers.len() == 6
        {
            mode.shape.extend(&numbers[1..]);
        }
    }
    modes
}

fn mac(a: &[f64], b: &[f64]) -> f64 {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    dot(a, b).powi(2) / (dot(a, a) * dot(b, b))
}

/// Half a unit of the fifth digit.
fn half_a_digit(value: f64) -> f64 {
    0.5 * 10_f64.powf(value.log10().floor() + 1.0 - 5.0)
}

/// The four cases that are distributed with BModes: every printed frequency, and every shape up to
/// sign and scale.
#[test]
fn the_cases_of_bmodes_come_out() {
    let Some(data) = data() else { return };
    let cases = [
        "Test01_nonunif_blade",
        "Test02_blade_with_tip_mass",
        "Test03_tower",
        "Test04_wires_supported_tower",
    ];
    for case in cases {
        let deck = path(&data, &format!("bmodes/{case}.bmi"));
        let out = printed(&["solve", &deck, "--bmodes-quirks", "--format", "bmodes"]);
        let stored = std::fs::read(path(&data, &format!("bmodes/{case}.out"))).expect("read");
        let (ours, theirs) = (modes_of(&out), modes_of(&String::from_utf8_lossy(&stored)));
        assert_eq!((ours.len(), theirs.len()), (20, 20), "{case}");
        for (number, (ours, theirs)) in (1..).zip(ours.iter().zip(&theirs)) {
            let (f, g) = (ours.frequency_hz, theirs.frequency_hz);
            let holds = (f - g).abs() <= 2e-5 * g + half_a_digit(g);
            assert!(holds, "{case} mode {number}: {f} {g}");
            assert_eq!(ours.shape.len(), theirs.shape.len(), "{case} mode {number}");
            // BModes prints no motion along the axis: axial modes are tables of zeros.
            let moves = |shape: &[f64]| shape.iter().any(|x| *x != 0.0);
            let expected = moves(&theirs.shape);
            assert_eq!(moves(&ours.shape), expected, "{case} mode {number}");
            if moves(&ours.shape) {
                let mac = mac(&ours.shape, &theirs.shape);
                assert!(mac > 0.99999, "{case} mode {number}: MAC {mac}");
            }
        }
    }
}

#[track_caller]
fn assert_printed(ours: &[f64], theirs: &[f64], tolerance: f64) {
    for (ours, theirs) in ours.iter().zip(theirs) {
        let allowed = tolerance * theirs + half_a_digit(*theirs);
        assert!((ours - theirs).abs() <= allowed, "{ours} and {theirs}");
    }
    assert!(ours.len() >= theirs.len());
}

/// Offshore decks as the later BModes_JJ, which has no fault in the tower-top offsets, is quoted;
/// surge and sway to one unit of the last digit, where that program's own rounding is.
#[test]
fn offshore_decks_come_out() {
    let Some(data) = data() else { return };
    let monopile = frequencies(&[&path(&data, "bmodes/CS_Monopile.bmi")]);
    assert_printed(&monopile, &[0.24230, 0.24383, 1.32077, 1.36900], 2e-5);
    let spar = frequencies(&[&path(&data, "bmodes/OC3Hywind.bmi")]);
    let quoted = [
        0.0081183, 0.0081184, 0.032428, 0.039312, 0.039327, 0.12051, 0.481579, 0.490754, 1.56969,
    ];
    assert_printed(&spar, &quoted, 2e-5);
}

/// The same decks by the published BModes 3.00 with its faults; its dense solver is good to 1e-5
/// here.
#[test]
fn offshore_decks_come_out_with_quirks() {
    let Some(data) = data() else { return };
    let quirks = |deck: &str| frequencies(&[&path(&data, deck), "--bmodes-quirks"]);
    let stock = [
        0.248685, 0.250358, 1.322280, 1.374683, 1.543951, 2.780839, 3.124484, 6.039262,
    ];
    assert_printed(&quirks("bmodes/CS_Monopile.bmi"), &stock, 2e-5);
    let stock = [
        0.00811834, 0.00811835, 0.0324282, 0.0394686, 0.0394887, 0.120241, 0.499688, 0.508739,
        1.559644, 2.020863,
    ];
    assert_printed(&quirks("bmodes/OC3Hywind.bmi"), &stock, 2e-5);
}

/// The NREL 5 MW turbine on land: published first frequencies are 0.312 to 0.324 Hz (Jonkman et al.
/// 2009).
#[test]
fn the_nrel_5mw_deck_comes_out() {
    let Some(data) = data() else { return };
    let file = "openfast/nrel5mw_land_deck/NRELOffshrBsline5MW_Onshore_ElastoDyn.dat";
    let deck = path(&data, file);
    let found = frequencies(&[&deck]);
    let holds = found[..2].iter().all(|f| (0.31..0.345).contains(f));
    assert!(holds, "{found:?}");
    let table = printed(&["solve", &deck]);
    table.says("± error");
    table.says("buckling load factor ");
    // By an independent Ritz solution of the eleven rows with a locked rotor; weights take 1.8 %
    // off.
    let weightless = frequencies(&[&deck, "--no-gravity"]);
    assert!((weightless[0] - 0.3198).abs() < 5e-5, "{weightless:?}");
    assert!((found[0] / weightless[0] - 0.982).abs() < 1e-3, "{found:?}");
    // Rotor and generator turn with the nacelle, or by themselves.
    let free = frequencies(&[&deck, "--no-gravity", "--rotor", "free"]);
    assert!(free[1] > 1.01 * weightless[0], "{free:?}");
    // The tower alone, an Euler-Bernoulli beam of the eleven rows.
    let bare = frequencies(&[&deck, "--no-rna", "--no-gravity", "--method", "spectral"]);
    assert_printed(&[bare[0], bare[2]], &[0.89145, 4.37505], 1e-6);
}

/// A copy of a deck, to be written to.
struct Copied {
    folder: PathBuf,
}

impl Copied {
    fn of(data: &Path, name: &str) -> Self {
        let folder =
            std::env::temp_dir().join(format!("towermodes-peers-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        for entry in std::fs::read_dir(data.join("openfast/nrel5mw_land_deck")).expect("the deck") {
            let from = entry.expect("an entry").path();
            let text = std::fs::read(&from).expect("read");
            std::fs::write(folder.join(from.file_name().expect("a name")), text).expect("written");
        }
        Self { folder }
    }

    fn main(&self) -> String {
        let main = self
            .folder
            .join("NRELOffshrBsline5MW_Onshore_ElastoDyn.dat");
        main.display().to_string()
    }

    fn tower(&self) -> String {
        let tower = self.folder.join("NRELOffshrBsline5MW_Tower.dat");
        std::fs::read_to_string(tower).expect("the tower file")
    }
}

impl Drop for Copied {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

#[test]
fn a_deck_is_patched_and_nothing_else_changes() {
    let Some(data) = data() else { return };
    let copied = Copied::of(&data, "patch");
    let (deck, before) = (copied.main(), copied.tower());
    // Second modes of a tower whose top hardly moves: the coefficients shipped are not those of
    // this machine.
    let judged = run(&["elastodyn", "validate", &deck]);
    assert_eq!(judged.status.code(), Some(1));
    for dry in ["--dry-run", "--diff"] {
        printed(&["elastodyn", "patch", &deck, dry]).says("TwFAM2Sh(6)");
        assert_eq!(copied.tower(), before);
    }
    printed(&["elastodyn", "patch", &deck, "--backup"]);
    let after = copied.tower();
    let backup = copied.folder.join("NRELOffshrBsline5MW_Tower.dat.bak");
    assert_eq!(std::fs::read_to_string(backup).expect("the backup"), before);
    assert_eq!(before.lines().count(), after.lines().count());
    for (before, after) in before.split('\n').zip(after.split('\n')) {
        let is_coefficient = before.contains("M1Sh(") || before.contains("M2Sh(");
        if is_coefficient {
            let rest = |line: &str| {
                line.trim_start()
                    .split_once(' ')
                    .map(|(_, rest)| rest.trim_start().to_owned())
            };
            assert_eq!(rest(before), rest(after));
        } else {
            assert_eq!(before, after);
        }
    }
    // What was written is the tower's own, and stays.
    printed(&["elastodyn", "validate", &deck]);
    printed(&["elastodyn", "patch", &deck]);
    assert_eq!(copied.tower(), after);
}

/// The tower of the IEA 15 MW turbine from two versions of windIO, from OpenFAST and from HAWC2.
/// Its first frequencies, clamped without a machine, by an independent transfer-matrix program from
/// the rows of the OpenFAST file: 0.77459 and 3.25575 Hz (Euler-Bernoulli).
#[test]
fn the_iea_15mw_tower_is_one_in_every_file() {
    let Some(data) = data() else { return };
    let yaml = |file: &str| {
        let file = path(&data, file);
        let line = format!("{file} --part tower --no-rna --no-rotary-inertia --method spectral");
        frequencies(&arguments(&line))
    };
    let folder = "openfast/iea15_monopile";
    let main = path(
        &data,
        &format!("{folder}/IEA-15-240-RWT-Monopile_ElastoDyn.dat"),
    );
    let deck = frequencies(&[&main, "--no-rna", "--no-gravity", "--method", "spectral"]);
    assert!((deck[0] / 0.77459 - 1.0).abs() < 1e-4 && (deck[2] / 3.25575 - 1.0).abs() < 1e-4);
    for found in [
        yaml("windio/v1/IEA-15-240-RWT.yaml"),
        yaml("windio/v2/IEA-15-240-RWT.yaml"),
        yaml(&format!("{folder}/IEA-15-240-RWT.yaml")),
    ] {
        found[0].close_to(deck[0], 5e-3);
        found[2].close_to(deck[2], 5e-3);
    }
    let st = path(&data, &format!("{folder}/IEA_15MW_RWT_Tower_st.dat"));
    printed(&["check", &main, &st, "--no-rna", "--tower-base", "15"]);
    let v1 = path(&data, "windio/v1/IEA-15-240-RWT.yaml");
    // Smooth walls in one file and steps in the other: by height they differ, as a whole they do
    // not.
    let said = run(&arguments(&format!(
        "check {v1} {main} --no-rna --part tower --format json"
    )));
    assert_eq!(said.status.code(), Some(1));
    let said = String::from_utf8(said.stdout).expect("text");
    let checked: serde_json::Value = serde_json::from_str(&said).expect("JSON");
    let mass = checked["mass_kg"]["difference"]
        .as_f64()
        .expect("a difference");
    assert!(mass.abs() < 5e-3, "{mass}");
}

/// Files with an anchor that is defined again, and with several parts.
#[test]
fn every_windio_file_is_read() {
    let Some(data) = data() else { return };
    for file in [
        "openfast/iea10/IEA-10-198-RWT.yaml",
        "openfast/iea15_monopile/IEA-15-240-RWT.yaml",
        "openfast/nrel5mw_land/nrel5mw.yaml",
        "openfast/nrel5mw_oc3hywind/nrel5mw-spar_oc3.yaml",
        "windio/v1/IEA-15-240-RWT.yaml",
        "windio/v2/IEA-15-240-RWT.yaml",
    ] {
        let found = frequencies(&[&path(&data, file), "--part", "tower"]);
        assert!(found[0] > 0.1 && found[0] < 2.0, "{file}: {found:?}");
    }
}
