//! The bar of first frequencies: what is on it, whatever the rotor.

use crate::pictures;

use pictures::{EXAMPLES, example, keep};
use towermodes::Rotor;
use towermodes_analysis::resonance::{Campbell, CampbellOptions, campbell};
use towermodes_report::figures::first_frequencies;
use towermodes_report::svg::{Figure, Look};
use towermodes_testing::{rotor, with};

fn diagram(name: &str, rotor: &Rotor, options: &CampbellOptions) -> Campbell {
    let (_, tower, solution) = example(name, 8);
    campbell(&tower, &solution, None, rotor, options).expect("a diagram")
}

/// Every text is inside the picture and apart from the others.
fn check(what: &str, figure: &Figure) {
    let (width, height) = (figure.drawing.width, figure.drawing.height);
    let labels = figure.labels();
    for (index, label) in labels.iter().enumerate() {
        let is_inside = label.left >= 0.0 && label.top >= 0.0;
        let is_inside = is_inside && label.right <= width && label.bottom <= height;
        assert!(is_inside, "{what}: {label:?}");
        for other in &labels[index + 1..] {
            assert!(!label.overlaps(other), "{what}: {label:?} and {other:?}");
        }
    }
    let svg = figure.to_svg(Look::Standalone);
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "{what}");
}

#[test]
fn labels_are_apart_whatever_the_rotor() {
    let rotors = [
        ("usual", rotor(3, 6.9, 12.1)),
        ("one speed", rotor(3, 12.1, 12.1)),
        ("1P and 3P overlap", rotor(3, 4.0, 14.0)),
        ("one blade", rotor(1, 10.0, 20.0)),
        ("two blades", rotor(2, 15.0, 18.0)),
        ("fast", rotor(3, 50.0, 100.0)),
        ("slow", rotor(3, 1.0, 3.2)),
    ];
    for name in EXAMPLES {
        for (what, rotor) in &rotors {
            let diagram = diagram(name, rotor, &CampbellOptions::default());
            let figure = first_frequencies(&diagram).expect("a bar");
            check(&format!("{name}, {what}"), &figure);
            keep(&format!("{name} {what}"), &[figure]);
        }
    }
}

/// Where ranges overlap, the fill of one does not cover an edge of the other.
#[test]
fn fills_are_below_all_edges() {
    let rotor = rotor(3, 4.0, 14.0);
    let diagram = diagram("nrel-5mw.toml", &rotor, &CampbellOptions::default());
    let figure = first_frequencies(&diagram).expect("a bar");
    let svg = figure.to_svg(Look::Standalone);
    let first_edge = svg.find("stroke-dasharray=\"6 4\"").expect("an edge");
    let height = "height=\"132\"";
    assert_eq!(svg.matches(height).count(), 4);
    assert!(svg.rfind(height).expect("a fill") < first_edge);
}

#[test]
fn only_what_was_looked_at_is_on_the_bar() {
    let with = |multiples: &[usize]| {
        let options = with!(CampbellOptions, multiples = multiples.to_vec());
        first_frequencies(&diagram("nrel-5mw.toml", &rotor(3, 6.9, 12.1), &options))
    };
    assert_eq!(with(&[6]), None);
    let excitations = |figure: Option<Figure>| -> Vec<String> {
        let rows = figure.expect("a bar").table.rows;
        rows.into_iter().map(|row| row[3].clone()).collect()
    };
    assert_eq!(excitations(with(&[3, 6])), ["3P", "3P"]);
    assert_eq!(excitations(with(&[1, 3])), ["1P", "3P", "1P", "3P"]);
}

/// By hand: 1P at 12 rpm is 0.2 Hz, 3P 0.6 Hz. A margin of 20 % keeps 0.2/1.2 = 0.1667 to 0.2/0.8 =
/// 0.25 Hz and 0.5 to 0.75 Hz free.
#[test]
fn ranges_are_those_of_hand() {
    let options = with!(CampbellOptions, margin = 0.2);
    let diagram = diagram("reference-tower.toml", &rotor(3, 12.0, 12.0), &options);
    let figure = first_frequencies(&diagram).expect("a bar");
    let rows = &figure.table.rows;
    assert_eq!(rows.len(), 4);
    assert_eq!(rows[0][4..6], ["0.2000 to 0.2000", "0.1667 to 0.2500"]);
    assert_eq!(rows[1][4..6], ["0.6000 to 0.6000", "0.5000 to 0.7500"]);
    assert!(
        figure
            .description
            .contains("the margin of 20 % natural frequencies must lie outside 0.1667 to 0.2500 and 0.5000 to 0.7500 Hz"),
        "{}",
        figure.description
    );
}

#[test]
fn without_modes_there_is_no_bar() {
    let mut diagram = diagram(
        "nrel-5mw.toml",
        &rotor(3, 6.9, 12.1),
        &CampbellOptions::default(),
    );
    diagram.lines.clear();
    assert_eq!(first_frequencies(&diagram), None);
}
