//! The properties of a tower that a tower file of ElastoDyn does not contain.

use towermodes::{Foundation, Inertia, LossFactors, Shear, TowerDescription};

use crate::note::Note;

/// The note on all properties that a tower file does not contain. Its shapes include the effect of
/// all of them.
pub fn left_out(description: &TowerDescription) -> Vec<Note> {
    let d = description;
    let mut masses = d.point_masses.iter();
    let mut rows = d.properties.iter();
    let shears = if d.stations.is_empty() {
        rows.any(|row| row.properties.shear_n.is_some())
    } else {
        d.shear != Shear::Rigid
    };
    let things = [
        (
            !d.rna.is_absent(),
            "the rotor-nacelle assembly, which is in the main file",
        ),
        (
            d.foundation != Foundation::Clamped,
            "the foundation, whose motion is removed from the shapes",
        ),
        (d.has_soil(), "the soil"),
        (
            d.water.is_some() || !d.added_mass.is_empty(),
            "the water's mass",
        ),
        (!d.wires.is_empty(), "the guy wires"),
        (
            d.gravity_m_per_s2 != 0.0,
            "gravity, which is in the main file",
        ),
        (d.rotor.is_some(), "the rotor, which is in the main file"),
        (
            d.damping.loss_factors != LossFactors::default(),
            "the loss factors; the file has damping ratios of its own",
        ),
        (shears, "shear deformation"),
        (
            masses.any(|mass| mass.inertia_kg_m2 != Inertia::default()),
            "the inertias of point masses",
        ),
        (true, "torsion, axial motion and rotary inertia"),
    ];
    let missing = things.into_iter().filter(|(is_there, _)| *is_there);
    let missing: Vec<&str> = missing.map(|(_, what)| what).collect();
    vec![Note::left_out(format!(
        "a tower file of ElastoDyn does not contain {}; the shapes are those of the tower with all of them",
        missing.join("; ")
    ))]
}
