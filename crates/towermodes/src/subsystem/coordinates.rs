//! The motion components of a subsystem among the six of a section.

use crate::space::{Matrix, SpatialMatrix};
use crate::tower::{Component, Motion, Motions};

/// How many components the equations of coupled motions have: 1 for torsion or axial motion, 2 for
/// a bending plane, 3 for a bending plane with torsion or axial motion, 6 for any other set.
pub fn dimension(motions: Motions) -> usize {
    let bending = motions.iter().filter(|motion| motion.bends()).count();
    match (bending, motions.iter().count() - bending) {
        (0, 1) => 1,
        (1, 0) => 2,
        (1, 1) => 3,
        _ => 6,
    }
}

/// D of the components (x, y, z, rotation about x, y, z), in the order and with the signs that the
/// equations of a subsystem have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coordinates<const D: usize> {
    motions: Motions,
    components: [Component; D],
}

impl<const D: usize> Coordinates<D> {
    /// The components of motions whose [`dimension`] is D. With D = 6 these are all six, and those
    /// that belong to no motion of the set do not move.
    pub fn new(motions: Motions) -> Self {
        let mut own = motions.iter().flat_map(Motion::components);
        let mut in_space = 0..6;
        let mut next = || match D {
            6 => in_space.next().map(|component| (component, 1.0)),
            _ => own.next().copied(),
        };
        Self {
            motions,
            components: std::array::from_fn(|_| next().unwrap_or_default()),
        }
    }

    /// The motions.
    pub fn motions(&self) -> Motions {
        self.motions
    }

    /// A matrix for all six components, restricted to these: s_i s_j A_ij.
    #[inline]
    pub fn restrict(&self, matrix: &SpatialMatrix) -> Matrix<D> {
        let mut own = [[0.0; D]; D];
        for (row, (i, s)) in own.iter_mut().zip(&self.components) {
            for (entry, (j, t)) in row.iter_mut().zip(&self.components) {
                *entry = s * t * matrix[*i][*j];
            }
        }
        own
    }

    /// The entries of a diagonal matrix that belong to these components.
    #[inline]
    pub fn restrict_diagonal(&self, diagonal: &[f64; 6]) -> [f64; D] {
        let mut own = [0.0; D];
        for (entry, (i, _)) in own.iter_mut().zip(&self.components) {
            *entry = diagonal[*i];
        }
        own
    }

    /// The same, with zero for components that do not move.
    #[inline]
    pub fn restrict_moving(&self, diagonal: &[f64; 6]) -> [f64; D] {
        // Fewer than six components all move.
        if D == 6 {
            self.restrict_diagonal(&self.motions.masked(*diagonal))
        } else {
            self.restrict_diagonal(diagonal)
        }
    }

    /// A motion or force in these components as one in all six.
    pub fn expand(&self, vector: &[f64; D]) -> [f64; 6] {
        let mut all = [0.0; 6];
        for (value, (i, sign)) in vector.iter().zip(&self.components) {
            all[*i] = sign * value;
        }
        all
    }

    /// The same for values that do not depend on the direction of a component, such as energies.
    pub fn expand_unsigned(&self, values: &[f64; D]) -> [f64; 6] {
        let mut all = [0.0; 6];
        for (value, (i, _)) in values.iter().zip(&self.components) {
            all[*i] = *value;
        }
        all
    }

    /// Component by component.
    pub fn components(&self) -> &[Component; D] {
        &self.components
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tower::Plane;

    const SIDE_SIDE: Motion = Motion::Bending(Plane::SideSide);

    #[test]
    fn side_side_bending_turns_backwards_about_x() {
        let coordinates = Coordinates::<2>::new(Motions::only(SIDE_SIDE));
        assert_eq!(
            coordinates.expand(&[2.0, 3.0]),
            [0.0, 2.0, 0.0, -3.0, 0.0, 0.0]
        );
        let mut matrix = [[0.0; 6]; 6];
        (matrix[1][3], matrix[3][1], matrix[3][3]) = (-5.0, -5.0, 7.0);
        assert_eq!(coordinates.restrict(&matrix), [[0.0, 5.0], [5.0, 7.0]]);
    }

    #[test]
    fn each_set_of_motions_has_as_many_components_as_it_needs() {
        let only = Motions::only;
        let (bending, torsion, axial) =
            (only(SIDE_SIDE), only(Motion::Torsion), only(Motion::Axial));
        assert_eq!(dimension(torsion), 1);
        assert_eq!(dimension(bending), 2);
        assert_eq!(dimension(bending.and(axial)), 3);
        assert_eq!(dimension(torsion.and(axial)), 6);
        assert_eq!(dimension(bending.and(torsion).and(axial)), 6);
    }
}
