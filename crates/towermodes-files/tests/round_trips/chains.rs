//! From format to format to format: what is lost is lost once.

use towermodes::TowerDescription;

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
    let (last, notes) = along(
        &description,
        &[Target::Toml, Target::Bmodes, Target::WindIo, Target::Toml],
    );
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
    assert!(said("the tower does not twist"), "{notes:?}");
    assert!(said("the tower does not stretch"), "{notes:?}");
    assert!(said("without polar inertia"), "{notes:?}");
    let off = largest_difference(&bending_hz(&tower(&last)), &bending_hz(&tower(&file)));
    assert!(off <= 1e-9, "{off:e}");
}

/// Files that are made of files of their own format soon stand still, and are the same tower all the way.
#[test]
fn every_format_stands_still() {
    for (name, description) in towers::all() {
        for target in Target::ALL {
            let first = there_and_back(&description, target).description;
            let second = there_and_back(&first, target).description;
            let third = written(&second, target);
            let fourth = written(&third.read().description, target);
            let is_still = fourth.source == third.source && fourth.companions == third.companions;
            assert!(is_still, "{name} {target:?}");
            let last = fourth.read().description;
            assert_eq!(last.name, first.name, "{name} {target:?}");
            let (last_hz, first_hz) = (
                frequencies_hz(&tower(&last)),
                frequencies_hz(&tower(&first)),
            );
            let off = largest_difference(&last_hz, &first_hz);
            assert!(off <= 1e-9, "{name} {target:?}: {off:e}");
        }
    }
}
