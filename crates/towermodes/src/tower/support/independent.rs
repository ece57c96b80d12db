//! The coupled motions of a tower: decided by the structure, not by the size of the entries.

use super::super::pieces::planes::Plane;
use crate::space::SpatialMatrix;

/// A component of a motion: its place in (x, y, z, rotation about x, y, z), and its sign there.
pub type Component = (usize, f64);

/// The motions that a bare tower has independently of each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Motion {
    /// Bending in a plane.
    Bending(Plane),
    /// Torsion about the axis.
    Torsion,
    /// Axial motion.
    Axial,
}

impl Motion {
    /// All of them, in the order in which modes of one frequency are listed.
    pub const ALL: [Self; 4] = [
        Self::Bending(Plane::ForeAft),
        Self::Bending(Plane::SideSide),
        Self::Torsion,
        Self::Axial,
    ];

    /// Its components in (x, y, z, rotation about x, y, z), each with the sign that it has in a
    /// chain: translations first.
    pub fn components(self) -> &'static [Component] {
        match self {
            Self::Bending(Plane::ForeAft) => &[(0, 1.0), (4, 1.0)],
            // A positive slope of y is a negative rotation about x.
            Self::Bending(Plane::SideSide) => &[(1, 1.0), (3, -1.0)],
            Self::Torsion => &[(5, 1.0)],
            Self::Axial => &[(2, 1.0)],
        }
    }

    /// Whether it is bending.
    pub fn bends(self) -> bool {
        matches!(self, Self::Bending(_))
    }

    fn index(self) -> usize {
        match self {
            Self::Bending(Plane::ForeAft) => 0,
            Self::Bending(Plane::SideSide) => 1,
            Self::Torsion => 2,
            Self::Axial => 3,
        }
    }
}

/// A set of motions that are coupled with each other and with no other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Motions([bool; 4]);

impl Motions {
    /// One motion alone.
    pub fn only(motion: Motion) -> Self {
        let mut set = Self([false; 4]);
        set.0[motion.index()] = true;
        set
    }

    /// All motions.
    pub fn all() -> Self {
        Self([true; 4])
    }

    /// Whether a motion is in the set.
    pub fn contains(self, motion: Motion) -> bool {
        self.0[motion.index()]
    }

    /// The motions of the set.
    pub fn iter(self) -> impl Iterator<Item = Motion> {
        Motion::ALL.into_iter().filter(move |m| self.contains(*m))
    }

    /// The motion of the set, if there is only one.
    pub fn only_one(self) -> Option<Motion> {
        let mut motions = self.iter();
        let first = motions.next()?;
        motions.next().is_none().then_some(first)
    }

    /// A vector (x, y, z, rotation about x, y, z) without the components of motions that are not in
    /// the set.
    pub fn masked(self, mut vector: [f64; 6]) -> [f64; 6] {
        for motion in Motion::ALL.into_iter().filter(|m| !self.contains(*m)) {
            for (component, _) in motion.components() {
                vector[*component] = 0.0;
            }
        }
        vector
    }

    /// The set without a motion.
    pub(crate) fn without(mut self, motion: Motion) -> Self {
        self.0[motion.index()] = false;
        self
    }

    /// This and another set together.
    pub fn and(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] || other.0[i]))
    }
}

/// The smallest sets of motions that no matrix couples with each other.
pub(crate) fn independent_motions<'a>(
    matrices: impl Iterator<Item = &'a SpatialMatrix>,
) -> Vec<Motions> {
    let mut sets: Vec<Motions> = Motion::ALL.map(Motions::only).into();
    for matrix in matrices {
        for (i, a) in Motion::ALL.into_iter().enumerate() {
            for b in Motion::ALL.into_iter().skip(i + 1) {
                if couples(matrix, a, b) {
                    join(&mut sets, a, b);
                }
            }
        }
    }
    sets
}

fn couples(matrix: &SpatialMatrix, a: Motion, b: Motion) -> bool {
    let entries = a.components().iter().flat_map(|(i, _)| {
        let columns = b.components().iter();
        columns.map(|(j, _)| matrix[*i][*j])
    });
    entries.into_iter().any(|entry| entry != 0.0)
}

fn join(sets: &mut Vec<Motions>, a: Motion, b: Motion) {
    let position = |sets: &[Motions], motion| sets.iter().position(|set| set.contains(motion));
    if let (Some(i), Some(j)) = (position(sets, a), position(sets, b))
        && i != j
    {
        let (first, second) = (i.min(j), i.max(j));
        sets[first] = sets[first].and(sets[second]);
        sets.remove(second);
    }
}

/// Whether a matrix is the same in both bending planes.
pub(crate) fn planes_are_equal(matrix: &SpatialMatrix) -> bool {
    let [fore_aft, side_side] =
        [Plane::ForeAft, Plane::SideSide].map(|plane| Motion::Bending(plane).components());
    let entry = |(i, s): Component, (j, t): Component| s * t * matrix[i][j];
    let mut rows = fore_aft.iter().zip(side_side);
    rows.all(|(a, b)| {
        let mut columns = fore_aft.iter().zip(side_side);
        columns.all(|(c, d)| entry(*a, *c) == entry(*b, *d))
    })
}
