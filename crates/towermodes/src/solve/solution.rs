//! What a solve gives.

use super::spectrum::Found;
use crate::Method;
use crate::Warning;
use crate::eigen::Statistics;
use crate::modes::{Family, ModeCurve, ShapePoint};

/// A natural mode of a tower.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Place in the list, from 1.
    pub number: usize,
    /// Natural frequency of the chain of rigid bodies, Hz.
    pub frequency_hz: f64,
    /// The kind of motion.
    pub family: Family,
    /// Order within the family, from 1.
    pub order: usize,
    /// Bound on the error of the eigenvalue computation, Hz.
    pub algebraic_error_hz: f64,
    /// Estimate of the error of representing the beam by this many segments, Hz.
    pub discretization_error_hz: f64,
    /// The beam's frequency extrapolated from meshes of half or twice the segments, Hz.
    pub extrapolated_hz: f64,
    /// Modal mass uᵀMu for the shape as normalized here: kg, or kg m² for torsion.
    pub modal_mass: f64,
    /// The shape at equal heights from the base to the top.
    pub shape: Vec<ShapePoint>,
    /// The shape at the tower's stations.
    pub station_shape: Vec<ShapePoint>,
}

impl Mode {
    /// A mode as found, its discretization error still unknown.
    pub(super) fn new(
        number: usize,
        found: &Found,
        curve: &ModeCurve<'_>,
        heights_m: &[f64],
        stations_m: &[f64],
    ) -> Self {
        let frequency_hz = found.eigenvalue.frequency_hz();
        Self {
            number,
            frequency_hz,
            family: found.family,
            order: found.order,
            algebraic_error_hz: found.eigenvalue.frequency_error_hz(),
            discretization_error_hz: 0.0,
            extrapolated_hz: frequency_hz,
            // The vector has uᵀKu = 1 and so uᵀMu = 1/λ.
            modal_mass: 1.0 / (curve.largest() * curve.largest() * found.eigenvalue.lambda),
            shape: curve.sample(found.family, heights_m),
            station_shape: curve.sample(found.family, stations_m),
        }
    }

    /// The same mode in the side-side plane of a tower whose planes are equal.
    pub(super) fn in_side_side(&self, number: usize) -> Self {
        let turned =
            |shape: &[ShapePoint]| shape.iter().map(ShapePoint::turned_to_side_side).collect();
        Self {
            number,
            family: Family::SideSide,
            shape: turned(&self.shape),
            station_shape: turned(&self.station_shape),
            ..*self
        }
    }

    /// Whether no number of it overflowed on the way.
    pub(super) fn is_finite(&self) -> bool {
        let mut points = self.shape.iter().chain(&self.station_shape);
        self.modal_mass.is_finite() && points.all(ShapePoint::is_finite)
    }

    /// 1/frequency, s.
    pub fn period_s(&self) -> f64 {
        1.0 / self.frequency_hz
    }

    /// The whole error, of the segments and of the eigenvalue computation, Hz.
    pub fn error_hz(&self) -> f64 {
        self.discretization_error_hz + self.algebraic_error_hz
    }

    /// Modal mass, kg; none for torsion.
    pub fn modal_mass_kg(&self) -> Option<f64> {
        (self.family != Family::Torsion).then_some(self.modal_mass)
    }

    /// Modal inertia, kg m²; for torsion only.
    pub fn modal_inertia_kg_m2(&self) -> Option<f64> {
        (self.family == Family::Torsion).then_some(self.modal_mass)
    }

    /// What it is: "1st fore-aft bending".
    pub fn label(&self) -> String {
        self.family.label(self.order)
    }
}

/// The proof that no mode is missing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Certificate {
    /// Whether the inertia count and the list agree; a solution that is not complete is never returned.
    pub complete: bool,
    /// Number of modes that the inertia count proves below [`below_hz`](Self::below_hz): as many as are listed, or more if
    /// the number asked for cuts a repeated pair.
    pub count: usize,
    /// A frequency in the gap above the last mode, Hz.
    pub below_hz: f64,
}

/// The lowest modes of a tower, with their errors and the proof that they are all.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// The method used.
    pub method: Method,
    /// Number of segments used, or of elements.
    pub segments: usize,
    /// Polynomial degree of the elements of the spectral beam; none for other methods.
    pub degree: Option<usize>,
    /// Degrees of freedom of the whole tower.
    pub degrees_of_freedom: usize,
    /// The modes by frequency; of a repeated pair the fore-aft one first.
    pub modes: Vec<Mode>,
    /// The proof that none is missing.
    pub certificate: Certificate,
    /// What looks like a slip.
    pub warnings: Vec<Warning>,
    /// What it cost.
    pub statistics: Statistics,
}

impl Solution {
    /// The mode of a family and an order in it, from 1, if it is in the list.
    pub fn mode(&self, family: Family, order: usize) -> Option<&Mode> {
        let mut modes = self.modes.iter();
        modes.find(|mode| mode.family == family && mode.order == order)
    }
}
