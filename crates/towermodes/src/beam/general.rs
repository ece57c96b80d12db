//! Elements with a full section stiffness: coupled strains, and full matrices for the motion of the
//! sections.

use super::element::{Stencil, write_shape};
use super::model::{Beam, add_congruent, place};
use super::strain::Deformation;
use crate::space::SpatialMatrix;
use crate::subsystem::{Coordinates, MatrixKind};

/// An element whose section is given by full matrices at each point of a stencil.
pub struct GeneralElement<'a> {
    /// Height of its base, m.
    pub(super) base_m: f64,
    /// Length, m.
    pub(super) length_m: f64,
    /// The section at each point.
    pub(super) points: &'a [GeneralSection],
}

/// A section given by full matrices, all per length.
pub struct GeneralSection {
    /// Stiffness against the strains in the order of [`Strain::ALL`](super::Strain::ALL).
    pub(super) strain_stiffness: SpatialMatrix,
    /// Inertia for the motion of the section.
    pub(super) inertia: SpatialMatrix,
    /// Stiffness to the ground for the motion of the section.
    pub(super) foundation: SpatialMatrix,
}

impl Stencil {
    /// Adds a general element to a beam with these coordinates.
    pub(super) fn add_general_element<const D: usize>(
        &mut self,
        beam: &mut Beam<D>,
        coordinates: &Coordinates<D>,
        element: &GeneralElement<'_>,
    ) {
        let (base_m, length_m) = (element.base_m, element.length_m);
        self.begin_element(beam, base_m, length_m, |stencil, beam, root| {
            for (point, section) in element.points.iter().enumerate() {
                let stiffness = &section.strain_stiffness;
                let deformations = beam.deformations();
                stencil.add_strain_stiffness(deformations, length_m, point, stiffness, root);
            }
        });
        for (point, section) in element.points.iter().enumerate() {
            self.write_shape_at(beam, point);
            let weight = 0.5 * length_m * self.points[point].1;
            for (kind, matrix) in [
                (MatrixKind::Inertia, &section.inertia),
                (MatrixKind::Foundation, &section.foundation),
            ] {
                let matrix = coordinates.restrict(matrix);
                let matrix = matrix.map(|row| row.map(|entry| weight * entry));
                let rows = beam.rows();
                add_congruent(&matrix, &self.shape, rows, beam.last_matrix(place(kind)));
            }
        }
        self.end_element(beam);
    }

    /// Writes the motion at a point of the last element for the motion of its base and its
    /// coordinates.
    fn write_shape_at<const D: usize>(&mut self, beam: &Beam<D>, point: usize) {
        let m = beam.coordinates();
        let length_m = beam.ends.last().map_or(0.0, |(_, length_m)| *length_m);
        let rise_m = 0.5 * length_m * (1.0 + self.points[point].0);
        let root = &beam.roots[beam.roots.len() - m * m..];
        let (at, shape) = (&self.at_points[point], &mut self.shape);
        write_shape(at, length_m, rise_m, &beam.deformations, root, shape);
    }

    /// Adds the stiffness of a section at a point to the lower triangle of `sum`.
    pub(super) fn add_strain_stiffness<const D: usize>(
        &self,
        deformations: &[Deformation<D>],
        length_m: f64,
        point: usize,
        stiffness: &SpatialMatrix,
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
