//! Check of a list of modes with new eigenvalue counts.

use std::f64::consts::TAU;

use thiserror::Error;

use super::super::equations::model::{TurbineModel, UNRESISTED};
use super::super::results::mode::{TurbineMode, TurbineModes};

/// An interval in which eigenvalue counts and the list of modes differ.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error(
    "the eigenvalue count changes by {counted} between {from_hz:.6} and {to_hz:.6} Hz, but the list has {listed} there"
)]
pub struct MissedModes {
    /// Lower end of the interval, Hz.
    pub from_hz: f64,
    /// Upper end of the interval, Hz.
    pub to_hz: f64,
    /// By how much the count of negative eigenvalues rises: the number of modes, less twice those
    /// of negative energy.
    pub counted: isize,
    /// The rise of the count that follows from the modes in the list.
    pub listed: isize,
}

impl TurbineModel {
    /// Checks a list of modes of this model: counts at the bounds of each mode and at the limit.
    ///
    /// It finds every mode that is missing, listed twice, or outside its bounds. The only
    /// exception: a mode of negative energy and a mode of positive energy that are both missing in
    /// one gap.
    ///
    /// # Errors
    /// [`MissedModes`] with the first interval where list and counts differ.
    pub fn recount(&mut self, modes: &TurbineModes) -> Result<(), MissedModes> {
        let speed = modes.rotor_speed_rpm;
        let from_hz = UNRESISTED / TAU;
        let mut last = (from_hz, self.count(from_hz, speed));
        let same = |a: &TurbineMode, b: &TurbineMode| a.bounds_hz() == b.bounds_hz();
        for group in modes.modes.chunk_by(same) {
            let [low_hz, high_hz] = group[0].bounds_hz();
            let size = group.len() as isize;
            let listed = if group[0].frequency.has_negative_energy {
                -size
            } else {
                size
            };
            self.compare(&mut last, low_hz, 0, speed)?;
            self.compare(&mut last, high_hz, listed, speed)?;
        }
        self.compare(&mut last, modes.limit_hz, 0, speed)
    }

    fn compare(
        &mut self,
        last: &mut (f64, usize),
        to_hz: f64,
        listed: isize,
        speed: f64,
    ) -> Result<(), MissedModes> {
        let (from_hz, before) = *last;
        let count = self.count(to_hz, speed);
        *last = (to_hz, count);
        let counted = count as isize - before as isize;
        match counted == listed {
            true => Ok(()),
            false => Err(MissedModes {
                from_hz,
                to_hz,
                counted,
                listed,
            }),
        }
    }
}

impl TurbineMode {
    fn bounds_hz(&self) -> [f64; 2] {
        [self.frequency.lower_hz, self.frequency.upper_hz]
    }
}
