//! The front door: a tower in, its modes out.

mod options;
mod spectrum;

pub use options::{
    DEFAULT_MODES, DEFAULT_POINTS, DEFAULT_SEGMENTS, MAX_POINTS, MAX_SEGMENTS, MAX_VECTOR_BYTES,
    Options, SolveError,
};

use crate::Warning;
use crate::chain::DecoupledChains;
use crate::eigen::{EigenError, Statistics};
use crate::elements::{Mesh, Method, assemble};
use crate::modes::{Companion, Family, ModeCurve, ShapePoint, ShapeWorkspace, richardson};
use crate::tower::Tower;
use spectrum::{Found, Spectrum};

/// A natural mode of a tower.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Place in the list, from 1.
    pub number: usize,
    /// Natural frequency of the chain of rigid bodies, Hz.
    pub frequency_hz: f64,
    /// The kind of motion.
    pub family: Family,
    /// Order within the family, from 1.
    pub order: usize,
    /// Bound on the error of the eigenvalue computation, Hz.
    pub algebraic_error_hz: f64,
    /// Estimate of the error of representing the beam by this many segments, Hz.
    pub discretization_error_hz: f64,
    /// The beam's frequency extrapolated from two meshes, Hz.
    pub extrapolated_hz: f64,
    /// Modal mass uᵀMu for the shape as normalized here: kg, or kg m² for torsion.
    pub modal_mass: f64,
    /// The shape at equal heights from the base to the top.
    pub shape: Vec<ShapePoint>,
    /// The shape at the tower's stations.
    pub station_shape: Vec<ShapePoint>,
}

impl Mode {
    /// What it is: "1st fore-aft bending".
    pub fn label(&self) -> String {
        self.family.label(self.order)
    }
}

/// The proof that no mode is missing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Certificate {
    /// Whether the inertia count and the list agree; a solution that is not complete is never returned.
    pub complete: bool,
    /// Number of modes that the inertia count proves below [`below_hz`](Self::below_hz): as many as are listed, or more if
    /// the number asked for cuts a repeated pair.
    pub count: usize,
    /// A frequency in the gap above the last mode, Hz.
    pub below_hz: f64,
}

/// The lowest modes of a tower, with their errors and the proof that they are all.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// The element used.
    pub method: Method,
    /// Number of segments used.
    pub segments: usize,
    /// Degrees of freedom of the whole tower.
    pub degrees_of_freedom: usize,
    /// The modes by frequency; of a repeated pair the fore-aft one first.
    pub modes: Vec<Mode>,
    /// The proof that none is missing.
    pub certificate: Certificate,
    /// What looks like a slip.
    pub warnings: Vec<Warning>,
    /// What it cost.
    pub statistics: Statistics,
}

/// Memory that is reused from solve to solve.
#[derive(Debug, Default)]
pub struct Workspace {
    chains: DecoupledChains,
    spectrum: Spectrum,
    shapes: ShapeWorkspace,
}

/// Finds the lowest modes of a tower.
///
/// # Errors
/// [`SolveError`]: impossible options, or a computation that failed; never an incomplete list.
///
/// # Example
/// See the [crate's front page](crate).
pub fn solve(tower: &Tower, options: &Options) -> Result<Solution, SolveError> {
    solve_with(tower, options, &mut Workspace::default())
}

/// [`solve`] in memory that was used before: for those who ask a million times.
///
/// # Errors
/// As [`solve`].
pub fn solve_with(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<Solution, SolveError> {
    let mesh = mesh_of(tower, options)?;
    let (found, certificate, mut statistics) = solve_mesh(tower, &mesh, options, workspace)?;
    let listed = &found[..options.modes];
    let mut modes = shapes(tower, &mesh, options, listed, workspace);
    let degrees_of_freedom = workspace.chains.degrees_of_freedom();
    estimate_errors(tower, &mesh, options, &mut modes, workspace)?;
    statistics += workspace.spectrum.statistics;
    let warnings = warnings(tower, &mesh, options, &modes, &found);
    Ok(Solution {
        method: options.method,
        segments: mesh.segments(),
        degrees_of_freedom,
        modes,
        certificate,
        warnings,
        statistics,
    })
}

fn mesh_of(tower: &Tower, options: &Options) -> Result<Mesh, SolveError> {
    if options.modes == 0 {
        return Err(SolveError::NoModes);
    }
    if !(2..=MAX_POINTS).contains(&options.points) {
        return Err(SolveError::Points {
            points: options.points,
        });
    }
    let fewest = Mesh::fewest_segments(tower);
    let segments = options.segments.unwrap_or(DEFAULT_SEGMENTS.max(2 * fewest));
    if segments == 0 || segments.max(fewest) > MAX_SEGMENTS {
        return Err(SolveError::Segments {
            segments: segments.max(if segments == 0 { 0 } else { fewest }),
        });
    }
    Ok(Mesh::new(tower, segments))
}

/// Assembles the tower on a mesh, solves it, and proves the list complete.
fn solve_mesh(
    tower: &Tower,
    mesh: &Mesh,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<(Vec<Found>, Certificate, Statistics), SolveError> {
    let Workspace {
        chains, spectrum, ..
    } = workspace;
    assemble(tower, mesh, options.method, options.rotary_inertia, chains);
    if !chains.is_finite() {
        return Err(EigenError::NotFinite.into());
    }
    let (modes, available) = (options.modes, chains.degrees_of_freedom());
    if modes > available {
        return Err(SolveError::TooManyModes {
            modes,
            segments: mesh.segments(),
            available,
        });
    }
    if modes.saturating_mul(available) > MAX_VECTOR_BYTES / size_of::<f64>() {
        return Err(SolveError::TooLarge {
            modes,
            degrees_of_freedom: available,
        });
    }
    let found = spectrum.solve(chains, modes)?;
    let proof = spectrum.prove(chains, &found, modes)?;
    let certificate = Certificate {
        complete: true,
        count: proof.count,
        below_hz: proof.below.sqrt() / std::f64::consts::TAU,
    };
    Ok((found, certificate, spectrum.statistics))
}

/// The modes with their shapes; the discretization error is still missing.
fn shapes(
    tower: &Tower,
    mesh: &Mesh,
    options: &Options,
    listed: &[Found],
    workspace: &mut Workspace,
) -> Vec<Mode> {
    let Workspace {
        chains,
        spectrum,
        shapes,
    } = workspace;
    let heights_m = equal_heights(tower, options.points);
    let stations_m: Vec<f64> = tower.stations().iter().map(|s| s.height_m).collect();
    let mode = |(index, found): (usize, &Found)| {
        let vector = spectrum.of(chains, found.family).vector(found.order - 1);
        let curve = match found.family {
            Family::SideSide if !chains.planes_are_equal() => {
                ModeCurve::bending(mesh, &chains.side_side, vector, shapes)
            }
            Family::ForeAft | Family::SideSide => {
                ModeCurve::bending(mesh, &chains.fore_aft, vector, shapes)
            }
            Family::Torsion => ModeCurve::axial(mesh, &chains.torsion, vector, shapes),
            Family::Axial => ModeCurve::axial(mesh, &chains.axial, vector, shapes),
        };
        Mode {
            number: index + 1,
            frequency_hz: found.eigenvalue.frequency_hz(),
            family: found.family,
            order: found.order,
            algebraic_error_hz: found.eigenvalue.frequency_error_hz(),
            discretization_error_hz: 0.0,
            extrapolated_hz: found.eigenvalue.frequency_hz(),
            // The vector has uᵀKu = 1 and so uᵀMu = 1/λ.
            modal_mass: 1.0 / (curve.largest() * curve.largest() * found.eigenvalue.lambda),
            shape: curve.sample(found.family, &heights_m),
            station_shape: curve.sample(found.family, &stations_m),
        }
    };
    listed.iter().enumerate().map(mode).collect()
}

/// Heights from the base to the top in equal steps, both ends exactly.
fn equal_heights(tower: &Tower, points: usize) -> Vec<f64> {
    let (base_m, top_m) = (tower.base_m(), tower.top_m());
    let height = |k: usize| {
        let s = k as f64 / (points - 1) as f64;
        base_m * (1.0 - s) + top_m * s
    };
    (0..points).map(height).collect()
}

/// Solves again with every segment halved or doubled and extrapolates.
fn estimate_errors(
    tower: &Tower,
    mesh: &Mesh,
    options: &Options,
    modes: &mut [Mode],
    workspace: &mut Workspace,
) -> Result<(), SolveError> {
    let (companion_mesh, companion) = companion_of(mesh, modes);
    let Workspace {
        chains, spectrum, ..
    } = workspace;
    assemble(
        tower,
        &companion_mesh,
        options.method,
        options.rotary_inertia,
        chains,
    );
    spectrum.statistics = Statistics::default();
    for family in [
        Family::ForeAft,
        Family::SideSide,
        Family::Torsion,
        Family::Axial,
    ] {
        let is_copy = family == Family::SideSide && chains.planes_are_equal();
        let wanted = orders_of(modes, family);
        if wanted > 0 && !is_copy {
            spectrum.solve_family(chains, family, wanted)?;
        }
    }
    for mode in modes {
        let companion_hz =
            spectrum.of(chains, mode.family).eigenvalues()[mode.order - 1].frequency_hz();
        let order = match mode.family {
            Family::ForeAft | Family::SideSide => options.method.bending_order(tower.shear()),
            Family::Torsion | Family::Axial => options.method.axial_order(),
        };
        let estimate = richardson(mode.frequency_hz, companion_hz, companion, order);
        mode.discretization_error_hz = estimate.error_hz;
        mode.extrapolated_hz = estimate.extrapolated_hz;
    }
    Ok(())
}

/// The highest order of a family in the list.
fn orders_of(modes: &[Mode], family: Family) -> usize {
    let orders = modes.iter().filter(|m| m.family == family).map(|m| m.order);
    orders.max().unwrap_or(0)
}

/// Half the segments if every span allows it and every family still has its modes, else twice.
fn companion_of(mesh: &Mesh, modes: &[Mode]) -> (Mesh, Companion) {
    let has_all = |mesh: &Mesh| {
        // Every element has two joint coordinates a segment in a bending plane, one in torsion and one axially.
        let bending = orders_of(modes, Family::ForeAft).max(orders_of(modes, Family::SideSide));
        let axial = orders_of(modes, Family::Torsion).max(orders_of(modes, Family::Axial));
        bending <= 2 * mesh.segments() && axial <= mesh.segments()
    };
    match mesh.halved().filter(has_all) {
        Some(halved) => (halved, Companion::Halved),
        None => (mesh.doubled(), Companion::Doubled),
    }
}

/// An estimate above this share of the frequency says that the mode is not resolved.
const RESOLVED: f64 = 0.05;

fn warnings(
    tower: &Tower,
    mesh: &Mesh,
    options: &Options,
    modes: &[Mode],
    found: &[Found],
) -> Vec<Warning> {
    let mut warnings = tower.plausibility();
    let frequency_hz = modes[0].frequency_hz;
    if !(0.01..=100.0).contains(&frequency_hz) {
        warnings.push(Warning::UnusualFrequency { frequency_hz });
    }
    if let Some(asked) = options.segments.filter(|&asked| asked != mesh.segments()) {
        let used = mesh.segments();
        warnings.push(Warning::MoreSegments { asked, used });
    }
    let relative = |m: &Mode| m.discretization_error_hz / m.frequency_hz;
    if let Some(mode) = modes.iter().find(|m| relative(m) > RESOLVED) {
        warnings.push(Warning::Unresolved {
            number: mode.number,
            relative_error: relative(mode),
        });
    }
    let last = found[modes.len() - 1].eigenvalue.lambda;
    if let Some(cut) = found
        .get(modes.len())
        .filter(|cut| cut.eigenvalue.lambda == last)
    {
        warnings.push(Warning::CutPair {
            label: cut.family.label(cut.order),
            frequency_hz: cut.eigenvalue.frequency_hz(),
        });
    }
    warnings
}
