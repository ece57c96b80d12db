//! The properties of a tower that windIO cannot store.

use towermodes::{Foundation, Inertia, LossFactors, Shear, TowerDescription};

use crate::note::Note;

/// A note on each property that is omitted or written differently.
pub(super) fn notes(description: &TowerDescription) -> Vec<Note> {
    let d = description;
    let is_heavy = |mass: &towermodes::PointMass| mass.inertia_kg_m2 != Inertia::default();
    let left_out = [
        (
            d.foundation != Foundation::Clamped,
            "the foundation is left out: windIO has no soil or foundation",
        ),
        (d.has_soil(), "the soil is left out"),
        (d.water.is_some(), "the water is left out"),
        (!d.added_mass.is_empty(), "the added mass is left out"),
        (!d.wires.is_empty(), "the guy wires are left out"),
        (
            d.damping.loss_factors != LossFactors::default(),
            "the loss factors are left out: windIO has none",
        ),
        (
            d.gravity_m_per_s2 != 0.0,
            "gravity is left out: windIO does not specify it",
        ),
        (
            d.shear != Shear::Rigid && !d.stations.is_empty(),
            "the shear model is left out: windIO does not specify it",
        ),
        (
            d.point_masses.iter().any(is_heavy),
            "the inertias of point masses are left out: the format has only their masses",
        ),
        (
            !d.rna.is_absent(),
            "the whole rotor-nacelle assembly is written as components.drivetrain, which includes hub and blades",
        ),
        (
            !(1.0..=2.0).contains(&d.outfitting_factor) && !d.stations.is_empty(),
            "the outfitting factor is not between 1 and 2, as the schema of windIO requires",
        ),
        (
            !d.properties.is_empty(),
            "the tower has no tubes: its outer diameter is unknown and written as 0",
        ),
        (
            d.stations.first().is_some_and(|s| s.height_m < 0.0)
                || d.properties.first().is_some_and(|p| p.height_m < 0.0),
            "the part below z = 0, which may be a monopile, is written as a part of the tower",
        ),
        (
            !d.missing_parts.is_empty(),
            "the parts of the structure that this model lacks are named only in a comment, which programs do not read: results of the written file look complete",
        ),
        (true, "the drag coefficient is unknown and written as 0"),
    ];
    let found = left_out.into_iter().filter(|(is_so, _)| *is_so);
    found.map(|(_, message)| Note::left_out(message)).collect()
}
