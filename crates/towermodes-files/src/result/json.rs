//! A solution as JSON: keys are stable, new ones may come, none changes its meaning.

use std::io::Write;

use serde::Serialize;
use towermodes::{Certificate, Family, Mode, ShapePoint, Solution, Tower};

use super::ResultError;

#[derive(Serialize)]
struct SolutionJson<'a> {
    method: &'static str,
    segments: usize,
    degrees_of_freedom: usize,
    tower: TowerJson<'a>,
    modes: Vec<ModeJson>,
    certificate: CertificateJson,
    solver: SolverJson,
    warnings: Vec<String>,
}

#[derive(Serialize)]
struct TowerJson<'a> {
    name: &'a str,
    height_m: f64,
    mass_kg: f64,
    top_mass_kg: f64,
}

#[derive(Serialize)]
struct ModeJson {
    number: usize,
    frequency_hz: f64,
    period_s: f64,
    family: &'static str,
    order: usize,
    label: String,
    algebraic_error_hz: f64,
    discretization_error_hz: f64,
    extrapolated_hz: f64,
    /// Of translation; none for torsion.
    modal_mass_kg: Option<f64>,
    /// Of torsion; none for translation.
    modal_inertia_kg_m2: Option<f64>,
    shape: ShapeJson,
    station_shape: ShapeJson,
}

#[derive(Serialize)]
struct ShapeJson {
    height_m: Vec<f64>,
    x: Vec<f64>,
    y: Vec<f64>,
    z: Vec<f64>,
    rotation_x: Vec<f64>,
    rotation_y: Vec<f64>,
    rotation_z: Vec<f64>,
}

#[derive(Serialize)]
struct CertificateJson {
    complete: bool,
    count: usize,
    below_hz: f64,
}

#[derive(Serialize)]
struct SolverJson {
    products: usize,
    restarts: usize,
}

/// Writes a solution as indented JSON with a newline at the end.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_json(
    tower: &Tower,
    solution: &Solution,
    mut writer: impl Write,
) -> Result<(), ResultError> {
    serde_json::to_writer_pretty(&mut writer, &solution_json(tower, solution))?;
    writeln!(writer)?;
    Ok(())
}

fn solution_json<'a>(tower: &'a Tower, solution: &Solution) -> SolutionJson<'a> {
    SolutionJson {
        method: solution.method.name(),
        segments: solution.segments,
        degrees_of_freedom: solution.degrees_of_freedom,
        tower: TowerJson {
            name: tower.name(),
            height_m: tower.height_m(),
            mass_kg: tower.mass_kg(),
            top_mass_kg: tower.rna().mass_kg,
        },
        modes: solution.modes.iter().map(mode_json).collect(),
        certificate: certificate_json(&solution.certificate),
        solver: SolverJson {
            products: solution.statistics.products,
            restarts: solution.statistics.restarts,
        },
        warnings: solution.warnings.iter().map(ToString::to_string).collect(),
    }
}

fn certificate_json(certificate: &Certificate) -> CertificateJson {
    CertificateJson {
        complete: certificate.complete,
        count: certificate.count,
        below_hz: certificate.below_hz,
    }
}

fn mode_json(mode: &Mode) -> ModeJson {
    let twists = mode.family == Family::Torsion;
    ModeJson {
        number: mode.number,
        frequency_hz: mode.frequency_hz,
        period_s: 1.0 / mode.frequency_hz,
        family: mode.family.name(),
        order: mode.order,
        label: mode.label(),
        algebraic_error_hz: mode.algebraic_error_hz,
        discretization_error_hz: mode.discretization_error_hz,
        extrapolated_hz: mode.extrapolated_hz,
        modal_mass_kg: (!twists).then_some(mode.modal_mass),
        modal_inertia_kg_m2: twists.then_some(mode.modal_mass),
        shape: shape_json(&mode.shape),
        station_shape: shape_json(&mode.station_shape),
    }
}

fn shape_json(points: &[ShapePoint]) -> ShapeJson {
    let column = |value: fn(&ShapePoint) -> f64| points.iter().map(value).collect();
    ShapeJson {
        height_m: column(|p| p.height_m),
        x: column(|p| p.translation[0]),
        y: column(|p| p.translation[1]),
        z: column(|p| p.translation[2]),
        rotation_x: column(|p| p.rotation[0]),
        rotation_y: column(|p| p.rotation[1]),
        rotation_z: column(|p| p.rotation[2]),
    }
}
