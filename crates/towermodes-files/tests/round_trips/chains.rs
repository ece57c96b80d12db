//! From format to format to format: what is lost is lost once.

use towermodes::{Method, Options, TowerDescription, solve};
use towermodes_files::TowerInput;

use super::comparison::{bending_hz, frequencies_hz, in_the_air, largest_difference};
use super::formats::{Target, there_and_back, tower, written};
use super::towers;

/// All descriptions along a chain, the first one last but for the format that is read.
fn along(description: &TowerDescription, chain: &[Target]) -> (TowerDescription, Vec<String>) {
    let mut now = description.clone();
    let mut notes = Vec::new();
    for target in chain {
        let written = written(&now, *target);
        let input = written.read();
        let all = written.notes.iter().chain(&input.notes);
        notes.extend(all.map(ToString::to_string));
        now = input.description;
    }
    (now, notes)
}

#[test]
fn a_tower_in_the_air_goes_round() {
    for name in ["nrel-5mw", "reference-tower-350t", "nrel-5mw-table"] {
        let description = towers::example(name);
        let chain = [
            Target::Toml,
            Target::Bmodes,
            Target::Toml,
            Target::WindIo,
            Target::Toml,
        ];
        let (last, notes) = along(&description, &chain);
        assert!(!notes.is_empty());
        let (first_hz, last_hz) = (
            frequencies_hz(&tower(&description)),
            frequencies_hz(&tower(&last)),
        );
        let off = largest_difference(&last_hz, &first_hz);
        assert!(off <= 5e-6, "{name}: {off:e}");
        // The deck alone makes a difference.
        let deck = there_and_back(&description, Target::Bmodes);
        let deck_hz = frequencies_hz(&tower(&deck.description));
        let off = largest_difference(&last_hz, &deck_hz);
        assert!(off <= 1e-12, "{name}: {off:e}");
    }
}

#[test]
fn notes_accumulate() {
    let description = towers::in_soil();
    let chain = [Target::Toml, Target::Bmodes, Target::WindIo, Target::Toml];
    let (last, notes) = along(&description, &chain);
    for words in [
        "BModes has no gravity",
        "BModes has no shear deformation",
        "the foundation is left out",
        "the soil is left out",
    ] {
        let said = notes.iter().filter(|note| note.contains(words)).count();
        assert_eq!(said, 1, "{words}: {notes:?}");
    }
    let off = largest_difference(
        &frequencies_hz(&tower(&last)),
        &frequencies_hz(&tower(&in_the_air(&description))),
    );
    assert!(off <= 5e-6, "{off:e}");
}

/// A tower that only bends has no torsion for BModes, which needs some.
#[test]
fn a_tower_file_goes_through_all_formats() {
    let description = towers::stepped();
    let file = there_and_back(&description, Target::ElastoDyn).description;
    let (last, notes) = along(
        &file,
        &[
            Target::WindIo,
            Target::Toml,
            Target::ElastoDyn,
            Target::Bmodes,
            Target::ElastoDyn,
        ],
    );
    let said = |words: &str| notes.iter().any(|note| note.contains(words));
    assert!(said("rigid in torsion"), "{notes:?}");
    assert!(said("axially rigid"), "{notes:?}");
    assert!(said("BModes needs polar inertia"), "{notes:?}");
    let off = largest_difference(&bending_hz(&tower(&last)), &bending_hz(&tower(&file)));
    assert!(off <= 1e-9, "{off:e}");
}

/// Files that are made of files of their own format soon stand still, and are the same tower all
/// the way.
#[test]
fn every_format_stands_still() {
    for (name, description) in towers::all() {
        for target in Target::ALL {
            let first = there_and_back(&description, target).description;
            let (third, _) = along(&first, &[target, target]);
            let (fifth, _) = along(&third, &[target, target]);
            assert_eq!(fifth.name, first.name, "{name} {target:?}");
            assert_eq!(sizes(&fifth), sizes(&third), "{name} {target:?}");
            let (last_hz, first_hz) = (
                frequencies_hz(&tower(&fifth)),
                frequencies_hz(&tower(&first)),
            );
            let off = largest_difference(&last_hz, &first_hz);
            // Steps are a ten-millionth of the length, and heights beside them are joined.
            assert!(off <= 1e-8, "{name} {target:?}: {off:e}");
        }
    }
}

fn sizes(description: &TowerDescription) -> [usize; 4] {
    [
        description.stations.len() + description.properties.len(),
        description.point_masses.len(),
        description.soil.iter().map(Vec::len).sum(),
        description.added_mass.iter().map(Vec::len).sum(),
    ]
}

/// By the elements that a deck prescribes, each of which has the section of its middle, Hz.
fn by_its_elements_hz(input: &TowerInput) -> Vec<f64> {
    let options = Options {
        method: Method::Bmodes,
        borders_m: input.prescribed.borders_m.clone(),
        points: 2,
        ..Options::default()
    };
    let solution = solve(&input.tower().expect("a tower"), &options).expect("modes");
    solution
        .modes
        .iter()
        .map(|mode| mode.frequency_hz)
        .collect()
}

/// Masses and wires that a deck has spread are still one element's when the deck comes from another
/// deck: an element takes the section of its middle, and would miss them or have too much of them.
#[test]
fn what_is_spread_keeps_its_elements() {
    for (name, description) in [
        ("masses along it", towers::with_masses()),
        ("stepped", towers::stepped()),
        ("guyed", towers::example("guyed")),
        ("monopile", towers::example("monopile")),
    ] {
        let first = there_and_back(&description, Target::Bmodes);
        let second = there_and_back(&first.description, Target::Bmodes);
        let [one, other] = [&first, &second].map(by_its_elements_hz);
        let off = largest_difference(&other, &one);
        assert!(off <= 1e-6, "{name}: {off:e}");
        // Elements of BModes have constant sections and no rotary inertia.
        let exact_hz = frequencies_hz(&tower(&first.description));
        let off = largest_difference(&one, &exact_hz);
        assert!(off < 0.01, "{name}: {off:e}");
    }
}
