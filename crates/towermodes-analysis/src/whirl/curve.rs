//! The curve of a mode over the rotor speed.

use towermodes::turbine::{CoupledFrequency, TurbineEnergy, TurbineModeName};

use crate::resonance::LineEnd;

/// A mode of a turbine followed over the rotor speed.
#[derive(Debug, Clone, PartialEq)]
pub struct CoupledCurve {
    /// Its name: the part that names its modes over most of the operating speeds, and its order by
    /// mean frequency among the curves of that part.
    pub name: TurbineModeName,
    /// Its points by rising rotor speed. Modes that leave the frequencies of the diagram have no
    /// points there.
    pub points: Vec<CurvePoint>,
    /// Of a backward whirl the index of the curve of the forward whirl with the same motion and
    /// order, and the reverse; none if it has no such curve.
    pub partner: Option<usize>,
    /// The end of a curve that was lost: no mode at the next speed has a similar shape.
    pub lost: Option<LineEnd>,
}

/// A mode of a curve at a rotor speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePoint {
    /// Rotor speed, rpm.
    pub rotor_speed_rpm: f64,
    /// Its index in the list of modes at this speed, from 0.
    pub mode: usize,
    /// Its frequency, with the bounds that counts prove.
    pub frequency: CoupledFrequency,
    /// The estimated error of the mesh, Hz; known at the ends of the diagram and of the operating
    /// range.
    pub error_hz: Option<f64>,
    /// Its name at this speed, by elastic energy.
    pub name: TurbineModeName,
    /// Its name at this speed by kinetic energy.
    pub second_name: TurbineModeName,
    /// Fractions of its elastic energy.
    pub energy: TurbineEnergy,
}

impl CurvePoint {
    /// Rotor speed (rpm) and frequency (Hz).
    pub fn place(&self) -> [f64; 2] {
        [self.rotor_speed_rpm, self.frequency.frequency_hz]
    }
}

impl CoupledCurve {
    /// Rotor speeds (rpm) and frequencies (Hz).
    pub fn places(&self) -> Vec<[f64; 2]> {
        self.points.iter().map(CurvePoint::place).collect()
    }

    /// The point at a rotor speed at which the turbine was solved, rpm.
    pub fn at_rpm(&self, rpm: f64) -> Option<&CurvePoint> {
        self.points.iter().find(|point| {
            (point.rotor_speed_rpm - rpm).abs() <= 1e-9 * rpm.abs().max(f64::MIN_POSITIVE)
        })
    }

    /// The largest error of its frequencies that is known, Hz: that of the mesh and half the width
    /// of the bounds.
    pub fn error_hz(&self) -> f64 {
        let errors = self.points.iter().map(|point| {
            let frequency = &point.frequency;
            point.error_hz.unwrap_or_default() + 0.5 * (frequency.upper_hz - frequency.lower_hz)
        });
        errors.fold(0.0, f64::max)
    }

    /// Whether the mode has negative energy at some speed.
    pub fn has_negative_energy(&self) -> bool {
        let mut points = self.points.iter();
        points.any(|point| point.frequency.has_negative_energy)
    }
}
