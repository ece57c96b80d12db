//! p-refinement of the spectral method: the degree increases until the modes converge.

use super::super::error::SolveError;
use super::super::on_mesh::cut::Cut;
use super::super::on_mesh::listing::list;
use super::super::on_mesh::one_mesh::{describe, solve_cut};
use super::super::on_mesh::spectral_cut::{CONVERGED, STEP, can_be_finer, finer, first_cut};
use super::super::on_mesh::spectrum::Found;
use super::super::request::cost::{Cost, DEGREES};
use super::super::request::options::Options;
use super::super::results::solution::Solution;
use super::super::results::warnings::warnings;
use super::super::workspace::Workspace;
use crate::eigen::Statistics;
use crate::tower::Tower;

/// Limit of the work beyond the first two meshes, as a multiple of their work and in seconds. Modes
/// that have not converged by then, for example if a few numbers of a file are wrong by nine orders
/// of magnitude, are given with their last change as error.
const PATIENCE: f64 = 3.0;
const PATIENCE_S: f64 = 1.0;

/// A cut that is solved, with the change from a coarser or to a finer one, Hz a mode.
struct Solved {
    cut: Cut,
    found: Vec<Found>,
    changes_hz: Vec<f64>,
}

/// Solves with rising degree until the modes requested have converged, or with the degree asked
/// for; the change from one degree to the next is the estimate of the error.
pub(crate) fn solve(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<Solution, SolveError> {
    let (solved, statistics) = refine(tower, options, workspace)?;
    let mut result = describe(tower, &solved.cut, options, &solved.found, workspace)?;
    for (mode, change_hz) in result.modes.iter_mut().zip(solved.changes_hz) {
        mode.discretization_error_hz = change_hz + tower.soil_error() * mode.frequency_hz;
    }
    let mesh = &solved.cut.mesh;
    let warnings = warnings(tower, mesh, options, &result);
    let solution = result.into_solution(options, mesh.segments(), warnings, statistics);
    workspace.spectral_cut = Some(solved.cut);
    Ok(solution)
}

/// As above without shapes; the frequencies are in the workspace.
pub(crate) fn solve_frequencies(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<(), SolveError> {
    let (solved, _) = refine(tower, options, workspace)?;
    list(tower, &solved.cut, options, &solved.found, workspace)?;
    let modes = workspace.frequencies.modes.iter_mut();
    for (mode, change_hz) in modes.zip(solved.changes_hz) {
        mode.discretization_error_hz = change_hz + tower.soil_error() * mode.frequency_hz;
    }
    workspace.spectral_cut = Some(solved.cut);
    Ok(())
}

/// The modes and the cut that they have converged on.
pub(crate) fn lowest(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<(Cut, Vec<Found>), SolveError> {
    let (solved, _) = refine(tower, options, workspace)?;
    Ok((solved.cut, solved.found))
}

/// The modes on the last cut; the spectrum and the model of the workspace are those of this cut.
fn refine(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<(Solved, Statistics), SolveError> {
    let mut statistics = Statistics::default();
    let first = first_cut(tower, options)?;
    let solve = |cut: &Cut| {
        let found = solve_cut(tower, cut, options, None, workspace)?;
        statistics += workspace.spectrum.statistics;
        Ok::<_, SolveError>(found)
    };
    let solved = match options.degree {
        None => {
            let seconds = |cut: &Cut| Cost::of(tower, cut, options).seconds / DEGREES;
            raise(first, options, seconds, solve)?
        }
        Some(degree) => fix(Cut { degree, ..first }, options, solve)?,
    };
    Ok((solved, statistics))
}

/// Solves with one degree, after the next higher degree, from which the error is estimated.
fn fix(
    cut: Cut,
    options: &Options,
    mut solve: impl FnMut(&Cut) -> Result<Vec<Found>, SolveError>,
) -> Result<Solved, SolveError> {
    let finer = solve(&Cut {
        degree: cut.degree + STEP,
        ..cut.clone()
    })?;
    let found = solve(&cut)?;
    let changes_hz = changes(&found[..options.modes], &finer);
    Ok(Solved {
        cut,
        found,
        changes_hz,
    })
}

/// Increases the degree until the modes requested have converged.
fn raise(
    first: Cut,
    options: &Options,
    seconds: impl Fn(&Cut) -> f64,
    mut solve: impl FnMut(&Cut) -> Result<Vec<Found>, SolveError>,
) -> Result<Solved, SolveError> {
    let mut cut = first;
    let mut found = solve(&cut)?;
    let first_two_s = seconds(&cut) + seconds(&finer(cut.clone(), options));
    let mut left_s = PATIENCE_S + PATIENCE * first_two_s;
    loop {
        cut = finer(cut, options);
        let solved = solve(&cut)?;
        let changes_hz = changes(&solved[..options.modes], &found);
        found = solved;
        left_s -= seconds(&finer(cut.clone(), options));
        if have_converged(&changes_hz, &found) || !can_be_finer(&cut, options) || left_s < 0.0 {
            return Ok(Solved {
                cut,
                found,
                changes_hz,
            });
        }
    }
}

/// The change of each frequency from one mesh to another, Hz; the whole frequency if the mode is
/// missing there.
fn changes(modes: &[Found], others: &[Found]) -> Vec<f64> {
    let change = |found: &Found| {
        let other = others.iter().find(|other| other.key == found.key);
        let other_hz = other.map_or(0.0, |other| other.eigenvalue.frequency_hz());
        (other_hz - found.eigenvalue.frequency_hz()).abs()
    };
    modes.iter().map(change).collect()
}

/// Whether no change exceeds the tolerance, or the error of the eigenvalues.
fn have_converged(changes_hz: &[f64], found: &[Found]) -> bool {
    changes_hz.iter().zip(found).all(|(change_hz, found)| {
        let known = 2.0 * found.eigenvalue.frequency_error_hz();
        *change_hz <= CONVERGED * found.eigenvalue.frequency_hz() + known
    })
}
