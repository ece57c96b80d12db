//! The pictures of the examples, number by number.
//!
//! `TOWERMODES_BLESS=1 cargo test -p towermodes-report --test all golden` writes them anew; then
//! look at each.

use crate::pictures;

use std::fs;
use std::path::Path;

use pictures::{EXAMPLES, check, check_labels, example, input};
use towermodes::{Method, Options, Solver, solve};
use towermodes_analysis::resonance::{CampbellOptions, campbell};
use towermodes_analysis::study::{self, ColumnSpec, Fineness, converge};
use towermodes_report::figures;
use towermodes_report::svg::{Figure, Heading, Look};
use towermodes_testing::{rotor, with};

/// Largest difference of two numbers of a picture, in pixels.
const TOLERANCE: f64 = 0.05;
/// Modes of the pictures.
const MODES: usize = 8;

/// A text with its numbers taken out, and the numbers.
fn parted(svg: &str) -> (String, Vec<f64>) {
    let (mut rest, mut text, mut numbers) = (svg, String::new(), Vec::new());
    while let Some(first) = rest.chars().next() {
        let is_number = |c: char| c.is_ascii_digit() || c == '.';
        let digits = rest.trim_start_matches('-');
        let sign = rest.len() - digits.len();
        let length = digits.find(|c| !is_number(c)).unwrap_or(digits.len());
        if let Some(Ok(number)) = (sign <= 1 && length > 0).then(|| rest[..sign + length].parse()) {
            numbers.push(number);
            text.push('#');
            rest = &rest[sign + length..];
        } else {
            text.push(first);
            rest = &rest[first.len_utf8()..];
        }
    }
    (text, numbers)
}

/// Compares a picture with its file, or writes that.
fn compare(file: &str, figure: &Figure) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    let path = folder.join(format!("{file}.svg"));
    let svg = figure.to_svg(Look::Standalone);
    if std::env::var_os("TOWERMODES_BLESS").is_some() {
        fs::write(&path, svg).expect("a file of the repository");
        return;
    }
    let golden = fs::read_to_string(&path).unwrap_or_else(|_| {
        panic!(
            "{} is missing: TOWERMODES_BLESS=1 writes it",
            path.display()
        )
    });
    assert_alike(file, &golden, &svg);
}

fn assert_alike(file: &str, golden: &str, svg: &str) {
    assert_eq!(
        golden.lines().count(),
        svg.lines().count(),
        "{file}: elements"
    );
    for (line, (golden, svg)) in golden.lines().zip(svg.lines()).enumerate() {
        let ((golden_text, golden_numbers), (text, numbers)) = (parted(golden), parted(svg));
        assert_eq!(golden_text, text, "{file}:{}", line + 1);
        // What readers read is the same to the last digit.
        let said = |line: &str| line.split_once('>').map(|(_, said)| said.to_owned());
        if golden.starts_with("<text") {
            assert_eq!(said(golden), said(svg), "{file}:{}", line + 1);
        }
        for (golden, number) in golden_numbers.iter().zip(&numbers) {
            let holds = (golden - number).abs() <= TOLERANCE;
            assert!(holds, "{file}:{}: {golden} became {number}", line + 1);
        }
    }
}

#[test]
fn towers_of_the_examples() {
    for name in EXAMPLES {
        let (description, tower, _) = example(name, MODES);
        let figure = figures::tower(&description, &tower);
        check(name, &figure);
        compare(&format!("tower-{}", name.replace('.', "-")), &figure);
    }
}

#[test]
fn shapes_of_the_examples() {
    for name in EXAMPLES {
        let (description, tower, solution) = example(name, MODES);
        let figure = figures::shapes(&description, &tower, &solution);
        check(name, &figure);
        compare(&format!("shapes-{}", name.replace('.', "-")), &figure);
    }
}

/// A heading above a picture, long enough to be broken, meets nothing of it.
#[test]
fn headings_stand_above_the_pictures() {
    let heading = Heading {
        title: "A tower with a very long name ".repeat(4),
        lines: vec!["What is shown".to_owned(), "It follows. ".repeat(40)],
    };
    for name in EXAMPLES {
        let (description, tower, solution) = example(name, MODES);
        for figure in [
            figures::tower(&description, &tower),
            figures::shapes(&description, &tower, &solution),
        ] {
            let words = figure.labels().len();
            let headed = figure.headed(&heading);
            assert!(headed.labels().len() >= words + 5, "{name}: no heading");
            check_labels(name, &headed);
        }
    }
}

#[test]
fn diagrams_of_a_rotor() {
    let rotors = [
        ("nrel-5mw.toml", [6.0, 12.1]),
        ("small-turbine/ElastoDyn.dat", [40.0, 80.0]),
    ];
    for (name, [lowest_rpm, highest_rpm]) in rotors {
        let (input, tower) = input(name);
        let solution = solve(&tower, &Options::default()).expect("its modes");
        let rotor = rotor(3, lowest_rpm, highest_rpm);
        let (blade, options) = (input.blade.as_ref(), CampbellOptions::default());
        let campbell = campbell(&tower, &solution, blade, &rotor, &options).expect("a diagram");
        let figure = figures::campbell(&campbell);
        let file = format!("campbell-{}", name.replace(['.', '/'], "-"));
        compare(&file, &figure);
    }
}

#[test]
fn studies_of_methods() {
    let (_, tower) = input("nrel-5mw.toml");
    let segments = [10, 20, 40, 80].map(Fineness::Segments);
    for method in [Method::Rmje, Method::RmjeExact] {
        let options = with!(Options, method);
        let study = converge(&tower, &segments, &mut Solver::new(options.clone()), |_| ())
            .expect("solvable");
        let figure = figures::convergence(&study);
        compare(&format!("convergence-{}", method.name()), &figure);
    }
    let column = |method| ColumnSpec {
        method,
        segments: (method != Method::Spectral).then_some(60),
    };
    let columns = Method::ALL.map(column);
    let study = study::compare(&tower, &columns, &mut Solver::default(), |_, _| ());
    compare("error", &figures::error(&study.expect("solvable")));
}

#[test]
fn a_moved_line_and_another_word_are_seen() {
    let svg = "<path d=\"M1 2L3 4\"/>\n<text x=\"5\">0.3215 Hz</text>\n";
    assert_alike("same", svg, &svg.replace("L3 4", "L3.04 4"));
    for other in [
        svg.replace("L3 4", "L3.06 4"),
        svg.replace("0.3215", "0.3216"),
        svg.replace("Hz", "rpm"),
        svg.replace("<path", "<path/>\n<path"),
    ] {
        let alike = std::panic::catch_unwind(|| assert_alike("changed", svg, &other));
        assert!(alike.is_err(), "{other}");
    }
}
