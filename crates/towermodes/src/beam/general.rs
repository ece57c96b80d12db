//! Elements of any kind: full matrices for the motion of sections, and strains that resist each
//! other.

use super::element::{Stencil, write_shape};
use super::model::{Beam, add_congruent, place};
use super::strain::Deformation;
use crate::parts::Role;
use crate::space::{Dim, Matrix, Space};

impl Stencil {
    /// Adds matrices for the motion of the section at a point, inertia and ground, per length, to
    /// the last element.
    pub(super) fn add_matrices<const D: usize>(
        &mut self,
        beam: &mut Beam<D>,
        point: usize,
        matrices: [&Matrix<D>; 2],
    ) where
        Dim<D>: Space,
    {
        let (m, rows) = (beam.coordinates(), beam.rows());
        let (xi, weight) = self.points[point];
        let length_m = beam.ends.last().map_or(0.0, |(_, length_m)| *length_m);
        let rise_m = 0.5 * length_m * (1.0 + xi);
        let weight = 0.5 * length_m * weight;
        let Self {
            at_points, shape, ..
        } = self;
        let root = &beam.roots[beam.roots.len() - m * m..];
        let at = &at_points[point];
        write_shape(at, length_m, rise_m, &beam.deformations, root, shape);
        for (role, matrix) in [Role::Inertia, Role::Ground].into_iter().zip(matrices) {
            let matrix = matrix.map(|row| row.map(|entry| weight * entry));
            add_congruent(&matrix, shape, rows, beam.last_matrix(place(role)));
        }
    }

    /// Adds what a section at a point resists strains with, per length: a symmetric matrix over
    /// [`Strain::ALL`]; the lower triangle.
    pub(super) fn add_strain_stiffness<const D: usize>(
        &self,
        deformations: &[Deformation<D>],
        length_m: f64,
        point: usize,
        stiffness: &[[f64; 6]; 6],
        sum: &mut [f64],
    ) {
        let m: usize = deformations.iter().map(|d| d.count).sum();
        let terms = &self.at_points[point];
        let weight = 0.5 * length_m * self.points[point].1;
        let coordinates = deformations.iter().flat_map(|deformation| {
            let strain = deformation.strain.index();
            (0..deformation.count).map(move |k| (strain, terms[k].value))
        });
        let coordinates: Vec<(usize, f64)> = coordinates.collect();
        for (i, (strain, value)) in coordinates.iter().enumerate() {
            let row = &mut sum[i * m..=i * m + i];
            for (entry, (other, other_value)) in row.iter_mut().zip(&coordinates) {
                *entry += weight * stiffness[*strain][*other] * value * other_value;
            }
        }
    }
}
