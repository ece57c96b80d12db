//! One beam element of any degree: its stiffness, its inertia, the motion of its top.
//!
//! A strain of the element (curvature, shear, stretch, twist) is Σ c_k P_k(ξ), and each motion component is that strain integrated
//! once or twice over the height. The stiffness ∫ s P_i P_j dz is a weighted Gram matrix of Legendre polynomials, diagonal where the
//! section is constant and well conditioned at any degree. In y = Lᵀ c it is the identity.

use super::legendre::{Legendre, Term, gauss_points};
use super::model::{Beam, rigid_motion};
use crate::chain::{Dim, Space};
use crate::tower::Section;

/// The stiffness of a section against a strain.
pub(super) type Stiffness = fn(&Section) -> f64;

/// A strain, and how it moves the element.
#[derive(Clone, Copy)]
pub(super) struct Strain<const D: usize> {
    /// Number of its coordinates.
    pub(super) count: usize,
    /// How often it is integrated to give each motion component; 0 where it does not move it.
    pub(super) integrals: [usize; D],
    /// What sections resist it with.
    pub(super) stiffness: Stiffness,
}

/// What the sections of an element resist a motion with: each component its mass per length.
pub(super) type Inertia<'a, const D: usize> = &'a dyn Fn(&Section) -> [f64; D];

/// The Gauss points of an element with the polynomials there, and working memory.
#[derive(Debug, Clone, Default)]
pub(super) struct Stencil {
    /// ξ and weight on [−1, 1].
    points: Vec<(f64, f64)>,
    at_points: Vec<Vec<Term>>,
    at_top: Vec<Term>,
    count: usize,
    shape: Vec<f64>,
}

impl Stencil {
    /// Makes it for so many points and polynomials, unless it is already.
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

    /// Adds an element that begins at `base_m` (m) with the sections at its points.
    pub(super) fn add_element<const D: usize>(
        &mut self,
        beam: &mut Beam<D>,
        (base_m, length_m): (f64, f64),
        strains: &[Strain<D>],
        sections: &[Section],
        inertia: Inertia<'_, D>,
    ) where
        Dim<D>: Space,
    {
        let (m, rows) = (beam.coordinates(), beam.rows());
        beam.ends.push((base_m, length_m));
        let from = beam.roots.len();
        beam.roots.resize(from + m * m, 0.0);
        let root = &mut beam.roots[from..];
        self.add_stiffness(length_m, strains, sections, m, root);
        cholesky(root, m);
        let from = beam.masses.len();
        beam.masses.resize(from + rows * rows, 0.0);
        let mass = &mut beam.masses[from..];
        self.shape.resize(D * rows, 0.0);
        for (point, section) in sections.iter().enumerate() {
            let (xi, weight) = self.points[point];
            let rise_m = 0.5 * length_m * (1.0 + xi);
            let at = &self.at_points[point];
            write_shape(at, length_m, rise_m, strains, root, &mut self.shape);
            let inertia = inertia(section).map(|inertia| 0.5 * length_m * weight * inertia);
            add_squares(&inertia, &self.shape, rows, mass);
        }
        write_shape(
            &self.at_top,
            length_m,
            length_m,
            strains,
            root,
            &mut self.shape,
        );
        for row in self.shape.chunks_exact(rows) {
            beam.tips.extend_from_slice(&row[D..]);
        }
    }

    /// ∫ s P_i P_j dz of each strain, one block a strain; the lower triangle.
    fn add_stiffness<const D: usize>(
        &self,
        length_m: f64,
        strains: &[Strain<D>],
        sections: &[Section],
        m: usize,
        sum: &mut [f64],
    ) {
        for (point, section) in sections.iter().enumerate() {
            let terms = &self.at_points[point];
            let weight = 0.5 * length_m * self.points[point].1;
            let mut first = 0;
            for strain in strains {
                let stiffness = weight * (strain.stiffness)(section);
                for i in 0..strain.count {
                    let row = &mut sum[(first + i) * m + first..];
                    let factor = stiffness * terms[i].value;
                    for (entry, term) in row[..=i].iter_mut().zip(terms) {
                        *entry += factor * term.value;
                    }
                }
                first += strain.count;
            }
        }
    }
}

/// The motion components `rise_m` above the element's base, for the motion of the base and the coordinates y: D rows.
fn write_shape<const D: usize>(
    at: &[Term],
    length_m: f64,
    rise_m: f64,
    strains: &[Strain<D>],
    root: &[f64],
    shape: &mut [f64],
) where
    Dim<D>: Space,
{
    let rows = shape.len() / D;
    let half = 0.5 * length_m;
    let rigid = rigid_motion::<D>(rise_m);
    for (d, row) in shape.chunks_exact_mut(rows).enumerate() {
        row[..D].copy_from_slice(&rigid[d]);
        let mut coordinates = row[D..].iter_mut();
        for strain in strains {
            let integral = |k: usize| match strain.integrals[d] {
                0 => 0.0,
                1 => half * at[k].first,
                _ => half * half * at[k].second,
            };
            for (k, coordinate) in coordinates.by_ref().take(strain.count).enumerate() {
                *coordinate = integral(k);
            }
        }
        // (row)·c = (row)·L⁻ᵀ y = (L⁻¹ row)·y.
        forward_substitute(root, &mut row[D..]);
    }
}

/// sum += Σ_d inertia_d · row_d row_dᵀ.
fn add_squares<const D: usize>(inertia: &[f64; D], shape: &[f64], rows: usize, sum: &mut [f64]) {
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

/// Overwrites the lower triangle of a positive definite m×m matrix by its Cholesky factor; NaN if it is not positive definite.
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
fn forward_substitute(root: &[f64], x: &mut [f64]) {
    let m = x.len();
    for i in 0..m {
        let row = &root[i * m..=i * m + i];
        let sum: f64 = row[..i].iter().zip(&x[..i]).map(|(l, x)| l * x).sum();
        x[i] = (x[i] - sum) / row[i];
    }
}
