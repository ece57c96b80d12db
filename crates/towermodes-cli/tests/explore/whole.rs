//! Answers beyond the modes of a tower: the whole turbine, soil, damping, a target, another file.
//! They are those of the other commands.

use std::path::PathBuf;

use serde_json::{Value, json};
use towermodes_testing::Says;

use super::answers::{json_of, same_rows};
use super::server::Explorer;
use crate::pages::root;
use crate::program::run;

const TURBINES: [&str; 2] = [
    "examples/nrel-5mw-turbine.toml",
    "examples/small-turbine/ElastoDyn.dat",
];

/// The words of a text without its line breaks.
fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Verdict, rows and conclusion are those of `campbell` at as many speeds, also for a changed
/// number.
#[test]
fn the_diagram_of_a_turbine_is_that_of_campbell() {
    for (file, name, value) in [
        (TURBINES[0], "stations[0].wall", 0.04),
        (TURBINES[1], "tower.outfitting_factor", 1.1),
    ] {
        let explorer = Explorer::start(&[file]);
        let set = format!("{name}={value}");
        let commands: [(Value, Vec<&str>); 2] = [
            (json!({}), Vec::new()),
            (json!({ name: value }), vec!["--set", &set]),
        ];
        for (numbers, options) in commands {
            let arguments = [&["campbell", file, "--speeds", "15"], &options[..]].concat();
            let answer = explorer.answer("coupled", &json!({ "numbers": numbers }));
            assert_eq!(answer["refused"], Value::Null);
            let campbell = json_of(&arguments);
            same_rows(&answer["resonance"], &campbell);
            let count = campbell["speeds"].as_array().map(Vec::len);
            assert_eq!(answer["speeds"].as_u64(), count.map(|count| count as u64));
            let printed = run(&arguments).stdout;
            let printed = words(&String::from_utf8(printed).expect("text"));
            let conclusion = answer["resonance"]["conclusion"].as_array();
            let first = &conclusion.expect("sentences")[0];
            printed.says(&words(first.as_str().expect("a sentence")));
        }
    }
}

/// The modes at the speed of the slider are those of the diagram there.
#[test]
fn the_modes_at_a_rotor_speed_are_those_of_the_diagram() {
    let file = TURBINES[0];
    let explorer = Explorer::start(&[file]);
    let campbell = json_of(&["campbell", file]);
    for rpm in [0.0, 12.1] {
        let answer = explorer.answer("whirl", &json!({ "numbers": {}, "rpm": rpm }));
        let modes = answer["modes"].as_array().expect("modes");
        assert_eq!(
            answer["scene"]["modes"].as_array().map(Vec::len),
            Some(modes.len())
        );
        let curves = campbell["curves"].as_array().expect("curves").iter();
        let points = curves.flat_map(|curve| curve["points"].as_array().expect("points"));
        let there = points.filter(|point| point["rotor_speed_rpm"].as_f64() == Some(rpm));
        let mut compared = 0;
        for point in there {
            let named = modes.iter().find(|mode| mode["name"] == point["label"]);
            let Some(mode) = named else { continue };
            let [own, low, high] = [
                &mode["frequency_hz"],
                &point["lower_hz"],
                &point["upper_hz"],
            ]
            .map(|value| value.as_f64().expect("a number"));
            // Both are within bounds of about the same width.
            let width = (high - low).max(1e-9 * own);
            let holds = low - width <= own && own <= high + width;
            assert!(holds, "{point}: {own}");
            compared += 1;
        }
        // The tower with a rigid rotor has the modes of the tower, and none of the blades.
        for mode in modes {
            let name = mode["name"].as_str().expect("a name");
            let is_of_tower = name.contains("tower");
            assert_eq!(mode["tower_mode"].is_object(), is_of_tower, "{name}");
        }
        assert!(compared >= 10, "{rpm} rpm: {compared}");
    }
}

#[test]
fn a_tower_has_no_turbine_and_a_clamped_one_no_soil() {
    let explorer = Explorer::start(&["examples/nrel-5mw.toml"]);
    let refused = |what: &str| {
        let answer = explorer.answer(what, &json!({ "numbers": {} }));
        answer["refused"]["message"]
            .as_str()
            .expect("a message")
            .to_owned()
    };
    refused("coupled").says("no turbine with flexible blades");
    refused("band").says("the tower has no soil");
    let sheet = explorer.ask("GET", "sheet", b"");
    let sheet: Value = serde_json::from_slice(&sheet.body).expect("JSON");
    assert_eq!([&sheet["has_turbine"], &sheet["has_soil"]], [false, false]);
}

#[test]
fn the_soil_band_is_that_of_campbell() {
    let file = "examples/monopile-layers.toml";
    let explorer = Explorer::start(&[file]);
    let answer = explorer.answer("band", &json!({ "numbers": {} }));
    let campbell = json_of(&["campbell", file]);
    let band = &campbell["soil_band"];
    assert_eq!(answer["factors"], band["factors"]);
    let modes = band["modes"].as_array().expect("modes");
    assert!(modes.len() >= 4);
    for (own, mode) in answer["modes"].as_array().expect("modes").iter().zip(modes) {
        assert_eq!(own["label"], mode["label"]);
        for (own, at) in own["at"]
            .as_array()
            .expect("values")
            .iter()
            .zip(mode["at"].as_array().expect("values"))
        {
            assert_eq!(own["frequency_hz"], at["frequency_hz"]);
            assert_eq!(own["verdict"], at["verdict"]);
        }
    }
}

fn folder() -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("explore-whole");
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// A tower with a loss factor has the damping of `damping`; without one it has none.
#[test]
fn damping_is_that_of_the_command() {
    let plain = std::fs::read_to_string(root().join("examples/nrel-5mw.toml")).expect("a file");
    let path = folder().join("damped.toml");
    std::fs::write(&path, plain + "\n[damping]\ntower_loss_factor = 0.004\n").expect("written");
    let path = path.to_string_lossy().into_owned();
    let explorer = Explorer::start(&[&path, "--modes", "4"]);
    let answer = explorer.answer("solve", &json!({ "numbers": {} }));
    let damping = json_of(&["damping", &path, "--modes", "4"]);
    for (own, theirs) in answer["modes"]
        .as_array()
        .expect("modes")
        .iter()
        .zip(damping["modes"].as_array().expect("modes"))
    {
        let [own, theirs] = [&own["damping"]["ratio"], &theirs["damping_ratio"]];
        let [own, theirs] = [own, theirs].map(|ratio| ratio.as_f64().expect("a ratio"));
        assert!((own - theirs).abs() < 1e-12, "{own} {theirs}");
        // Half the loss factor where the tower has all of the energy.
        assert!((own - 0.002).abs() < 2e-4, "{own}");
    }
    let without = Explorer::start(&["examples/nrel-5mw.toml"]);
    let answer = without.answer("solve", &json!({ "numbers": {} }));
    assert_eq!(answer["modes"][0]["damping"], Value::Null);
}

/// The numbers that a target gives are a tower that meets it; a target that no tower meets is
/// refused in words.
#[test]
fn a_target_is_met_by_its_numbers() {
    let file = "examples/nrel-5mw.toml";
    let explorer = Explorer::start(&[file]);
    let question = |min_hz: f64| {
        json!({
            "numbers": { "rna.mass": 3.6e5 }, "mode": "fore-aft 1", "min_hz": min_hz, "max_hz": null,
            "variables": [{ "name": "scale(stations[*].wall)", "low": 0.5, "high": 1.5 }],
        })
    };
    let found = explorer.answer("target", &question(0.33));
    assert_eq!(found["refused"], Value::Null, "{found}");
    assert_eq!(found["numbers"]["rna.mass"], 3.6e5);
    let state = json!({ "numbers": found["numbers"] });
    let solved = explorer.answer("solve", &state);
    let hz = solved["modes"].as_array().expect("modes").iter();
    let mut own = hz.filter(|mode| mode["label"] == "1st fore-aft bending");
    let hz = own.next().and_then(|mode| mode["frequency_hz"].as_f64());
    // The lightest tower is at the limit.
    let hz = hz.expect("a frequency");
    assert!((hz - 0.33).abs() < 1e-5, "{hz}");
    found["sentences"][0]
        .as_str()
        .expect("a sentence")
        .says_all("fore-aft 1 & Hz");
    let refused = explorer.answer("target", &question(3.0));
    let message = refused["refused"]["message"].as_str().expect("a message");
    message.says_all("no tower was found that meets & fore-aft 1 & 3 Hz");
    explorer.is_well();
}

/// The tower to compare with is solved as its own file.
#[test]
fn another_file_is_solved_as_itself() {
    let (file, other) = ("examples/monopile.toml", "examples/monopile-layers.toml");
    let explorer = Explorer::start(&[file, "--against", other]);
    let sheet = explorer.ask("GET", "sheet", b"");
    let sheet: Value = serde_json::from_slice(&sheet.body).expect("JSON");
    assert_eq!(sheet["against"]["file"], other);
    sheet["command"]
        .as_str()
        .expect("a command")
        .says("--against examples/monopile-layers.toml");
    let answer = explorer.answer("solve", &json!({ "numbers": {}, "is_of_other": true }));
    let names = sheet["against"]["names"].as_array().expect("names");
    assert_eq!(answer["values"].as_array().map(Vec::len), Some(names.len()));
    let own = answer["modes"].as_array().expect("modes");
    let solved = json_of(&["solve", other, "--modes", "6"]);
    for (own, mode) in own.iter().zip(solved["modes"].as_array().expect("modes")) {
        let [own, theirs] = [own, mode].map(|mode| mode["frequency_hz"].as_f64().expect("Hz"));
        assert!((own - theirs).abs() < 1e-9 * theirs, "{own} {theirs}");
    }
    // What cannot be read is said before the page opens.
    let done = run(&["explore", file, "--against", "examples/nothing.toml"]);
    assert_eq!(done.status.code(), Some(2));
}
