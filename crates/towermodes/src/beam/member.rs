//! One element of a straight member: its matrices for the motion of its near end and its own
//! coordinates, in the axes of the member.

use super::element::{Slice, Stencil, add_squares, soil, write_shape};
use super::legendre::{Legendre, Term, gauss_points};
use super::model::{Beam, add_congruent, place, rigid_motion};
use super::strain::{Strain, deformations};
use crate::space::SpatialMatrix;
use crate::subsystem::MatrixKind;
use crate::tower::{Component, Motion, Motions, Section, SoilStiffness};

/// All components, all with positive sign.
const ALL: [Component; 6] = [(0, 1.0), (1, 1.0), (2, 1.0), (3, 1.0), (4, 1.0), (5, 1.0)];
/// More points than a polynomial requires: shear flexibility is a rational function.
const EXTRA_POINTS: usize = 7;
/// Additional points if only masses and the compression vary.
const EXTRA_POINTS_OF_UNIFORM: usize = 4;
/// Additional points on a part of an element, besides those for its fraction of the polynomials.
const POINTS_OF_A_PART: usize = 4;

/// Makes elements one by one, with memory that is reused.
#[derive(Debug, Default)]
pub(crate) struct MemberElement {
    in_plane: Beam<2>,
    in_line: Beam<1>,
    in_space: Beam<6>,
    stencil: Stencil,
    /// Tables for uniform elements.
    of_uniform: Stencil,
    sections: Vec<Section>,
    compressions_n: Vec<f64>,
    /// ξ and weight for each number of points used so far.
    points: Vec<Vec<(f64, f64)>>,
}

/// Motions of an element that are coupled with no other motions, and their matrices.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MemberPart {
    /// The components of the motion of an end, in the axes of the member; for equal bending planes
    /// the components of both planes.
    pub(crate) planes: Vec<&'static [Component]>,
    /// Its kinds of strain, each with the number of its coordinates, in the order of the
    /// coordinates.
    pub(crate) strains: Vec<(Strain, usize)>,
    /// The motion of the far end for the coordinates of the part, whose stiffness is the identity:
    /// a row for each component.
    pub(crate) tips: Vec<Vec<f64>>,
    /// Inertia, stiffness to the ground and geometric stiffness for the motion of the near end and
    /// the own coordinates, row by row; empty where it has none.
    pub(crate) matrices: [Vec<f64>; 3],
    /// The motion at each requested distance, for the motion of the near end and the coordinates of
    /// the part: a row for each component, row by row.
    pub(crate) shapes: Vec<Vec<f64>>,
}

/// Data of an element.
pub(crate) struct MemberSlice<'a> {
    /// Length, m.
    pub(crate) length_m: f64,
    /// Whether its section, without the masses and springs attached to it, is constant along the
    /// element.
    pub(crate) is_uniform: bool,
    /// The section at a distance (m) from the near end.
    pub(crate) section_at: &'a dyn Fn(f64) -> Section,
    /// The compression (N) at such a distance, if it is known.
    pub(crate) compression_n: Option<&'a dyn Fn(f64) -> f64>,
    /// Inertia that moves with the section at a distance (m) from the near end. It can couple all
    /// motions.
    pub(crate) bodies: &'a [(f64, SpatialMatrix)],
    /// Springs to the ground between two distances (m) from the near end, with the stiffness at
    /// both and linear between them. They have kinks, so each part is integrated by itself.
    pub(crate) soil: &'a [SoilPart],
    /// Distances (m) from the near end at which the shapes are requested.
    pub(crate) sampled_m: &'a [f64],
}

/// The ends of a part of an element, and the springs at both ends.
pub(crate) type SoilPart = ([f64; 2], [SoilStiffness; 2]);

/// The number of polynomials of each strain of an element.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct MemberStrains {
    pub(crate) curvature: usize,
    pub(crate) shear: usize,
    pub(crate) torsion: usize,
    pub(crate) axial: usize,
}

impl MemberStrains {
    /// Spectral elements of a degree, with no more polynomials than the curvature needs beside it:
    /// shear is a small part of the deflection, and in a uniform member the waves of torsion and
    /// axial motion are many times as long as those of bending.
    pub(crate) fn of_degree(degree: usize, shears: bool, is_uniform: bool) -> Self {
        let along = match is_uniform {
            true => degree.saturating_sub(3).max(2),
            false => degree,
        };
        Self {
            // With only one curvature polynomial the rotation of the far end would be proportional
            // to its deflection.
            curvature: (degree - 1).max(2),
            shear: if shears { (degree - 2).max(1) } else { 0 },
            torsion: along,
            axial: along,
        }
    }

    /// Number of polynomials of a kind of strain.
    pub(crate) fn count(&self, strain: Strain) -> usize {
        match strain {
            Strain::Curvature(_) => self.curvature,
            Strain::Shear(_) => self.shear,
            Strain::Twist => self.torsion,
            Strain::Stretch => self.axial,
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
    /// Makes an element as separate parts, or as one part if bodies on it can couple all motions.
    pub(crate) fn make(
        &mut self,
        strains: MemberStrains,
        element: &MemberSlice<'_>,
    ) -> Vec<MemberPart> {
        let most = strains.most();
        let (stencil, extra) = match element.is_uniform {
            true => (&mut self.of_uniform, EXTRA_POINTS_OF_UNIFORM),
            false => (&mut self.stencil, EXTRA_POINTS),
        };
        stencil.prepare(most + extra, most.max(2));
        let length_m = element.length_m;
        let heights_m = || stencil.heights_m(0.0, length_m);
        self.sections.clear();
        self.sections.extend(heights_m().map(element.section_at));
        self.compressions_n.clear();
        if let Some(compression_n) = element.compression_n {
            self.compressions_n.extend(heights_m().map(compression_n));
        }
        let slice = Slice {
            base_m: 0.0,
            length_m,
            sections: &self.sections,
            compressions_n: &self.compressions_n,
            rotary_inertia: true,
        };
        let points = &mut self.points;
        if !element.bodies.is_empty() {
            let motions = Motion::ALL.into_iter().map(Motions::only);
            let motions = motions.fold(Motions::default(), Motions::and);
            let beam = &mut self.in_space;
            fill(beam, stencil, (motions, &ALL), strains, &slice);
            add_soil(beam, &ALL, element.soil, points);
            for (distance_m, inertia) in element.bodies {
                add_inertia(beam, *distance_m, inertia);
            }
            return vec![part_of(beam, vec![&ALL], element.sampled_m)];
        }
        let mut parts: Vec<MemberPart> = Vec::with_capacity(Motion::ALL.len());
        let has_equal_planes = planes_are_equal(&self.sections, element.soil);
        for motion in Motion::ALL {
            let (motions, components) = (Motions::only(motion), motion.components());
            if let (Motion::Bending(_), true, Some(first)) =
                (motion, has_equal_planes, parts.first_mut())
            {
                first.planes.push(components);
                continue;
            }
            parts.push(match motion {
                Motion::Bending(_) => {
                    let beam = &mut self.in_plane;
                    fill(beam, stencil, (motions, components), strains, &slice);
                    add_soil(beam, components, element.soil, points);
                    part_of(beam, vec![components], element.sampled_m)
                }
                Motion::Torsion | Motion::Axial => {
                    let beam = &mut self.in_line;
                    fill(beam, stencil, (motions, components), strains, &slice);
                    add_soil(beam, components, element.soil, points);
                    part_of(beam, vec![components], element.sampled_m)
                }
            });
        }
        parts
    }

    /// The motion of the far end for that of the near end without deformation.
    pub(crate) fn rigid(length_m: f64) -> SpatialMatrix {
        rigid_motion(length_m)
    }
}

/// Makes the only element of a beam.
fn fill<const D: usize>(
    beam: &mut Beam<D>,
    stencil: &mut Stencil,
    (motions, components): (Motions, &[Component]),
    strains: MemberStrains,
    slice: &Slice<'_>,
) {
    let components: [Component; D] = std::array::from_fn(|d| components[d]);
    beam.clear();
    beam.set_deformations(deformations(motions, &components, |strain| {
        strains.count(strain)
    }));
    stencil.add_element(beam, &components, slice);
}

fn part_of<const D: usize>(
    beam: &Beam<D>,
    planes: Vec<&'static [Component]>,
    sampled_m: &[f64],
) -> MemberPart {
    MemberPart {
        planes,
        strains: beam
            .deformations()
            .iter()
            .map(|d| (d.strain, d.count))
            .collect(),
        tips: beam.tip_rows(0).map(<[f64]>::to_vec).collect(),
        matrices: beam.matrices.clone(),
        shapes: sampled_m.iter().map(|at_m| shape_at(beam, *at_m)).collect(),
    }
}

/// Whether an element has equal matrices in both bending planes.
fn planes_are_equal(sections: &[Section], soil: &[SoilPart]) -> bool {
    let is_equal = |soil: &SoilStiffness| {
        soil.x_n_per_m2 == soil.y_n_per_m2 && soil.rotation_x_n == soil.rotation_y_n
    };
    let of_section = |section: &Section| {
        let planes = [
            section.bending_n_m2,
            section.shear_flexibility_per_n,
            section.masses.rotary_inertia_kg_m,
        ];
        planes.iter().all(|p| p.fore_aft == p.side_side) && is_equal(&section.soil)
    };
    sections.iter().all(of_section) && soil.iter().flat_map(|(_, s)| s).all(is_equal)
}

/// Adds an inertia that moves with the section at a distance (m) from the near end.
fn add_inertia(beam: &mut Beam<6>, distance_m: f64, inertia: &SpatialMatrix) {
    let (rows, shape) = (beam.rows(), shape_at(beam, distance_m));
    let matrix = beam.last_matrix(place(MatrixKind::Inertia));
    add_congruent(inertia, &shape, rows, matrix);
}

/// Adds springs to the ground. The polynomials of the element vary in a part of it about as those
/// of degree p √share do.
fn add_soil<const D: usize>(
    beam: &mut Beam<D>,
    components: &[Component],
    parts: &[SoilPart],
    points: &mut Vec<Vec<(f64, f64)>>,
) {
    for ([from_m, to_m], springs) in parts {
        let counts = beam.deformations().iter().map(|d| d.count);
        let most = counts.max().unwrap_or(0) + 2;
        let share = (to_m - from_m) / beam.length_m(0);
        let needed = POINTS_OF_A_PART + (most as f64 * share.sqrt()).ceil() as usize;
        let rows = beam.rows();
        for (xi, weight) in points_of(needed.min(most + 1), points) {
            let s = 0.5 * (1.0 + xi);
            let per_m = soil(&springs[0].blend(&springs[1], s));
            let weight = 0.5 * weight * (to_m - from_m);
            let here: [f64; D] = std::array::from_fn(|d| weight * per_m[components[d].0]);
            let shape = shape_at(beam, from_m + s * (to_m - from_m));
            let matrix = beam.last_matrix(place(MatrixKind::Foundation));
            add_squares(&here, &shape, rows, matrix);
        }
    }
}

fn points_of(count: usize, known: &mut Vec<Vec<(f64, f64)>>) -> Vec<(f64, f64)> {
    if known.len() <= count {
        known.resize_with(count + 1, Vec::new);
    }
    let points = &mut known[count];
    if points.is_empty() {
        *points = gauss_points(count);
    }
    points.clone()
}

/// The motion of the section at a distance (m) from the near end, for the motion of the near end
/// and the coordinates of the element: D rows.
fn shape_at<const D: usize>(beam: &Beam<D>, distance_m: f64) -> Vec<f64> {
    let length_m = beam.length_m(0);
    let deformations = beam.deformations();
    let count = deformations.iter().map(|d| d.count).max();
    let terms = Legendre::at(2.0 * distance_m / length_m - 1.0);
    let terms: Vec<Term> = terms.take(count.unwrap_or(0)).collect();
    let mut shape = vec![0.0; D * beam.rows()];
    let root = &beam.roots;
    write_shape(&terms, length_m, distance_m, deformations, root, &mut shape);
    shape
}
