//! What windIO cannot hold of a tower.

use towermodes::{Foundation, Inertia, Rna, Shear, TowerDescription};

use crate::input::Note;

/// A note on each thing that is left out or written differently.
pub(super) fn notes(description: &TowerDescription) -> Vec<Note> {
    let d = description;
    let is_heavy = |mass: &towermodes::PointMass| mass.inertia_kg_m2 != Inertia::default();
    let left_out = [
        (
            d.foundation != Foundation::Clamped,
            "the foundation is left out: windIO has no ground under the tower",
        ),
        (!d.soil.is_empty(), "the soil is left out"),
        (d.water.is_some(), "the water is left out"),
        (!d.added_mass.is_empty(), "the added mass is left out"),
        (!d.wires.is_empty(), "the wires are left out"),
        (
            d.gravity_m_per_s2 != 0.0,
            "gravity is left out: windIO does not say whether weights soften the tower",
        ),
        (
            d.shear != Shear::Rigid && !d.stations.is_empty(),
            "the shear model is left out: windIO does not say whether tubes deform in shear",
        ),
        (
            d.point_masses.iter().any(is_heavy),
            "the inertias of point masses are left out: the format has their masses alone",
        ),
        (
            d.rna != Rna::default(),
            "the whole rotor-nacelle assembly is written as components.drivetrain: hub and blades are in it",
        ),
        (
            !(1.0..=2.0).contains(&d.outfitting_factor) && !d.stations.is_empty(),
            "the outfitting factor is not between 1 and 2, as the schema of windIO wants",
        ),
        (
            !d.properties.is_empty(),
            "the tower has no tubes: its outer diameter is not known and written as 0",
        ),
        (
            d.stations.first().is_some_and(|s| s.height_m < 0.0)
                || d.properties.first().is_some_and(|p| p.height_m < 0.0),
            "all is written as the tower, also what is below z = 0 and may be a monopile",
        ),
        (true, "the drag coefficient is not known and written as 0"),
    ];
    let found = left_out.into_iter().filter(|(is_so, _)| *is_so);
    found.map(|(_, message)| Note::new(message)).collect()
}
