//! One element of a straight member by itself: its matrices for the motion of its near end and its
//! own coordinates, in the axes of the member.

use super::element::{Slice, Stencil, write_shape};
use super::legendre::{Legendre, Term};
use super::model::{Beam, add_congruent, place, rigid_motion};
use super::strain::{Strain, deformations};
use crate::space::SpatialMatrix;
use crate::subsystem::MatrixKind;
use crate::tower::{Component, Motion, Motions, Section};

/// All components, none backwards.
const ALL: [Component; 6] = [(0, 1.0), (1, 1.0), (2, 1.0), (3, 1.0), (4, 1.0), (5, 1.0)];
/// More points than a polynomial needs: shear flexibility is rational.
const EXTRA_POINTS: usize = 7;

/// Makes elements one by one, with memory that is reused.
#[derive(Debug, Default)]
pub(crate) struct MemberElement {
    beam: Beam<6>,
    stencil: Stencil,
    sections: Vec<Section>,
    compressions_n: Vec<f64>,
}

/// The strains of an element: how many polynomials each has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct MemberStrains {
    pub(crate) curvature: usize,
    pub(crate) shear: usize,
    pub(crate) torsion: usize,
    pub(crate) axial: usize,
}

impl MemberStrains {
    /// Spectral elements of a degree; see [`BeamRecipe`](super::BeamRecipe).
    pub(crate) fn of_degree(degree: usize, shears: bool) -> Self {
        Self {
            curvature: degree - 1,
            shear: if shears { degree } else { 0 },
            torsion: degree,
            axial: degree,
        }
    }

    fn most(&self) -> usize {
        let Self {
            curvature,
            shear,
            torsion,
            axial,
        } = *self;
        curvature.max(shear).max(torsion).max(axial)
    }
}

impl MemberElement {
    /// Makes an element of a length (m) with the section and the compression (N) at each distance
    /// from its near end.
    pub(crate) fn make(
        &mut self,
        strains: MemberStrains,
        length_m: f64,
        section_at: impl Fn(f64) -> Section,
        compression_n: Option<&dyn Fn(f64) -> f64>,
    ) {
        let motions = Motion::ALL.into_iter().map(Motions::only);
        let motions = motions.fold(Motions::default(), Motions::and);
        let count = |strain| match strain {
            Strain::Curvature(_) => strains.curvature,
            Strain::Shear(_) => strains.shear,
            Strain::Twist => strains.torsion,
            Strain::Stretch => strains.axial,
        };
        self.beam.clear();
        self.beam
            .set_deformations(deformations(motions, &ALL, count));
        let most = strains.most();
        self.stencil.prepare(most + EXTRA_POINTS, most.max(2));
        let at = |height_m: f64| section_at(height_m);
        self.sections.clear();
        self.sections
            .extend(self.stencil.heights_m(0.0, length_m).map(at));
        self.compressions_n.clear();
        if let Some(compression_n) = compression_n {
            let heights_m = self.stencil.heights_m(0.0, length_m);
            self.compressions_n.extend(heights_m.map(compression_n));
        }
        let slice = Slice {
            base_m: 0.0,
            length_m,
            sections: &self.sections,
            compressions_n: &self.compressions_n,
            rotary_inertia: true,
        };
        self.stencil.add_element(&mut self.beam, &ALL, &slice);
    }

    /// Adds an inertia that moves with the section at a distance (m) from the near end.
    pub(crate) fn add_inertia(&mut self, distance_m: f64, inertia: &SpatialMatrix) {
        let length_m = self.beam.length_m(0);
        let (rows, coordinates) = (self.beam.rows(), self.beam.coordinates());
        let count = self.beam.deformations().iter().map(|d| d.count).max();
        let terms = Legendre::at(2.0 * distance_m / length_m - 1.0);
        let terms: Vec<Term> = terms.take(count.unwrap_or(0)).collect();
        let mut shape = vec![0.0; 6 * rows];
        let root = self.beam.roots[..coordinates * coordinates].to_vec();
        let deformations = self.beam.deformations();
        write_shape(
            &terms,
            length_m,
            distance_m,
            deformations,
            &root,
            &mut shape,
        );
        let matrix = self.beam.last_matrix(place(MatrixKind::Inertia));
        add_congruent(inertia, &shape, rows, matrix);
    }

    /// The motion of its far end for its own coordinates, whose stiffness is the identity: 6 rows.
    pub(crate) fn tip(&self) -> impl Iterator<Item = &[f64]> {
        self.beam.tip_rows(0)
    }

    /// Inertia, stiffness to the ground and geometric stiffness for the motion of its near end and
    /// its own coordinates, row by row; empty where it has none.
    pub(crate) fn matrices(&self) -> &[Vec<f64>; 3] {
        &self.beam.matrices
    }

    /// The motion of its far end for that of its near end, if it does not deform.
    pub(crate) fn rigid(length_m: f64) -> SpatialMatrix {
        rigid_motion(length_m)
    }
}
