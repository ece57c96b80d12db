//! A solution as JSON: keys are stable, new ones may come, none changes its meaning.

use std::io::Write;

use schemars::JsonSchema;
use serde::Serialize;
use towermodes::{ByMotion, Certificate, Mode, ShapePoint, Solution, Tower};

use super::{ResultError, write_pretty};
use crate::input::Note;

/// The result of `towermodes solve --format json`. Keys are stable: new ones may be added, none is
/// renamed.
#[derive(Serialize, JsonSchema)]
#[schemars(title = "towermodes solution")]
pub(super) struct SolutionJson<'a> {
    /// The method, by its name on the command line.
    method: &'static str,
    /// Number of segments, or of elements.
    segments: usize,
    /// Polynomial degree of the elements of the spectral beam; null for other methods.
    degree: Option<usize>,
    /// Degrees of freedom of the whole tower.
    degrees_of_freedom: usize,
    /// What was solved.
    tower: TowerJson<'a>,
    /// The lowest modes by frequency; of a repeated pair the fore-aft one first.
    modes: Vec<ModeJson>,
    /// The proof that no mode is missing.
    certificate: CertificateJson,
    /// The factor by which all weights must be multiplied for the tower to buckle; null without
    /// gravity, or where it floats.
    buckling_load_factor: Option<f64>,
    /// Effective masses of the listed modes together, as shares of the whole tower's.
    effective_mass_shares: DirectionsJson,
    /// What it cost.
    solver: SolverJson,
    /// What the reader of the file decided or left out, and what looks like a slip.
    warnings: Vec<String>,
}

/// What was solved.
#[derive(Serialize, JsonSchema)]
struct TowerJson<'a> {
    /// The name in the file; may be empty.
    name: &'a str,
    /// Base to top, m.
    height_m: f64,
    /// Mass with outfitting and point masses, without the rotor-nacelle assembly, kg.
    mass_kg: f64,
    /// Mass of the rotor-nacelle assembly, kg.
    top_mass_kg: f64,
    /// Acceleration of gravity, m/s2; 0 if weights are left out.
    gravity_m_per_s2: f64,
    /// Inertia of all that moves against rigid motions (x, y, z, rotation about x, y, z) of the
    /// whole tower about its base: kg, kg m, kg m2.
    rigid_inertia: [[f64; 6]; 6],
}

/// A value for each direction.
#[derive(Serialize, JsonSchema)]
struct DirectionsJson {
    /// Translation fore-aft; an effective mass in kg.
    x: f64,
    /// Translation side-side; an effective mass in kg.
    y: f64,
    /// Translation upwards; an effective mass in kg.
    z: f64,
    /// Rotation about x through the base; an effective mass in kg m2.
    rotation_x: f64,
    /// Rotation about y through the base; an effective mass in kg m2.
    rotation_y: f64,
    /// Rotation about the tower's axis; an effective mass in kg m2.
    rotation_z: f64,
}

/// Where the energy of a mode is.
#[derive(Serialize, JsonSchema)]
struct EnergyJson {
    /// Shares of the kinetic energy.
    kinetic: ByMotionJson,
    /// Shares of the strain energy of tower, foundation, soil, wires and weights; all zero if there
    /// is none.
    strain: ByMotionJson,
}

/// A share for each motion of a bare tower.
#[derive(Serialize, JsonSchema)]
pub(super) struct ByMotionJson {
    /// Bending fore-aft.
    fore_aft: f64,
    /// Bending side-side.
    side_side: f64,
    /// Twist about the tower's axis.
    torsion: f64,
    /// Stretch along the tower's axis.
    axial: f64,
}

/// A natural mode.
#[derive(Serialize, JsonSchema)]
struct ModeJson {
    /// Place in the list, from 1.
    number: usize,
    /// Natural frequency of the chain of rigid bodies or of the beam, Hz.
    frequency_hz: f64,
    /// 1/frequency, s; null for a motion that nothing resists.
    period_s: Option<f64>,
    /// `fore-aft`, `side-side`, `torsion`, `axial` or `coupled`; of a floating tower that moves as
    /// one body `surge`, `sway`, `heave`, `roll`, `pitch` or `yaw`.
    family: &'static str,
    /// Order within the family, from 1.
    order: usize,
    /// What it is called, as "1st fore-aft bending".
    label: String,
    /// Bound on the error of the eigenvalue computation, Hz.
    algebraic_error_hz: f64,
    /// Estimate of the error of cutting the tower into segments, Hz.
    discretization_error_hz: f64,
    /// The beam's frequency extrapolated from several numbers of segments, Hz.
    extrapolated_hz: f64,
    /// Modal mass for the shape as normalized, kg; null for torsion and yaw.
    modal_mass_kg: Option<f64>,
    /// Modal inertia for the shape as normalized, kg m2; null except for torsion and yaw.
    modal_inertia_kg_m2: Option<f64>,
    /// Where its energy is.
    energy: EnergyJson,
    /// Effective modal masses: over all modes they add up to the diagonal of the tower's rigid
    /// inertia.
    effective_mass: DirectionsJson,
    /// The shape at equal heights from the base to the top.
    shape: ShapeJson,
    /// The shape at the stations of the file.
    station_shape: ShapeJson,
}

/// A shape, one list an axis; the largest translation in the mode's direction (in torsion and yaw:
/// rotation) of the tower is 1, positive at the top.
#[derive(Serialize, JsonSchema)]
pub(super) struct ShapeJson {
    /// Heights in the datum of the stations, m.
    height_m: Vec<f64>,
    /// Translation fore-aft.
    x: Vec<f64>,
    /// Translation side-side.
    y: Vec<f64>,
    /// Translation upwards.
    z: Vec<f64>,
    /// Rotation about x, 1/m (in torsion: none).
    rotation_x: Vec<f64>,
    /// Rotation about y, 1/m (in torsion: none).
    rotation_y: Vec<f64>,
    /// Rotation about z.
    rotation_z: Vec<f64>,
}

/// The proof that no mode is missing.
#[derive(Serialize, JsonSchema)]
pub(super) struct CertificateJson {
    /// Whether the list and the count agree; always true in a result.
    complete: bool,
    /// Number of modes below `below_hz` by inertia count; more than listed only if the list cuts a
    /// repeated pair.
    count: usize,
    /// A frequency in the gap above the last mode, Hz.
    below_hz: f64,
}

/// What a solve cost.
#[derive(Serialize, JsonSchema)]
struct SolverJson {
    /// Products with the mass matrix.
    products: usize,
    /// Restarts because a count disagreed with the list.
    restarts: usize,
}

/// Writes a solution as indented JSON with a newline at the end; what the reader of the file noted
/// comes before the warnings.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_json(
    tower: &Tower,
    solution: &Solution,
    notes: &[Note],
    writer: impl Write,
) -> Result<(), ResultError> {
    write_pretty(&solution_json(tower, solution, notes), writer)
}

fn solution_json<'a>(tower: &'a Tower, solution: &Solution, notes: &[Note]) -> SolutionJson<'a> {
    let notes = notes.iter().map(ToString::to_string);
    let warnings = solution.warnings.iter().map(ToString::to_string);
    SolutionJson {
        method: solution.method.name(),
        segments: solution.segments,
        degree: solution.degree,
        degrees_of_freedom: solution.degrees_of_freedom,
        tower: TowerJson {
            name: tower.name(),
            height_m: tower.height_m(),
            mass_kg: tower.mass_kg(),
            top_mass_kg: tower.rna().mass_kg,
            gravity_m_per_s2: tower.gravity_m_per_s2(),
            rigid_inertia: solution.rigid_inertia,
        },
        modes: solution.modes.iter().map(mode_json).collect(),
        certificate: certificate_json(&solution.certificate),
        buckling_load_factor: solution.buckling_load_factor,
        effective_mass_shares: directions_json(solution.effective_mass_shares()),
        solver: SolverJson {
            products: solution.statistics.products,
            restarts: solution.statistics.restarts,
        },
        warnings: notes.chain(warnings).collect(),
    }
}

pub(super) fn certificate_json(certificate: &Certificate) -> CertificateJson {
    CertificateJson {
        complete: certificate.complete,
        count: certificate.count,
        below_hz: certificate.below_hz,
    }
}

fn mode_json(mode: &Mode) -> ModeJson {
    ModeJson {
        number: mode.number,
        frequency_hz: mode.frequency_hz,
        period_s: Some(mode.period_s()).filter(|period| period.is_finite()),
        family: mode.family.name(),
        order: mode.order,
        label: mode.label(),
        algebraic_error_hz: mode.algebraic_error_hz,
        discretization_error_hz: mode.discretization_error_hz,
        extrapolated_hz: mode.extrapolated_hz,
        modal_mass_kg: mode.modal_mass_kg(),
        modal_inertia_kg_m2: mode.modal_inertia_kg_m2(),
        energy: EnergyJson {
            kinetic: by_motion_json(&mode.energy.kinetic),
            strain: by_motion_json(&mode.energy.strain),
        },
        effective_mass: directions_json(mode.effective_mass),
        shape: shape_json(&mode.shape),
        station_shape: shape_json(&mode.station_shape),
    }
}

fn directions_json(values: [f64; 6]) -> DirectionsJson {
    let [x, y, z, rotation_x, rotation_y, rotation_z] = values;
    DirectionsJson {
        x,
        y,
        z,
        rotation_x,
        rotation_y,
        rotation_z,
    }
}

fn by_motion_json(values: &ByMotion) -> ByMotionJson {
    ByMotionJson {
        fore_aft: values.fore_aft,
        side_side: values.side_side,
        torsion: values.torsion,
        axial: values.axial,
    }
}

pub(super) fn shape_json(points: &[ShapePoint]) -> ShapeJson {
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
