//! TOML keeps everything, windIO whatever is a tube or a table, with its machine.

use towermodes::TowerDescription;
use towermodes_files::FileFormat;

use super::comparison::{assert_near, frequencies_hz, in_the_air, largest_difference};
use super::formats::{Target, there_and_back, tower};
use super::towers;

#[test]
fn toml_keeps_every_number() {
    for (name, description) in towers::all() {
        let input = there_and_back(&description, Target::Toml);
        assert_eq!(input.format, FileFormat::Toml, "{name}");
        assert_eq!(input.description, description, "{name}");
        let (original, again) = (tower(&description), input.tower().expect("a tower"));
        assert_near(again.mass_kg(), original.mass_kg(), 1e-15, name);
        let off = largest_difference(&frequencies_hz(&again), &frequencies_hz(&original));
        assert!(off <= 1e-12, "{name}: {off:e}");
    }
}

#[test]
fn windio_keeps_what_is_in_the_air() {
    for (name, description) in towers::all() {
        let input = there_and_back(&description, Target::WindIo);
        assert_eq!(input.format, FileFormat::WindIo, "{name}");
        assert_same_in_the_air(name, &input.description, &description);
    }
}

/// Tables keep their own shear stiffness; tubes have none in windIO.
fn assert_same_in_the_air(name: &str, again: &TowerDescription, description: &TowerDescription) {
    let mut reduced = in_the_air(description);
    reduced.properties.clone_from(&description.properties);
    assert_eq!(again.rna, description.rna, "{name}");
    assert_eq!(again.name, description.name, "{name}");
    assert_eq!(again.stations.len(), description.stations.len(), "{name}");
    let (original, again) = (tower(&reduced), tower(again));
    assert_near(again.mass_kg(), original.mass_kg(), 1e-9, name);
    assert_eq!(again.base_m(), original.base_m(), "{name}");
    assert_eq!(again.top_m(), original.top_m(), "{name}");
    let off = largest_difference(&frequencies_hz(&again), &frequencies_hz(&original));
    eprintln!("windIO, {name}: {off:.1e}");
    assert!(off <= 1e-9, "{name}: {off:e}");
}
