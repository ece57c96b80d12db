//! A structure for motions that are coupled with each other, in as many components as they have.

use super::pencil::{Problem, StructurePencil};
use super::structure::{Role, Structure};
use crate::eigen::Pencil;
use crate::space::{Dim, Matrix, Space, SpatialMatrix};
use crate::tower::{Component, Line, Motion, Motions, OnAxis, Plane};

/// A kind of structure, of any number of components: chains or beams.
pub trait Kind {
    /// The structure in D components.
    type Of<const D: usize>: Structure<D>
    where
        Dim<D>: Space;
}

/// A structure with its working memory.
pub struct Member<K: Kind, const D: usize>
where
    Dim<D>: Space,
{
    /// The structure.
    pub structure: K::Of<D>,
    /// Its memory.
    pub work: <K::Of<D> as Structure<D>>::Work,
}

impl<K: Kind, const D: usize> Default for Member<K, D>
where
    Dim<D>: Space,
{
    fn default() -> Self {
        Self {
            structure: Default::default(),
            work: Default::default(),
        }
    }
}

/// A structure for motions that are coupled with each other.
pub enum Part<K: Kind> {
    /// Torsion or axial motion.
    Line(Line, Member<K, 1>),
    /// A bending plane.
    Plane(Plane, Member<K, 2>),
    /// A bending plane with torsion or axial motion.
    PlaneAndLine(Plane, Line, Member<K, 3>),
    /// Any other set of motions, in six components of which some may be held.
    Space(Motions, Member<K, 6>),
}

/// Runs the same code on the member of a part, whatever its number of components.
macro_rules! on_structure {
    ($part:expr, $member:ident => $act:expr) => {
        match $part {
            $crate::parts::Part::Line(_, $member) => $act,
            $crate::parts::Part::Plane(_, $member) => $act,
            $crate::parts::Part::PlaneAndLine(_, _, $member) => $act,
            $crate::parts::Part::Space(_, $member) => $act,
        }
    };
}
pub(crate) use on_structure;

/// The same with the components of the part, as an array.
macro_rules! on_components {
    ($part:expr, $member:ident, $components:ident => $act:expr) => {
        match $part {
            $crate::parts::Part::Line(line, $member) => {
                let $components = line.components();
                $act
            }
            $crate::parts::Part::Plane(plane, $member) => {
                let $components = $crate::parts::plane_components(*plane);
                $act
            }
            $crate::parts::Part::PlaneAndLine(plane, line, $member) => {
                let $components = $crate::parts::plane_and_line_components(*plane, *line);
                $act
            }
            $crate::parts::Part::Space(_, $member) => {
                let $components = $crate::parts::SPACE;
                $act
            }
        }
    };
}
pub(crate) use on_components;

/// The components of space.
pub(crate) const SPACE: [Component; 6] =
    [(0, 1.0), (1, 1.0), (2, 1.0), (3, 1.0), (4, 1.0), (5, 1.0)];

impl<K: Kind> Part<K> {
    /// An empty part for a set of motions.
    pub(super) fn new(motions: Motions) -> Self {
        let planes = [Plane::ForeAft, Plane::SideSide];
        let mut planes = planes
            .into_iter()
            .filter(|plane| motions.contains(Motion::Bending(*plane)));
        let mut lines = [Line::Torsion, Line::Axial]
            .into_iter()
            .filter(|line| motions.contains(line.motion()));
        match (planes.next(), planes.next(), lines.next(), lines.next()) {
            (None, None, Some(line), None) => Self::Line(line, Member::default()),
            (Some(plane), None, None, None) => Self::Plane(plane, Member::default()),
            (Some(plane), None, Some(line), None) => {
                Self::PlaneAndLine(plane, line, Member::default())
            }
            _ => Self::Space(motions, Member::default()),
        }
    }

    /// The motions it is for.
    pub fn motions(&self) -> Motions {
        match self {
            Self::Line(line, _) => Motions::only(line.motion()),
            Self::Plane(plane, _) => Motions::only(Motion::Bending(*plane)),
            Self::PlaneAndLine(plane, line, _) => {
                Motions::only(Motion::Bending(*plane)).and(Motions::only(line.motion()))
            }
            Self::Space(motions, _) => *motions,
        }
    }

    /// Adds a matrix of a piece of tower, given about a height (m), to what was added last.
    #[inline]
    pub(super) fn add(&mut self, role: Role, z: f64, body: &OnAxis) {
        match self {
            Self::Line(line, member) => member.structure.add(role, z, [[body.line(*line)]]),
            Self::Plane(plane, member) => member.structure.add(role, z, body.plane(*plane)),
            Self::PlaneAndLine(plane, line, member) => {
                let matrix = body.plane_and_line(*plane, *line);
                member.structure.add(role, z, matrix);
            }
            Self::Space(_, member) => member.structure.add(role, z, body.spatial()),
        }
    }

    /// Adds any matrix, given about a height (m), to what was added last.
    pub(super) fn add_spatial(&mut self, role: Role, z: f64, matrix: &SpatialMatrix) {
        if matrix.iter().flatten().any(|entry| *entry != 0.0) {
            on_components!(self, member, components => {
                member.structure.add(role, z, seen(matrix, &components));
            });
        }
    }

    /// Takes a stiffness (N m) against rotation about x and y from what was added last.
    #[inline]
    pub(super) fn overturn(&mut self, stiffness_n_m: f64) {
        if stiffness_n_m != 0.0 {
            on_structure!(self, member => member.structure.overturn(stiffness_n_m));
        }
    }

    /// Begins with a base that moves freely in the components with a unit.
    pub(super) fn add_base(&mut self, z: f64, unit: [f64; 6]) {
        let unit = self.motions().masked(unit);
        on_components!(self, member, components => {
            member.structure.add_base(z, components.map(|(i, _)| unit[i]));
        });
    }

    /// Number of unknowns.
    pub fn degrees_of_freedom(&self) -> usize {
        on_structure!(self, member => member.structure.degrees_of_freedom())
    }

    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        on_structure!(self, member => member.structure.is_finite())
    }

    /// Lets `act` work on an eigenvalue problem of the part.
    pub fn with_pencil<R>(
        &mut self,
        problem: Problem,
        act: impl FnOnce(&mut dyn Pencil) -> R,
    ) -> R {
        self.with_pencil_beginning(problem, None, act)
    }

    /// The same, with iterations that begin with a vector near the one looked for.
    pub fn with_pencil_beginning<R>(
        &mut self,
        problem: Problem,
        first: Option<&[f64]>,
        act: impl FnOnce(&mut dyn Pencil) -> R,
    ) -> R {
        on_structure!(self, member => {
            let Member { structure, work } = member;
            let pencil = StructurePencil::new(structure, work, problem);
            act(&mut pencil.beginning_with(first))
        })
    }

    pub(super) fn clear(&mut self) {
        on_structure!(self, member => member.structure.clear());
    }
}

pub(crate) fn plane_components(plane: Plane) -> [Component; 2] {
    let components = Motion::Bending(plane).components();
    [components[0], components[1]]
}

pub(crate) fn plane_and_line_components(plane: Plane, line: Line) -> [Component; 3] {
    let ([w, theta], [line]) = (plane_components(plane), line.components());
    [w, theta, line]
}

/// The rows and columns of a matrix that belong to components, with their signs.
fn seen<const D: usize>(matrix: &SpatialMatrix, components: &[Component; D]) -> Matrix<D> {
    components.map(|(i, s)| components.map(|(j, t)| s * t * matrix[i][j]))
}

/// A motion in D components as (x, y, z, rotation about x, y, z).
pub(crate) fn embedded<const D: usize>(motion: &[f64; D], components: &[Component; D]) -> [f64; 6] {
    let mut vector = [0.0; 6];
    for (value, (i, sign)) in motion.iter().zip(components) {
        vector[*i] = sign * value;
    }
    vector
}
