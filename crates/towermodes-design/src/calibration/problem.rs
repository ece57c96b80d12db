//! The problem: measurements, unknowns, priors.

use std::collections::HashSet;

use towermodes::{Change, ModeName, TowerDescription};

use super::error::{CalibrationError, is_in_proportion};

/// A tower, its measured frequencies, and the input values to be fitted.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
    /// The tower; its input values are the start of the iteration.
    pub base: TowerDescription,
    /// The unknowns. No input value may belong to two of them.
    pub unknowns: Vec<Unknown>,
    /// The measurements.
    pub measured: Vec<Measured>,
}

/// An unknown of the fit: one input value, or several changed by one value.
#[derive(Debug, Clone, PartialEq)]
pub struct Unknown {
    /// Which input values this unknown changes.
    pub change: Change,
    /// The prior: knowledge of the value without the measurements.
    pub prior: Option<Prior>,
    /// The lowest and the highest value.
    pub bounds: Option<[f64; 2]>,
}

/// A value that is known with a standard deviation. A positive input value has a lognormal
/// distribution with this mean and standard deviation, any other a normal distribution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prior {
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
}

/// A measured natural frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// The frequency, Hz.
    pub frequency_hz: f64,
    /// Its standard deviation, Hz.
    pub deviation_hz: f64,
    /// The mode, if it is known; otherwise it is found by frequency and shape.
    pub mode: Option<ModeName>,
    /// The measured mode shape, used to identify the mode.
    pub shape: Option<MeasuredShape>,
}

/// A measured mode shape, in any scale.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MeasuredShape {
    /// The heights of the sensors, m in the datum of the tower.
    pub heights_m: Vec<f64>,
    /// The displacement at each height, fore-aft and side-side.
    pub displacements: Vec<[f64; 2]>,
}

impl Unknown {
    /// An unknown without prior and bounds.
    pub fn new(change: Change) -> Self {
        Self {
            change,
            prior: None,
            bounds: None,
        }
    }
}

impl Measured {
    /// The measured frequency of a known mode, Hz, and its standard deviation, Hz.
    pub fn of(mode: ModeName, frequency_hz: f64, deviation_hz: f64) -> Self {
        Self {
            frequency_hz,
            deviation_hz,
            mode: Some(mode),
            shape: None,
        }
    }
}

impl Problem {
    /// Checks the values of the problem.
    ///
    /// # Errors
    /// [`CalibrationError`] with the first contradiction.
    pub fn check(&self) -> Result<(), CalibrationError> {
        if self.unknowns.is_empty() {
            return Err(CalibrationError::NoUnknowns);
        }
        for (index, measured) in self.measured.iter().enumerate() {
            measured.check(index)?;
            let mut before = self.measured[..index].iter();
            let is_again = |other: &Measured| other.mode == measured.mode;
            if let (Some(mode), Some(first)) = (measured.mode, before.position(is_again)) {
                return Err(CalibrationError::Repeated { first, index, mode });
            }
        }
        for unknown in &self.unknowns {
            unknown.check()?;
        }
        let priors = self.unknowns.iter().filter(|one| one.prior.is_some());
        let (priors, measured) = (priors.count(), self.measured.len());
        if measured == 0 || measured + priors < self.unknowns.len() {
            let mut without = self.unknowns.iter().filter(|one| one.prior.is_none());
            let beyond = without.nth(measured).unwrap_or(&self.unknowns[0]);
            return Err(CalibrationError::TooFewMeasurements {
                beyond: beyond.change.name().to_owned(),
                measured,
                priors,
                unknowns: self.unknowns.len(),
            });
        }
        self.check_overlap()
    }

    fn check_overlap(&self) -> Result<(), CalibrationError> {
        let mut seen = HashSet::new();
        for unknown in &self.unknowns {
            for parameter in unknown.change.parameters() {
                if !seen.insert(*parameter) {
                    return Err(CalibrationError::Overlap {
                        change: unknown.change.name().to_owned(),
                        parameter: parameter.to_string(),
                    });
                }
            }
        }
        Ok(())
    }
}

impl Measured {
    fn check(&self, index: usize) -> Result<(), CalibrationError> {
        let positive = [
            ("frequency", self.frequency_hz),
            ("standard deviation", self.deviation_hz),
        ];
        for (what, value) in positive {
            if !(value > 0.0 && value.is_finite()) {
                return Err(CalibrationError::NotPositive { index, what, value });
            }
        }
        let (deviation_hz, frequency_hz) = (self.deviation_hz, self.frequency_hz);
        if !is_in_proportion(deviation_hz, frequency_hz) {
            return Err(CalibrationError::DeviationRange {
                index,
                deviation_hz,
                frequency_hz,
            });
        }
        let Some(shape) = &self.shape else {
            return Ok(());
        };
        let (heights, displacements) = (shape.heights_m.len(), shape.displacements.len());
        let all = shape.displacements.iter().flatten();
        let size = all.clone().fold(0.0_f64, |most, x| most.max(x.abs()));
        let are_finite = all.chain(&shape.heights_m).all(|x| x.is_finite());
        match heights == displacements && heights > 0 && size > 0.0 && are_finite {
            true => Ok(()),
            false => Err(CalibrationError::Shape { index }),
        }
    }
}

impl Unknown {
    fn check(&self) -> Result<(), CalibrationError> {
        let name = || self.change.name().to_owned();
        if let Some([low, high]) = self.bounds
            && !(low < high && low.is_finite() && high.is_finite())
        {
            return Err(CalibrationError::Bounds {
                change: name(),
                low,
                high,
            });
        }
        let Some(Prior { mean, deviation }) = self.prior else {
            return Ok(());
        };
        if !(deviation > 0.0 && deviation.is_finite() && mean.is_finite()) {
            return Err(CalibrationError::Prior {
                change: name(),
                mean,
                deviation,
            });
        }
        if mean != 0.0 && !is_in_proportion(deviation, mean) {
            return Err(CalibrationError::PriorRange {
                change: name(),
                mean,
                deviation,
            });
        }
        match self.bounds {
            Some([low, high]) if mean < low || mean > high => Err(CalibrationError::PriorOutside {
                change: name(),
                mean,
                low,
                high,
            }),
            _ => Ok(()),
        }
    }
}
