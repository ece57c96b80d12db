//! The quantities of a mode as columns, and a solution as CSV: one line per mode; shapes are in the
//! JSON.

use std::io::Write;

use towermodes::{Family, Mode, Solution, Warning};

use super::ResultError;
use super::columns::Cell::{self, Count, Number, Small, Text};
use super::columns::{Column, record};

/// The quantities of a mode: the columns of the CSV and of `Solution.column` in Python.
#[rustfmt::skip]
pub static MODE_COLUMNS: &[Column<Mode>] = &[
    Column { key: "number", unit: "", meaning: "place in the list, from 1", value: |m| Count(m.number) },
    Column { key: "family", unit: "", meaning: "type of motion", value: |m| name(m.family) },
    Column { key: "order", unit: "", meaning: "order within the family, from 1", value: |m| Count(m.order) },
    Column { key: "share", unit: "", meaning: "share of its own family in its energy", value: |m| Number(m.share()) },
    Column { key: "second.family", unit: "", meaning: "family with the largest share beside its own", value: |m| text(m.second().map(|of| of.family.name())) },
    Column { key: "second.share", unit: "", meaning: "share of that family", value: |m| number(m.second().map(|of| of.share)) },
    Column { key: "label", unit: "", meaning: "name in words", value: |m| Text(m.label()) },
    Column { key: "frequency_hz", unit: "Hz", meaning: "natural frequency of the discretized tower, not extrapolated", value: |m| Number(m.frequency_hz) },
    Column { key: "period_s", unit: "s", meaning: "period; infinite for a motion without stiffness", value: |m| Number(m.period_s()) },
    Column { key: "algebraic_error_hz", unit: "Hz", meaning: "bound on the error of the eigenvalue computation", value: |m| Small(m.algebraic_error_hz) },
    Column { key: "discretization_error_hz", unit: "Hz", meaning: "estimate of the discretization error", value: |m| Small(m.discretization_error_hz) },
    Column { key: "extrapolated_hz", unit: "Hz", meaning: "frequency of the beam, extrapolated from several numbers of segments", value: |m| Number(m.extrapolated_hz) },
    Column { key: "modal_mass_kg", unit: "kg", meaning: "modal mass for the shape as normalized; none for torsion and yaw", value: |m| number(m.modal_mass_kg()) },
    Column { key: "modal_inertia_kg_m2", unit: "kg m²", meaning: "modal inertia of torsion and yaw", value: |m| number(m.modal_inertia_kg_m2()) },
    Column { key: "energy.kinetic.fore_aft", unit: "", meaning: "fraction of the kinetic energy in fore-aft motion", value: |m| Small(m.energy.kinetic.fore_aft) },
    Column { key: "energy.kinetic.side_side", unit: "", meaning: "fraction of the kinetic energy in side-side motion", value: |m| Small(m.energy.kinetic.side_side) },
    Column { key: "energy.kinetic.torsion", unit: "", meaning: "fraction of the kinetic energy in torsion", value: |m| Small(m.energy.kinetic.torsion) },
    Column { key: "energy.kinetic.axial", unit: "", meaning: "fraction of the kinetic energy in axial motion", value: |m| Small(m.energy.kinetic.axial) },
    Column { key: "energy.strain.fore_aft", unit: "", meaning: "fraction of the strain energy in fore-aft motion", value: |m| Small(m.energy.strain.fore_aft) },
    Column { key: "energy.strain.side_side", unit: "", meaning: "fraction of the strain energy in side-side motion", value: |m| Small(m.energy.strain.side_side) },
    Column { key: "energy.strain.torsion", unit: "", meaning: "fraction of the strain energy in torsion", value: |m| Small(m.energy.strain.torsion) },
    Column { key: "energy.strain.axial", unit: "", meaning: "fraction of the strain energy in axial motion", value: |m| Small(m.energy.strain.axial) },
    Column { key: "effective_mass.x", unit: "kg", meaning: "effective modal mass in x", value: |m| Small(m.effective_mass[0]) },
    Column { key: "effective_mass.y", unit: "kg", meaning: "effective modal mass in y", value: |m| Small(m.effective_mass[1]) },
    Column { key: "effective_mass.z", unit: "kg", meaning: "effective modal mass in z", value: |m| Small(m.effective_mass[2]) },
    Column { key: "effective_mass.rotation_x", unit: "kg m²", meaning: "effective modal moment of inertia about x", value: |m| Small(m.effective_mass[3]) },
    Column { key: "effective_mass.rotation_y", unit: "kg m²", meaning: "effective modal moment of inertia about y", value: |m| Small(m.effective_mass[4]) },
    Column { key: "effective_mass.rotation_z", unit: "kg m²", meaning: "effective modal moment of inertia about z", value: |m| Small(m.effective_mass[5]) },
    Column { key: "effective_mass_shares.x", unit: "", meaning: "effective modal mass in x as a fraction of the total mass, both with the added mass of the mode", value: |m| Small(m.effective_mass_shares()[0]) },
    Column { key: "effective_mass_shares.y", unit: "", meaning: "effective modal mass in y as a fraction of the total mass, both with the added mass of the mode", value: |m| Small(m.effective_mass_shares()[1]) },
    Column { key: "effective_mass_shares.z", unit: "", meaning: "effective modal mass in z as a fraction of the total mass, both with the added mass of the mode", value: |m| Small(m.effective_mass_shares()[2]) },
    Column { key: "effective_mass_shares.rotation_x", unit: "", meaning: "effective modal moment of inertia about x as a fraction of the total, both with the added mass of the mode", value: |m| Small(m.effective_mass_shares()[3]) },
    Column { key: "effective_mass_shares.rotation_y", unit: "", meaning: "effective modal moment of inertia about y as a fraction of the total, both with the added mass of the mode", value: |m| Small(m.effective_mass_shares()[4]) },
    Column { key: "effective_mass_shares.rotation_z", unit: "", meaning: "effective modal moment of inertia about z as a fraction of the total, both with the added mass of the mode", value: |m| Small(m.effective_mass_shares()[5]) },
];

fn name(family: Family) -> Cell {
    Text(family.name().to_owned())
}

fn text(text: Option<&str>) -> Cell {
    Text(text.unwrap_or_default().to_owned())
}

fn number(number: Option<f64>) -> Cell {
    Number(number.unwrap_or(f64::NAN))
}

/// The last column is a property of the tower: the parts of the structure that it lacks, separated
/// by spaces.
const MISSING_PARTS: &str = "missing_parts";

/// The names of the columns of the CSV.
pub(super) fn header() -> impl Iterator<Item = &'static str> {
    MODE_COLUMNS
        .iter()
        .map(|column| column.key)
        .chain([MISSING_PARTS])
}

/// The lines of a solution.
pub(super) fn records(solution: &Solution) -> impl Iterator<Item = Vec<String>> {
    let parts = missing_parts(solution);
    let modes = solution.modes.iter();
    modes.map(move |mode| record(MODE_COLUMNS, mode).chain([parts.clone()]).collect())
}

/// Writes the modes of a solution as CSV with a header.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_csv(solution: &Solution, writer: impl Write) -> Result<(), ResultError> {
    let mut csv = ::csv::Writer::from_writer(writer);
    csv.write_record(header())?;
    for line in records(solution) {
        csv.write_record(line)?;
    }
    csv.flush()?;
    Ok(())
}

/// The names of the parts that the tower of a solution lacks.
fn missing_parts(solution: &Solution) -> String {
    let missing = solution.warnings.iter().find_map(Warning::missing_parts);
    let parts = missing.into_iter().flat_map(|missing| &missing.parts);
    let names: Vec<&str> = parts.map(|part| part.name()).collect();
    names.join(" ")
}
