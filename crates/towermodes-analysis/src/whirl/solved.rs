//! The modes at a rotor speed, with the data that are needed to follow them.

use towermodes::turbine::TurbineModes;

use super::curve::CurvePoint;

/// The modes of a turbine at a rotor speed.
#[derive(Debug, Clone, PartialEq)]
pub struct SolvedSpeed<S = TurbineModes> {
    /// The speed, rpm.
    pub rotor_speed_rpm: f64,
    /// Whether it was added to follow curves that come close to each other.
    pub is_added: bool,
    /// The modes, with their certificate and their shapes.
    pub modes: S,
}

/// The data of the modes at a speed that are needed to follow them.
pub(super) trait Solved {
    /// Number of modes.
    fn count(&self) -> usize;

    /// Whether no mode is missing.
    fn is_complete(&self) -> bool;

    /// A mode as a point of a curve.
    fn point(&self, mode: usize) -> CurvePoint;

    /// The modal assurance criterion of a mode with a mode at another speed.
    fn mac(&self, mode: usize, other: &Self, other_mode: usize) -> f64;

    /// The frequency of a mode, Hz.
    fn frequency_hz(&self, mode: usize) -> f64 {
        self.point(mode).frequency.frequency_hz
    }
}

impl Solved for TurbineModes {
    fn count(&self) -> usize {
        self.modes.len()
    }

    fn is_complete(&self) -> bool {
        self.is_complete
    }

    fn point(&self, mode: usize) -> CurvePoint {
        let own = &self.modes[mode];
        CurvePoint {
            rotor_speed_rpm: self.rotor_speed_rpm,
            mode,
            frequency: own.frequency,
            error_hz: own.discretization_error_hz,
            name: own.name,
            share: own.share,
            second: own.second,
            energy: own.energy,
        }
    }

    fn mac(&self, mode: usize, other: &Self, other_mode: usize) -> f64 {
        self.modes[mode].mac(&other.modes[other_mode])
    }

    fn frequency_hz(&self, mode: usize) -> f64 {
        self.modes[mode].frequency.frequency_hz
    }
}
