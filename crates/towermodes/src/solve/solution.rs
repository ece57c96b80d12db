//! What a solve gives.

use super::naming::Identity;
use super::spectrum::{Found, ModeKey, Proof};
use crate::Method;
use crate::Warning;
use crate::eigen::Statistics;
use crate::modes::{ByMotion, Energy, Family, ModeCurve, ShapePoint};
use crate::space::SpatialMatrix;

/// A natural mode of a tower.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Place in the list, from 1.
    pub number: usize,
    /// Natural frequency of the chain of rigid bodies or of the beam, Hz; 0 for a motion that
    /// nothing resists.
    pub frequency_hz: f64,
    /// The kind of motion: that with most of the energy.
    pub family: Family,
    /// Order within the family, from 1.
    pub order: usize,
    /// Bound on the error of the eigenvalue computation, Hz.
    pub algebraic_error_hz: f64,
    /// Estimate of the error of representing the beam by this many segments, Hz.
    pub discretization_error_hz: f64,
    /// The beam's frequency extrapolated from meshes of half or twice the segments, Hz.
    pub extrapolated_hz: f64,
    /// Modal mass uᵀMu for the shape as normalized here: kg, or kg m² for torsion and yaw.
    pub modal_mass: f64,
    /// Where its energy is.
    pub energy: Energy,
    /// Effective modal masses in x, y, z, kg, and about the axes x, y, z through the base, kg m²:
    /// (uᵀ M r)²/(uᵀ M u) with r the rigid motion of 1 in that direction. Over all modes they add
    /// up to the diagonal of [`Solution::rigid_inertia`].
    pub effective_mass: [f64; 6],
    /// The shape at equal heights from the base to the top.
    pub shape: Vec<ShapePoint>,
    /// The shape at the tower's stations.
    pub station_shape: Vec<ShapePoint>,
    /// The shape at the heights of [`Options::heights_m`](crate::Options::heights_m).
    pub shape_there: Vec<ShapePoint>,
    /// Which mode it is on any mesh and by any method.
    pub(crate) key: ModeKey,
}

impl Mode {
    /// A mode as found in a spectrum that begins at `origin` (rad²/s²), its discretization error
    /// still unknown, with its shape at equal heights, at the stations and at others, m.
    pub(super) fn new(
        number: usize,
        found: &Found,
        identity: &Identity,
        origin: f64,
        curve: &ModeCurve<'_>,
        [equal_m, stations_m, others_m]: [&[f64]; 3],
    ) -> Self {
        let frequency_hz = found.eigenvalue.frequency_hz();
        Self {
            number,
            frequency_hz,
            family: identity.family,
            order: identity.order,
            energy: identity.energy,
            effective_mass: identity.effective_mass,
            key: found.key,
            algebraic_error_hz: found.eigenvalue.frequency_error_hz(),
            discretization_error_hz: 0.0,
            extrapolated_hz: frequency_hz,
            // The vector has uᵀ(K − σM)u = 1, and so uᵀMu = 1/(λ − σ).
            modal_mass: 1.0
                / (curve.largest() * curve.largest() * (found.eigenvalue.lambda - origin)),
            shape: curve.sample(equal_m),
            station_shape: curve.sample(stations_m),
            shape_there: curve.sample(others_m),
        }
    }

    /// The same mode in the side-side plane of a tower whose planes are equal.
    pub(super) fn in_side_side(&self, number: usize, found: &Found, identity: &Identity) -> Self {
        let turned =
            |shape: &[ShapePoint]| shape.iter().map(ShapePoint::turned_to_side_side).collect();
        Self {
            number,
            family: identity.family,
            order: identity.order,
            energy: identity.energy,
            effective_mass: identity.effective_mass,
            key: found.key,
            shape: turned(&self.shape),
            station_shape: turned(&self.station_shape),
            shape_there: turned(&self.shape_there),
            ..*self
        }
    }

    /// Whether no number of it overflowed on the way.
    pub(super) fn is_finite(&self) -> bool {
        let points = self.shape.iter().chain(&self.station_shape);
        let mut points = points.chain(&self.shape_there);
        self.modal_mass.is_finite() && points.all(ShapePoint::is_finite)
    }

    /// Whether it is the same mode as one of another solution of the tower, on another mesh or by
    /// another method: of the same subsystem of the tower and of the same order in it, whatever its
    /// frequency and family are there.
    pub fn is_same_as(&self, other: &Self) -> bool {
        self.key == other.key
    }

    /// The identity of the mode, the same on any mesh and by any method.
    pub fn key(&self) -> ModeKey {
        self.key
    }

    /// 1/frequency, s; infinite for a motion that nothing resists.
    pub fn period_s(&self) -> f64 {
        1.0 / self.frequency_hz
    }

    /// The whole error, of the segments and of the eigenvalue computation, Hz.
    pub fn error_hz(&self) -> f64 {
        self.discretization_error_hz + self.algebraic_error_hz
    }

    /// Modal mass, kg; none for torsion and yaw.
    pub fn modal_mass_kg(&self) -> Option<f64> {
        (!self.is_turning()).then_some(self.modal_mass)
    }

    /// Modal inertia, kg m²; for torsion and yaw only.
    pub fn modal_inertia_kg_m2(&self) -> Option<f64> {
        self.is_turning().then_some(self.modal_mass)
    }

    fn is_turning(&self) -> bool {
        matches!(self.family, Family::Torsion | Family::Yaw)
    }

    /// The parts of its energy that are not of its own family, with the family each is of, largest
    /// first.
    pub fn other_parts(&self) -> Vec<(Family, f64)> {
        let mean = self.energy.mean();
        let own = match self.family {
            Family::Surge | Family::Pitch => Family::ForeAft,
            Family::Sway | Family::Roll => Family::SideSide,
            Family::Heave => Family::Axial,
            Family::Yaw => Family::Torsion,
            family => family,
        };
        let ByMotion {
            fore_aft,
            side_side,
            torsion,
            axial,
        } = mean;
        let mut parts = vec![
            (Family::ForeAft, fore_aft),
            (Family::SideSide, side_side),
            (Family::Torsion, torsion),
            (Family::Axial, axial),
        ];
        parts.retain(|(family, _)| *family != own);
        parts.sort_by(|a, b| b.1.total_cmp(&a.1));
        parts
    }

    /// What it is: "1st fore-aft bending".
    pub fn label(&self) -> String {
        self.family.label(self.order)
    }
}

/// The proof that no mode is missing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Certificate {
    /// Whether the inertia count and the list agree; a solution that is not complete is never
    /// returned.
    pub complete: bool,
    /// Number of modes that the inertia count proves below [`below_hz`](Self::below_hz): as many as
    /// are listed, or more if the number asked for cuts a repeated pair.
    pub count: usize,
    /// A frequency in the gap above the last mode, Hz.
    pub below_hz: f64,
}

impl Certificate {
    pub(super) fn of(proof: &Proof) -> Self {
        Self {
            complete: true,
            count: proof.count,
            below_hz: proof.below.max(0.0).sqrt() / std::f64::consts::TAU,
        }
    }
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
    /// The inertia of the whole tower against rigid motions (x, y, z, rotation about x, y, z) about
    /// its base, with all that moves with it: kg, kg m, kg m². Its diagonal is what effective
    /// masses are shares of.
    pub rigid_inertia: SpatialMatrix,
    /// The factor by which all weights must be multiplied for the tower to buckle; none without
    /// gravity, or where it floats.
    pub buckling_load_factor: Option<f64>,
    /// What looks like a slip.
    pub warnings: Vec<Warning>,
    /// What it cost.
    pub statistics: Statistics,
}

impl Solution {
    /// The sums of the effective masses of the modes in the list, as shares of the whole: in x, y,
    /// z and about x, y, z.
    pub fn effective_mass_shares(&self) -> [f64; 6] {
        std::array::from_fn(|i| {
            let listed: f64 = self.modes.iter().map(|mode| mode.effective_mass[i]).sum();
            listed / self.rigid_inertia[i][i]
        })
    }

    /// The mode of a family and an order in it, from 1, if it is in the list.
    pub fn mode(&self, family: Family, order: usize) -> Option<&Mode> {
        let mut modes = self.modes.iter();
        modes.find(|mode| mode.family == family && mode.order == order)
    }
}
