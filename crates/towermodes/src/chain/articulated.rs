//! The articulated factorization of K − σM in O(n), with solve and inertia count.
//!
//! In scaled joint coordinates K − σM = 1 + Gᵀ Jᵀ B J G with B = S − σM block diagonal over the bodies. Seen from a joint, all
//! that is above it is one symmetric D×D matrix P. Going down from the tip,
//!
//! P ← B + Xᵀ P X;  for each spring of the joint, with column p = P e and root g = 1/√k:
//! δ = 1 + g² eᵀp,  P ← P − p pᵀ g²/δ.
//!
//! This is Featherstone's articulated-body recursion (2008, ch. 7) with forces in place of accelerations; the springs of one
//! joint are eliminated one by one, which needs no inverse. The pivots δ are the D of a factorization L D Lᵀ, so by Sylvester's
//! law the number of negative ones is the number of eigenvalues below σ: a Sturm count in O(n).

use super::model::Chain;
use super::space::{Dim, Space, add_scaled, lower, lower_matrix, raise};

/// Pivots closer to zero than this are moved there, to the negative side: 1 is the unit of a pivot, so the change is far
/// below rounding, and an eigenvalue hit exactly counts as below.
const TINY_PIVOT: f64 = 1e-30;

/// One eliminated spring.
#[derive(Debug, Clone, Copy)]
pub struct Elimination<const D: usize> {
    /// δ.
    pivot: f64,
    /// P e before the elimination.
    column: [f64; D],
}

/// The number of eigenvalues of the chain below the shift σ (rad²/s²), counted without storing anything.
pub fn count_below<const D: usize>(chain: &Chain<D>, shift: f64) -> usize
where
    Dim<D>: Space,
{
    eliminate(chain, shift, |_| {})
}

/// Factors K − σM into `factors` and returns the number of eigenvalues below σ (rad²/s²).
pub fn factorize<const D: usize>(
    chain: &Chain<D>,
    shift: f64,
    factors: &mut Vec<Elimination<D>>,
) -> usize
where
    Dim<D>: Space,
{
    factors.clear();
    eliminate(chain, shift, |elimination| factors.push(elimination))
}

/// Eliminates every spring from the tip down, tells each to `record`, returns how many pivots are negative.
#[inline]
fn eliminate<const D: usize>(
    chain: &Chain<D>,
    shift: f64,
    mut record: impl FnMut(Elimination<D>),
) -> usize
where
    Dim<D>: Space,
{
    let mut p = [[0.0; D]; D];
    let mut above_m = 0.0;
    let mut negative = 0;
    for (joint, link) in chain.links.iter().enumerate().rev() {
        lower_matrix(&mut p, above_m - link.height_m);
        above_m = link.height_m;
        add_scaled(&mut p, -shift, &link.inertia);
        if let Some(ground) = chain.ground_of(joint) {
            add_scaled(&mut p, 1.0, ground);
        }
        for (component, &root) in link.root.iter().enumerate() {
            if root == 0.0 {
                continue;
            }
            let column = p[component];
            let mut pivot = 1.0 + root * root * column[component];
            if pivot.abs() < TINY_PIVOT {
                pivot = -TINY_PIVOT;
            }
            negative += usize::from(pivot < 0.0);
            record(Elimination { pivot, column });
            let inverse = 1.0 / pivot;
            let factor = root * root * inverse;
            for (row, out) in p.iter_mut().enumerate() {
                // In the spring's own row and column p − p p_e g²/δ is p/δ: no cancellation when the spring is soft.
                for (col, entry) in out.iter_mut().enumerate() {
                    *entry = if row == component || col == component {
                        *entry * inverse
                    } else {
                        *entry - column[row] * column[col] * factor
                    };
                }
            }
        }
    }
    negative
}

/// Solves (K − σM) y = x in place, with the factors of [`factorize`].
///
/// Down: u = x − g eᵀb, b ← b + p g u/δ.  Up: y = (u − g pᵀv)/δ, v ← v + e g y.
pub fn solve<const D: usize>(chain: &Chain<D>, factors: &[Elimination<D>], x: &mut [f64])
where
    Dim<D>: Space,
{
    bias_down(chain, factors, x);
    motion_up(chain, factors, x);
}

fn bias_down<const D: usize>(chain: &Chain<D>, factors: &[Elimination<D>], x: &mut [f64])
where
    Dim<D>: Space,
{
    let mut bias = [0.0; D];
    let mut above_m = 0.0;
    let mut eliminations = factors.iter();
    // Within a joint the springs were eliminated in order of component, but x is filled from its end: go joint by joint.
    let mut first = x.len();
    for link in chain.links.iter().rev() {
        lower(&mut bias, above_m - link.height_m);
        above_m = link.height_m;
        first -= link.root.iter().filter(|root| **root != 0.0).count();
        let moving = (0..D).filter(|&component| link.root[component] != 0.0);
        for (x, component) in x[first..].iter_mut().zip(moving) {
            let elimination = eliminations
                .next()
                .expect("one elimination for each spring");
            let root = link.root[component];
            *x -= root * bias[component];
            let reaction = root * *x / elimination.pivot;
            for (b, p) in bias.iter_mut().zip(&elimination.column) {
                *b += p * reaction;
            }
        }
    }
}

fn motion_up<const D: usize>(chain: &Chain<D>, factors: &[Elimination<D>], x: &mut [f64])
where
    Dim<D>: Space,
{
    let mut motion = [0.0; D];
    let mut below_m = 0.0;
    let mut eliminations = factors.iter().rev();
    let mut first = 0;
    for link in &chain.links {
        raise(&mut motion, link.height_m - below_m);
        below_m = link.height_m;
        let count = link.root.iter().filter(|root| **root != 0.0).count();
        let moving = (0..D)
            .rev()
            .filter(|&component| link.root[component] != 0.0);
        for (x, component) in x[first..first + count].iter_mut().rev().zip(moving) {
            let elimination = eliminations
                .next()
                .expect("one elimination for each spring");
            let root = link.root[component];
            let pull: f64 = elimination
                .column
                .iter()
                .zip(&motion)
                .map(|(p, v)| p * v)
                .sum();
            *x = (*x - root * pull) / elimination.pivot;
            motion[component] += root * *x;
        }
        first += count;
    }
}
