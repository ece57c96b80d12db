//! One element of a straight member by itself: its matrices for the motion of its near end and its
//! own coordinates, in the axes of the member.

use super::element::{Slice, Stencil, add_squares, soil, write_shape};
use super::legendre::{Legendre, Term, gauss_points};
use super::model::{Beam, add_congruent, place, rigid_motion};
use super::strain::{Strain, deformations};
use crate::space::SpatialMatrix;
use crate::subsystem::MatrixKind;
use crate::tower::{Component, Motion, Motions, Section, SoilStiffness};

/// All components, none backwards.
const ALL: [Component; 6] = [(0, 1.0), (1, 1.0), (2, 1.0), (3, 1.0), (4, 1.0), (5, 1.0)];
/// More points than a polynomial needs: shear flexibility is rational.
const EXTRA_POINTS: usize = 7;
/// Points on a part of an element besides those that its share of the polynomials needs.
const POINTS_OF_A_PART: usize = 4;

/// Makes elements one by one, with memory that is reused.
#[derive(Debug, Default)]
pub(crate) struct MemberElement {
    beam: Beam<6>,
    stencil: Stencil,
    sections: Vec<Section>,
    compressions_n: Vec<f64>,
    /// ξ and weight of each number of points that was needed.
    points: Vec<Vec<(f64, f64)>>,
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
        let (rows, shape) = (self.beam.rows(), self.shape_at(distance_m));
        let matrix = self.beam.last_matrix(place(MatrixKind::Inertia));
        add_congruent(inertia, &shape, rows, matrix);
    }

    /// Adds springs to the ground between two distances (m) from the near end, with the stiffness
    /// at both and linear between them.
    ///
    /// The springs of an element have kinks, so each part is integrated by itself. The polynomials
    /// of the element vary in a part of it about as those of degree p √share do.
    pub(crate) fn add_soil(&mut self, [from_m, to_m]: [f64; 2], springs: [SoilStiffness; 2]) {
        let counts = self.beam.deformations().iter().map(|d| d.count);
        let most = counts.max().unwrap_or(0) + 2;
        let share = (to_m - from_m) / self.beam.length_m(0);
        let needed = POINTS_OF_A_PART + (most as f64 * share.sqrt()).ceil() as usize;
        let rows = self.beam.rows();
        for (xi, weight) in self.points(needed.min(most + 1)) {
            let s = 0.5 * (1.0 + xi);
            let per_m = soil(&springs[0].blend(&springs[1], s));
            let here = per_m.map(|spring| 0.5 * weight * (to_m - from_m) * spring);
            let shape = self.shape_at(from_m + s * (to_m - from_m));
            let matrix = self.beam.last_matrix(place(MatrixKind::Foundation));
            add_squares(&here, &shape, rows, matrix);
        }
    }

    fn points(&mut self, count: usize) -> Vec<(f64, f64)> {
        if self.points.len() <= count {
            self.points.resize_with(count + 1, Vec::new);
        }
        let points = &mut self.points[count];
        if points.is_empty() {
            *points = gauss_points(count);
        }
        points.clone()
    }

    /// The motion of the section at a distance (m) from the near end, for that of the near end and
    /// its own coordinates: 6 rows.
    fn shape_at(&self, distance_m: f64) -> Vec<f64> {
        let length_m = self.beam.length_m(0);
        let deformations = self.beam.deformations();
        let count = deformations.iter().map(|d| d.count).max();
        let terms = Legendre::at(2.0 * distance_m / length_m - 1.0);
        let terms: Vec<Term> = terms.take(count.unwrap_or(0)).collect();
        let mut shape = vec![0.0; 6 * self.beam.rows()];
        let root = &self.beam.roots;
        write_shape(&terms, length_m, distance_m, deformations, root, &mut shape);
        shape
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
