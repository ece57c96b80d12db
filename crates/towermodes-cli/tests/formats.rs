//! What other programs read: JSON and CSV, standard input, files, pipes.

use crate::program::{Folder, blade, json, root, run as output, towermodes};
use std::io::{Read, Write};
use std::path::PathBuf;
use std::process::Stdio;

use serde_json::Value;
use towermodes::Mode;
use towermodes_files::{Cell, Column, MODE_COLUMNS, generated_schema_of};
use towermodes_testing::{Says, arguments, rows};
use towermodes_verify::Verification;

fn close(value: &Value, expected: f64, tolerance: f64) {
    let value = value.as_f64().expect("a number");
    let holds = (value / expected - 1.0).abs() < tolerance;
    assert!(holds, "{value} is not {expected}");
}

/// The frequency of the lowest mode of a solve with one number set.
fn lowest_hz(file: &str, setting: &str) -> f64 {
    let words = ["solve", file, "--method", "spectral", "--set", setting];
    let result = json(&[&words[..], &["--modes", "1", "--format", "json"]].concat());
    result["modes"][0]["frequency_hz"]
        .as_f64()
        .expect("a number")
}

#[test]
fn sensitivities_in_json_are_differences_of_solves() {
    let file = "examples/nrel-5mw.toml";
    let one = ["sensitivities", file, "rna.mass", "--format", "json"];
    let alone = json(&one);
    let together = json(&["solve", file, "--format", "json", "--sensitivities"]);
    let (low_hz, high_hz) = (
        lowest_hz(file, "rna.mass=349000"),
        lowest_hz(file, "rna.mass=351000"),
    );
    let expected = (high_hz - low_hz) / 2000.0;
    let numbers = together["sensitivities"]["numbers"]
        .as_array()
        .expect("a list");
    let mass = numbers.iter().find(|number| number["name"] == "rna.mass");
    for number in [&alone["numbers"][0], mass.expect("it is listed")] {
        assert_eq!(number["unit"], "kg");
        assert_eq!(number["percent_of"], "value");
        close(&number["modes"][0]["hz_per_unit"], expected, 1e-5);
        assert_eq!(number["mass_kg_per_unit"], 0.0);
    }
    let elasticity = expected * 350e3 / lowest_hz(file, "rna.mass=350000");
    close(
        &alone["numbers"][0]["modes"][0]["percent_per_percent"],
        elasticity,
        1e-5,
    );
    assert_eq!(alone["modes"].as_array().map(Vec::len), Some(4));
}

#[test]
fn json_has_the_documented_keys_and_values() {
    let file = "examples/reference-tower.toml";
    let line = format!("solve {file} --method rmje --segments 60 --format json");
    let result = json(&arguments(&line));
    assert_eq!(result["method"], "rmje");
    assert_eq!(result["segments"], 60);
    assert_eq!(result["degrees_of_freedom"], 360);
    assert_eq!(result["tower"]["name"], "Reference tower");
    close(&result["tower"]["height_m"], 87.6, 1e-15);
    close(&result["tower"]["mass_kg"], 267_586.067, 1e-8);
    assert_eq!(result["tower"]["top_mass_kg"], 0.0);
    let mode = &result["modes"][0];
    assert_eq!(mode["number"], 1);
    close(&mode["frequency_hz"], 0.89118235, 1e-8);
    close(&mode["period_s"], 1.0 / 0.89118235, 1e-8);
    assert_eq!(mode["family"], "fore-aft");
    assert_eq!(mode["order"], 1);
    assert_eq!(mode["label"], "1st fore-aft bending");
    close(&mode["extrapolated_hz"], 0.89126331, 1e-8);
    close(&mode["discretization_error_hz"], 8.5e-5, 0.01);
    assert!(
        mode["algebraic_error_hz"]
            .as_f64()
            .is_some_and(|error| error > 0.0 && error < 1e-13)
    );
    close(&mode["modal_mass_kg"], 47_136.8, 1e-5);
    assert!(mode["modal_inertia_kg_m2"].is_null());
    let certificate = &result["certificate"];
    assert_eq!(certificate["complete"], true);
    assert_eq!(certificate["count"], 8);
    assert!(
        certificate["below_hz"]
            .as_f64()
            .is_some_and(|hz| hz > 16.436 && hz < 21.31)
    );
    assert!(
        result["solver"]["products"]
            .as_u64()
            .is_some_and(|products| products < 130)
    );
    assert_eq!(result["solver"]["restarts"], 0);
    assert_eq!(result["warnings"], Value::Array(vec![]));
}

#[test]
fn json_gives_shapes_at_equal_heights_and_at_the_stations() {
    let file = "examples/nrel-5mw.toml";
    let result = json(&["solve", file, "--format", "json", "--points", "11"]);
    for mode in result["modes"].as_array().expect("modes") {
        for (shape, points) in [("shape", 11), ("station_shape", 2)] {
            for key in [
                "height_m",
                "x",
                "y",
                "z",
                "rotation_x",
                "rotation_y",
                "rotation_z",
            ] {
                let column = mode[shape][key].as_array().expect(key);
                assert_eq!(column.len(), points, "{shape}.{key}");
                if key != "height_m" {
                    assert_eq!(column[0], 0.0, "the base is clamped");
                }
            }
            close(&mode[shape]["height_m"][points - 1], 87.6, 1e-15);
        }
    }
    let torsion = &result["modes"][2];
    assert_eq!(torsion["family"], "torsion");
    assert_eq!(torsion["shape"]["rotation_z"][10], 1.0);
    assert!(torsion["modal_mass_kg"].is_null() && torsion["modal_inertia_kg_m2"].is_number());
    // A side-side mode leans towards +y at the top, which turns its sections about −x.
    let side = &result["modes"][0];
    assert_eq!(side["family"], "side-side");
    assert_eq!(side["shape"]["y"][10], 1.0);
    assert!(
        side["shape"]["rotation_x"][10]
            .as_f64()
            .is_some_and(|r| r < 0.0)
    );
}

/// Command lines of results by the names of their schemas. A result that is not listed is that of
/// its command with one tower.
const LINES: &str = "
    compare | compare examples/reference-tower.toml --modes 2
    converge | converge examples/reference-tower.toml --segments 4,8
    verify | verify paper
    solve-several | solve examples/nrel-5mw.toml examples/reference-tower.toml
    mooring | solve examples/spar_MoorDyn.dat
    substructure | solve examples/tripod_SubDyn.dat
    blade | solve BLADE
    design | design examples/nrel-5mw.toml crates/towermodes-cli/tests/inputs/design/mass.toml
    calibrate | calibrate examples/monopile.toml crates/towermodes-cli/tests/inputs/measured/pairing.toml
    first-order | sweep examples/studies/uncertainty.toml --first-order
    campbell | campbell examples/small-turbine/ElastoDyn.dat --rpm 9,17 --uncoupled
    campbell-turbine | campbell examples/nrel-5mw-turbine.toml
    check-one | check examples/nrel-5mw.toml
    check | check examples/nrel-5mw.toml examples/nrel-5mw.yaml
    validate | elastodyn validate examples/small-turbine/ElastoDyn.dat
";

/// `TOWERMODES_BLESS=1` writes the files again after a wanted change of a result.
#[test]
fn the_schemas_are_made_from_the_types_of_the_results() {
    let files = towermodes_files::RESULTS.iter().map(|kind| {
        let path = format!("crates/towermodes-files/schemas/{}.json", kind.name);
        (kind.name, path, kind.generated_schema())
    });
    let verification = generated_schema_of::<Verification>("towermodes verification", "verify");
    let path = "crates/towermodes-verify/schema.json".to_owned();
    for (name, path, generated) in files.chain([("verify", path, verification)]) {
        let generated = generated.expect("a schema");
        if std::env::var_os("TOWERMODES_BLESS").is_some() {
            std::fs::write(root().join(&path), &generated).expect("the file is written");
            continue;
        }
        let in_file = std::fs::read_to_string(root().join(&path)).expect("the schema");
        assert!(generated == in_file, "{path}: run with TOWERMODES_BLESS=1");
        let holds = output(&["schema", name]).stdout == in_file.as_bytes();
        assert!(holds, "{name}");
    }
}

/// The numbers of modes as properties of Python. `TOWERMODES_BLESS=1` writes the file again after a
/// change of `MODE_COLUMNS`.
#[test]
fn the_numbers_of_modes_in_python_are_those_of_the_columns() {
    let path = root().join("python/towermodes/_mode_columns.py");
    let expected = mode_columns();
    if std::env::var_os("TOWERMODES_BLESS").is_some() {
        std::fs::write(&path, &expected).expect("the file is written");
    }
    let in_file = std::fs::read_to_string(&path).expect("the file");
    assert!(in_file == expected, "run with TOWERMODES_BLESS=1");
}

/// The file with the properties.
fn mode_columns() -> String {
    let input = towermodes_files::read(
        &root().join("examples/nrel-5mw.toml"),
        &towermodes_files::ReadOptions::default(),
    );
    let Ok(towermodes_files::Input::Tower(input)) = input else {
        panic!("a tower");
    };
    let tower = input.tower().expect("a tower");
    let options = towermodes::Options::default();
    let modes = towermodes::solve(&tower, &options).expect("solved").modes;
    let is_number = |column: &&Column<Mode>| {
        let cell = (column.value)(&modes[0]);
        !column.key.contains('.') && matches!(cell, Cell::Number(_) | Cell::Small(_))
    };
    let (mut arrays, mut numbers) = (String::new(), String::new());
    for column in MODE_COLUMNS.iter().filter(is_number) {
        let (key, meaning) = (column.key, column.meaning);
        let meaning = meaning[..1].to_uppercase() + &meaning[1..];
        let unit = match column.unit {
            "" => String::new(),
            unit => format!(", {unit}"),
        };
        arrays += &format!(
            "\n    @property\n    def {key}(self) -> Array:\n        \"\"\"{meaning}{unit}: (modes,).\"\"\"\n        array: Array = self.column(\"{key}\")\n        return array\n"
        );
        numbers += &format!(
            "\n    @property\n    def {key}(self) -> float:\n        \"\"\"{meaning}{unit}.\"\"\"\n        return self._value(\"{key}\")\n"
        );
    }
    PYTHON
        .replace("    # arrays\n", arrays.trim_start_matches('\n'))
        .replace("    # numbers\n", numbers.trim_start_matches('\n'))
}

const PYTHON: &str =
    "# Made from the columns of modes by a test with TOWERMODES_BLESS=1; do not edit.
\"\"\"The numbers of modes.\"\"\"

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


class ModeArrays:
    \"\"\"The numbers of all modes of a solution as arrays.\"\"\"

    __slots__ = ()

    _core: Any

    def column(self, key: str) -> Any:
        \"\"\"A column of the CSV by its key, one value for each mode: an array, or a list of texts.

        Raises:
            KeyError: There is no such column.

        >>> import towermodes as tm
        >>> solution = tm.read(\"examples/nrel-5mw.toml\").solve(modes=2)
        >>> solution.column(\"label\")
        ['1st side-side bending', '1st fore-aft bending']
        >>> solution.column(\"energy.strain.fore_aft\").round(3)
        array([0., 1.])
        \"\"\"
        return self._core.column(key)

    # arrays


class ModeNumbers:
    \"\"\"The numbers of one mode.\"\"\"

    __slots__ = ()

    def _value(self, key: str) -> float:
        raise NotImplementedError

    # numbers
";

/// The keys of an object, in the order of the alphabet.
fn keys(value: &Value) -> Vec<String> {
    value
        .as_object()
        .expect("an object")
        .keys()
        .cloned()
        .collect()
}

/// Compares the keys of a value with its schema, and those of the objects inside it.
fn check_keys(value: &Value, schema: &Value, definitions: &Value, path: &str) {
    // What may be null is one of two schemas, of which the first has the keys.
    let schema = match schema["anyOf"].as_array() {
        Some(either) => &either[0],
        None => schema,
    };
    let named = schema["$ref"]
        .as_str()
        .and_then(|name| name.rsplit('/').next());
    let schema = named.map_or(schema, |name| &definitions[name]);
    match value {
        Value::Object(entries) => {
            assert_eq!(keys(&schema["properties"]), keys(value), "{path}");
            for (key, value) in entries {
                let path = format!("{path}.{key}");
                check_keys(value, &schema["properties"][key], definitions, &path);
            }
        }
        Value::Array(items) => {
            let of_items = &schema["items"];
            assert!(!of_items.is_null(), "{path}");
            items
                .iter()
                .for_each(|item| check_keys(item, of_items, definitions, path));
        }
        _ => {}
    }
}

#[test]
fn the_schemas_name_every_key() {
    let folder = Folder::new("blade-schema");
    let blade = blade(&folder);
    let lines: Vec<[&str; 2]> = rows(LINES).collect();
    let names = towermodes_files::RESULTS
        .iter()
        .map(|kind| (kind.name, kind.command));
    for (name, command) in names.chain([("verify", "verify")]) {
        let line = lines.iter().find(|[of, _]| *of == name);
        let with_tower = || format!("{command} examples/reference-tower.toml");
        let line = line.map_or_else(with_tower, |[_, line]| line.replace("BLADE", &blade));
        let schema = json(&["schema", name]);
        let result = output(&arguments(&format!("{line} --format json")));
        let result = serde_json::from_slice(&result.stdout);
        let result: Value = result.unwrap_or_else(|error| {
            panic!("`{line}` gives no JSON ({error}): write a command line that gives `{name}` into LINES")
        });
        check_keys(&result, &schema, &schema["$defs"], name);
    }
}

#[test]
fn a_comparison_has_a_column_for_each_method_and_number_of_segments() {
    let file = "examples/reference-tower.toml";
    let result = json(&["compare", file, "--segments", "20,60", "--format", "json"]);
    let methods = result["methods"].as_array().expect("a list");
    // Six methods with two numbers each, and the spectral beam once.
    assert_eq!(methods.len(), 13);
    let of = |name: &str, segments: usize| {
        let mut methods = methods.iter();
        methods
            .find(|m| m["method"] == name && m["segments"] == segments)
            .expect("a column")
    };
    close(&of("rmje", 60)["frequencies_hz"][0], 0.89118235, 1e-8);
    close(&of("lumped", 20)["frequencies_hz"][1], 4.3432510318, 1e-9);
    assert_eq!(of("bmodes", 20)["degrees_of_freedom"], 180);
    assert_eq!(of("spectral", 1)["relative_differences"][0], 0.0);
    let difference = of("bmodes", 60)["relative_differences"][2].as_f64();
    let holds = difference.is_some_and(|d| (d - 0.0136).abs() < 1e-4);
    assert!(holds, "{difference:?}");
    for method in methods {
        assert!(
            method["seconds_per_solve"]
                .as_f64()
                .is_some_and(|s| s > 0.0)
        );
        assert_eq!(method["frequencies_hz"].as_array().map(Vec::len), Some(5));
    }
}

#[test]
fn a_method_too_coarse_for_a_mode_says_so() {
    let file = "examples/reference-tower.toml";
    let line = format!("compare {file} --methods rmje --segments 1 --modes 20 --format json");
    let result = json(&arguments(&line));
    let frequencies = result["methods"][0]["frequencies_hz"]
        .as_array()
        .expect("a list");
    assert!(frequencies[0].is_number());
    assert!(frequencies.last().is_some_and(Value::is_null));
}

#[test]
fn convergence_has_errors_and_orders() {
    let result = json(&[
        "converge",
        "examples/reference-tower.toml",
        "--method",
        "bmodes",
        "--segments",
        "20,40,80",
        "--format",
        "json",
    ]);
    assert_eq!(result["limit_has_rotary_inertia"], false);
    close(&result["modes"][0]["frequency_hz"], 0.892169154365, 1e-10);
    let last = &result["levels"][2];
    close(&last["observed_orders"][0], 2.0, 0.01);
    close(&last["frequencies_hz"][0], 0.892115364, 1e-8);
    assert!(result["levels"][0]["observed_orders"][0].is_null());
}

#[test]
fn the_manual_is_in_the_book_as_the_program_prints_it() {
    let in_book = std::fs::read(root().join("book/src/verification.md")).expect("the chapter");
    let output = output(&["verify", "--format", "markdown"]);
    assert!(output.status.success());
    assert!(
        output.stdout == in_book,
        "run: towermodes verify --format markdown > book/src/verification.md"
    );
}

#[test]
fn the_manual_as_csv_has_one_line_a_value() {
    let output = output(&["verify", "--format", "csv"]);
    let text = String::from_utf8(output.stdout).expect("text");
    text.begins("chapter,case,source,method,mode,unit,expected,got,");
    let rows = json(&["verify", "--format", "json"]);
    assert_eq!(rows["failures"], 0);
    assert_eq!(
        rows["values"].as_u64(),
        Some(text.lines().count() as u64 - 1)
    );
}

#[test]
fn warnings_are_in_the_json_too() {
    let result = json(&arguments(
        "solve examples/reference-tower.toml --modes 1 --format json",
    ));
    let warning = result["warnings"][0].as_str().expect("a warning");
    warning.says("1st side-side bending");
    assert_eq!(result["certificate"]["count"], 2);
}

#[test]
fn csv_and_json_say_the_same() {
    let file = "examples/nrel-5mw.toml";
    let json = json(&["solve", file, "--format", "json"]);
    let csv = output(&["solve", file, "--format", "csv"]);
    let text = String::from_utf8(csv.stdout).expect("text");
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let modes = json["modes"].as_array().expect("modes");
    assert_eq!(lines.clone().count(), modes.len());
    for (line, mode) in lines.zip(modes) {
        for (key, field) in header.iter().zip(line.split(',')) {
            let value = key.split('.').fold(mode, |object, key| &object[key]);
            let is_same = match value {
                Value::Null => field.is_empty(),
                Value::String(text) => field == text,
                number => field.parse::<f64>().ok() == number.as_f64(),
            };
            assert!(
                is_same,
                "{key} is {field} in the CSV and {value} in the JSON; the keys of the JSON are in crates/towermodes/src/solve/results/mode_keys.rs"
            );
        }
    }
}

#[test]
fn standard_input_gives_the_same_as_a_file() {
    let path = "examples/nrel-5mw.toml";
    let text = std::fs::read(root().join(path)).expect("the example");
    let mut child = towermodes(&["solve", "-", "--format", "json"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program runs");
    child
        .stdin
        .take()
        .expect("piped")
        .write_all(&text)
        .expect("it reads");
    let piped = child.wait_with_output().expect("it ends");
    assert!(piped.status.success());
    let expected = output(&["solve", path, "--format", "json"]).stdout;
    assert_eq!(piped.stdout, expected);
}

#[test]
fn output_goes_to_the_file_and_nowhere_else() {
    let path = std::env::temp_dir().join(format!("towermodes-{}.csv", std::process::id()));
    let name = path.to_str().expect("a plain path");
    let file = "examples/nrel-5mw.toml";
    let written = output(&["solve", file, "--format", "csv", "--output", name]);
    assert!(written.status.success() && written.stdout.is_empty() && written.stderr.is_empty());
    let content = std::fs::read(&path).expect("the result");
    std::fs::remove_file(&path).expect("ours");
    assert_eq!(content, output(&["solve", file, "--format", "csv"]).stdout);
}

#[test]
fn a_result_never_overwrites_its_tower_by_any_name() {
    let folder = std::env::temp_dir().join(format!("towermodes-links-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder of ours");
    let (tower, link) = (folder.join("tower.toml"), folder.join("link.toml"));
    std::fs::copy(root().join("examples/nrel-5mw.toml"), &tower).expect("a copy");
    std::fs::hard_link(&tower, &link).expect("a hard link");
    let before = std::fs::read(&tower).expect("the tower");
    let name = |path: &PathBuf| path.to_str().expect("a plain path").to_owned();
    let refused = output(&["solve", &name(&tower), "--output", &name(&link)]);
    assert_eq!(refused.status.code(), Some(2), "{refused:?}");
    let redirected = towermodes(&["solve", "-", "--output", &name(&link)])
        .stdin(std::fs::File::open(&tower).expect("the tower"))
        .output()
        .expect("the program runs");
    assert_eq!(redirected.status.code(), Some(2), "{redirected:?}");
    assert_eq!(std::fs::read(&tower).expect("the tower"), before);
    std::fs::remove_dir_all(&folder).expect("ours");
}

#[test]
fn a_closed_pipe_is_no_failure() {
    let line = "solve examples/nrel-5mw.toml --format json --points 5000";
    let mut child = towermodes(&arguments(line))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program runs");
    let mut first = [0; 16];
    let mut stdout = child.stdout.take().expect("piped");
    stdout.read_exact(&mut first).expect("it begins");
    drop(stdout);
    let output = child.wait_with_output().expect("it ends");
    assert!(output.status.success(), "{output:?}");
    assert!(output.stderr.is_empty(), "{output:?}");
}

#[test]
fn refusals_leave_standard_output_empty() {
    for arguments in [
        &["solve", "missing.toml"][..],
        &["solve", "crates/towermodes-cli/tests/inputs/nan.toml"],
        &["solve", "examples/nrel-5mw.toml", "--segments", "0"],
        &arguments("solve examples/nrel-5mw.toml --segments 1 --modes 7"),
    ] {
        let refused = output(arguments);
        assert_eq!(refused.status.code(), Some(2), "{arguments:?}");
        assert!(refused.stdout.is_empty(), "{arguments:?}");
        assert!(!refused.stderr.is_empty(), "{arguments:?}");
    }
}

#[test]
fn completions_and_manual_pages_name_the_commands() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = String::from_utf8(output(&["completions", shell]).stdout).expect("text");
        assert!(script.contains("solve"), "{shell}");
        assert!(script.contains("segments"), "{shell}");
    }
    let page = String::from_utf8(output(&["man", "solve"]).stdout).expect("text");
    assert!(page.starts_with(".ie") && page.contains("\\-\\-segments"));
}
