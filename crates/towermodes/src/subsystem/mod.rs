//! Uncoupled groups of motions of a model, each an eigenvalue problem, for all element types.

mod coefficients;
mod coordinates;
mod curves;
mod list;
mod pencil;

pub use coefficients::{Coefficients, MatrixKind};
pub(crate) use coordinates::{Coordinates, dimension};
pub use curves::{SegmentCurves, ShearFraction};
pub use list::Subsystems;
pub use pencil::{Eigenproblem, ProductObserver, SubsystemPencil};

use crate::space::SpatialMatrix;
use crate::tower::Motions;

/// The equations of motion of an uncoupled group of motions, with the memory to work on them.
///
/// A subsystem is assembled from the base upwards: base, then what flexes (joints or elements, by
/// the methods of its kind) and what is attached in between. Its unknowns are scaled so that the
/// stiffness of joints or elements is the identity; see [`Chain`](crate::chain::Chain) and
/// [`Beam`](crate::beam::Beam). Vectors have as many entries as there are
/// [degrees of freedom](Self::degrees_of_freedom).
///
/// All algorithms take O(n) time and memory for n segments.
pub trait Subsystem: Send + Sync {
    /// The motions that are coupled here.
    fn motions(&self) -> Motions;

    /// Number of unknowns.
    fn degrees_of_freedom(&self) -> usize;

    /// Whether every number is finite: false if the numbers of the tower overflowed.
    fn is_finite(&self) -> bool;

    /// Removes everything but keeps the memory.
    fn clear(&mut self);

    /// Begins with a base at a height (m). It moves freely in the components (x, y, z, rotation
    /// about x, y, z) with a unit: the motion (m or rad) for a coordinate of 1. Zero holds one.
    fn add_base(&mut self, height_m: f64, unit: &[f64; 6]);

    /// Adds a matrix, given for the motion of the point at `reference_m` (m), to what was added
    /// last.
    fn add(&mut self, kind: MatrixKind, reference_m: f64, matrix: &SpatialMatrix);

    /// Adds a geometric stiffness −`moment_n_m` (N m/rad) against rotation in the bending planes to
    /// what was added last: a body of weight W whose centre is h above the point that it turns
    /// about has −W h.
    fn add_geometric_stiffness(&mut self, moment_n_m: f64);

    /// Whether a matrix A is the identity.
    fn is_identity(&self, a: &Coefficients) -> bool;

    /// out = A x.
    fn product(&mut self, a: &Coefficients, x: &[f64], out: &mut [f64]);

    /// The number of negative eigenvalues of A, by Sylvester's law of inertia.
    fn count_negative(&mut self, a: &Coefficients) -> usize;

    /// Factors A for [`solve`](Self::solve) and returns the number of its negative eigenvalues.
    fn factorize(&mut self, a: &Coefficients) -> usize;

    /// x ← A⁻¹ x, with the matrix factored last.
    fn solve(&mut self, x: &mut [f64]);

    /// xᵀ A x.
    fn energy(&mut self, a: &Coefficients, x: &[f64]) -> f64;

    /// The resultant of A x about the base at `base_m` (m), and the energy xᵀ A x by components.
    fn resultant(&mut self, a: &Coefficients, x: &[f64], base_m: f64) -> Resultant;

    /// A start vector for iterations, with a part in every mode that a shaken base excites: the
    /// inertia forces of a rigid-body motion that is 1 in every component at the base.
    fn start(&mut self, out: &mut [f64]);

    /// An eigenvector as curves over segments with these borders, m.
    fn curves<'a>(
        &self,
        borders_m: &'a [f64],
        shear: &'a ShearFraction<'a>,
        vector: &[f64],
    ) -> Box<dyn SegmentCurves + 'a>;
}

/// What a matrix A and a vector x of a subsystem give, in (x, y, z, rotation about x, y, z).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resultant {
    /// The resultant of A x about the base. For the inertia: the products with the rigid-body
    /// motions of the whole.
    pub force: [f64; 6],
    /// The contribution of each component to xᵀ A x.
    pub energy: [f64; 6],
}
