//! The modes of a rotating blade as JSON and CSV.

use std::io::Write;

use schemars::JsonSchema;
use serde::Serialize;
use towermodes::{Blade, BladeMode, BladeSolution, ByMotion};

use super::solution_json::{CertificateJson, ShapeJson, certificate_json, shape_json};
use super::{ResultError, write_pretty};
use crate::input::Note;

/// The result of `towermodes solve --format json` for a rotating blade. Keys are stable: new ones
/// may be added, none is renamed.
#[derive(Serialize, JsonSchema)]
#[schemars(title = "towermodes blade solution")]
pub(super) struct BladeSolutionJson<'a> {
    /// The method: always `bmodes`.
    method: &'static str,
    /// Number of elements.
    elements: usize,
    /// Degrees of freedom.
    degrees_of_freedom: usize,
    /// What was solved.
    blade: BladeJson<'a>,
    /// The lowest modes by frequency.
    modes: Vec<BladeModeJson>,
    /// The proof that no mode is missing.
    certificate: CertificateJson,
    /// What the reader of the file decided or left out.
    warnings: Vec<String>,
}

/// What was solved.
#[derive(Serialize, JsonSchema)]
struct BladeJson<'a> {
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
    /// Speed of the rotor, rad/s.
    rotor_speed_rad_per_s: f64,
}

/// A natural mode of a rotating blade.
#[derive(Serialize, JsonSchema)]
struct BladeModeJson {
    /// Place in the list, from 1.
    number: usize,
    /// Natural frequency in the rotating frame, Hz.
    frequency_hz: f64,
    /// `flap`, `lag`, `torsion` or `axial`: the motion with most of the kinetic energy.
    family: &'static str,
    /// Order within the family, from 1.
    order: usize,
    /// Bound on the error of the eigenvalue computation, Hz.
    algebraic_error_hz: f64,
    /// Estimate of the error of the elements, Hz.
    discretization_error_hz: f64,
    /// The frequency extrapolated from elements cut in two, Hz.
    extrapolated_hz: f64,
    /// Shares of the kinetic energy.
    kinetic: BladeEnergyJson,
    /// The shape at the element borders: x is lag, y flap, z along the span; `height_m` is the
    /// distance from the rotor's axis.
    shape: ShapeJson,
}

/// A share for each motion of a blade.
#[derive(Serialize, JsonSchema)]
struct BladeEnergyJson {
    /// Out of the rotor's plane.
    flap: f64,
    /// In the rotor's plane.
    lag: f64,
    /// About the span.
    torsion: f64,
    /// Along the span.
    axial: f64,
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
    let result = BladeSolutionJson {
        method: "bmodes",
        elements: solution.elements,
        degrees_of_freedom: solution.degrees_of_freedom,
        blade: BladeJson {
            name: &description.name,
            hub_radius_m: description.hub_radius_m,
            tip_radius_m: description.tip_radius_m,
            mass_kg: blade.mass_kg(),
            tip_mass_kg: description.tip.mass_kg,
            rotor_speed_rad_per_s: description.rotor_speed_rad_per_s,
        },
        modes: solution.modes.iter().map(mode_json).collect(),
        certificate: certificate_json(&solution.certificate),
        warnings: notes.iter().map(ToString::to_string).collect(),
    };
    write_pretty(&result, writer)
}

fn mode_json(mode: &BladeMode) -> BladeModeJson {
    BladeModeJson {
        number: mode.number,
        frequency_hz: mode.frequency_hz,
        family: mode.family.name(),
        order: mode.order,
        algebraic_error_hz: mode.algebraic_error_hz,
        discretization_error_hz: mode.discretization_error_hz,
        extrapolated_hz: mode.extrapolated_hz,
        kinetic: energy_json(&mode.kinetic),
        shape: shape_json(&mode.shape),
    }
}

fn energy_json(kinetic: &ByMotion) -> BladeEnergyJson {
    BladeEnergyJson {
        flap: kinetic.side_side,
        lag: kinetic.fore_aft,
        torsion: kinetic.torsion,
        axial: kinetic.axial,
    }
}

/// Writes the modes of a blade as CSV with a header: the keys of the JSON, a dot going into an
/// object.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_blade_csv(solution: &BladeSolution, writer: impl Write) -> Result<(), ResultError> {
    let mut csv = ::csv::Writer::from_writer(writer);
    csv.write_record([
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
    ])?;
    for mode in &solution.modes {
        let kinetic = energy_json(&mode.kinetic);
        csv.write_record([
            mode.number.to_string(),
            mode.family.name().to_owned(),
            mode.order.to_string(),
            mode.frequency_hz.to_string(),
            format!("{:e}", mode.algebraic_error_hz),
            format!("{:e}", mode.discretization_error_hz),
            mode.extrapolated_hz.to_string(),
            format!("{:e}", kinetic.flap),
            format!("{:e}", kinetic.lag),
            format!("{:e}", kinetic.torsion),
            format!("{:e}", kinetic.axial),
        ])?;
    }
    csv.flush()?;
    Ok(())
}
