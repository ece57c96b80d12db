//! The result of a solve.

use super::super::on_mesh::naming::Identity;
use super::super::on_mesh::spectrum::{Found, ModeKey, Proof};
use super::super::request::added_mass::AddedMassAt;
use crate::Method;
use crate::eigen::Statistics;
use crate::frame::FrameShape;
use crate::modes::{
    Energy, EnergyParts, Family, ModeCurve, ModeName, SecondFamily, ShapePoint, Shares,
};
use crate::space::SpatialMatrix;
use crate::tower::{Motion, Warning};

/// With a larger error relative to the frequency a mode is not resolved.
pub(super) const RESOLVED: f64 = 0.02;

/// A natural mode of a tower, one of [`Solution::modes`].
///
/// # Example
/// ```
/// use towermodes::{Material, Options, Rna, Station, Tower, TowerDescription, solve};
///
/// let tower = Tower::new(TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     ..TowerDescription::default()
/// })?;
/// let mode = &solve(&tower, &Options::default())?.modes[0];
/// assert_eq!(mode.label(), "1st fore-aft bending");
/// assert!((mode.period_s() - 3.331).abs() < 1e-3);
/// assert!(mode.error_hz() < 1e-4 * mode.frequency_hz);
/// let top = mode.shape.last().expect("101 points");
/// assert_eq!((top.height_m, top.translation[0]), (87.6, 1.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Number in the list, from 1.
    pub number: usize,
    /// Natural frequency of the discretized tower, Hz; 0 for a rigid-body motion that nothing
    /// resists.
    pub frequency_hz: f64,
    /// The kind of motion that names the mode: the family whose energy, added up over the modes so
    /// far, exceeds the number of modes already named after it by the largest amount
    /// ([`Arrears`](crate::modes::Arrears)).
    pub family: Family,
    /// Order within the family, from 1.
    pub order: usize,
    /// The share of each kind of motion in its energy.
    pub shares: Shares,
    /// Bound on the error of the eigenvalue computation, Hz.
    pub algebraic_error_hz: f64,
    /// Estimate of the discretization error, Hz: the difference from the exact frequency of the
    /// continuous beam.
    pub discretization_error_hz: f64,
    /// The frequency of the continuous beam, Hz, extrapolated from meshes with half or twice the
    /// number of segments.
    pub extrapolated_hz: f64,
    /// Modal mass uᵀMu of the shape as normalized here: kg, or kg m² for torsion and yaw. The shape
    /// is normalized by the motion of its family, or, if this family has less than a tenth of the
    /// energy, by the motion of the family with the largest share.
    pub modal_mass: f64,
    /// Distribution of its energy over the motions.
    pub energy: Energy,
    /// Distribution of its energy over the parts of the tower; only with
    /// [`Options::energy_parts`](crate::Options::energy_parts).
    pub energy_parts: Option<EnergyParts>,
    /// Effective modal masses in x, y, z, kg, and about the axes x, y, z through the base, kg m²:
    /// (uᵀ M r)²/(uᵀ M u) with r the rigid motion of 1 in that direction. Over all modes they add
    /// up to the diagonal of [`Solution::rigid_inertia`], if all have the same M.
    pub effective_mass: [f64; 6],
    /// rᵀ M r with the M of this mode: the mass and the moments of inertia of the whole tower in
    /// the same directions, with the added mass that the mode has, kg and kg m².
    pub rigid_inertia: [f64; 6],
    /// The shape at equally spaced heights from the base to the top.
    pub shape: Vec<ShapePoint>,
    /// The shape at the tower's stations.
    pub station_shape: Vec<ShapePoint>,
    /// The shape at the heights of [`Options::heights_m`](crate::Options::heights_m).
    pub shape_there: Vec<ShapePoint>,
    /// The shape of the frame under the tower, normalized by the same factor as `shape`; none
    /// without a frame.
    pub frame: Option<FrameShape>,
    /// Its identity on any mesh and by any method.
    pub(crate) key: ModeKey,
}

impl Mode {
    /// A mode as found in a spectrum that begins at `origin` (rad²/s²), its discretization error
    /// still unknown, of a tower with this inertia in the directions of rigid motions, with its
    /// shape at equal heights, at the stations and at others, m.
    pub(crate) fn new(
        number: usize,
        found: &Found,
        identity: &Identity,
        origin: f64,
        curve: &ModeCurve<'_>,
        rigid_inertia: [f64; 6],
        [equal_m, stations_m, others_m]: [&[f64]; 3],
    ) -> Self {
        let frequency_hz = found.eigenvalue.frequency_hz();
        Self {
            number,
            frequency_hz,
            family: identity.family,
            order: identity.order,
            shares: identity.shares,
            energy: identity.energy,
            energy_parts: None,
            effective_mass: identity.effective_mass,
            rigid_inertia,
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
            frame: None,
        }
    }

    /// The same mode in the side-side plane of a tower whose planes are equal.
    pub(crate) fn in_side_side(&self, number: usize, found: &Found, identity: &Identity) -> Self {
        let turned =
            |shape: &[ShapePoint]| shape.iter().map(ShapePoint::turned_to_side_side).collect();
        Self {
            number,
            family: identity.family,
            order: identity.order,
            shares: identity.shares,
            energy: identity.energy,
            energy_parts: None,
            effective_mass: identity.effective_mass,
            key: found.key,
            shape: turned(&self.shape),
            station_shape: turned(&self.station_shape),
            shape_there: turned(&self.shape_there),
            // A frame couples all motions, so no mode is another one rotated.
            frame: None,
            ..*self
        }
    }

    /// Whether every number is finite.
    pub(crate) fn is_finite(&self) -> bool {
        let points = self.shape.iter().chain(&self.station_shape);
        let mut points = points.chain(&self.shape_there);
        let is_frame_finite = self.frame.as_ref().is_none_or(FrameShape::is_finite);
        self.modal_mass.is_finite() && is_frame_finite && points.all(ShapePoint::is_finite)
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

    /// Period 1/f, s; infinite for a motion that nothing resists.
    pub fn period_s(&self) -> f64 {
        1.0 / self.frequency_hz
    }

    /// The total error, Hz: discretization error plus error of the eigenvalue computation.
    pub fn error_hz(&self) -> f64 {
        self.discretization_error_hz + self.algebraic_error_hz
    }

    /// Whether the total error is at most 2 % of the frequency; if not, the mode is one of the
    /// discretized model and may not be one of the tower.
    pub fn is_resolved(&self) -> bool {
        // A motion without stiffness has frequency 0, and no error is small relative to it.
        self.frequency_hz == 0.0 || self.error_hz() <= RESOLVED * self.frequency_hz
    }

    /// Modal mass, kg; none for torsion and yaw.
    pub fn modal_mass_kg(&self) -> Option<f64> {
        (!self.is_turning()).then_some(self.modal_mass)
    }

    /// Modal inertia, kg m²; for torsion and yaw only.
    pub fn modal_inertia_kg_m2(&self) -> Option<f64> {
        self.is_turning().then_some(self.modal_mass)
    }

    /// The effective masses as fractions of the total masses and moments of inertia, in x, y, z and
    /// about x, y, z: (uᵀ M r)²/(uᵀ M u · rᵀ M r), none above 1 (Cauchy's inequality). Not finite
    /// in a direction in which nothing has inertia.
    pub fn effective_mass_shares(&self) -> [f64; 6] {
        std::array::from_fn(|i| self.effective_mass[i] / self.rigid_inertia[i])
    }

    /// Whether the rotation about z scales the shape.
    fn is_turning(&self) -> bool {
        self.shares.scale(self.family) == Motion::Torsion
    }

    /// Its name: family and order.
    pub fn name(&self) -> ModeName {
        ModeName {
            family: self.family,
            order: self.order,
        }
    }

    /// The share of its family in the energy of the mode.
    pub fn share(&self) -> f64 {
        self.shares.of(self.family)
    }

    /// Among the other families, the one with the largest share of the energy of the mode; none if
    /// no other family has a share.
    pub fn second(&self) -> Option<SecondFamily> {
        self.shares.second_to(self.family)
    }

    /// Whether it has less than 60 % of its energy in the motion of its family; surge, pitch and
    /// fore-aft bending are one motion.
    pub fn is_coupled(&self) -> bool {
        self.shares.is_coupled(self.family)
    }

    /// Order and family in words: "1st fore-aft bending".
    pub fn label(&self) -> String {
        self.family.label(self.order)
    }
}

/// The proof that no mode is missing: an eigenvalue count (Sylvester's law) of the stiffness less a
/// shift times the mass, just above the last mode, equals the number of modes found.
///
/// # Example
/// ```
/// use towermodes::{Material, Options, Station, Tower, TowerDescription, solve};
///
/// let tower = Tower::new(TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     ..TowerDescription::default()
/// })?;
/// let solution = solve(&tower, &Options::default())?;
/// let certificate = &solution.certificate;
/// assert_eq!((certificate.complete, certificate.count), (true, 8));
/// assert!(certificate.below_hz > solution.modes[7].frequency_hz);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Certificate {
    /// Whether the eigenvalue count and the list agree, and no mode is missing anywhere. A solution
    /// that is not complete is returned only if the added mass depends on frequency and leaves an
    /// interval [uncertain](Self::uncertain_hz).
    pub complete: bool,
    /// Number of modes below `below_hz` by the eigenvalue count: the number of listed modes, or
    /// more if the requested number cuts a repeated pair.
    pub count: usize,
    /// A frequency in the gap above the last mode, Hz.
    pub below_hz: f64,
    /// The interval of frequency, Hz, in which there may be other modes: the added mass decreases
    /// there so fast that the count of modes need not rise with frequency. Outside of it the list
    /// is complete.
    pub uncertain_hz: Option<[f64; 2]>,
}

impl Certificate {
    pub(crate) fn of(proof: &Proof) -> Self {
        Self {
            complete: true,
            count: proof.count,
            below_hz: proof.below.max(0.0).sqrt() / std::f64::consts::TAU,
            uncertain_hz: None,
        }
    }
}

/// The lowest modes of a tower, with their errors and the proof that none is missing.
///
/// # Example
/// ```
/// use towermodes::{Family, Material, Options, Rna, Station, Tower, TowerDescription, solve};
///
/// let tower = Tower::new(TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     ..TowerDescription::default()
/// })?;
/// let solution = solve(&tower, &Options::default())?;
/// let first = solution.mode(Family::ForeAft, 1).expect("it is the lowest mode");
/// assert!((first.frequency_hz - 0.300206).abs() < 1e-5);
/// assert_eq!(solution.modes.len(), 8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// The method used.
    pub method: Method,
    /// Number of segments or elements used.
    pub segments: usize,
    /// Polynomial degree of the elements of [`Method::Spectral`]; none for other methods.
    pub degree: Option<usize>,
    /// Degrees of freedom of the whole tower.
    pub degrees_of_freedom: usize,
    /// The modes by frequency; of a repeated pair the fore-aft one first.
    pub modes: Vec<Mode>,
    /// What the discretization errors of the modes are estimated from.
    pub error_basis: ErrorBasis,
    /// The proof that no mode is missing.
    pub certificate: Certificate,
    /// The inertia of the whole tower, with everything that moves with it, against rigid-body
    /// motions (x, y, z, rotation about x, y, z) about its base: kg, kg m, kg m². Its diagonal is
    /// the sum of the effective masses of all modes. Where each mode has the added mass of its own
    /// frequency, it is here that of infinite frequency.
    pub rigid_inertia: SpatialMatrix,
    /// The factor by which self-weight must be multiplied for the tower to buckle; none without
    /// gravity, and for a floating tower.
    pub buckling_load_factor: Option<f64>,
    /// At which frequency the platform has its added mass; none where that does not depend on
    /// frequency.
    pub added_mass: Option<AddedMassAt>,
    /// Possible input mistakes, and limits of the results.
    pub warnings: Vec<Warning>,
    /// Numbers of matrix products and restarts of the eigenvalue solver.
    pub statistics: Statistics,
}

/// What the discretization errors of a [`Solution`] are estimated from. Both lists are empty for
/// [`Method::Spectral`], whose errors are estimated from other degrees and numbers of elements of
/// this method.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ErrorBasis {
    /// The numbers of segments or elements of the other meshes that were solved.
    pub segments: Vec<usize>,
    /// The numbers of the modes whose error is the difference from the reference solution
    /// ([`Method::Spectral`]), and whose extrapolated frequency is the frequency of the reference
    /// solution.
    pub compared: Vec<usize>,
}

impl Solution {
    /// The sums of the effective masses of the modes in the list, as fractions of the total masses
    /// and moments of inertia: in x, y, z and about x, y, z. None if each mode has the added mass
    /// at its own frequency: modes of different mass matrices are not orthogonal, and their
    /// effective masses do not add up to one total. Then only [those of each
    /// mode](Mode::effective_mass_shares) have a meaning.
    pub fn effective_mass_shares(&self) -> Option<[f64; 6]> {
        match self.added_mass {
            Some(AddedMassAt::Own) => None,
            None | Some(AddedMassAt::Infinite | AddedMassAt::Zero | AddedMassAt::Hz(_)) => {
                Some(std::array::from_fn(|i| {
                    let listed: f64 = self.modes.iter().map(|mode| mode.effective_mass[i]).sum();
                    listed / self.rigid_inertia[i][i]
                }))
            }
        }
    }

    /// The mode with this family and this order (from 1) within the family, if it is in the list.
    pub fn mode(&self, family: Family, order: usize) -> Option<&Mode> {
        let mut modes = self.modes.iter();
        modes.find(|mode| mode.family == family && mode.order == order)
    }
}
