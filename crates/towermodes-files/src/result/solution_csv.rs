//! A solution as CSV: one line per mode; shapes are in the JSON.

use std::io::Write;

use towermodes::{Mode, Solution, Warning};

use super::ResultError;

/// The keys of a mode in the JSON; a dot precedes the keys of an object. The last one is of the
/// tower: parts of the structure that it lacks, separated by spaces.
pub(super) const HEADER: [&str; 29] = [
    "number",
    "family",
    "order",
    "share",
    "second.family",
    "second.share",
    "label",
    "frequency_hz",
    "period_s",
    "algebraic_error_hz",
    "discretization_error_hz",
    "extrapolated_hz",
    "modal_mass_kg",
    "modal_inertia_kg_m2",
    "energy.kinetic.fore_aft",
    "energy.kinetic.side_side",
    "energy.kinetic.torsion",
    "energy.kinetic.axial",
    "energy.strain.fore_aft",
    "energy.strain.side_side",
    "energy.strain.torsion",
    "energy.strain.axial",
    "effective_mass.x",
    "effective_mass.y",
    "effective_mass.z",
    "effective_mass.rotation_x",
    "effective_mass.rotation_y",
    "effective_mass.rotation_z",
    "missing_parts",
];

/// Writes the modes of a solution as CSV with a header.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_csv(solution: &Solution, writer: impl Write) -> Result<(), ResultError> {
    let mut csv = ::csv::Writer::from_writer(writer);
    csv.write_record(HEADER)?;
    for mode in &solution.modes {
        csv.write_record(record(mode, solution))?;
    }
    csv.flush()?;
    Ok(())
}

/// The values of a mode, in the order of [`HEADER`].
pub(super) fn record(mode: &Mode, solution: &Solution) -> Vec<String> {
    let or_empty = |value: Option<f64>| value.map_or_else(String::new, |v| v.to_string());
    let second = mode.second();
    let mut record = vec![
        mode.number.to_string(),
        mode.family.name().to_owned(),
        mode.order.to_string(),
        mode.share().to_string(),
        second.map_or_else(String::new, |it| it.family.name().to_owned()),
        or_empty(second.map(|it| it.share)),
        mode.label(),
        mode.frequency_hz.to_string(),
        or_empty(Some(mode.period_s()).filter(|period| period.is_finite())),
        format!("{:e}", mode.algebraic_error_hz),
        format!("{:e}", mode.discretization_error_hz),
        mode.extrapolated_hz.to_string(),
        or_empty(mode.modal_mass_kg()),
        or_empty(mode.modal_inertia_kg_m2()),
    ];
    let energy = [mode.energy.kinetic.values(), mode.energy.strain.values()];
    let fractions = energy.iter().flatten().chain(&mode.effective_mass);
    record.extend(fractions.map(|value| format!("{value:e}")));
    record.push(missing_parts(solution));
    record
}

/// The names of the parts that the tower of a solution lacks.
fn missing_parts(solution: &Solution) -> String {
    let missing = solution.warnings.iter().find_map(Warning::missing_parts);
    let parts = missing.into_iter().flat_map(|missing| &missing.parts);
    let names: Vec<&str> = parts.map(|part| part.name()).collect();
    names.join(" ")
}
