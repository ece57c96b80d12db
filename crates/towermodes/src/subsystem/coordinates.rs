//! The motion components of a subsystem among the six of a section.

use crate::space::{Matrix, SpatialMatrix};
use crate::tower::{Axisymmetric, Component, Motion, Motions, Plane};

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
    /// The bending plane, and the motion along or about the axis, if there is at most one of each.
    plane: Option<Plane>,
    straight: Option<Motion>,
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
        let plane = motions.iter().find_map(|motion| match motion {
            Motion::Bending(plane) => Some(plane),
            Motion::Torsion | Motion::Axial => None,
        });
        Self {
            plane,
            straight: motions.iter().find(|motion| !motion.bends()),
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

    /// The same of the matrix of a piece of tower.
    #[inline]
    pub fn restrict_axisymmetric(&self, matrix: &Axisymmetric) -> Matrix<D> {
        if D == 6 {
            return self.restrict(&matrix.spatial());
        }
        let mut own = [[0.0; D]; D];
        if let Some(plane) = self.plane
            && D > 1
        {
            let [[ww, wt], [_, tt]] = matrix.plane(plane);
            (own[0][0], own[0][1], own[1][0], own[1][1]) = (ww, wt, wt, tt);
        }
        // The index after those of the bending plane.
        match self.straight {
            Some(Motion::Torsion) => own[D - 1][D - 1] = matrix.torsion,
            Some(Motion::Axial) => own[D - 1][D - 1] = matrix.axial,
            Some(Motion::Bending(_)) | None => {}
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
        // With fewer than six components all of them move.
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
    use crate::tower::Planes;

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
    fn the_matrix_of_a_piece_is_restricted_as_that_of_the_space() {
        let bending = Planes {
            fore_aft: [2.0, 3.0, 5.0],
            side_side: [7.0, 11.0, 13.0],
        };
        let piece = Axisymmetric {
            bending,
            torsion: 17.0,
            axial: 19.0,
        };
        fn check<const D: usize>(motions: Motions, piece: &Axisymmetric) {
            let coordinates = Coordinates::<D>::new(motions);
            let expected = coordinates.restrict(&piece.spatial());
            assert_eq!(coordinates.restrict_axisymmetric(piece), expected);
        }
        let only = Motions::only;
        let (torsion, axial) = (only(Motion::Torsion), only(Motion::Axial));
        check::<1>(torsion, &piece);
        check::<1>(axial, &piece);
        for plane in [Plane::ForeAft, Plane::SideSide] {
            let bending = only(Motion::Bending(plane));
            check::<2>(bending, &piece);
            check::<3>(bending.and(torsion), &piece);
            check::<3>(bending.and(axial), &piece);
            check::<6>(bending.and(torsion).and(axial), &piece);
        }
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
