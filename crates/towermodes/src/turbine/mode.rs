//! The modes of a turbine at a speed of its rotor.

use super::energy::TurbineEnergy;
use super::frequencies::CoupledFrequency;
use super::name::TurbineModeName;
use super::shape::TurbineShape;
use crate::scalar::Complex;

/// A mode of a turbine at a speed of its rotor.
#[derive(Debug, Clone, PartialEq)]
pub struct TurbineMode {
    /// Its frequency, with the bounds that counts prove.
    pub frequency: CoupledFrequency,
    /// An estimate of the error of the mesh, Hz: the change of the frequency to a finer one.
    pub discretization_error_hz: f64,
    /// Its name: where most of its elastic energy is.
    pub name: TurbineModeName,
    /// The name by kinetic energy, a second vote; it differs where modes veer or two motions are
    /// coupled.
    pub second_name: TurbineModeName,
    /// Fractions of the elastic energy; they sum to 1.
    pub energy: TurbineEnergy,
    /// Its shape; the largest deflection is 1.
    pub shape: TurbineShape,
    /// Coordinates whose squares are elastic energies; the sum of their squares is 1.
    pub(super) strains: Vec<Complex>,
}

/// The modes of a turbine below a limit, at a speed of its rotor.
#[derive(Debug, Clone, PartialEq)]
pub struct TurbineModes {
    /// The speed, rad/s.
    pub speed_rad_per_s: f64,
    /// The modes by frequency. The rotation of a free shaft, at 0, is not among them.
    pub modes: Vec<TurbineMode>,
    /// The limit, Hz.
    pub limit_hz: f64,
    /// Whether counts prove that these are all below the limit, and that the turbine is stable; see
    /// [`CoupledSpectrum::is_complete`](super::CoupledSpectrum::is_complete).
    pub is_complete: bool,
    /// How many modes of negative energy there are if none is unstable; they may lie above the
    /// limit.
    pub negative_energy_expected: usize,
    /// How many were found.
    pub negative_energy_found: usize,
}

impl TurbineMode {
    /// The modal assurance criterion |⟨a, b⟩|² of this mode and another of the same model, at the
    /// same or another speed, in the inner product of the elastic energy: 1 for the same shape, 0
    /// for shapes that share no energy.
    ///
    /// Source: Allemang & Brown, *A correlation coefficient for modal vector analysis* (1982).
    pub fn mac(&self, other: &Self) -> f64 {
        let pairs = self.strains.iter().zip(&other.strains);
        let product: Complex = pairs.map(|(a, b)| Complex::new(a.re, -a.im) * *b).sum();
        product.re * product.re + product.im * product.im
    }
}
