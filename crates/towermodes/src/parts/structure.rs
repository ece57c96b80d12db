//! What the eigenvalue problems need of a chain or a beam.

use crate::space::{Dim, Matrix, Space};

/// A sum of the matrices of a structure: `springs`·1 + `mass`·M + `ground`·S + `weights`·G.
///
/// 1 is the stiffness of its joints or elements in scaled coordinates, M its inertia, S what ties
/// it to the ground, G what weights add to the stiffness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Combination {
    /// Factor of the joints' or elements' own stiffness.
    pub springs: f64,
    /// Factor of the inertia, 1/s².
    pub mass: f64,
    /// Factor of the ground's stiffness.
    pub ground: f64,
    /// Factor of the weights' stiffness.
    pub weights: f64,
}

impl Combination {
    const NONE: Self = Self {
        springs: 0.0,
        mass: 0.0,
        ground: 0.0,
        weights: 0.0,
    };
    /// The inertia.
    pub const MASS: Self = Self {
        mass: 1.0,
        ..Self::NONE
    };
    /// The ground.
    pub const GROUND: Self = Self {
        ground: 1.0,
        ..Self::NONE
    };
    /// The stiffness without the weights.
    pub const ELASTIC: Self = Self {
        springs: 1.0,
        ..Self::GROUND
    };
    /// The stiffness.
    pub const STIFFNESS: Self = Self {
        weights: 1.0,
        ..Self::ELASTIC
    };
    /// What weights take from the stiffness.
    pub const WEIGHTS: Self = Self {
        weights: -1.0,
        ..Self::NONE
    };

    /// This minus `shift` times another.
    pub fn minus(self, shift: f64, other: Self) -> Self {
        Self {
            springs: self.springs - shift * other.springs,
            mass: self.mass - shift * other.mass,
            ground: self.ground - shift * other.ground,
            weights: self.weights - shift * other.weights,
        }
    }
}

/// What a motion gives with a combination A of a structure's matrices.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Balance<const D: usize> {
    /// The resultant of A times the motion about the base: with the inertia, its products with the
    /// rigid motions of the whole.
    pub force: [f64; D],
    /// What each component contributes to the energy xᵀ A x.
    pub energy: [f64; D],
}

/// What a matrix adds to a structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Inertia.
    Inertia,
    /// Stiffness that ties to the ground: foundation, soil, wires.
    Ground,
}

/// A model in D motion components that is made from the base up.
pub trait Structure<const D: usize>: Default
where
    Dim<D>: Space,
{
    /// Its working memory.
    type Work: Default;

    /// Forgets everything but the memory.
    fn clear(&mut self);

    /// Begins with a base that moves freely in the components with a unit, the motion that a
    /// coordinate of 1 is; zero holds one.
    fn add_base(&mut self, height_m: f64, unit: [f64; D]);

    /// Adds a matrix, given about a height (m), to what was added last.
    fn add(&mut self, role: Role, reference_m: f64, matrix: Matrix<D>);

    /// Takes a stiffness (N m) against rotation about x and y, by which weights overturn, from what
    /// was added last.
    fn overturn(&mut self, stiffness_n_m: f64);

    /// Number of unknowns.
    fn degrees_of_freedom(&self) -> usize;

    /// Whether every number is finite.
    fn is_finite(&self) -> bool;

    /// Whether a combination is the identity.
    fn is_identity(&self, combination: &Combination) -> bool;

    /// out = A x for a combination A.
    fn times(&self, combination: &Combination, work: &mut Self::Work, x: &[f64], out: &mut [f64]);

    /// The number of negative eigenvalues of a combination.
    fn count_negative(&self, combination: &Combination, work: &mut Self::Work) -> usize;

    /// Factors a combination for [`solve`](Self::solve); the number of its negative eigenvalues.
    fn factorize(&self, combination: &Combination, work: &mut Self::Work) -> usize;

    /// x ← A⁻¹ x, with the combination factored last.
    fn solve(&self, work: &mut Self::Work, x: &mut [f64]);

    /// What a motion x gives with a combination A: forces, and where its energy is. `base_m` is the
    /// height of the base, m.
    fn balance(
        &self,
        combination: &Combination,
        work: &mut Self::Work,
        x: &[f64],
        base_m: f64,
    ) -> Balance<D>;

    /// A start vector for iterations: the inertia forces of a rigid motion that is one in every
    /// component at the base.
    fn start(&self, work: &mut Self::Work, out: &mut [f64]);
}
