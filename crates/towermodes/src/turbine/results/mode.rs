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
    /// An estimate of the error of the mesh, Hz: the change of the frequency to a finer one, and
    /// the error of soil springs that are straight between depths; none before
    /// [`TurbineModel::estimate_errors`](super::super::TurbineModel::estimate_errors).
    pub discretization_error_hz: Option<f64>,
    /// Its name. Each name is that of one mode at a speed; see [`TurbineModes::modes`].
    pub name: TurbineModeName,
    /// The fraction of its elastic energy in the part that names it.
    pub share: f64,
    /// The part with the most energy besides, with its fraction; none if there is no energy
    /// elsewhere.
    pub second: Option<(TurbinePart, f64)>,
    /// Fractions of the elastic energy; they sum to 1.
    pub energy: TurbineEnergy,
    /// Its shape; the largest deflection is 1.
    pub shape: TurbineShape,
    /// What it is a mode of: all that moves the tower, or a harmonic of the blades.
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
    /// The speed, rpm.
    pub rotor_speed_rpm: f64,
    /// The modes by frequency. The rotation of a free shaft, at 0, is not among them.
    ///
    /// Going up in frequency, each mode gets the part that is most in arrears: the one whose energy
    /// in the modes so far exceeds the number of its names by most, as
    /// [`Arrears`](crate::modes::Arrears) chooses among the parts that have at least a quarter of
    /// the energy of the largest. From a mode to the next the arrears fade with the eighth power of
    /// the ratio of their frequencies. Backward and forward whirl of a motion are one part first,
    /// and the same rule chooses between them. So a name depends on this speed alone.
    pub modes: Vec<TurbineMode>,
    /// The limit, Hz.
    pub limit_hz: f64,
    /// Whether eigenvalue counts prove that the list contains all modes below the limit and that
    /// the turbine is stable; see
    /// [`CoupledSpectrum::is_complete`](super::super::CoupledSpectrum::is_complete).
    pub is_complete: bool,
    /// Intervals, Hz, in which counts do not exclude two more modes, one of positive and one of
    /// negative energy; see
    /// [`CoupledSpectrum::unproven_hz`](super::super::CoupledSpectrum::unproven_hz).
    pub unproven_hz: Vec<[f64; 2]>,
    /// How many modes grow without limit, as far as it is known; see
    /// [`CoupledSpectrum::growing`](super::super::CoupledSpectrum::growing).
    pub growing: usize,
    /// How many motions are slower than 1e-5 rad/s (1.6e-6 Hz) and not among the modes, beside the
    /// rotation of a free shaft: those that nothing resists.
    pub unresisted: usize,
    /// How many modes of negative energy there are if none is unstable; they may lie above the
    /// limit.
    pub negative_energy_expected: usize,
    /// How many were found.
    pub negative_energy_found: usize,
}

impl TurbineModes {
    /// The speed, rad/s.
    pub(crate) fn speed(&self) -> f64 {
        rad_per_s(self.rotor_speed_rpm)
    }
}

impl TurbineMode {
    /// What the mode does to the nacelle if it is a whirl of which both waves are alike, as at
    /// standstill.
    pub fn nodding(&self) -> Option<Nodding> {
        self.energy.nodding_of(self.name.part)
    }

    /// Its name, with what it does to the nacelle if both waves are alike: "1st flapwise backward
    /// whirl (yaw)".
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
