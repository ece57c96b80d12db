//! Modes of equal frequency, combined so that each moves along or about one axis.
//!
//! Any linear combination of modes with the same frequency is a mode, and an eigensolver gives an
//! arbitrary one. An engineer expects the one that bends in one plane, or surges without yawing.

use super::model::Model;
use crate::eigen::EigenWorkspace;
use crate::symmetric::eigenpairs;

/// If more modes have the same frequency, they are not changed.
const MOST: usize = 6;

/// Mixes the eigenvectors of a subsystem that have one eigenvalue, within a relative distance, so
/// that each is as much of one motion as can be: bending fore-aft first, then side-side, torsion,
/// stretch.
pub(super) fn align(
    model: &mut Model,
    subsystem: usize,
    repeated: f64,
    workspace: &mut EigenWorkspace,
) {
    if model.has_single_motion(subsystem) {
        return;
    }
    let mut first = 0;
    while first < workspace.eigenvalues().len() {
        let others = &workspace.eigenvalues()[first..];
        let ceiling = others[0].lambda * (1.0 + repeated);
        let count = others.iter().take_while(|e| e.lambda <= ceiling).count();
        if (2..=MOST).contains(&count) {
            let rows = axes(model, subsystem, workspace, first, count);
            workspace.mix(first, count, &rows);
        }
        first += count;
    }
}

/// The coefficients that combine the vectors from `first` on: one row per new vector.
fn axes(
    model: &mut Model,
    subsystem: usize,
    workspace: &EigenWorkspace,
    first: usize,
    count: usize,
) -> [[f64; MOST]; MOST] {
    // The motion that should be first has the lowest value.
    let mut value = |vector: &[f64]| {
        let kinetic = model.modal_forces(subsystem, vector).kinetic;
        -(3.0 * kinetic.fore_aft + 2.0 * kinetic.side_side + kinetic.torsion)
    };
    let mut form = |i: usize, j: usize| {
        let (a, b) = (workspace.vector(first + i), workspace.vector(first + j));
        let of = |sign: f64| -> Vec<f64> { a.iter().zip(b).map(|(a, b)| a + sign * b).collect() };
        // A bilinear form is computed from squares.
        0.25 * (value(&of(1.0)) - value(&of(-1.0)))
    };
    let mut matrix = [[0.0; MOST]; MOST];
    let pairs = (0..count).flat_map(|i| (0..=i).map(move |j| (i, j)));
    for (i, j) in pairs {
        matrix[i][j] = form(i, j);
        matrix[j][i] = matrix[i][j];
    }
    // Missing motions are last.
    let beyond = 1.0 + matrix.iter().flatten().map(|x| x.abs()).sum::<f64>();
    (count..MOST).for_each(|i| matrix[i][i] = beyond);
    eigenpairs(matrix).1
}
