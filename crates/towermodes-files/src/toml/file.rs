//! The whole file: which sections there are, and the tower they describe together.

use towermodes::TowerDescription;

use super::Reading;
use super::foundation::check_foundation;
use super::masses::{point_masses, rna};
use super::materials::materials;
use super::stations::{TOWER, outfitting_factor, shear, stations};
use super::table::{Keys, Table};
use super::values::text;

/// The sections of a file.
pub(super) const FILE: Keys = Keys {
    known: &[
        "name",
        "material",
        "materials",
        "tower",
        "rna",
        "point_mass",
        "foundation",
    ],
    planned: &["soil", "water", "wires", "gravity", "rotor"],
};

/// The whole file.
pub(super) fn description(root: &Table<'_>, reading: &mut Reading) -> Option<TowerDescription> {
    let name = root
        .get("name")
        .and_then(|v| text(v, "name", reading))
        .unwrap_or_default();
    let materials = materials(root, reading);
    check_foundation(root, reading);
    let rna = root.get("rna").and_then(|value| rna(value, reading));
    let point_masses = point_masses(root, reading);
    let hint = "add [tower] with stations = [[height, diameter, wall], ...]";
    let value = root.require("tower", hint, reading)?;
    let tower = Table::of(value, "[tower]", &TOWER, reading)?;
    let stations = stations(&tower, materials.as_ref(), reading);
    Some(TowerDescription {
        name: name.to_owned(),
        stations: stations?,
        materials: materials?.list,
        outfitting_factor: outfitting_factor(&tower, reading)?,
        shear: shear(&tower, reading)?,
        rna: rna.unwrap_or_default(),
        point_masses: point_masses?,
    })
}
