//! The front door: a tower in, its modes out.

mod degree;
mod estimate;
mod model;
mod options;
mod solution;
mod spectrum;
mod warnings;

pub use options::{
    DEFAULT_MODES, DEFAULT_POINTS, DEFAULT_SEGMENTS, MAX_DEGREE, MAX_POINTS, MAX_SEGMENTS,
    MAX_SPECTRAL_ELEMENTS, MAX_VECTOR_BYTES, Options, SolveError,
};
pub use solution::{Certificate, Mode, Solution};

use crate::Method;
use crate::eigen::EigenError;
use crate::elements::Mesh;
use crate::modes::{Family, ModeCurve};
use crate::tower::Tower;
use estimate::estimate_errors;
use model::{Cut, Model};
use spectrum::{Found, Proof, Spectrum};
use warnings::{uncertain_end, warnings};

/// Memory that is reused from solve to solve.
#[derive(Debug, Default)]
pub struct Workspace {
    model: Model,
    spectrum: Spectrum,
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
    options.check()?;
    match options.method {
        Method::Spectral => degree::solve(tower, options, workspace),
        _ => solve_segments(tower, options, workspace),
    }
}

/// On segments of a fixed kind: solved once, the errors estimated from meshes of half or twice as many.
fn solve_segments(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<Solution, SolveError> {
    let cut = Cut {
        mesh: mesh_of(tower, options)?,
        degree: 0,
    };
    let found = solve_cut(tower, &cut, options, workspace)?;
    let Workspace { model, spectrum } = workspace;
    let proof = spectrum.prove(model, &found, options.modes)?;
    let mut modes = shapes(tower, &cut.mesh, options, &found, workspace)?;
    let degrees_of_freedom = workspace.model.degrees_of_freedom();
    let elsewhere = estimate_errors(tower, &cut, options, &mut modes, proof.below, workspace)?;
    let certificate = certificate(&proof);
    let mut warnings = warnings(tower, &cut.mesh, options, &modes, &found);
    warnings.extend(uncertain_end(&modes, &certificate, elsewhere));
    Ok(Solution {
        method: options.method,
        segments: cut.mesh.segments(),
        degree: None,
        degrees_of_freedom,
        modes,
        certificate,
        warnings,
        statistics: workspace.spectrum.statistics,
    })
}

fn certificate(proof: &Proof) -> Certificate {
    Certificate {
        complete: true,
        count: proof.count,
        below_hz: proof.below.sqrt() / std::f64::consts::TAU,
    }
}

fn mesh_of(tower: &Tower, options: &Options) -> Result<Mesh, SolveError> {
    let (borders, most) = (options.borders(), MAX_SEGMENTS);
    let fewest = Mesh::fewest_segments(tower, borders);
    let Some(segments) = options.segments else {
        return within_limit(fewest, most)
            .map(|()| Mesh::at_least(tower, borders, options.default_segments(tower)));
    };
    within_limit(segments, most)?;
    within_limit(fewest, most)?;
    Ok(Mesh::new(tower, borders, segments))
}

fn within_limit(segments: usize, most: usize) -> Result<(), SolveError> {
    if (1..=most).contains(&segments) {
        Ok(())
    } else {
        Err(SolveError::Segments { segments, most })
    }
}

/// Assembles the tower as cut and solves it for at least the modes asked for.
fn solve_cut(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<Vec<Found>, SolveError> {
    options.check_memory(cut)?;
    let Workspace { model, spectrum } = workspace;
    model.assemble(tower, cut, options);
    if !model.is_finite() {
        return Err(EigenError::NotFinite.into());
    }
    options.check_size(cut.mesh.segments(), model.degrees_of_freedom())?;
    Ok(spectrum.solve(model, options.modes)?)
}

/// The modes asked for with their shapes; the discretization error is still missing.
fn shapes(
    tower: &Tower,
    mesh: &Mesh,
    options: &Options,
    found: &[Found],
    workspace: &mut Workspace,
) -> Result<Vec<Mode>, SolveError> {
    let Workspace { model, spectrum } = workspace;
    let heights_m = equal_heights(tower, options.points);
    let stations_m = tower.station_heights_m();
    let planes_are_equal = model.planes_are_equal();
    let mut modes: Vec<Mode> = Vec::with_capacity(options.modes);
    for found in &found[..options.modes] {
        let number = modes.len() + 1;
        // Of a repeated pair the second is the first in the other plane.
        let twin = modes
            .last()
            .filter(|_| found.family == Family::SideSide && planes_are_equal);
        let mode = match twin {
            Some(twin) => twin.in_side_side(number),
            None => {
                let eigenvectors = spectrum.of(planes_are_equal, found.family);
                let vector = eigenvectors.vector(found.order - 1);
                let curves = model.curves(tower, mesh, found.family, vector);
                let curve = ModeCurve::new(mesh.borders_m(), &*curves);
                Mode::new(number, found, &curve, &heights_m, &stations_m)
            }
        };
        if !mode.is_finite() {
            return Err(EigenError::NotFinite.into());
        }
        modes.push(mode);
    }
    Ok(modes)
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
