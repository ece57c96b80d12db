//! What files say of a rotor: where it is used, where it is handed on, and what is said of it.

use crate::program::{Folder, root, run, texts};
use std::fs;

use towermodes_testing::{Says, arguments};

/// Standard output and standard error.
#[track_caller]
fn said(arguments: &[&str]) -> [String; 2] {
    let output = run(arguments);
    let [out, err] =
        [output.stdout, output.stderr].map(|text| String::from_utf8(text).expect("text"));
    assert!(output.status.success(), "{arguments:?}: {err}");
    [out, err]
}

impl Folder {
    /// The example deck with parts of lines of its main file replaced.
    fn with_main_file(name: &str, changes: &[(&str, &str)]) -> Self {
        let folder = Self::new(name);
        let example = root().join("examples/small-turbine");
        for file in ["Blade.dat", "Tower.dat"] {
            fs::copy(example.join(file), folder.0.join(file)).expect("copied");
        }
        let mut text = fs::read_to_string(example.join("ElastoDyn.dat")).expect("the example");
        for (from, to) in changes {
            text.says(from);
            text = text.replace(from, to);
        }
        fs::write(folder.0.join("ElastoDyn.dat"), text).expect("written");
        folder
    }

    /// The 5 MW machine in windIO without the number of its blades, and with a speed that is a
    /// limit.
    fn with_windio(name: &str) -> Self {
        let folder = Self::new(name);
        let text = fs::read_to_string(root().join("examples/nrel-5mw.yaml")).expect("the example");
        let blades = "assembly:\n  number_of_blades: 3\n";
        text.says(blades);
        let rated = "  rated_rotor_speed: 12.1\n";
        let text = text
            .replace(blades, "")
            .replace(rated, &format!("{rated}  max_rotor_speed: 14\n"));
        fs::write(folder.0.join("turbine.yaml"), text).expect("written");
        folder
    }
}

/// A deck whose simulation begins at standstill still knows its blades.
#[test]
fn blades_are_known_without_a_speed() {
    let changes = [
        ("17.0   RotSpeed", "0.0   RotSpeed"),
        ("3   NumBl", "2   NumBl"),
    ];
    let folder = Folder::with_main_file("two-blades", &changes);
    let deck = folder.path("ElastoDyn.dat");
    let [out, err] = said(&["campbell", &deck, "--rpm", "7,9", "--modes", "2"]);
    out.says("2 blades at 7 to 9 rpm");
    assert!(!err.contains("the number of blades is not given"), "{err}");
    let [out, _] = said(&arguments(&format!(
        "campbell {deck} --rpm 7,9 --modes 2 --blades 4"
    )));
    out.says("4 blades at 7 to 9 rpm");
}

#[test]
fn a_number_of_blades_that_is_given_is_not_guessed() {
    let folder = Folder::with_windio("no-blades");
    let file = folder.path("turbine.yaml");
    let guess = "no number_of_blades: 3 is assumed";
    let campbell = ["campbell", &file, "--modes", "2", "--multiples", "1"];
    said(&campbell)[1].says(guess);
    let given = [&campbell[..], &["--blades", "2"]].concat();
    assert!(!said(&given)[1].contains(guess));
}

/// What was guessed of a rotor is said where it becomes a fact, and only there.
#[test]
fn conversions_say_how_the_rotor_was_found() {
    let folder = Folder::with_main_file("converted", &[]);
    let deck = folder.path("ElastoDyn.dat");
    for to in ["toml", "windio", "elastodyn"] {
        let [_, err] = said(&["convert", &deck, "--to", to]);
        // The speed of the start is handed on to nothing, nor are blades.
        assert!(!err.contains("RotSpeed"), "{to}: {err}");
        assert!(!err.contains("PreCone"), "{to}: {err}");
    }
    let folder = Folder::with_windio("guessed");
    let [_, err] = said(&["convert", &folder.path("turbine.yaml"), "--to", "toml"]);
    err.says("max_rotor_speed = 14 rpm is a protection limit");
    err.says("no number_of_blades: 3 is assumed");
}

/// A simulation may begin at any speed, at standstill too: that is no range of operation, and
/// without one nothing is checked. The diagram is there all the same.
#[test]
fn the_speed_of_the_start_is_no_range_of_operation() {
    for speed in ["17.0", "1.5", "0.0"] {
        let row = format!("{speed}   RotSpeed");
        let folder = Folder::with_main_file("start", &[("17.0   RotSpeed", &row)]);
        let deck = folder.path("ElastoDyn.dat");
        for uncoupled in [true, false] {
            let command = ["campbell", &deck, "--speeds", "3"];
            let rigid = ["campbell", &deck, "--uncoupled", "--modes", "2"];
            let command = if uncoupled { &rigid[..] } else { &command };
            let output = run(command);
            let [out, err] = texts(&output);
            assert_eq!(output.status.code(), Some(1), "{out}{err}");
            out.says_all("Not checked: operating speeds unknown. & crosses 1P at");
            out.says("3 blades, operating speeds unknown | not checked");
            for word in ["PASS", "FAIL", "soft-stiff", "No pair"] {
                assert!(!out.contains(word), "{word}: {out}");
            }
            err.says("is the initial speed of the simulation");
            err.says_all("error: not checked: operating speeds unknown & --rpm LOWEST,HIGHEST");
        }
        // With speeds there are verdicts.
        let command = [
            "campbell",
            &deck,
            "--uncoupled",
            "--modes",
            "2",
            "--rpm",
            "9,17",
        ];
        let [out, err] = texts(&run(&command));
        out.says(" fail");
        assert!(!err.contains("RotSpeed"), "{err}");
    }
}

/// Each reason without verdicts has its help at once.
#[test]
fn what_verdicts_need_is_named_at_once() {
    let folder = Folder::new("needs");
    let path = folder.path("tower.toml");
    let text = fs::read_to_string(root().join("examples/nrel-5mw.toml")).expect("the example");
    let start = text.find("[rotor]").expect("a rotor");
    let after = text[start + 1..]
        .find("\n[")
        .map_or(text.len(), |at| start + 1 + at);
    let text = format!("{}{}", &text[..start], &text[after..]);
    for (parts, needs_structure) in [
        ("missing_parts = [\"nacelle\", \"hub\"]\n", true),
        ("", false),
    ] {
        fs::write(&path, format!("{parts}{text}")).expect("a file");
        for (rpm, needs_speeds) in [(None, true), (Some("--rpm=6.9,12.1"), false)] {
            let command: Vec<&str> = ["campbell", &path].into_iter().chain(rpm).collect();
            let output = run(&command);
            let [out, err] = texts(&output);
            let found = err.contains("give a file that describes the whole structure");
            assert_eq!(found, needs_structure, "{err}");
            let found = err.contains("give --rpm LOWEST,HIGHEST");
            assert_eq!(found, needs_speeds, "{err}");
            let mark = "the mass of the nacelle and the hub is not in this model";
            assert_eq!(out.contains(mark), needs_structure, "{out}");
        }
    }
}

/// The CSV of a turbine has a line for each point of the JSON, with energies that sum to 1.
#[test]
fn the_curves_of_a_turbine_are_the_same_in_csv_and_json() {
    let command = arguments("campbell examples/nrel-5mw-turbine.toml --speeds 3");
    let written = |format| said(&[&command[..], &["--format", format]].concat())[0].clone();
    let json: serde_json::Value = serde_json::from_str(&written("json")).expect("JSON");
    let curves = json["curves"].as_array().expect("curves").iter();
    let points = curves.flat_map(|curve| curve["points"].as_array().expect("points"));
    let points: Vec<&serde_json::Value> = points.collect();
    let csv = written("csv");
    let mut lines = csv
        .lines()
        .map(|line| line.split(',').collect::<Vec<&str>>());
    let header = lines.next().expect("a header");
    let column = |name: &str| header.iter().position(|own| *own == name).expect(name);
    let rows: Vec<Vec<&str>> = lines.collect();
    assert_eq!(rows.len(), points.len());
    for (row, point) in rows.iter().zip(points) {
        let number = |at: usize| row[at].parse::<f64>().expect("a number");
        for key in ["rotor_speed_rpm", "frequency_hz", "lower_hz", "upper_hz"] {
            assert_eq!(number(column(key)), point[key].as_f64().expect(key));
        }
        let energies = column("tower_fore_aft")..column("not_checked");
        let standing = |at: &usize| header[*at].ends_with("_tilt") || header[*at].ends_with("_yaw");
        let sum: f64 = energies.filter(|at| !standing(at)).map(number).sum();
        assert!((sum - 1.0).abs() < 1e-12, "{sum}");
    }
    assert_eq!(json["is_certified"], true);
}
