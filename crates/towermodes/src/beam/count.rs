//! The inertia count of a beam in O(n).
//!
//! As for a chain of rigid bodies: seen from the base of an element, all that is above it is one symmetric D×D matrix P. Going down,
//!
//! A ← −σ M_e + [X T]ᵀ P [X T] + diag(0, 1),
//!
//! the element's coordinates are eliminated from A one by one, the stiffest first, and what is left is the P of its base. The pivots
//! are the D of a factorization L D Lᵀ of K − σM, so the negative ones are the eigenvalues below σ (Sylvester).

use super::model::{Beam, add_congruent};
use crate::chain::{Dim, Space};

/// Pivots closer to zero than this are moved there, to the negative side: an eigenvalue hit exactly counts as below.
const TINY_PIVOT: f64 = 1e-30;

/// The number of eigenvalues of the beam below the shift σ (rad²/s²); `work` is working memory.
pub fn count_below<const D: usize>(beam: &Beam<D>, shift: f64, work: &mut Vec<f64>) -> usize
where
    Dim<D>: Space,
{
    let rows = beam.rows();
    work.clear();
    work.resize(rows * rows + D * rows, 0.0);
    let (matrix, top) = work.split_at_mut(rows * rows);
    let mut above = [[0.0; D]; D];
    let mut negative = 0;
    for element in (0..beam.elements()).rev() {
        let mass = &beam.masses[element * rows * rows..(element + 1) * rows * rows];
        for (entry, mass) in matrix.iter_mut().zip(mass) {
            *entry = -shift * mass;
        }
        beam.top_motion(element, top);
        add_congruent(&above, top, rows, matrix);
        (D..rows).for_each(|i| matrix[i * rows + i] += 1.0);
        negative += eliminate::<D>(matrix, rows);
        above = std::array::from_fn(|i| std::array::from_fn(|j| matrix[i * rows + j]));
    }
    negative
}

/// Eliminates all rows from the last to the D-th; returns how many pivots are negative.
fn eliminate<const D: usize>(matrix: &mut [f64], rows: usize) -> usize {
    let mut negative = 0;
    for last in (D..rows).rev() {
        let (rest, row) = matrix.split_at_mut(last * rows);
        let mut pivot = row[last];
        if pivot.abs() < TINY_PIVOT {
            pivot = -TINY_PIVOT;
        }
        negative += usize::from(pivot < 0.0);
        for (i, out) in rest.chunks_exact_mut(rows).enumerate() {
            let factor = row[i] / pivot;
            for (out, row) in out[..last].iter_mut().zip(&row[..last]) {
                *out -= factor * row;
            }
        }
    }
    negative
}
