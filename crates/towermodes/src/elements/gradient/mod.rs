//! Derivatives of eigenvalues with respect to all input values of a tower, by one pass along the
//! chain for each mode.
//!
//! For [`Element::RmjeExact`](super::Element::RmjeExact). All integrals of a segment are sums over
//! points, so each point gives its share to the numbers of its piece: diameter, wall and material
//! of a tube, or the columns of a table. What the points and sections are is the same for all
//! modes.

mod borders;
mod mode;
mod numbers;
mod segments;

use super::Mesh;
use crate::subsystem::JointState;
use crate::tower::{Places, Tower};
use mode::{Body, Walk};
use numbers::Numbers;
use segments::Segments;

/// A tower on a mesh, to take derivatives of its modes.
pub(crate) struct GradientMesh<'a> {
    tower: &'a Tower,
    mesh: &'a Mesh,
    rotary_inertia: bool,
    values: Vec<f64>,
    segments: Segments,
    borders: Vec<f64>,
}

impl<'a> GradientMesh<'a> {
    /// For a tower whose bending planes are [apart](Tower::planes_are_apart).
    pub(crate) fn new(tower: &'a Tower, mesh: &'a Mesh, rotary_inertia: bool) -> Self {
        let mut values = Vec::new();
        tower.write_numbers(&mut values);
        Self {
            tower,
            mesh,
            rotary_inertia,
            values,
            segments: Segments::of(tower, mesh),
            borders: Vec::new(),
        }
    }

    /// Writes the derivatives of xᵀKx − λ xᵀMx with respect to the numbers of the tower for a mode
    /// with these joints; false if the chain is another one.
    pub(crate) fn write(
        &mut self,
        lambda: f64,
        states: &[JointState],
        gradient: &mut Vec<f64>,
    ) -> bool {
        gradient.clear();
        gradient.resize(Places::of(self.tower).count(), 0.0);
        self.borders.clear();
        self.borders.resize(self.mesh.segments() + 1, 0.0);
        let walk = Walk {
            tower: self.tower,
            segments: &self.segments,
            lambda,
            rotary_inertia: self.rotary_inertia,
            numbers: Numbers::new(self.tower, &self.values, gradient, &mut self.borders),
            states,
            body: Body::default(),
            load: [0.0; 2],
        };
        let is_whole = walk.run(self.mesh);
        borders::carry_to_heights(self.tower, self.mesh, &self.borders, gradient);
        is_whole
    }
}
