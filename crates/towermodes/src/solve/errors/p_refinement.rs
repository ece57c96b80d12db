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

/// Limit of the modes sought on the finer mesh, as a multiple of those requested.
const LONGEST: usize = 16;

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
    let solve = |cut: &Cut, options: &Options| {
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
    mut solve: impl FnMut(&Cut, &Options) -> Result<Vec<Found>, SolveError>,
) -> Result<Solved, SolveError> {
    let finer = Cut {
        degree: cut.degree + STEP,
        ..cut.clone()
    };
    let mut on_finer = solve(&finer, options)?;
    let mut found = solve(&cut, options)?;
    if is_any_missing(&found[..options.modes], &on_finer) {
        on_finer = solve_further(&finer, options, &found, on_finer, &mut solve);
        found = solve(&cut, options)?;
    }
    let changes_hz = changes(&found[..options.modes], &on_finer);
    Ok(Solved {
        cut,
        found,
        changes_hz,
    })
}

/// The list of a finer cut, made longer until it has the modes of `found`: modes that the degree
/// hardly changes can be far up in it.
fn solve_further(
    finer: &Cut,
    options: &Options,
    found: &[Found],
    mut on_finer: Vec<Found>,
    solve: &mut impl FnMut(&Cut, &Options) -> Result<Vec<Found>, SolveError>,
) -> Vec<Found> {
    let mut longer = options.clone();
    while is_any_missing(&found[..options.modes], &on_finer)
        && longer.modes < LONGEST * options.modes
    {
        longer.modes *= 2;
        // The model may have fewer modes; then the list stays as it is.
        match solve(finer, &longer) {
            Ok(more) => on_finer = more,
            Err(_) => break,
        }
    }
    on_finer
}

/// Increases the degree until the modes requested have converged.
fn raise(
    first: Cut,
    options: &Options,
    seconds: impl Fn(&Cut) -> f64,
    mut solve: impl FnMut(&Cut, &Options) -> Result<Vec<Found>, SolveError>,
) -> Result<Solved, SolveError> {
    let mut cut = first;
    let mut found = solve(&cut, options)?;
    let first_two_s = seconds(&cut) + seconds(&finer(cut.clone(), options));
    let mut left_s = PATIENCE_S + PATIENCE * first_two_s;
    loop {
        cut = finer(cut, options);
        let solved = solve(&cut, options)?;
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
        let other = partner(found, others);
        let other_hz = other.map_or(0.0, |other| other.eigenvalue.frequency_hz());
        (other_hz - found.eigenvalue.frequency_hz()).abs()
    };
    modes.iter().map(change).collect()
}

/// The same mode on another mesh.
fn partner<'a>(found: &Found, others: &'a [Found]) -> Option<&'a Found> {
    others.iter().find(|other| other.key == found.key)
}

fn is_any_missing(modes: &[Found], others: &[Found]) -> bool {
    modes.iter().any(|found| partner(found, others).is_none())
}

/// Whether no change exceeds the tolerance, or the error of the eigenvalues.
fn have_converged(changes_hz: &[f64], found: &[Found]) -> bool {
    changes_hz.iter().zip(found).all(|(change_hz, found)| {
        let known = 2.0 * found.eigenvalue.frequency_error_hz();
        *change_hz <= CONVERGED * found.eigenvalue.frequency_hz() + known
    })
}
