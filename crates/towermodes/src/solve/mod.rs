//! The front door: a tower in, its modes out.

mod estimate;
mod options;
mod solution;
mod spectrum;
mod warnings;

pub use options::{
    DEFAULT_MODES, DEFAULT_POINTS, DEFAULT_SEGMENTS, MAX_POINTS, MAX_SEGMENTS, MAX_VECTOR_BYTES,
    Options, SolveError,
};
pub use solution::{Certificate, Mode, Solution};

use crate::chain::DecoupledChains;
use crate::eigen::EigenError;
use crate::elements::{Mesh, assemble};
use crate::modes::{Family, ModeCurve, ShapeWorkspace};
use crate::tower::Tower;
use estimate::estimate_errors;
use spectrum::{Found, Proof, Spectrum};
use warnings::{uncertain_end, warnings};

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
    options.check()?;
    let mesh = mesh_of(tower, options)?;
    let (found, proof) = solve_mesh(tower, &mesh, options, workspace)?;
    let listed = &found[..options.modes];
    let mut modes = shapes(tower, &mesh, options, listed, workspace);
    let degrees_of_freedom = workspace.chains.degrees_of_freedom();
    let elsewhere = estimate_errors(tower, &mesh, options, &mut modes, proof.below, workspace)?;
    let certificate = Certificate {
        complete: true,
        count: proof.count,
        below_hz: proof.below.sqrt() / std::f64::consts::TAU,
    };
    let mut warnings = warnings(tower, &mesh, options, &modes, &found);
    warnings.extend(uncertain_end(&modes, &certificate, elsewhere));
    Ok(Solution {
        method: options.method,
        segments: mesh.segments(),
        degrees_of_freedom,
        modes,
        certificate,
        warnings,
        statistics: workspace.spectrum.statistics,
    })
}

fn mesh_of(tower: &Tower, options: &Options) -> Result<Mesh, SolveError> {
    let fewest = Mesh::fewest_segments(tower);
    let Some(segments) = options.segments else {
        return within_limit(fewest).map(|()| Mesh::at_least(tower, DEFAULT_SEGMENTS));
    };
    within_limit(segments)?;
    within_limit(fewest)?;
    Ok(Mesh::new(tower, segments))
}

fn within_limit(segments: usize) -> Result<(), SolveError> {
    if (1..=MAX_SEGMENTS).contains(&segments) {
        Ok(())
    } else {
        Err(SolveError::Segments { segments })
    }
}

/// Assembles the tower on a mesh, solves it, and proves the list complete.
fn solve_mesh(
    tower: &Tower,
    mesh: &Mesh,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<(Vec<Found>, Proof), SolveError> {
    let Workspace {
        chains, spectrum, ..
    } = workspace;
    assemble(tower, mesh, &options.recipe(), chains);
    if !chains.is_finite() {
        return Err(EigenError::NotFinite.into());
    }
    options.check_size(mesh.segments(), chains.degrees_of_freedom())?;
    let found = spectrum.solve(chains, options.modes)?;
    let proof = spectrum.prove(chains, &found, options.modes)?;
    Ok((found, proof))
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
    let mut modes: Vec<Mode> = Vec::with_capacity(listed.len());
    for found in listed {
        let number = modes.len() + 1;
        // Of a repeated pair the second is the first in the other plane.
        let twin = modes
            .last()
            .filter(|_| found.family == Family::SideSide && chains.planes_are_equal());
        let mode = match twin {
            Some(twin) => twin.in_side_side(number),
            None => {
                let vector = spectrum.of(chains, found.family).vector(found.order - 1);
                let curve = curve_of(found.family, mesh, chains, vector, shapes);
                Mode::new(number, found, &curve, &heights_m, &stations_m)
            }
        };
        modes.push(mode);
    }
    modes
}

fn curve_of<'a>(
    family: Family,
    mesh: &'a Mesh,
    chains: &DecoupledChains,
    vector: &[f64],
    shapes: &'a mut ShapeWorkspace,
) -> ModeCurve<'a> {
    match family {
        Family::ForeAft => ModeCurve::bending(mesh, &chains.fore_aft, vector, shapes),
        Family::SideSide => ModeCurve::bending(mesh, &chains.side_side, vector, shapes),
        Family::Torsion => ModeCurve::axial(mesh, &chains.torsion, vector, shapes),
        Family::Axial => ModeCurve::axial(mesh, &chains.axial, vector, shapes),
    }
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
