//! The modes of a turbine at a speed of its rotor.

use std::ops::Range;

use super::super::counts::frequencies::{CoupledFrequency, Part};
use super::super::description::rad_per_s;
use super::energy::{Nodding, TurbineEnergy, TurbinePart};
use super::name::TurbineModeName;
use super::shape::TurbineShape;
use crate::scalar::{Complex, Scalar};

/// A mode of a turbine at a speed of its rotor.
#[derive(Debug, Clone, PartialEq)]
pub struct TurbineMode {
    /// The frequency, with bounds from eigenvalue counts.
    pub frequency: CoupledFrequency,
    /// Estimate of the discretization error, Hz: the change of the frequency from this mesh to a
    /// finer mesh, and the error of soil springs that are linear between depths; none before
    /// [`TurbineModel::estimate_errors`](super::super::TurbineModel::estimate_errors).
    pub discretization_error_hz: Option<f64>,
    /// Name of the mode. At a speed each name belongs to one mode only; see
    /// [`TurbineModes::modes`].
    pub name: TurbineModeName,
    /// The fraction of its elastic energy in the part that names it.
    pub share: f64,
    /// The part with the most elastic energy among the other parts, and its fraction; none if the
    /// other parts have no energy.
    pub second: Option<(TurbinePart, f64)>,
    /// Fractions of the elastic energy; they sum to 1.
    pub energy: TurbineEnergy,
    /// Shape of the mode; its largest deflection is 1.
    pub shape: TurbineShape,
    /// The part of the equations of the mode: the part that moves the tower, or a harmonic of the
    /// blades.
    pub(crate) part: Part,
    /// Its vector.
    pub(crate) vector: Vec<Complex>,
    /// Coordinates of the vector whose squares are elastic energies, in two ranges.
    pub(super) strains: [Range<usize>; 2],
    /// Square roots of the energies of yaw drive and shaft, of the motions of a platform, and of
    /// the strains of a frame.
    pub(crate) springs: Vec<Complex>,
}

/// The modes of a turbine below a limit, at a speed of its rotor.
#[derive(Debug, Clone, PartialEq)]
pub struct TurbineModes {
    /// Rotor speed, rpm.
    pub rotor_speed_rpm: f64,
    /// The modes by rising frequency. The rotation of a free shaft, at frequency 0, is not
    /// included.
    ///
    /// Names are given by rising frequency. Each mode is named after the part whose energy, added
    /// up over the modes so far, exceeds the number of modes already named after it by the largest
    /// amount. [`Arrears`](crate::modes::Arrears) does this among the parts with at least a quarter
    /// of the largest energy of a part in the mode. From one mode to the next these amounts are
    /// multiplied by the eighth power of the ratio of the lower to the higher frequency. Backward
    /// and forward whirl of a motion first count as one part, and then the same rule chooses
    /// between them. Therefore the names depend on the modes at this speed alone.
    pub modes: Vec<TurbineMode>,
    /// Upper limit of the frequencies in the list, Hz.
    pub limit_hz: f64,
    /// Whether eigenvalue counts prove that the list contains all modes below the limit and that
    /// the turbine is stable; see
    /// [`CoupledSpectrum::is_complete`](super::super::CoupledSpectrum::is_complete).
    pub is_complete: bool,
    /// Frequency intervals, Hz, in which the eigenvalue counts do not exclude two more modes, one
    /// of positive and one of negative energy; see
    /// [`CoupledSpectrum::unproven_hz`](super::super::CoupledSpectrum::unproven_hz).
    pub unproven_hz: Vec<[f64; 2]>,
    /// Number of unstable modes, whose amplitude grows without limit, as far as it is known; see
    /// [`CoupledSpectrum::growing`](super::super::CoupledSpectrum::growing).
    pub growing: usize,
    /// Number of motions without stiffness, such as yaw of a platform without moorings: they are
    /// slower than 1e-5 rad/s (1.6e-6 Hz) and not in the list. The rotation of a free shaft is not
    /// counted.
    pub unresisted: usize,
    /// How many modes of negative energy there are if none is unstable; they may lie above the
    /// limit.
    pub negative_energy_expected: usize,
    /// Number of modes of negative energy that were found.
    pub negative_energy_found: usize,
}

impl TurbineModes {
    /// Rotor speed, rad/s.
    pub(crate) fn speed(&self) -> f64 {
        rad_per_s(self.rotor_speed_rpm)
    }
}

impl TurbineMode {
    /// Tilt or yaw, if the mode is a whirl whose two waves together mostly tilt or mostly yaw the
    /// nacelle, as at standstill; otherwise none.
    pub fn nodding(&self) -> Option<Nodding> {
        self.energy.nodding_of(self.name.part)
    }

    /// The name, followed by the motion of the nacelle (tilt or yaw) if [`nodding`](Self::nodding)
    /// gives one: "1st flapwise backward whirl (yaw)".
    pub fn label(&self) -> String {
        self.name.with(self.nodding())
    }

    /// The modal assurance criterion |⟨a, b⟩|² of this mode and another of the same model, at the
    /// same or another speed, in the inner product of the elastic energy (of a floating platform:
    /// the kinetic one): 1 for the same shape, 0 for shapes that share no energy.
    ///
    /// Source: Allemang & Brown, *A correlation coefficient for modal vector analysis* (1982).
    pub fn mac(&self, other: &Self) -> f64 {
        if self.part != other.part || self.vector.len() != other.vector.len() {
            return 0.0;
        }
        let sizes = self.product(self).re * other.product(other).re;
        self.product(other).norm_squared() / sizes
    }

    /// The inner product of the elastic energy.
    fn product(&self, other: &Self) -> Complex {
        let strains = self.strains.iter().flat_map(|range| {
            let own = &self.vector[range.clone()];
            own.iter().zip(&other.vector[range.clone()])
        });
        let springs = self.springs.iter().zip(&other.springs);
        strains.chain(springs).map(|(a, b)| a.conj() * *b).sum()
    }
}
