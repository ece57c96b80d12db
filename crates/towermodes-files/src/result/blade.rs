//! The modes of a rotating blade as JSON and CSV.

use std::io::Write;

use serde::Serialize;
use towermodes::{Blade, BladeMode, BladeSolution, Certificate, Method};

use super::columns::Cell::{Count, Number, Small, Text};
use super::columns::{Column, write_columns_csv};
use super::{ResultError, write_result_json};
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
/// [`ResultError`] if writing fails.
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

/// The quantities of a mode of a blade: the columns of the CSV.
#[rustfmt::skip]
static COLUMNS: [Column<BladeMode>; 11] = [
    Column { key: "number", unit: "", meaning: "place in the list, from 1", value: |m| Count(m.number) },
    Column { key: "family", unit: "", meaning: "type of motion", value: |m| Text(m.family.name().to_owned()) },
    Column { key: "order", unit: "", meaning: "order within the family, from 1", value: |m| Count(m.order) },
    Column { key: "frequency_hz", unit: "Hz", meaning: "natural frequency", value: |m| Number(m.frequency_hz) },
    Column { key: "algebraic_error_hz", unit: "Hz", meaning: "bound on the error of the eigenvalue computation", value: |m| Small(m.algebraic_error_hz) },
    Column { key: "discretization_error_hz", unit: "Hz", meaning: "estimate of the discretization error", value: |m| Small(m.discretization_error_hz) },
    Column { key: "extrapolated_hz", unit: "Hz", meaning: "extrapolated frequency", value: |m| Number(m.extrapolated_hz) },
    Column { key: "kinetic.flap", unit: "", meaning: "fraction of the kinetic energy in flap", value: |m| Small(m.kinetic.side_side) },
    Column { key: "kinetic.lag", unit: "", meaning: "fraction of the kinetic energy in lag", value: |m| Small(m.kinetic.fore_aft) },
    Column { key: "kinetic.torsion", unit: "", meaning: "fraction of the kinetic energy in torsion", value: |m| Small(m.kinetic.torsion) },
    Column { key: "kinetic.axial", unit: "", meaning: "fraction of the kinetic energy in axial motion", value: |m| Small(m.kinetic.axial) },
];

/// Writes the modes of a blade as CSV with a header.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_blade_csv(solution: &BladeSolution, writer: impl Write) -> Result<(), ResultError> {
    write_columns_csv(&COLUMNS, &solution.modes, writer)
}
