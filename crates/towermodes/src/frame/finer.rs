//! How much eigenvalues of a frame change with elements of a higher degree.
//!
//! With the motions of the nodes held, an element of a higher degree has other forces at its ends.
//! For an eigenvector x with eigenvalue λ the change of all these energies is that of the
//! eigenvalue to first order, as x is stationary:
//!
//! δλ = Σ (eᵀ D′(λ) e − eᵀ D(λ) e) / xᵀ M x,
//!
//! with the motions e of the ends of each element and its matrix D for them, without its bubbles.

use super::equations::{ELASTIC, Equations, GEOMETRIC, GROUND, INERTIA, KINDS, Link, motion_of};
use super::parts::{MOST_ENDS, inverse_of_columns};
use super::rigid::{Motion, moved};

/// Working memory.
#[derive(Debug, Default)]
pub(super) struct Finer {
    motions: Vec<Motion>,
    factors: Vec<Vec<f64>>,
    rest: Vec<f64>,
    at: Vec<f64>,
}

impl Finer {
    /// Σ (eᵀ D′ e − eᵀ D e) for the unknowns x of equations that begin with those of a frame, from
    /// the elements of the frame to `finer` ones.
    pub(super) fn change(
        &mut self,
        (equations, finer): (&Equations, &Equations),
        lambda: f64,
        x: &[f64],
    ) -> f64 {
        let mut a = [0.0; KINDS];
        (a[INERTIA], a[GROUND]) = (-lambda, 1.0);
        (a[GEOMETRIC], a[ELASTIC]) = (1.0, 1.0);
        let Self {
            motions,
            factors,
            rest,
            at,
        } = self;
        equations.set_motions(x, motions);
        let mut change = 0.0;
        for (link, fine) in equations.links.iter().zip(&finer.links) {
            if link.own == 0.0 {
                continue;
            }
            let near = motion_of(motions, link.parent);
            let side = link.side(x, &near);
            let mut energies = [0.0; KINDS];
            link.parts
                .add_energies(&side.ends, side.bubbles, at, &mut energies);
            let own = &x[link.first..][..link.coordinates];
            energies[ELASTIC] += own.iter().map(|x| x * x).sum::<f64>();
            change -= sum(&a, &energies);
            let mut ends = [0.0; MOST_ENDS];
            ends[..6].copy_from_slice(&near);
            ends[6..6 + fine.tip.len()].copy_from_slice(&of_far(fine, &near, &motions[link.child]));
            factors.resize(fine.parts.blocks.len().max(factors.len()), Vec::new());
            fine.parts
                .condense((&a, 1.0), &mut factors.iter_mut(), rest);
            change += energy(rest, &ends[..fine.parts.ends]);
        }
        for (chord, fine) in equations.chords.iter().zip(&finer.chords) {
            let of_ends = chord.ends.map(|end| motion_of(motions, end));
            let side = chord.side(x, of_ends);
            let mut energies = [0.0; KINDS];
            chord
                .parts
                .add_energies(&side.ends, side.bubbles, at, &mut energies);
            energies[ELASTIC] += side.bubbles.iter().map(|x| x * x).sum::<f64>();
            change -= sum(&a, &energies);
            factors.resize(fine.parts.blocks.len().max(factors.len()), Vec::new());
            fine.parts
                .condense((&a, 1.0), &mut factors.iter_mut(), rest);
            change += energy(rest, &of_ends.concat());
        }
        change
    }
}

fn sum(factors: &[f64; KINDS], energies: &[f64; KINDS]) -> f64 {
    factors.iter().zip(energies).map(|(a, e)| a * e).sum()
}

/// eᵀ D e.
fn energy(matrix: &[f64], ends: &[f64]) -> f64 {
    let rows = matrix.chunks_exact(ends.len()).zip(ends);
    rows.map(|(row, x)| x * row.iter().zip(ends).map(|(d, e)| d * e).sum::<f64>())
        .sum()
}

/// The coordinates of a link that move its child as it moves.
fn of_far(link: &Link, near: &Motion, far: &Motion) -> Vec<f64> {
    let carried = moved(&link.transfer, near);
    let columns: Vec<Vec<f64>> = link.tip.iter().map(|column| column.to_vec()).collect();
    let inverse = inverse_of_columns(&columns, 6);
    let own = inverse.iter().take(columns.len()).map(|row| {
        let difference = far.iter().zip(carried).map(|(far, carried)| far - carried);
        row.iter().zip(difference).map(|(a, x)| a * x).sum()
    });
    own.collect()
}
