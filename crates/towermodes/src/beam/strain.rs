//! The strains of an element.

use crate::tower::{Component, Motion, Motions, Plane, Section};

/// A kind of strain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Strain {
    /// Curvature in a plane: causes rotation and deflection.
    Curvature(Plane),
    /// Shear in a plane: causes deflection only.
    Shear(Plane),
    /// Twist about the axis.
    Twist,
    /// Stretch along the axis.
    Stretch,
}

impl Strain {
    /// All kinds, in the order of an element's coordinates.
    pub const ALL: [Self; 6] = [
        Self::Curvature(Plane::ForeAft),
        Self::Shear(Plane::ForeAft),
        Self::Curvature(Plane::SideSide),
        Self::Shear(Plane::SideSide),
        Self::Twist,
        Self::Stretch,
    ];

    /// Index in [`ALL`](Self::ALL).
    pub(super) fn index(self) -> usize {
        match self {
            Self::Curvature(Plane::ForeAft) => 0,
            Self::Shear(Plane::ForeAft) => 1,
            Self::Curvature(Plane::SideSide) => 2,
            Self::Shear(Plane::SideSide) => 3,
            Self::Twist => 4,
            Self::Stretch => 5,
        }
    }

    /// The motion to which the strain belongs.
    pub(super) fn motion(self) -> Motion {
        match self {
            Self::Curvature(plane) | Self::Shear(plane) => Motion::Bending(plane),
            Self::Twist => Motion::Torsion,
            Self::Stretch => Motion::Axial,
        }
    }

    /// Number of integrations from the strain to each component of its motion, translation before
    /// rotation.
    fn integrals(self) -> &'static [usize] {
        match self {
            Self::Curvature(_) => &[2, 1],
            Self::Shear(_) => &[1, 0],
            Self::Twist | Self::Stretch => &[1],
        }
    }

    /// The section stiffness against this strain: EI, κGA, GJ or EA.
    pub(super) fn stiffness(self, section: &Section) -> f64 {
        match self {
            Self::Curvature(plane) => section.bending_n_m2.of(plane),
            Self::Shear(plane) => 1.0 / section.shear_flexibility_per_n.of(plane),
            Self::Twist => section.torsion_n_m2,
            Self::Stretch => section.axial_n,
        }
    }
}

/// A strain of an element in D components.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deformation<const D: usize> {
    /// The kind of strain.
    pub strain: Strain,
    /// Number of its coordinates.
    pub count: usize,
    /// Number of integrations to each component, 0 for components that do not depend on this
    /// strain; with negative sign if the component decreases.
    pub(super) integrals: [i32; D],
}

/// The deformations of an element for a set of motions, each with `count` coordinates.
pub(super) fn deformations<const D: usize>(
    motions: Motions,
    components: &[Component; D],
    count: impl Fn(Strain) -> usize,
) -> impl Iterator<Item = Deformation<D>> {
    let components = *components;
    let own = Strain::ALL.into_iter();
    let counted = own.map(move |strain| (strain, count(strain)));
    counted
        .filter(move |(strain, count)| motions.contains(strain.motion()) && *count > 0)
        .map(move |(strain, count)| Deformation {
            strain,
            count,
            integrals: components.map(|(component, sign)| {
                let mut moved = strain.motion().components().iter().zip(strain.integrals());
                let found = moved.find(|((c, _), _)| *c == component);
                found.map_or(0, |((_, s), times)| (sign * s) as i32 * *times as i32)
            }),
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn side_side_bending_turns_backwards_in_space_and_forwards_in_its_plane() {
        let side_side = Motions::only(Motion::Bending(Plane::SideSide));
        let space = [(0, 1.0), (1, 1.0), (2, 1.0), (3, 1.0), (4, 1.0), (5, 1.0)];
        let count = |strain| usize::from(strain != Strain::Shear(Plane::SideSide));
        let in_space: Vec<_> = deformations(side_side, &space, count).collect();
        assert_eq!(in_space[0].integrals, [0, 2, 0, -1, 0, 0]);
        let in_plane: Vec<_> = deformations(side_side, &[(1, 1.0), (3, -1.0)], count).collect();
        assert_eq!(in_plane[0].integrals, [2, 1]);
    }
}
