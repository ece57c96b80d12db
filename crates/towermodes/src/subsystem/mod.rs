//! Uncoupled groups of motions of a model, each an eigenvalue problem, for all element types.

mod branch;
mod coefficients;
mod coordinates;
mod curves;
mod forces;
mod list;
mod pencil;
mod states;

pub use branch::{Branch, BranchLink};
pub use coefficients::{Coefficients, MatrixKind};
pub(crate) use coordinates::{Coordinates, dimension};
pub use curves::{SegmentCurves, ShearFraction};
pub use forces::{ForceReader, InternalForces};
pub use list::Subsystems;
pub use pencil::{Eigenproblem, ProductObserver, SubsystemPencil};
pub use states::JointState;

use crate::lanes::LANES;
use crate::space::SpatialMatrix;
use crate::tower::Motions;

/// The equations of motion of an uncoupled group of motions, with work arrays.
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
    /// about x, y, z) with a unit: the motion (m or rad) for a coordinate of 1. A zero fixes the
    /// component.
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

    /// One step of inverse iteration: x ← A⁻¹ M x for the inertia M, with A factored first if it is
    /// given, else with the matrix factored last. The number of negative eigenvalues of A (0 if it
    /// is not factored), and xᵀ A x for each of the matrices of the new x. None, and no effect,
    /// where this takes as long as [`factorize`](Self::factorize), [`product`](Self::product),
    /// [`solve`](Self::solve) and [`energies`](Self::energies).
    fn inverse_step(
        &mut self,
        _a: Option<&Coefficients>,
        _x: &mut [f64],
    ) -> Option<(usize, Energies)> {
        None
    }

    /// The same for several matrices A that differ in the coefficient of the inertia, each with a
    /// vector, or without one if only the negative eigenvalues are counted. The results are those
    /// of [single steps](Self::inverse_step). None, and no effect, where single steps take no
    /// longer.
    fn inverse_steps(
        &mut self,
        _a: &[Coefficients; LANES],
        _x: [Option<&mut [f64]>; LANES],
    ) -> Option<[(usize, Energies); LANES]> {
        None
    }

    /// xᵀ A x.
    fn energy(&mut self, a: &Coefficients, x: &[f64]) -> f64;

    /// xᵀ A x for each of the matrices.
    fn energies(&mut self, x: &[f64]) -> Energies {
        let elastic = Coefficients::ELASTIC.minus(1.0, Coefficients::FOUNDATION);
        Energies {
            elastic: self.energy(&elastic, x),
            foundation: self.energy(&Coefficients::FOUNDATION, x),
            gravity: self.energy(&Coefficients::GRAVITY, x),
            mass: self.energy(&Coefficients::MASS, x),
        }
    }

    /// Tells `part` the height (m) and the part of xᵀ x of each joint or element: its strain
    /// energy, times 2. The base has none.
    fn strain_energies(&self, x: &[f64], part: &mut dyn FnMut(f64, f64));

    /// The internal forces of a vector; false if a vector of this kind of model cannot be carried
    /// to another mesh by them.
    fn internal_forces(&self, _x: &[f64], _forces: &mut InternalForces) -> bool {
        false
    }

    /// Writes the vector with the [internal forces](Self::internal_forces) of one on another mesh.
    /// The forces may jump at some heights (m, rising).
    fn with_internal_forces(&self, _forces: &InternalForces, _jumps_m: &[f64], _out: &mut [f64]) {}

    /// The same equations as a branch of links; none if not all motions are coupled here.
    fn branch(&self) -> Option<Branch> {
        None
    }

    /// Data of each joint in a mode of an eigenvalue λ, rad²/s²; false if the subsystem is not a
    /// chain of joints.
    fn joint_states(&self, _lambda: f64, _x: &[f64], _states: &mut Vec<JointState>) -> bool {
        false
    }

    /// The resultant of A x about the base at `base_m` (m), and the energy xᵀ A x by components.
    fn resultant(&mut self, a: &Coefficients, x: &[f64], base_m: f64) -> Resultant;

    /// The resultant of the inertia forces M x, and xᵀ K x by components.
    fn modal_resultant(&mut self, x: &[f64], base_m: f64) -> (Resultant, [f64; 6]) {
        let strain = self.resultant(&Coefficients::STIFFNESS, x, base_m);
        (
            self.resultant(&Coefficients::MASS, x, base_m),
            strain.energy,
        )
    }

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

/// xᵀ A x for the matrices A of a subsystem.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Energies {
    /// Of the joints or elements.
    pub elastic: f64,
    /// Of foundation, soil and guy wires.
    pub foundation: f64,
    /// Of −G, by which gravity reduces the stiffness.
    pub gravity: f64,
    /// Of the inertia.
    pub mass: f64,
}

impl Energies {
    /// xᵀ A x of a linear combination A.
    pub fn of(&self, a: &Coefficients) -> f64 {
        a.stiffness * self.elastic + a.foundation * self.foundation - a.geometric * self.gravity
            + a.mass * self.mass
    }
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
