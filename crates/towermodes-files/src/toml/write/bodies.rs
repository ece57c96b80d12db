//! `[rna]`, `[rotor]` and `[[point_mass]]`.

use towermodes::{Drivetrain, Inertia, PointMass, Rna, Rotor};

use super::inputs::values;
use super::text::number;
use super::writing::Writing;
use crate::toml::schema;

/// Writes the rotor-nacelle assembly; if it is a point mass, with zero inertia.
pub(super) fn rna(rna: &Rna, is_point: bool, writing: &mut Writing) {
    if rna.is_absent() {
        return;
    }
    writing.section(&schema::RNA);
    values(rna, writing);
    if is_point && rna.inertia_kg_m2 == Inertia::default() {
        inertia_with(&rna.inertia_kg_m2, &["xx", "yy", "zz"], writing);
    }
}

pub(super) fn rotor(rotor: Option<&Rotor>, writing: &mut Writing) {
    let Some(rotor) = rotor else {
        return;
    };
    writing.section(&schema::ROTOR);
    writing.value("blades", &rotor.blades.to_string());
    let (lowest, highest) = (rotor.lowest_rpm, rotor.highest_rpm);
    if lowest == highest {
        writing.commented("rpm", &number(highest), "constant");
    } else {
        let range = format!("[{}, {}]", number(lowest), number(highest));
        writing.commented("rpm", &range, "lowest and highest operating speed");
    }
}

pub(super) fn point_masses(masses: &[PointMass], names: &[String], writing: &mut Writing) {
    for (index, mass) in masses.iter().enumerate() {
        writing.section(&schema::POINT_MASS);
        writing.name(names.get(index));
        values(mass, writing);
    }
}

/// `inertia` with the entries that are not zero and the required ones.
pub(super) fn inertia_with(inertia: &Inertia, required: &[&str], writing: &mut Writing) {
    writing.value("inertia", &inertia_of(inertia, required));
}

/// The table of an inertia.
pub(super) fn inertia_of(inertia: &Inertia, required: &[&str]) -> String {
    let entries = [
        ("xx", inertia.xx),
        ("yy", inertia.yy),
        ("zz", inertia.zz),
        ("xy", inertia.xy),
        ("xz", inertia.xz),
        ("yz", inertia.yz),
    ];
    let is_written = |(key, value): &(&str, f64)| *value != 0.0 || required.contains(key);
    let written = entries.into_iter().filter(is_written);
    let written: Vec<String> = written
        .map(|(key, value)| format!("{key} = {}", number(value)))
        .collect();
    format!("{{ {} }}", written.join(", "))
}

pub(super) fn drivetrain(drivetrain: Option<&Drivetrain>, writing: &mut Writing) {
    let Some(drivetrain) = drivetrain else {
        return;
    };
    writing.section(&schema::DRIVETRAIN);
    values(drivetrain, writing);
}
