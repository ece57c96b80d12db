//! The articulated factorization of a matrix A of a chain, as K − σM, in O(n), with solution and
//! eigenvalue count.
//!
//! In scaled joint coordinates A = k + Gᵀ Jᵀ B J G with k = 1 for springs, 0 for a free base, and B
//! = S + W − σM block diagonal over the bodies (S stiffness to the ground, W geometric stiffness).
//! Seen from a joint, all that is above it is one symmetric D×D matrix P. From the tip down,
//!
//! P ← B + Xᵀ P X;  for each spring of the joint, with column p = P e and root g = 1/√k:
//! δ = k + g² eᵀp,  P ← P − p pᵀ g²/δ.
//!
//! A shear deflection under a compression N is coupled with the rotation θ above it by −N: its
//! column is p − N e_θ.
//!
//! Source: the articulated-body recursion of Featherstone (2008, ch. 7) with forces in place of
//! accelerations. The springs of one joint are eliminated one by one, which needs no inverse. The
//! pivots δ are the D of a factorization L D Lᵀ, so by Sylvester's law the number of negative ones
//! is the number of eigenvalues below σ: a Sturm count in O(n).

use super::model::{Chain, Link};
use crate::lanes::Lanes;
use crate::scalar::Number;
use crate::space::{
    Matrix, SquareMatrix, add, add_scaled, levers, transform_force, transform_matrix,
    transform_motion,
};
use crate::subsystem::Coefficients;

/// Pivots closer to zero than this are moved there, to the negative side: 1 is the unit of a pivot,
/// so the change is far below rounding, and an eigenvalue hit exactly counts as below.
const TINY_PIVOT: f64 = 1e-30;

/// One eliminated spring.
#[derive(Debug, Clone, Copy)]
pub struct Elimination<const D: usize, T = f64> {
    /// 1/δ of the pivot δ.
    inverse: T,
    /// Column P e before the elimination.
    column: [T; D],
}

/// The number of negative eigenvalues of a matrix A of the chain; nothing is stored.
pub fn count_negative<const D: usize>(chain: &Chain<D>, a: &Coefficients) -> usize {
    eliminate(chain, a, a.mass, &mut ()) as usize
}

/// Factors a matrix A of the chain into `factors` and returns the number of its negative
/// eigenvalues.
pub fn factorize<const D: usize>(
    chain: &Chain<D>,
    a: &Coefficients,
    factors: &mut Vec<Elimination<D>>,
) -> usize {
    factors.clear();
    eliminate(chain, a, a.mass, factors) as usize
}

/// What uses the eliminated springs, from the tip down.
pub(super) trait Eliminations<const D: usize, T> {
    /// The springs of this joint are the next; it is `rise_m` below the joint before.
    #[inline(always)]
    fn begin(&mut self, _joint: usize, _link: &Link<D>, _rise_m: f64) {}

    /// The next spring of the joint, of this component and root.
    fn take(&mut self, component: usize, root: f64, elimination: Elimination<D, T>);
}

impl<const D: usize, T> Eliminations<D, T> for () {
    #[inline(always)]
    fn take(&mut self, _component: usize, _root: f64, _elimination: Elimination<D, T>) {}
}

impl<const D: usize, T> Eliminations<D, T> for Vec<Elimination<D, T>> {
    #[inline(always)]
    fn take(&mut self, _component: usize, _root: f64, elimination: Elimination<D, T>) {
        self.push(elimination);
    }
}

/// Eliminates every spring from the tip down, and returns how many pivots are negative. `mass` is
/// the coefficient of the inertia, which may be different in each lane.
#[inline]
pub(super) fn eliminate<const D: usize, T: Lanes>(
    chain: &Chain<D>,
    a: &Coefficients,
    mass: T,
    eliminations: &mut impl Eliminations<D, T>,
) -> T {
    let mut p = [[T::default(); D]; D];
    let mut above_m = 0.0;
    let mut negative = T::default();
    let has_geometric = a.geometric != 0.0;
    for (joint, (link, inertia)) in chain.links.iter().zip(&chain.inertias).enumerate().rev() {
        let rise_m = above_m - link.height_m;
        transform_matrix(&mut p, rise_m);
        eliminations.begin(joint, link, rise_m);
        above_m = link.height_m;
        if link.has_body {
            add_body(chain, (a, mass), joint, inertia, &mut p);
        }
        if has_geometric {
            add_geometric(link, a.geometric, &mut p);
        }
        let spring = a.stiffness * link.spring;
        for_components!(D, component, {
            let root = link.root[component];
            if root != 0.0 {
                let mut column = p[component];
                let pivot = T::real(spring) + column[component].times(root * root);
                let pivot = pivot.off_zero(TINY_PIVOT);
                negative += pivot.one_if_negative();
                let inverse = pivot.inverse();
                let spring = (spring, root, inverse);
                if has_geometric {
                    let p_delta = p_delta(link, a.geometric, component);
                    add(&mut column, &p_delta.map(T::real));
                    update_pressed(&mut p, component, &column, &p_delta, spring);
                } else {
                    update(&mut p, component, &column, spring);
                }
                eliminations.take(component, root, Elimination { inverse, column });
            }
        });
    }
    negative
}

/// P ← P − p pᵀ g²/δ after the elimination of one spring k of root g.
#[inline(always)]
fn update<const D: usize, T: Number>(
    matrix: &mut SquareMatrix<T, D>,
    component: usize,
    column: &[T; D],
    (spring, root, inverse): (f64, f64, T),
) {
    let fraction = inverse.times(spring);
    subtract_square(matrix, component, column, inverse.times(root * root));
    // In the spring's own row and column p − p p_e g²/δ is p k/δ: no cancellation when the spring
    // is soft.
    for k in 0..D {
        let entry = column[k] * fraction;
        matrix[component][k] = entry;
        matrix[k][component] = entry;
    }
}

/// As above, if a compression couples the spring with a rotation by `p_delta`, which is part of the
/// column.
#[inline(always)]
fn update_pressed<const D: usize, T: Number>(
    matrix: &mut SquareMatrix<T, D>,
    component: usize,
    column: &[T; D],
    p_delta: &[f64; D],
    (spring, root, inverse): (f64, f64, T),
) {
    let factor = inverse.times(root * root);
    let own = matrix[component];
    subtract_square(matrix, component, column, factor);
    let (fraction, slid) = (inverse.times(spring), own[component] * factor);
    for k in 0..D {
        let entry = own[k] * fraction - slid.times(p_delta[k]);
        matrix[component][k] = entry;
        matrix[k][component] = entry;
    }
}

/// Subtracts `factor` c cᵀ from a symmetric matrix, except in one row and column.
#[inline(always)]
fn subtract_square<const D: usize, T: Number>(
    matrix: &mut SquareMatrix<T, D>,
    component: usize,
    column: &[T; D],
    factor: T,
) {
    for i in 0..D {
        for j in 0..D {
            if i != component && j != component {
                matrix[i][j] -= column[i] * column[j] * factor;
            }
        }
    }
}

/// P ← P + mass M + foundation S of one body.
#[inline]
fn add_body<const D: usize, T: Lanes>(
    chain: &Chain<D>,
    (a, mass): (&Coefficients, T),
    joint: usize,
    inertia: &Matrix<D>,
    p: &mut SquareMatrix<T, D>,
) {
    if !mass.are_zero() {
        add_scaled(p, mass, inertia);
    }
    if a.foundation != 0.0
        && let Some(foundation) = chain.foundation.get(joint)
    {
        add_scaled(p, T::real(a.foundation), foundation);
    }
}

/// P ← P + geometric G of one body.
#[inline]
fn add_geometric<const D: usize, T: Number>(
    link: &Link<D>,
    geometric: f64,
    p: &mut SquareMatrix<T, D>,
) {
    for lever in const { levers(D) } {
        p[lever.by][lever.by] -= T::real(geometric * link.geometric_n_m);
    }
}

/// The column −N s e_θ by which a shear deflection of a joint is coupled with the rotation of its
/// body (P-Delta effect).
#[inline(always)]
fn p_delta<const D: usize>(link: &Link<D>, geometric: f64, component: usize) -> [f64; D] {
    let mut column = [0.0; D];
    for lever in const { levers(D) } {
        if lever.moved == component {
            column[lever.by] -= geometric * link.compression_n * lever.sign;
        }
    }
    column
}

/// Solves A y = x in place, with the factors of A from [`factorize`].
///
/// Down: u = x − g eᵀb, b ← b + p g u/δ.  Up: y = (u − g pᵀv)/δ, v ← v + e g y.
pub fn solve<const D: usize>(chain: &Chain<D>, factors: &[Elimination<D>], x: &mut [f64]) {
    bias_down(chain, factors, x);
    motion_up(chain, factors, x, |_, _, _, _| {});
}

pub(super) fn bias_down<const D: usize>(
    chain: &Chain<D>,
    factors: &[Elimination<D>],
    x: &mut [f64],
) {
    let mut bias = [0.0; D];
    let mut above_m = 0.0;
    let (mut rest, mut factors) = (x, factors);
    for link in chain.links.iter().rev() {
        transform_force(&mut bias, above_m - link.height_m);
        above_m = link.height_m;
        // The springs of a joint were eliminated in order of component, but x is read from its end:
        // process joint by joint.
        let (below, own) = rest.split_at_mut(rest.len() - link.moving);
        let (eliminations, others) = factors.split_at(link.moving);
        (rest, factors) = (below, others);
        // Nearly all joints move in every component, so this case has no branches.
        if let (Ok(own), Ok(springs)) = (
            <&mut [f64; D]>::try_from(&mut *own),
            <&[Elimination<D>; D]>::try_from(eliminations),
        ) {
            for_components!(D, component, {
                let root = link.root[component];
                springs[component].bias(component, root, &mut own[component], &mut bias);
            });
            continue;
        }
        let mut springs = own.iter_mut().zip(eliminations);
        for_components!(D, component, {
            let root = link.root[component];
            if root != 0.0
                && let Some((x, spring)) = springs.next()
            {
                spring.bias(component, root, x, &mut bias);
            }
        });
    }
}

/// Passes to `body` each joint with the motion of the body above and its own coordinates.
#[inline(always)]
pub(super) fn motion_up<const D: usize, T: Number>(
    chain: &Chain<D>,
    factors: &[Elimination<D, T>],
    x: &mut [T],
    mut body: impl FnMut(usize, &Link<D>, &[T; D], &[T]),
) {
    let mut motion = [T::default(); D];
    let mut below_m = 0.0;
    let (mut rest, mut factors) = (x, factors);
    for (joint, link) in chain.links.iter().enumerate() {
        transform_motion(&mut motion, link.height_m - below_m);
        below_m = link.height_m;
        let (own, above) = rest.split_at_mut(link.moving);
        let (others, eliminations) = factors.split_at(factors.len() - link.moving);
        (rest, factors) = (above, others);
        if let (Ok(own), Ok(springs)) = (
            <&mut [T; D]>::try_from(&mut *own),
            <&[Elimination<D, T>; D]>::try_from(eliminations),
        ) {
            for_components!(D, from_the_last, {
                let component = D - 1 - from_the_last;
                let root = link.root[component];
                springs[component].release(component, root, &mut own[component], &mut motion);
            });
            body(joint, link, &motion, own);
            continue;
        }
        let mut springs = own.iter_mut().zip(eliminations).rev();
        for_components!(D, from_the_last, {
            let component = D - 1 - from_the_last;
            let root = link.root[component];
            if root != 0.0
                && let Some((x, spring)) = springs.next()
            {
                spring.release(component, root, x, &mut motion);
            }
        });
        body(joint, link, &motion, own);
    }
}

impl<const D: usize, T: Number> Elimination<D, T> {
    /// u = x − g eᵀb in place of x, then b ← b + p g u/δ, for the spring of a component.
    #[inline(always)]
    pub(super) fn bias(&self, component: usize, root: f64, x: &mut T, bias: &mut [T; D]) {
        *x -= bias[component].times(root);
        let reaction = x.times(root) * self.inverse;
        for (b, p) in bias.iter_mut().zip(&self.column) {
            *b += *p * reaction;
        }
    }

    /// y = (u − g pᵀv)/δ in place of u, then v ← v + e g y, for the spring of a component.
    #[inline(always)]
    fn release(&self, component: usize, root: f64, x: &mut T, motion: &mut [T; D]) {
        let pull = dot(&self.column, motion);
        *x = (*x - pull.times(root)) * self.inverse;
        motion[component] += x.times(root);
    }
}

/// pᵀv, with even and odd components summed separately: this halves the chain of dependent
/// additions.
#[inline]
fn dot<const D: usize, T: Number>(p: &[T; D], v: &[T; D]) -> T {
    let mut sums = [T::default(); 2];
    for (k, (p, v)) in p.iter().zip(v).enumerate() {
        sums[k % 2] += *p * *v;
    }
    sums[0] + sums[1]
}
