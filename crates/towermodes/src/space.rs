//! Rigid-body motions, forces and matrices at points on one vertical axis.
//!
//! A motion that is known at one height is known at every height: only the transverse translations
//! change, by rotation times rise. That is all the spatial algebra that a straight tower needs. It
//! is written once for D components, and a table of levers gives which rotation moves which
//! translation.
//!
//! Source: Featherstone, *Rigid Body Dynamics Algorithms* (2008), ch. 2, restricted to
//! displacements along z.
//!
//! | D | components |
//! |---|---|
//! | 1 | axial translation, or rotation about the axis |
//! | 2 | a bending plane: deflection w, rotation θ |
//! | 3 | a bending plane and a motion of one component |
//! | 6 | x, y, z, rotation about x, y, z |
//!
//! Any other D is a compile-time error.

use crate::scalar::Number;
pub use crate::symmetric::eigenpairs;

/// One entry of the rigid-body transformation X(h) = 1 + h·Σ sign·e_moved e_byᵀ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lever {
    /// Index of the translation component.
    pub(crate) moved: usize,
    /// Index of the rotation component that changes this translation.
    pub(crate) by: usize,
    /// +1, or −1 if a positive rotation decreases the translation.
    pub(crate) sign: f64,
}

const IN_A_PLANE: [Lever; 1] = [Lever {
    moved: 0,
    by: 1,
    sign: 1.0,
}];

const IN_SPACE: [Lever; 2] = [
    Lever {
        moved: 0,
        by: 4,
        sign: 1.0,
    },
    Lever {
        moved: 1,
        by: 3,
        sign: -1.0,
    },
];

/// The entries of X(h) for motions of `components` components.
pub(crate) const fn levers(components: usize) -> &'static [Lever] {
    match components {
        1 => &[],
        2 | 3 => &IN_A_PLANE,
        6 => &IN_SPACE,
        _ => panic!("a motion has 1, 2, 3 or 6 components"),
    }
}

/// A D×D matrix with entries S, Hermitian if they are complex; both triangles are stored.
pub type SquareMatrix<S, const D: usize> = [[S; D]; D];

/// A symmetric D×D matrix; both triangles are stored.
pub type Matrix<const D: usize> = SquareMatrix<f64, D>;

/// A symmetric matrix for the motion (x, y, z, rotation about x, y, z) of a point.
///
/// Inertia: kg, kg m, kg m². Stiffness: N/m, N, N m.
pub type SpatialMatrix = Matrix<6>;

/// Replaces a motion v by the motion X v of the point `rise_m` above (m, rad).
#[inline]
pub fn transform_motion<const D: usize, S: Number>(motion: &mut [S; D], rise_m: f64) {
    for lever in const { levers(D) } {
        let by = motion[lever.by];
        motion[lever.moved] += by.times(lever.sign * rise_m);
    }
}

/// Replaces a force f by its equivalent Xᵀ f at the point `rise_m` below (N, N m).
#[inline]
pub fn transform_force<const D: usize, S: Number>(force: &mut [S; D], rise_m: f64) {
    for lever in const { levers(D) } {
        let moved = force[lever.moved];
        force[lever.by] += moved.times(lever.sign * rise_m);
    }
}

/// Replaces an inertia or stiffness P by its equivalent Xᵀ P X for the motion of the point `rise_m`
/// below.
///
/// # Example
/// A point mass of 2 kg, 3 m above the point: m h = 6 kg m and m h² = 18 kg m².
/// ```
/// let mut inertia = [[2.0, 0.0], [0.0, 0.0]];
/// towermodes::space::transform_matrix(&mut inertia, 3.0);
/// assert_eq!(inertia, [[2.0, 6.0], [6.0, 18.0]]);
/// ```
#[inline]
pub fn transform_matrix<const D: usize, S: Number>(matrix: &mut SquareMatrix<S, D>, rise_m: f64) {
    for row in matrix.iter_mut() {
        transform_force(row, rise_m);
    }
    for lever in const { levers(D) } {
        let moved = matrix[lever.moved];
        for (entry, moved) in matrix[lever.by].iter_mut().zip(moved) {
            *entry += moved.times(lever.sign * rise_m);
        }
    }
}

/// The product of a symmetric matrix and a vector.
#[inline]
pub fn times<const D: usize, S: Number>(matrix: &Matrix<D>, vector: &[S; D]) -> [S; D] {
    let mut product = [S::default(); D];
    // By columns, which are the rows: no sum along a row, so the components go in step.
    for (column, x) in matrix.iter().zip(vector) {
        for (sum, entry) in product.iter_mut().zip(column) {
            *sum += x.times(*entry);
        }
    }
    product
}

/// Adds `addend` to `sum`, component by component.
#[inline]
pub fn add<const D: usize, S: Number>(sum: &mut [S; D], addend: &[S; D]) {
    for (s, a) in sum.iter_mut().zip(addend) {
        *s += *a;
    }
}

/// Adds `factor` times `addend` to `sum`, entry by entry.
#[inline]
pub fn add_scaled<const D: usize, S: Number>(
    sum: &mut SquareMatrix<S, D>,
    factor: S,
    addend: &Matrix<D>,
) {
    for (sum, addend) in sum.iter_mut().zip(addend) {
        for (s, a) in sum.iter_mut().zip(addend) {
            *s += factor.times(*a);
        }
    }
}
