//! The modes of a rotating blade as JSON and CSV.

use std::io::Write;

use serde::Serialize;
use towermodes::{Blade, BladeMode, BladeSolution, Certificate, Method};

use super::{ResultError, write_records_csv, write_result_json};
use crate::input::Note;

/// The result of `towermodes solve` for a rotating blade.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct BladeDocument<'a> {
    /// The method: always `bmodes`.
    method: Method,
    /// Number of elements.
    elements: usize,
    /// Degrees of freedom.
    degrees_of_freedom: usize,
    /// The blade that was solved.
    blade: BladeSummary<'a>,
    /// The lowest modes by frequency.
    modes: &'a [BladeMode],
    /// The proof that no mode is missing.
    certificate: Certificate,
    /// Assumptions of the reader and data that it omits.
    warnings: Vec<String>,
}

/// The blade that was solved.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct BladeSummary<'a> {
    /// The name in the file; may be empty.
    name: &'a str,
    /// Radius of the hub, m.
    hub_radius_m: f64,
    /// Radius of the tip, m.
    tip_radius_m: f64,
    /// Mass without the body at the tip, kg.
    mass_kg: f64,
    /// Mass of the body at the tip, kg.
    tip_mass_kg: f64,
    /// Rotor speed, rad/s.
    rotor_speed_rad_per_s: f64,
}

/// Writes the modes of a blade as indented JSON with a newline at the end.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_blade_json(
    blade: &Blade,
    solution: &BladeSolution,
    notes: &[Note],
    writer: impl Write,
) -> Result<(), ResultError> {
    let description = blade.description();
    let document = BladeDocument {
        method: Method::Bmodes,
        elements: solution.elements,
        degrees_of_freedom: solution.degrees_of_freedom,
        blade: BladeSummary {
            name: &description.name,
            hub_radius_m: description.hub_radius_m,
            tip_radius_m: description.tip_radius_m,
            mass_kg: blade.mass_kg(),
            tip_mass_kg: description.tip.mass_kg,
            rotor_speed_rad_per_s: description.rotor_speed_rad_per_s,
        },
        modes: &solution.modes,
        certificate: solution.certificate,
        warnings: notes.iter().map(ToString::to_string).collect(),
    };
    write_result_json(&document, writer)
}

/// The keys of a mode in the JSON, with a dot before the keys of an object.
const HEADER: [&str; 11] = [
    "number",
    "family",
    "order",
    "frequency_hz",
    "algebraic_error_hz",
    "discretization_error_hz",
    "extrapolated_hz",
    "kinetic.flap",
    "kinetic.lag",
    "kinetic.torsion",
    "kinetic.axial",
];

/// Writes the modes of a blade as CSV with a header.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_blade_csv(solution: &BladeSolution, writer: impl Write) -> Result<(), ResultError> {
    write_records_csv(HEADER, solution.modes.iter().map(record), writer)
}

fn record(mode: &BladeMode) -> [String; 11] {
    let kinetic = &mode.kinetic;
    [
        mode.number.to_string(),
        mode.family.name().to_owned(),
        mode.order.to_string(),
        mode.frequency_hz.to_string(),
        format!("{:e}", mode.algebraic_error_hz),
        format!("{:e}", mode.discretization_error_hz),
        mode.extrapolated_hz.to_string(),
        format!("{:e}", kinetic.side_side),
        format!("{:e}", kinetic.fore_aft),
        format!("{:e}", kinetic.torsion),
        format!("{:e}", kinetic.axial),
    ]
}
