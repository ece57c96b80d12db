//! The answers of the explorer are those of the other commands, digit by digit.

use crate::program::run;

use serde_json::{Value, json};
use towermodes_testing::Says;

use super::server::Explorer;

/// A tower of every format, and every kind of tower.
const TOWERS: [&str; 11] = [
    "examples/floating.toml",
    "examples/guyed.toml",
    "examples/monopile.toml",
    "examples/monopile-layers.toml",
    "examples/nrel-5mw-table.toml",
    "examples/nrel-5mw-turbine.toml",
    "examples/nrel-5mw.bmi",
    "examples/nrel-5mw.toml",
    "examples/nrel-5mw.yaml",
    "examples/reference-tower.toml",
    "examples/small-turbine/ElastoDyn.dat",
];

/// The result of a command in JSON.
#[track_caller]
pub fn json_of(arguments: &[&str]) -> Value {
    let done = run(&[arguments, &["--format", "json"]].concat());
    let said = String::from_utf8_lossy(&done.stderr);
    serde_json::from_slice(&done.stdout).unwrap_or_else(|_| panic!("{arguments:?}: {said}"))
}

/// The frequencies of a list of modes, Hz.
pub fn frequencies_hz(modes: &Value) -> Vec<f64> {
    let modes = modes.as_array().expect("modes").iter();
    modes
        .map(|mode| mode["frequency_hz"].as_f64().expect("a number"))
        .collect()
}

/// The first number of a tower that every tower has: a property of its material or section.
pub fn changed(sheet: &Value) -> (String, f64) {
    let parameters = sheet["parameters"].as_array().expect("parameters");
    let is_one = |of: &&Value| {
        let name = of["name"].as_str().unwrap_or_default();
        name.ends_with("youngs_modulus") || name.ends_with("[0].ei_fore_aft_n_m2")
    };
    let one = parameters.iter().find(is_one).expect("a stiffness");
    let value = one["value"].as_f64().expect("a number");
    (
        one["name"].as_str().expect("a name").to_owned(),
        1.1 * value,
    )
}

#[test]
fn frequencies_are_those_of_solve() {
    for tower in TOWERS {
        let explorer = Explorer::start(&[tower, "--modes", "6"]);
        let sheet: Value =
            serde_json::from_slice(&explorer.ask("GET", "sheet", b"").body).expect("JSON");
        let (name, value) = changed(&sheet);
        let set = format!("{name}={value:e}");
        let commands: [(Value, &[&str]); 2] =
            [(json!({}), &[]), (json!({ name: value }), &["--set", &set])];
        for (numbers, options) in commands {
            let answer = explorer.answer("solve", &json!({ "numbers": numbers }));
            let solved = json_of(&[&["solve", tower, "--modes", "6"], options].concat());
            let own = frequencies_hz(&answer["modes"]);
            assert_eq!(own, frequencies_hz(&solved["modes"]), "{tower} {options:?}");
            let parts = ["discretization_error_hz", "algebraic_error_hz"];
            let part_hz = parts.map(|part| solved["modes"][0][part].as_f64());
            let error_hz: f64 = part_hz.iter().flatten().sum();
            let found = answer["modes"][0]["error_hz"].as_f64();
            assert_eq!(found, Some(error_hz), "{tower}");
        }
    }
}

/// The page shows what the terminal shows.
#[test]
fn texts_are_those_of_the_terminal() {
    let tower = "examples/monopile.toml";
    let explorer = Explorer::start(&[tower]);
    let answer = explorer.answer("solve", &json!({ "numbers": { "rna.mass": 3.6e5 } }));
    let table = run(&["solve", tower, "--set", "rna.mass=360000"]).stdout;
    let table = String::from_utf8(table).expect("text");
    let text = |value: &Value| value.as_str().expect("a text").to_owned();
    for mode in answer["modes"].as_array().expect("modes") {
        let line = format!(" {}  ", text(&mode["shape"]));
        let line = table.lines().find(|of| of.contains(&line)).expect("a line");
        let words: Vec<&str> = line.split_whitespace().collect();
        assert!(words.contains(&text(&mode["frequency"]).as_str()), "{line}");
        assert!(words.contains(&text(&mode["error"]).as_str()), "{line}");
    }
    assert!(table.contains(&text(&answer["certificate"])));
    assert!(table.contains(&text(&answer["method"])));
    let facts = answer["facts"].as_array().expect("facts");
    let buckling = facts
        .iter()
        .find(|fact| fact["key"] == "buckling_load_factor");
    let buckling = text(&buckling.expect("with gravity")["text"]);
    table.says(&format!("buckling load factor {buckling}"));
}

#[test]
fn verdicts_are_those_of_campbell() {
    let tower = "examples/monopile.toml";
    let explorer = Explorer::start(&[tower, "--rpm", "5,9", "--margin", "10"]);
    let answer = explorer.answer("solve", &json!({ "numbers": {} }));
    let campbell = json_of(&["campbell", tower, "--rpm", "5,9", "--margin", "10"]);
    assert_eq!(answer["resonance"]["word"], campbell["verdict"]);
    for mode in answer["modes"].as_array().expect("modes") {
        let number = &mode["number"];
        let margins = campbell["margins"].as_array().expect("margins").iter();
        let line =
            |margin: &Value| &campbell["lines"][margin["line"].as_u64().unwrap_or(0) as usize];
        let own = margins.filter(|margin| line(margin)["number"] == *number);
        let rank = |word: &str| ["pass", "warn", "fail"].iter().position(|one| *one == word);
        let worst = own
            .filter_map(|margin| rank(margin["verdict"].as_str()?))
            .max();
        let shown = rank(mode["verdict"]["word"].as_str().expect("a word"));
        assert_eq!(shown, worst, "mode {number}");
    }
    same_rows(&answer["resonance"], &campbell);
}

/// The rows of a page are those of `campbell`, number by number.
#[track_caller]
pub fn same_rows(resonance: &Value, campbell: &Value) {
    assert_eq!(resonance["word"], campbell["verdict"]);
    let rows = resonance["rows"].as_array().expect("rows");
    let margins = campbell["margins"].as_array().expect("margins");
    assert_eq!(rows.len(), margins.len());
    for (row, margin) in rows.iter().zip(margins) {
        for key in [
            "label",
            "multiple",
            "nearest_rpm",
            "excitation_hz",
            "natural_hz",
            "distance",
            "verdict",
        ] {
            assert_eq!(row[key], margin[key], "{key} of {row}");
        }
    }
}

/// What no tower can have is answered with the numbers concerned; the other answers go on.
#[test]
fn refusals_name_their_numbers() {
    let explorer = Explorer::start(&["examples/monopile.toml"]);
    let refused = |numbers: Value| {
        let answer = explorer.answer("solve", &json!({ "numbers": numbers }));
        let refused = &answer["refused"];
        let message = refused["message"].as_str().expect("a message").to_owned();
        (
            message,
            refused["parameters"].clone(),
            refused["hint"].clone(),
        )
    };
    let (message, parameters, _) = refused(json!({ "stations[1].wall": -0.01 }));
    message.says("wall thickness is -0.01 m; it must be positive");
    assert_eq!(parameters, json!(["stations[1].wall"]));
    let (message, parameters, _) = refused(json!({ "material.youngs_modulus": 0.0 }));
    message.says("Young's modulus");
    assert_eq!(parameters, json!(["material.youngs_modulus"]));
    let (message, _, hint) = refused(json!({ "rna.mass": 1e8 }));
    message.says("buckle");
    hint.as_str().expect("a hint").says("reduce the mass");
    let (message, ..) = refused(json!({ "rna.mas": 1.0 }));
    message.says("did you mean `rna.mass`?");
    // The lowest speed above the highest.
    let (message, parameters, _) = refused(json!({ "rotor.rpm[0]": 20.0 }));
    let holds = !parameters.as_array().expect("names").is_empty();
    assert!(holds, "{message}");
    explorer.is_well();
}

/// The names of the sheet are those of `parameters`, except those of the assembly of a turbine, and
/// each value is between its ends.
#[test]
fn sliders_are_the_numbers_of_the_tower() {
    for tower in TOWERS {
        let explorer = Explorer::start(&[tower]);
        let sheet = explorer.ask("GET", "sheet", b"");
        let sheet: Value = serde_json::from_slice(&sheet.body).expect("JSON");
        let listed = json_of(&["parameters", tower]);
        let names = |list: &Value, key: &str| -> Vec<(String, f64)> {
            let list = list.as_array().expect("a list").iter();
            let pair = |one: &Value| {
                let value = one[key].as_f64().unwrap_or(f64::INFINITY);
                (one["name"].as_str().expect("a name").to_owned(), value)
            };
            list.map(pair).collect()
        };
        let own = names(&sheet["parameters"], "value");
        let mut listed = names(&listed["parameters"], "value");
        // The assembly of a turbine follows from its parts.
        let is_turbine = tower.contains("turbine");
        listed.retain(|(name, _)| !(is_turbine && name.starts_with("rna.")));
        assert_eq!(own, listed, "{tower}");
        for one in sheet["parameters"].as_array().expect("parameters") {
            let ends = ["low", "value", "high"].map(|key| one[key].as_f64());
            let [Some(low), Some(value), Some(high)] = ends else {
                continue;
            };
            assert!(low <= value, "{tower}: {one}");
            assert!(value <= high, "{tower}: {one}");
            assert!(low < high, "{tower}: {one}");
        }
    }
}

#[test]
fn elasticities_are_those_of_sensitivities() {
    let tower = "examples/nrel-5mw.toml";
    let explorer = Explorer::start(&[tower]);
    let question = json!({ "numbers": { "rna.mass": 3.6e5 }, "mode": 1 });
    let answer = explorer.answer("elasticities", &question);
    let command = json_of(&["sensitivities", tower, "--set", "rna.mass=360000"]);
    let mut compared = 0;
    for number in command["numbers"].as_array().expect("numbers") {
        let name = number["name"].as_str().expect("a name");
        let own = answer["elasticities"][name].as_f64();
        let theirs = number["modes"][0]["percent_per_percent"].as_f64();
        if let (Some(own), Some(theirs)) = (own, theirs) {
            let scale = theirs.abs().max(1e-3);
            let holds = (own - theirs).abs() < 1e-6 * scale;
            assert!(holds, "{name}: {own} {theirs}");
            compared += 1;
        }
    }
    assert!(compared > 10, "{compared}");
}

/// A page asks for the numbers that it shows first; answers by name are those of all, and what has
/// no elasticity has a reason.
#[test]
fn elasticities_by_name_are_those_of_all() {
    let explorer = Explorer::start(&["examples/monopile-layers.toml"]);
    let all = explorer.answer("elasticities", &json!({ "numbers": {}, "mode": 1 }));
    assert_eq!(all["left"], json!([]));
    let names = [
        "ground.surface",
        "stations[*].wall",
        "ground.scour.local",
        "ground.layer[1].friction_angle",
    ];
    let question =
        json!({ "numbers": {}, "mode": 1, "label": "1st side-side bending", "names": names });
    let some = explorer.answer("elasticities", &question);
    assert_eq!(some["mode"], "1st side-side bending");
    assert_eq!(some["left"], json!([]));
    for (kind, name) in [
        ("elasticities", names[0]),
        ("elasticities", "ground.layer[0].top"),
        ("columns", names[1]),
    ] {
        let [own, theirs] = [&some, &all].map(|answer| answer[kind][name].as_f64());
        let (own, theirs) = (own.expect("a number"), theirs.expect("a number"));
        assert!((own - theirs).abs() < 1e-3 * theirs.abs(), "{name}: {own}");
    }
    // The derivative of the command, which has it with three digits: −0.718 % per m.
    assert_eq!(some["reasons"][names[2]]["short"], "−0.72 %/m");
    let text = some["reasons"][names[3]]["text"].as_str().expect("a text");
    text.says("for an increase and a decrease");
    let only = some["elasticities"].as_object().expect("numbers");
    assert_eq!(only.len(), 2, "{only:?}");
}

/// The elasticity of a factor on a whole column is that of `sensitivities`: that of the heights is
/// no sum over stations, whose percent are percent of the height of the tower, and rows of a step
/// move together. Where the heights of a tower in soil can be scaled in one direction only, there
/// is none.
#[test]
fn elasticities_of_columns_are_those_of_factors() {
    for (tower, height) in [
        ("examples/cans.toml", Some(-1.4924)),
        ("examples/nrel-5mw.toml", Some(-1.4924)),
        ("examples/monopile.toml", None),
        ("examples/guyed.toml", Some(-4.3111)),
    ] {
        let explorer = Explorer::start(&[tower]);
        let answer = explorer.answer("elasticities", &json!({ "numbers": {}, "mode": 1 }));
        let columns = &answer["columns"];
        let own = columns["stations[*].height"].as_f64();
        let is_known = own.is_some() == height.is_some();
        let off = own.zip(height).map_or(0.0, |(own, height)| own - height);
        assert!(is_known && off.abs() < 1e-4, "{tower}: {own:?}");
        let names = ["height", "diameter", "wall"].map(|key| format!("stations[*].{key}"));
        // Point masses keep their places on the tower.
        let has_masses = tower == "examples/monopile.toml";
        let factors = names
            .each_ref()
            .map(|name| match has_masses && name.ends_with("height") {
                true => format!("scale({name},point_mass[*].height)"),
                false => format!("scale({name})"),
            });
        let factors = factors.each_ref().map(String::as_str);
        let command = json_of(&[&["sensitivities", tower], &factors[..]].concat());
        for (name, number) in names
            .iter()
            .zip(command["numbers"].as_array().expect("numbers"))
        {
            let theirs = number["modes"][0]["percent_per_percent"].as_f64();
            let own = columns[name].as_f64();
            assert_eq!(own.is_some(), theirs.is_some(), "{tower}, {name}");
            let holds = own
                .zip(theirs)
                .is_none_or(|(own, theirs)| (own - theirs).abs() < 1e-6);
            assert!(holds, "{tower}, {name}: {own:?} {theirs:?}");
        }
    }
}

/// A file says what it lacks of the old one; where numbers are changed in the old text, nothing.
#[test]
fn towers_taken_away_say_what_they_lack() {
    let taken = |tower, numbers: Value| {
        let explorer = Explorer::start(&[tower]);
        let question = json!({ "numbers": numbers, "what": "tower" }).to_string();
        let file = explorer.ask("POST", "take", question.as_bytes()).text();
        let lines = explorer.answer("reproduce", &json!({ "numbers": numbers }));
        let sentences = lines["left_out"].as_array().expect("sentences").iter();
        let sentences = sentences.map(|one| one.as_str().expect("a sentence").to_owned());
        (file, sentences.collect::<Vec<_>>())
    };
    let wall = || json!({ "stations[0].wall": 0.04 });
    let (file, lacks) = taken("examples/nrel-5mw-turbine.toml", wall());
    assert_eq!(lacks, [""; 0]);
    file.says_all("[turbine.blade] & wall");
    // A page has no such slider, but an address may have the number.
    let (file, lacks) = taken(
        "examples/nrel-5mw-turbine.toml",
        json!({ "rna.mass": 3.6e5 }),
    );
    assert_eq!(lacks.len(), 2);
    lacks[0].begins("Comments of the old file are left out, because ");
    lacks[1].says("blades of the turbine are omitted");
    file.begins("# From examples/nrel-5mw-turbine.toml by towermodes explore.\n# Comments");
    file.says(&format!("\n# {}\n", lacks[1]));
    let (file, lacks) = taken("examples/nrel-5mw.bmi", json!({}));
    assert_eq!(
        lacks[0],
        "Comments of the old file are left out, because the old file is not TOML."
    );
    file.says(&lacks[0]);
}

/// The page solves a tower with a rigid rotor, and says so of a turbine.
#[test]
fn a_turbine_is_named_as_a_tower_with_a_rigid_rotor() {
    for (tower, is_turbine) in [
        ("examples/nrel-5mw-turbine.toml", true),
        ("examples/small-turbine/ElastoDyn.dat", true),
        ("examples/nrel-5mw.toml", false),
    ] {
        let explorer = Explorer::start(&[tower]);
        let answer = explorer.answer("solve", &json!({ "numbers": {} }));
        let method = answer["method"].as_str().expect("a text");
        assert_eq!(
            method.contains("the rotor is a rigid body"),
            is_turbine,
            "{method}"
        );
    }
}

pub fn stem(tower: &str) -> String {
    let stem = std::path::Path::new(tower).file_stem().expect("a name");
    stem.to_string_lossy().into_owned()
}

#[test]
fn reports_taken_away_are_those_of_report() {
    let tower = "examples/nrel-5mw.toml";
    let explorer = Explorer::start(&[tower, "--modes", "6"]);
    let question = json!({ "numbers": { "rna.mass": 3.6e5 }, "what": "report" });
    let taken = explorer.ask("POST", "take", question.to_string().as_bytes());
    let arguments = ["report", tower, "--modes", "6", "--set", "rna.mass=360000"];
    let written = run(&[&arguments[..], &["--output", "-"]].concat());
    // The last arguments are not those of the page.
    let written = String::from_utf8(written.stdout)
        .expect("text")
        .replace(" --output -", "");
    let taken = taken.text().replace("set by the page", "set by --set");
    let lines = |text: &str| text.lines().map(str::to_owned).collect::<Vec<_>>();
    let (taken, written) = (lines(&taken), lines(&written));
    let other: Vec<_> = taken.iter().zip(&written).filter(|(a, b)| a != b).collect();
    assert_eq!(taken.len(), written.len());
    // One note says what has set the number.
    assert!(other.len() <= 1, "{other:#?}");
}

#[test]
fn pictures_taken_away_are_pictures() {
    let explorer = Explorer::start(&["examples/nrel-5mw.toml"]);
    for what in ["tower-picture", "shapes-picture", "resonance-picture"] {
        for (format, start) in [("svg", &b"<svg"[..]), ("png", b"\x89PNG")] {
            let question = json!({ "numbers": {}, "what": what, "format": format });
            let taken = explorer.ask("POST", "take", question.to_string().as_bytes());
            assert_eq!(taken.status, 200, "{what}: {}", taken.text());
            assert!(taken.body.starts_with(start), "{what} {format}");
        }
    }
    let without = Explorer::start(&["examples/reference-tower.toml"]);
    let question = json!({ "numbers": {}, "what": "resonance-picture" }).to_string();
    let taken = without.ask("POST", "take", question.as_bytes());
    assert_eq!(taken.status, 409);
    taken.text().says("the rotor speed is unknown");
}

/// `stations[2]` is before `stations[10]`, as in the tower file.
#[test]
fn the_reproducing_commands_are_in_the_order_of_the_file() {
    let explorer = Explorer::start(&["examples/cans.toml"]);
    let names = ["stations[10].wall", "stations[2].wall", "rna.mass"];
    let numbers = json!({ names[0]: 0.021, names[1]: 0.026, names[2]: 3.4e5 });
    let shell = explorer.answer("reproduce", &json!({ "numbers": numbers }));
    let shell = shell["shell"].as_str().expect("text").to_owned();
    let first = shell.lines().next().expect("a line");
    first.ends(
        "--set 'stations[2].wall=0.026' --set 'stations[10].wall=0.021' --set rna.mass=340000",
    );
}

/// The command that the page shows gives the digits of the page; a factor of a whole column is one
/// setting.
#[test]
fn the_reproducing_commands_give_the_same_digits() {
    let tower = "examples/nrel-5mw.toml";
    let explorer = Explorer::start(&[tower]);
    let sheet: Value =
        serde_json::from_slice(&explorer.ask("GET", "sheet", b"").body).expect("JSON");
    let mut numbers = serde_json::Map::new();
    for one in sheet["parameters"].as_array().expect("parameters") {
        if one["column"] == "stations[*].wall" {
            let value = 1.1 * one["value"].as_f64().expect("a number");
            numbers.insert(
                one["name"].as_str().expect("a name").to_owned(),
                json!(value),
            );
        }
    }
    numbers.insert("rna.mass".to_owned(), json!(3.6e5));
    let question = json!({ "numbers": numbers });
    let shell = explorer.answer("reproduce", &question);
    let shell = shell["shell"].as_str().expect("text").to_owned();
    let first = shell.lines().next().expect("a line");
    let expected = format!(
        "towermodes solve {tower} --set 'scale(stations[*].wall)=1.1' --set rna.mass=360000"
    );
    assert_eq!(first, expected);
    let set = ["scale(stations[*].wall)=1.1", "rna.mass=360000"];
    let solved = json_of(&["solve", tower, "--set", set[0], "--set", set[1]]);
    let answer = explorer.answer("solve", &question);
    let own = frequencies_hz(&answer["modes"]);
    let count = own.len().min(8);
    assert_eq!(own[..count], frequencies_hz(&solved["modes"])[..count]);
}

/// Numbers that the command line sets are in the address: the page can put them back.
#[test]
fn numbers_that_are_set_are_in_the_address() {
    let set = ["--set", "rna.mass=360000", "--set", "stations[0].wall=0.04"];
    let explorer = Explorer::start(&[&["examples/nrel-5mw.toml"], &set[..]].concat());
    let (_, fragment) = explorer.address.split_once('#').expect("a fragment");
    assert_eq!(fragment, "rna.mass=360000&stations%5B0%5D.wall=0.04");
}
