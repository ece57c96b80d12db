//! The spectral beam: the degree is raised until the modes stand still.

use super::model::Cut;
use super::options::{MAX_SPECTRAL_ELEMENTS, Options, SolveError};
use super::solution::Solution;
use super::spectrum::Found;
use super::warnings::warnings;
use super::{Workspace, certificate, shapes, solve_cut, within_limit};
use crate::elements::Mesh;
use crate::tower::Tower;

/// Frequencies that change by no more than this, relatively, from one degree to the next have converged.
const CONVERGED: f64 = 1e-10;
/// How much the degree is raised at a time.
const STEP: usize = 2;
/// Above this degree elements are halved instead: their matrices are full.
const MAX_DEGREE: usize = 30;
/// More modes an element than this are a matter of more elements, not of a higher degree.
const MODES_AN_ELEMENT: usize = 20;

/// Solves with rising degree until the modes asked for have converged; the last change is the estimate of the error.
pub(super) fn solve(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<Solution, SolveError> {
    let mut cut = first_cut(tower, options)?;
    let mut found = solve_cut(tower, &cut, options, workspace)?;
    let mut statistics = workspace.spectrum.statistics;
    let changes = loop {
        cut = finer(cut, options);
        let finer = solve_cut(tower, &cut, options, workspace)?;
        statistics += workspace.spectrum.statistics;
        let changes = changes(&finer[..options.modes], &found);
        found = finer;
        if have_converged(&changes, &found) || !can_be_finer(&cut, options) {
            break changes;
        }
    };
    let Workspace { model, spectrum } = workspace;
    let proof = spectrum.prove(model, &found, options.modes)?;
    let degrees_of_freedom = model.degrees_of_freedom();
    let mut modes = shapes(tower, &cut.mesh, options, &found, workspace);
    for (mode, change_hz) in modes.iter_mut().zip(changes) {
        mode.discretization_error_hz = change_hz;
    }
    let warnings = warnings(tower, &cut.mesh, options, &modes, &found);
    Ok(Solution {
        method: options.method,
        segments: cut.mesh.segments(),
        degree: Some(cut.degree),
        degrees_of_freedom,
        modes,
        certificate: certificate(&proof),
        warnings,
        statistics,
    })
}

/// One element a linear piece, or as many as told, of a degree that may do.
fn first_cut(tower: &Tower, options: &Options) -> Result<Cut, SolveError> {
    let borders = options.borders();
    let mut mesh = match options.segments {
        None => Mesh::coarsest(tower, borders),
        Some(segments) => {
            within_limit(segments, MAX_SPECTRAL_ELEMENTS)?;
            Mesh::new(tower, borders, segments)
        }
    };
    while options.modes / MODES_AN_ELEMENT > mesh.segments()
        && 2 * mesh.segments() <= MAX_SPECTRAL_ELEMENTS
    {
        mesh = mesh.doubled();
    }
    within_limit(mesh.segments(), MAX_SPECTRAL_ELEMENTS)?;
    Ok(Cut {
        degree: first_degree(options.modes, mesh.segments()),
        mesh,
    })
}

/// A degree at which so many modes of so many elements are nearly there.
fn first_degree(modes: usize, elements: usize) -> usize {
    // Half of the modes are in each bending plane, and a half wave takes about a degree and a half.
    7 + modes.div_ceil(elements)
}

/// The next finer cut: a higher degree, or elements of half the length.
fn finer(cut: Cut, options: &Options) -> Cut {
    if cut.degree + STEP <= MAX_DEGREE {
        return Cut {
            degree: cut.degree + STEP,
            ..cut
        };
    }
    let mesh = cut.mesh.doubled();
    Cut {
        degree: first_degree(options.modes, mesh.segments()),
        mesh,
    }
}

fn can_be_finer(cut: &Cut, options: &Options) -> bool {
    let elements = cut.mesh.segments();
    cut.degree + STEP <= MAX_DEGREE || 2 * elements <= MAX_SPECTRAL_ELEMENTS.min(64 * options.modes)
}

/// How far each mode moved since the coarser cut, Hz; all of its frequency if it was not there.
fn changes(finer: &[Found], coarser: &[Found]) -> Vec<f64> {
    let change = |found: &Found| {
        let before = coarser
            .iter()
            .find(|other| other.family == found.family && other.order == found.order);
        let before_hz = before.map_or(0.0, |before| before.eigenvalue.frequency_hz());
        (before_hz - found.eigenvalue.frequency_hz()).abs()
    };
    finer.iter().map(change).collect()
}

/// Whether no change is above the tolerance, or above what the eigenvalues are known to.
fn have_converged(changes_hz: &[f64], found: &[Found]) -> bool {
    changes_hz.iter().zip(found).all(|(change_hz, found)| {
        let known = 2.0 * found.eigenvalue.frequency_error_hz();
        *change_hz <= CONVERGED * found.eigenvalue.frequency_hz() + known
    })
}
