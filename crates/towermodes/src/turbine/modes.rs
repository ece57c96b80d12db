//! The modes of a turbine below a limit: frequencies with their names, energies and shapes.

use std::f64::consts::TAU;

use super::error::TurbineError;
use super::frequencies::{Part, Whole, check};
use super::mode::{TurbineMode, TurbineModes};
use super::model::TurbineModel;
use super::naming::{Named, Naming};
use super::search::{Found, Guess};

impl TurbineModel {
    /// The modes up to a limit (Hz) at a speed of the rotor (rad/s), with names and shapes.
    ///
    /// # Errors
    /// [`TurbineError`] if limit or speed is no number.
    ///
    /// # Example
    /// See [`Turbine`](super::Turbine).
    pub fn modes(
        &mut self,
        limit_hz: f64,
        speed_rad_per_s: f64,
    ) -> Result<TurbineModes, TurbineError> {
        self.modes_from(limit_hz, speed_rad_per_s, &[])
    }

    /// The same, sooner where the modes at one or two speeds before are known, the nearest last.
    /// Counts prove that none is missing, as without them.
    ///
    /// # Errors
    /// [`TurbineError`] if limit or speed is no number.
    pub fn modes_from(
        &mut self,
        limit_hz: f64,
        speed_rad_per_s: f64,
        before: &[TurbineModes],
    ) -> Result<TurbineModes, TurbineError> {
        check(limit_hz, speed_rad_per_s)?;
        let guesses = |part| guesses(part, speed_rad_per_s, before);
        let whole = self.search(TAU * limit_hz, speed_rad_per_s, guesses);
        Ok(self.named(whole, limit_hz, speed_rad_per_s))
    }

    fn named(&self, whole: Whole, limit_hz: f64, speed_rad_per_s: f64) -> TurbineModes {
        let (unproven_hz, growing) = (whole.unproven_hz(), whole.growing());
        let mut naming = Naming::default();
        let found = whole.found.into_iter();
        let modes = found.map(|(part, found)| self.mode(part, found, &mut naming));
        let modes = modes.collect();
        TurbineModes {
            speed_rad_per_s,
            modes,
            limit_hz,
            is_complete: whole.is_complete,
            unproven_hz,
            growing,
            unresisted: whole.unresisted,
            negative_energy_expected: whole.negative_energy_expected,
            negative_energy_found: whole.negative_energy_found,
        }
    }

    fn mode(&self, part: Part, found: Found, naming: &mut Naming) -> TurbineMode {
        let energy = self.elastic_energy(part, &found.vector).as_fractions();
        let Named {
            name,
            share,
            second,
        } = naming.next(part, found.as_hz().frequency_hz, &energy);
        let (shape, strains, springs) = self.shape(part, found.w, &found.vector);
        TurbineMode {
            frequency: found.as_hz(),
            discretization_error_hz: None,
            name,
            share,
            second,
            energy,
            shape,
            part,
            vector: found.vector,
            strains,
            springs,
        }
    }

    /// Estimates the discretization errors of modes of this turbine on a coarser mesh: how much
    /// lower the frequencies on this mesh are, each compared with that of the same number, and what
    /// [`Tower::soil_error`](crate::Tower::soil_error) adds to them. A mode without a counterpart
    /// has none.
    pub fn estimate_errors(&mut self, modes: &mut TurbineModes) {
        let own_guesses = |part| {
            let own = modes.modes.iter().filter(|mode| mode.part == part);
            own.map(|mode| Guess {
                w: TAU * mode.frequency.frequency_hz,
                vector: &[],
            })
            .collect()
        };
        let limit = TAU * modes.limit_hz;
        let soil_error = self.soil_error;
        let mut finer = self.search(limit, modes.speed_rad_per_s, own_guesses).found;
        for mode in &mut modes.modes {
            let counterpart = finer.iter().position(|(part, _)| *part == mode.part);
            let finer_hz = counterpart.map(|place| finer.remove(place).1.w / TAU);
            let own_hz = mode.frequency.frequency_hz;
            mode.discretization_error_hz =
                finer_hz.map(|hz| (hz - own_hz).abs() + soil_error * own_hz);
        }
    }
}

/// The modes of a part at the last speed, where they would be at this one.
fn guesses(part: Part, speed: f64, before: &[TurbineModes]) -> Vec<Guess<'_>> {
    let Some(last) = before.last() else {
        return Vec::new();
    };
    let own = |modes: &'_ TurbineModes| -> Vec<usize> {
        let all = modes.modes.iter().enumerate();
        all.filter(|(_, mode)| mode.part == part)
            .map(|(index, _)| index)
            .collect()
    };
    let earlier = before.len().checked_sub(2).map(|index| &before[index]);
    let places = own(last);
    let places_before = earlier.map(own).unwrap_or_default();
    let guess = |(order, place): (usize, &usize)| {
        let mode = &last.modes[*place];
        let hz = mode.frequency.frequency_hz;
        let before = earlier
            .zip(places_before.get(order))
            .map(|(earlier, place)| {
                let steps = last.speed_rad_per_s - earlier.speed_rad_per_s;
                let ratio = (speed - last.speed_rad_per_s) / steps;
                let change = hz - earlier.modes[*place].frequency.frequency_hz;
                if ratio.is_finite() {
                    ratio * change
                } else {
                    0.0
                }
            });
        Guess {
            w: TAU * (hz + before.unwrap_or_default()),
            vector: &mode.vector,
        }
    };
    places.iter().enumerate().map(guess).collect()
}
