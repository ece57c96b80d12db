//! Names and frequencies of modes, without their shapes.

use super::super::on_mesh::spectrum::ModeKey;
use super::solution::Certificate;
use crate::modes::{Family, ModeName, SecondFamily, Shares};

/// The name and the frequency of a natural mode of a tower, one of [`Frequencies::modes`]: its
/// values are equal, bit for bit, to those of the [`Mode`](crate::Mode) of a
/// [`Solution`](crate::Solution), unless they [start from a
/// base](crate::Solver::start_from).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ModeFrequency {
    /// The kind of motion that names the mode: the family whose energy, added up over the modes so
    /// far, exceeds the number of modes already named after it by the largest amount
    /// ([`Arrears`](crate::modes::Arrears)).
    pub family: Family,
    /// Order within the family, from 1.
    pub order: usize,
    /// The share of each kind of motion in its energy.
    pub shares: Shares,
    /// Natural frequency of the discretized tower, Hz; 0 for a rigid-body motion that nothing
    /// resists.
    pub frequency_hz: f64,
    /// Bound on the error of the eigenvalue computation, Hz.
    pub algebraic_error_hz: f64,
    /// Estimate of the discretization error, Hz: the difference from the exact frequency of the
    /// continuous beam.
    pub discretization_error_hz: f64,
    /// The frequency of the continuous beam, Hz, extrapolated from meshes with half or twice the
    /// number of segments.
    pub extrapolated_hz: f64,
}

impl ModeFrequency {
    /// The total error, Hz: discretization error plus error of the eigenvalue computation.
    pub fn error_hz(&self) -> f64 {
        self.discretization_error_hz + self.algebraic_error_hz
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

    /// Order and family in words: "1st fore-aft bending".
    pub fn label(&self) -> String {
        self.family.label(self.order)
    }
}

/// The lowest frequencies of a tower, with their errors and the proof that none is missing.
///
/// There are no warnings: effects that make a frequency uncertain are included in its error.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Frequencies {
    /// The modes by frequency; of a repeated pair the fore-aft one first.
    pub modes: Vec<ModeFrequency>,
    /// The proof that none is missing.
    pub certificate: Certificate,
    /// Whether the list ends within the error of the segments, so that another mesh may have
    /// another mode below its end; see [`Warning::UncertainEnd`](crate::Warning::UncertainEnd).
    pub has_uncertain_end: bool,
    /// Whether all modes were found from those of a similar tower; see
    /// [`Solver::start_from`](crate::Solver::start_from).
    pub is_near_base: bool,
    /// Number of segments or elements used.
    pub segments: usize,
}

impl Frequencies {
    /// The mode with this family and this order (from 1) within the family, if it is in the list.
    pub fn mode(&self, family: Family, order: usize) -> Option<&ModeFrequency> {
        let mut modes = self.modes.iter();
        modes.find(|mode| mode.family == family && mode.order == order)
    }
}

/// A mode and the estimate of its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Estimated {
    pub(crate) key: ModeKey,
    /// Its frequency on its own mesh, Hz.
    pub(crate) frequency_hz: f64,
    /// The estimated discretization error, Hz.
    pub(crate) error_hz: f64,
    /// The frequency of the beam, extrapolated, Hz.
    pub(crate) extrapolated_hz: f64,
}

impl Estimated {
    /// A mode whose error is not known yet.
    pub(crate) fn new(key: ModeKey, frequency_hz: f64) -> Self {
        Self {
            key,
            frequency_hz,
            error_hz: 0.0,
            extrapolated_hz: frequency_hz,
        }
    }
}
