//! One beam element of any degree: stiffness, inertia, soil, geometric stiffness, and the motion of
//! its top.
//!
//! A strain of the element (curvature, shear, stretch, twist) is Σ c_k P_k(ξ), and each motion
//! component is that strain integrated once or twice over the height. The stiffness ∫ s P_i P_j dz
//! is a weighted Gram matrix of Legendre polynomials, diagonal where the section is constant and
//! well conditioned at any degree. In y = Lᵀ c it is the identity.

use super::legendre::{Legendre, Term, gauss_points};
use super::model::{Beam, GEOMETRIC, place, rigid_motion};
use super::strain::{Deformation, Strain};
use crate::space::{Lever, levers};
use crate::subsystem::MatrixKind;
use crate::tower::{Component, Motion, Section, SoilStiffness};

/// The sections of an element at the points of a stencil.
pub struct Slice<'a> {
    /// Height of its base, m.
    pub(super) base_m: f64,
    /// Length, m.
    pub(super) length_m: f64,
    /// The section at each point.
    pub(super) sections: &'a [Section],
    /// The compression at each point, N; empty without gravity.
    pub(super) compressions_n: &'a [f64],
    /// Whether sections have rotary inertia in bending.
    pub(super) rotary_inertia: bool,
}

/// The Gauss points of an element with the polynomials there, and working memory.
#[derive(Debug, Clone, Default)]
pub struct Stencil {
    /// ξ and weight on [−1, 1].
    pub(super) points: Vec<(f64, f64)>,
    pub(super) at_points: Vec<Vec<Term>>,
    at_top: Vec<Term>,
    count: usize,
    pub(super) shape: Vec<f64>,
    shear: Vec<f64>,
}

impl Stencil {
    /// Allocates the tables for this number of points and polynomials, if they do not exist yet.
    pub(super) fn prepare(&mut self, points: usize, count: usize) {
        if self.points.len() == points && self.count == count {
            return;
        }
        self.count = count;
        self.points = gauss_points(points);
        let terms = |xi| Legendre::at(xi).take(count).collect();
        self.at_points = self.points.iter().map(|(xi, _)| terms(*xi)).collect();
        self.at_top = terms(1.0);
    }

    /// The heights of the points of an element, m.
    pub(super) fn heights_m(&self, base_m: f64, length_m: f64) -> impl Iterator<Item = f64> {
        let height = move |(xi, _): &(f64, f64)| base_m + 0.5 * length_m * (1.0 + xi);
        self.points.iter().map(height)
    }

    /// Adds an element to a beam with these components.
    pub(super) fn add_element<const D: usize>(
        &mut self,
        beam: &mut Beam<D>,
        components: &[Component; D],
        slice: &Slice<'_>,
    ) {
        self.begin_element(beam, slice.base_m, slice.length_m, |stencil, beam, root| {
            stencil.add_stiffness(slice, &beam.deformations, beam.coordinates(), root);
        });
        for point in 0..slice.sections.len() {
            self.add_point(beam, components, slice, point);
        }
        self.end_element(beam);
    }

    /// Begins an element whose stiffness for its strain coefficients, the lower triangle, is
    /// written by `add_stiffness`.
    pub(super) fn begin_element<const D: usize>(
        &mut self,
        beam: &mut Beam<D>,
        base_m: f64,
        length_m: f64,
        add_stiffness: impl FnOnce(&Self, &Beam<D>, &mut [f64]),
    ) {
        let (m, rows) = (beam.coordinates(), beam.rows());
        beam.ends.push((base_m, length_m));
        let from = beam.roots.len();
        let mut roots = std::mem::take(&mut beam.roots);
        roots.resize(from + m * m, 0.0);
        add_stiffness(self, beam, &mut roots[from..]);
        cholesky(&mut roots[from..], m);
        beam.roots = roots;
        self.shape.resize(D * rows, 0.0);
    }

    /// Ends an element: the motion of its top is known.
    pub(super) fn end_element<const D: usize>(&mut self, beam: &mut Beam<D>) {
        let (m, rows) = (beam.coordinates(), beam.rows());
        let Self { at_top, shape, .. } = self;
        let root = &beam.roots[beam.roots.len() - m * m..];
        let top_m = beam.ends.last().map_or(0.0, |(_, length_m)| *length_m);
        write_shape(at_top, top_m, top_m, &beam.deformations, root, shape);
        for row in shape.chunks_exact(rows) {
            beam.tips.extend_from_slice(&row[D..]);
        }
    }

    /// Adds the contribution of one point to the matrices of the last element.
    fn add_point<const D: usize>(
        &mut self,
        beam: &mut Beam<D>,
        components: &[Component; D],
        slice: &Slice<'_>,
        point: usize,
    ) {
        let (xi, weight) = self.points[point];
        let (section, length_m) = (&slice.sections[point], slice.length_m);
        let rise_m = 0.5 * length_m * (1.0 + xi);
        let weight = 0.5 * length_m * weight;
        let (element, m) = (beam.elements() - 1, beam.coordinates());
        let rows = beam.rows();
        let root = &beam.roots[element * m * m..];
        let at = &self.at_points[point];
        write_shape(
            at,
            length_m,
            rise_m,
            &beam.deformations,
            root,
            &mut self.shape,
        );
        let inertia = inertia(section, slice.rotary_inertia);
        let inertia = components.map(|(i, _)| weight * inertia[i]);
        let matrix = beam.last_matrix(place(MatrixKind::Inertia));
        add_squares(&inertia, &self.shape, rows, matrix);
        if section.soil != SoilStiffness::default() {
            let soil = soil(&section.soil);
            let soil = components.map(|(i, _)| weight * soil[i]);
            let matrix = beam.last_matrix(place(MatrixKind::Foundation));
            add_squares(&soil, &self.shape, rows, matrix);
        }
        let Some(compression_n) = slice.compressions_n.get(point) else {
            return;
        };
        for lever in const { levers(D) } {
            self.write_shear(beam, components, lever, point);
            let matrix = beam.last_matrix(GEOMETRIC);
            self.add_p_delta::<D>(lever, -weight * compression_n, rows, matrix);
        }
    }

    /// The shear at a point by the coordinates y, in the plane of a lever: one row.
    fn write_shear<const D: usize>(
        &mut self,
        beam: &Beam<D>,
        components: &[Component; D],
        lever: &Lever,
        point: usize,
    ) {
        let (element, m) = (beam.elements() - 1, beam.coordinates());
        self.shear.clear();
        self.shear.resize(beam.rows(), 0.0);
        let mut own = self.shear[D..].iter_mut();
        let moved = components[lever.moved].0;
        for deformation in &beam.deformations {
            let is_own = matches!(deformation.strain, Strain::Shear(plane)
                if Motion::Bending(plane).components()[0].0 == moved);
            let coordinates = own.by_ref().take(deformation.count);
            for (coordinate, term) in coordinates.zip(&self.at_points[point]) {
                *coordinate = if is_own { term.value } else { 0.0 };
            }
        }
        forward_substitute(&beam.roots[element * m * m..], &mut self.shear[D..]);
    }

    /// sum += factor·(θ θᵀ + θ γᵀ + γ θᵀ), with the rotation θ = dw/dz − γ of a lever's plane and
    /// the shear γ written last.
    ///
    /// With the factor −N it is the geometric stiffness of a compression N: sections that are
    /// rotated by θ lower what is above them by θ²/2, and the shear γ along them by γ θ.
    ///
    /// Source: Haringx (1948).
    fn add_p_delta<const D: usize>(
        &self,
        lever: &Lever,
        factor: f64,
        rows: usize,
        sum: &mut [f64],
    ) {
        let theta = &self.shape[lever.by * rows..(lever.by + 1) * rows];
        let gamma = &self.shear;
        for (i, out) in sum.chunks_exact_mut(rows).take(rows).enumerate() {
            for (j, out) in out.iter_mut().enumerate() {
                let turned = theta[i] * theta[j];
                let slid = theta[i] * gamma[j] + gamma[i] * theta[j];
                *out += factor * (turned + lever.sign * slid);
            }
        }
    }

    /// ∫ s P_i P_j dz of each strain, one block per strain; the lower triangle.
    fn add_stiffness<const D: usize>(
        &self,
        slice: &Slice<'_>,
        deformations: &[Deformation<D>],
        m: usize,
        sum: &mut [f64],
    ) {
        for (point, section) in slice.sections.iter().enumerate() {
            let terms = &self.at_points[point];
            let weight = 0.5 * slice.length_m * self.points[point].1;
            let mut first = 0;
            for deformation in deformations {
                let stiffness = weight * deformation.strain.stiffness(section);
                for i in 0..deformation.count {
                    let row = &mut sum[(first + i) * m + first..];
                    let factor = stiffness * terms[i].value;
                    for (entry, term) in row[..=i].iter_mut().zip(terms) {
                        *entry += factor * term.value;
                    }
                }
                first += deformation.count;
            }
        }
    }
}

/// The inertia of a section per length against (x, y, z, rotation about x, y, z), kg/m and kg m.
fn inertia(section: &Section, rotary_inertia: bool) -> [f64; 6] {
    let masses = &section.masses;
    let transverse = masses.mass_kg_per_m + masses.water_kg_per_m;
    let factor = f64::from(u8::from(rotary_inertia));
    let rotary = masses.rotary_inertia_kg_m.map(|rotary| factor * rotary);
    [
        transverse,
        transverse,
        masses.mass_kg_per_m,
        rotary.side_side,
        rotary.fore_aft,
        masses.polar_inertia_kg_m,
    ]
}

/// The stiffness of the soil per length against (x, y, z, rotation about x, y, z), N/m² and N.
pub(super) fn soil(soil: &SoilStiffness) -> [f64; 6] {
    [
        soil.x_n_per_m2,
        soil.y_n_per_m2,
        soil.z_n_per_m2,
        soil.rotation_x_n,
        soil.rotation_y_n,
        soil.torsion_n,
    ]
}

/// The motion components `rise_m` above the element's base, for the motion of the base and the
/// coordinates y: D rows.
pub(super) fn write_shape<const D: usize>(
    at: &[Term],
    length_m: f64,
    rise_m: f64,
    deformations: &[Deformation<D>],
    root: &[f64],
    shape: &mut [f64],
) {
    let rows = shape.len() / D;
    let half = 0.5 * length_m;
    let rigid = rigid_motion::<D>(rise_m);
    for (d, row) in shape.chunks_exact_mut(rows).enumerate() {
        row[..D].copy_from_slice(&rigid[d]);
        let mut coordinates = row[D..].iter_mut();
        for deformation in deformations {
            let times = deformation.integrals[d];
            let sign = f64::from(times.signum());
            let integral = |k: usize| match times.abs() {
                0 => 0.0,
                1 => sign * half * at[k].first,
                _ => sign * half * half * at[k].second,
            };
            let own = coordinates.by_ref().take(deformation.count);
            for (k, coordinate) in own.enumerate() {
                *coordinate = integral(k);
            }
        }
        // (row)·c = (row)·L⁻ᵀ y = (L⁻¹ row)·y.
        forward_substitute(root, &mut row[D..]);
    }
}

/// sum += Σ_d inertia_d · row_d row_dᵀ.
pub(super) fn add_squares<const D: usize>(
    inertia: &[f64; D],
    shape: &[f64],
    rows: usize,
    sum: &mut [f64],
) {
    for (inertia, row) in inertia.iter().zip(shape.chunks_exact(rows)) {
        if *inertia == 0.0 {
            continue;
        }
        for (out, a) in sum.chunks_exact_mut(rows).zip(row) {
            let factor = inertia * a;
            for (out, b) in out.iter_mut().zip(row) {
                *out += factor * b;
            }
        }
    }
}

/// Overwrites the lower triangle of a positive definite m×m matrix by its Cholesky factor; NaN if
/// it is not positive definite.
fn cholesky(matrix: &mut [f64], m: usize) {
    for i in 0..m {
        for j in 0..=i {
            let (a, b) = (&matrix[i * m..i * m + j], &matrix[j * m..j * m + j]);
            let sum: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
            let rest = matrix[i * m + j] - sum;
            matrix[i * m + j] = if i == j {
                rest.sqrt()
            } else {
                rest / matrix[j * m + j]
            };
        }
    }
}

/// x ← L⁻¹ x.
pub(super) fn forward_substitute(root: &[f64], x: &mut [f64]) {
    let m = x.len();
    for i in 0..m {
        let row = &root[i * m..=i * m + i];
        let sum: f64 = row[..i].iter().zip(&x[..i]).map(|(l, x)| l * x).sum();
        x[i] = (x[i] - sum) / row[i];
    }
}
