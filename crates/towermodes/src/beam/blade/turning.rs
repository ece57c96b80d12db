//! The element type of a blade in the rotating frame, and the condensation of the blade to the apex
//! of the rotor.
//!
//! The beam's motions are total ones from the apex outwards: the hub's motion is that of the beam's
//! base. In the turning frame, at a frequency s and a speed Ω, a blade is the Hermitian matrix
//!
//! D(s) = Kₑ + Ω² (K_g − S) + 2 i s Ω C − s² M.
//!
//! M is the inertia. C = ∫ Φᵀ [n] Φ dm (Coriolis forces) is skew, with n the axis of the rotor and
//! [n] b = n × b; S = ∫ Φᵀ (1 − n nᵀ) Φ dm softens by the spin; K_g is the geometric stiffness of
//! the steady centrifugal forces. All are per element, so that a speed and a frequency only combine
//! them. The elements are spectral: polynomial strains of any degree, sections where the points
//! are. The steady bend by centrifugal force and gravity is left out.

use super::super::element::{Stencil, forward_substitute, write_shape};
use super::super::elimination::Factors;
use super::super::legendre::Term;
use super::super::model::{Beam, add_congruent, place};
use super::super::strain::{Strain, deformations};
use super::phasors::Loads;
use super::steady::section_at;
use super::steady::{SteadyForces, steady_forces};
use super::turning_section::{COMPONENTS, TurningSection};
use crate::blade::{Blade, BladeSection};
use crate::scalar::{Complex, Scalar};
use crate::space::{SpatialMatrix, SquareMatrix, add_scaled, transform_matrix};
use crate::subsystem::{Coordinates, MatrixKind};
use crate::tower::{Motion, Motions, Plane};

/// More points than the degree of mass or stiffness times two strains requires: because of the
/// twist the integrands are not polynomials.
const EXTRA_POINTS: usize = 4;

/// A blade in the frame that turns with its rotor.
#[derive(Debug, Clone, Default)]
pub struct TurningBlade {
    pub(crate) beam: Beam<6>,
    /// C of each element, as the matrices of the beam.
    pub(crate) coriolis: Vec<f64>,
    /// Distance of the root from the apex, m.
    pub(super) root_m: f64,
    /// K_g of the rigid stretch from the apex to the root, for the motion of the apex.
    pub(crate) stretch: SpatialMatrix,
    /// Axes of the blade as rows, in the components (along the axis of the rotor, against the
    /// rotation, radial).
    pub(super) axes: [[f64; 3]; 3],
    /// The sections at the points of the elements, point by point.
    pub(super) gauges: Vec<Gauge>,
    /// The polynomials at the points of an element.
    pub(crate) polynomials: Vec<Vec<Term>>,
    /// Inertia of the rigid blade for the motion of the apex, in its axes.
    rigid: SpatialMatrix,
    pub(crate) factors: BladeFactors,
}

/// A section of a blade at a point of an element: what its strains store.
#[derive(Debug, Clone, Copy)]
pub(super) struct Gauge {
    /// Sin and cos of the angle of its chord from X towards Y.
    pub(crate) turn: (f64, f64),
    /// Stiffness against flap, edge, torsion and stretch, each times the length of the point.
    pub(crate) stiffness: [f64; 4],
}

/// The factors of a blade at a frequency, and working memory.
#[derive(Debug, Clone, Default)]
pub struct BladeFactors {
    pub(crate) factors: Factors<Complex>,
    pub(crate) loads: Loads,
}

impl TurningBlade {
    /// Makes the beam of a blade, coned by an angle (rad, positive downwind), with elements of a
    /// degree between these fractions of its span.
    pub fn new(blade: &Blade, cone_rad: f64, borders: &[f64], degree: usize) -> Self {
        let (sin, cos) = cone_rad.sin_cos();
        let mut own = Self {
            root_m: blade.description().hub_radius_m,
            axes: [[0.0, -1.0, 0.0], [cos, 0.0, -sin], [sin, 0.0, cos]],
            ..Self::default()
        };
        let motions = Motion::ALL.into_iter().map(Motions::only);
        let motions = motions.fold(Motions::default(), Motions::and);
        let coordinates = Coordinates::<6>::new(motions);
        let count = |strain| coordinates_of(blade, strain, degree);
        let strains = deformations(motions, coordinates.components(), count);
        own.beam.set_deformations(strains);
        let points = degree + EXTRA_POINTS;
        let mut stencil = Stencil::default();
        stencil.prepare(points, degree.max(2));
        let axis = [0.0, cos, sin];
        let steady = steady_forces(blade, axis, borders, &stencil);
        for (border, forces) in borders.windows(2).zip(&steady.elements) {
            let ends = (blade.radius_m(border[0]), blade.radius_m(border[1]));
            own.add_element(blade, axis, ends, forces, &mut stencil);
        }
        own.add_tip(blade, axis);
        own.polynomials = stencil.at_points;
        own.stretch = steady.stretch(own.root_m);
        own.rigid = own.rigid_inertia();
        own
    }

    fn add_element(
        &mut self,
        blade: &Blade,
        axis: [f64; 3],
        (root_m, tip_m): (f64, f64),
        forces: &[SteadyForces],
        stencil: &mut Stencil,
    ) {
        let length_m = tip_m - root_m;
        let radii_m: Vec<f64> = stencil.heights_m(root_m, length_m).collect();
        let sections = radii_m
            .iter()
            .zip(forces)
            .map(|(radius_m, forces)| TurningSection::at(blade, axis, *radius_m, forces));
        let sections: Vec<TurningSection> = sections.collect();
        let gauges = radii_m.iter().zip(&stencil.points);
        self.gauges.extend(gauges.map(|(radius_m, (_, weight))| {
            Gauge::new(section_at(blade, *radius_m), 0.5 * length_m * weight)
        }));
        let beam = &mut self.beam;
        stencil.begin_element(beam, root_m, length_m, |stencil, beam, root| {
            for (point, section) in sections.iter().enumerate() {
                let (strains, stiffness) = (beam.deformations(), &section.strain_stiffness);
                stencil.add_strain_stiffness(strains, length_m, point, stiffness, root);
            }
        });
        let rows = beam.rows();
        let from = self.coriolis.len();
        self.coriolis.resize(from + rows * rows, 0.0);
        for (point, section) in sections.iter().enumerate() {
            let shape = stencil.shape_and_strains(beam, point);
            let weight = 0.5 * length_m * stencil.points[point].1;
            let motion = &shape[..6 * rows];
            let inertia = scaled(&section.inertia, weight);
            let mass = beam.last_matrix(place(MatrixKind::Inertia));
            add_congruent(&inertia, motion, rows, mass);
            let spin: SquareMatrix<f64, COMPONENTS> = scaled(&section.spin, weight);
            let stiffness = beam.last_matrix(place(MatrixKind::Foundation));
            add_congruent(&spin, &shape, rows, stiffness);
            let coriolis = scaled(&section.coriolis, weight);
            add_congruent(&coriolis, motion, rows, &mut self.coriolis[from..]);
        }
        stencil.end_element(beam);
    }

    fn add_tip(&mut self, blade: &Blade, axis: [f64; 3]) {
        let tip_m = blade.description().tip_radius_m;
        let body = TurningSection::of_tip(blade, axis);
        self.beam.add(MatrixKind::Inertia, tip_m, body.inertia);
        let spin = std::array::from_fn(|i| std::array::from_fn(|j| body.spin[i][j]));
        self.beam.add(MatrixKind::Foundation, tip_m, spin);
        let rows = self.beam.rows();
        let mut top = vec![0.0; 6 * rows];
        let last = self.beam.elements() - 1;
        self.beam.top_motion(last, &mut top);
        let coriolis = &mut self.coriolis[last * rows * rows..];
        add_congruent(&body.coriolis, &top, rows, coriolis);
    }

    /// The inertia of the rigid blade for the motion of the apex, in (axis of the rotor, against
    /// the rotation, radial): kg, kg m, kg m².
    pub fn inertia(&self) -> SpatialMatrix {
        congruent(&self.rigid, &both(&self.axes))
    }

    fn rigid_inertia(&self) -> SpatialMatrix {
        let rows = self.beam.rows();
        let matrices = self.beam.matrices[place(MatrixKind::Inertia)].chunks_exact(rows * rows);
        let mut sum = [[0.0; 6]; 6];
        for (matrix, (root_m, _)) in matrices.zip(&self.beam.ends) {
            let mut own: SpatialMatrix =
                std::array::from_fn(|i| std::array::from_fn(|j| matrix[i * rows + j]));
            transform_matrix(&mut own, *root_m);
            add_scaled(&mut sum, 1.0, &own);
        }
        sum
    }

    /// Whether every number is finite: false if the input's numbers overflowed.
    pub fn is_finite(&self) -> bool {
        let stretch = self.stretch.as_flattened();
        let mut own = self.coriolis.iter().chain(stretch);
        self.beam.is_finite() && own.all(|value| value.is_finite())
    }

    /// Number of its unknowns.
    pub fn degrees_of_freedom(&self) -> usize {
        self.beam.degrees_of_freedom()
    }
}

impl Gauge {
    fn new((section, turn): (BladeSection, (f64, f64)), length_m: f64) -> Self {
        let BladeSection {
            flap_n_m2,
            edge_n_m2,
            torsion_n_m2,
            axial_n,
            ..
        } = section;
        Self {
            turn,
            stiffness: [flap_n_m2, edge_n_m2, torsion_n_m2, axial_n].map(|s| length_m * s),
        }
    }
}

impl Stencil {
    /// The motion (u, Θ) and the strains (γ, κ) at a point of the last element for the motion of
    /// its base and its coordinates: [`COMPONENTS`] rows.
    fn shape_and_strains(&self, beam: &Beam<6>, point: usize) -> Vec<f64> {
        let (m, rows) = (beam.coordinates(), beam.rows());
        let length_m = beam.ends.last().map_or(0.0, |(_, length_m)| *length_m);
        let rise_m = 0.5 * length_m * (1.0 + self.points[point].0);
        let root = &beam.roots[beam.roots.len() - m * m..];
        let at = &self.at_points[point];
        let mut shape = vec![0.0; COMPONENTS * rows];
        let motion = &mut shape[..6 * rows];
        write_shape(at, length_m, rise_m, &beam.deformations, root, motion);
        let mut first = 6;
        for deformation in &beam.deformations {
            let (component, sign) = strain_component(deformation.strain);
            let row = &mut shape[component * rows..(component + 1) * rows];
            for (entry, term) in row[first..].iter_mut().zip(at).take(deformation.count) {
                *entry = sign * term.value;
            }
            first += deformation.count;
        }
        for row in shape[6 * rows..].chunks_exact_mut(rows) {
            forward_substitute(root, &mut row[6..]);
        }
        shape
    }
}

/// Index of a strain among the components of a section, and its sign: bending in the side-side
/// plane rotates negatively about x.
fn strain_component(strain: Strain) -> (usize, f64) {
    match strain {
        Strain::Shear(Plane::ForeAft) => (6, 1.0),
        Strain::Shear(Plane::SideSide) => (7, 1.0),
        Strain::Stretch => (8, 1.0),
        Strain::Curvature(Plane::SideSide) => (9, -1.0),
        Strain::Curvature(Plane::ForeAft) => (10, 1.0),
        Strain::Twist => (11, 1.0),
    }
}

/// Number of polynomials of a strain in elements of this degree; zero if the stiffness of the blade
/// is infinite. Blades have no shear deformation.
fn coordinates_of(blade: &Blade, strain: Strain, degree: usize) -> usize {
    let first = blade.description().sections.first();
    let is_rigid =
        |stiffness: fn(&BladeSection) -> f64| first.map(stiffness) == Some(f64::INFINITY);
    match strain {
        Strain::Curvature(_) => degree - 1,
        Strain::Shear(_) => 0,
        Strain::Twist if is_rigid(|section| section.torsion_n_m2) => 0,
        Strain::Stretch if is_rigid(|section| section.axial_n) => 0,
        Strain::Twist | Strain::Stretch => degree,
    }
}

fn scaled<const D: usize>(matrix: &SquareMatrix<f64, D>, factor: f64) -> SquareMatrix<f64, D> {
    matrix.map(|row| row.map(|entry| factor * entry))
}

/// A matrix that turns translations and rotations alike.
pub fn both(axes: &[[f64; 3]; 3]) -> SpatialMatrix {
    let mut matrix = [[0.0; 6]; 6];
    for i in 0..3 {
        for j in 0..3 {
            matrix[i][j] = axes[i][j];
            matrix[3 + i][3 + j] = axes[i][j];
        }
    }
    matrix
}

/// Tᵀ A T.
pub fn congruent<S: Scalar>(matrix: &SquareMatrix<S, 6>, t: &SpatialMatrix) -> SquareMatrix<S, 6> {
    let mut product = [[S::default(); 6]; 6];
    add_congruent(matrix, t.as_flattened(), 6, product.as_flattened_mut());
    product
}
