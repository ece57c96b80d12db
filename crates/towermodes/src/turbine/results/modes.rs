//! The modes of a turbine below a limit: frequencies with their names, energies and shapes.

use std::f64::consts::TAU;

use super::super::checked::Turbine;
use super::super::counts::frequencies::{Part, Whole, check};
use super::super::counts::search::{Found, Guess};
use super::super::equations::model::TurbineModel;
use super::super::error::TurbineError;
use super::mode::{TurbineMode, TurbineModes};
use super::naming::{Named, Naming};

impl Turbine {
    /// The modes up to a limit (Hz) at a speed of the rotor (rpm) on the [usual mesh](Self::mesh),
    /// with names, shapes and the errors of the mesh.
    ///
    /// # Errors
    /// [`TurbineError`] if the limit is not positive, the limit or the speed is not finite, or the
    /// tower is unstable at rest.
    ///
    /// # Example
    /// See the [first page](crate).
    pub fn modes(&self, limit_hz: f64, rotor_speed_rpm: f64) -> Result<TurbineModes, TurbineError> {
        let mesh = self.mesh();
        let mut modes = TurbineModel::new(self, &mesh)?.modes(limit_hz, rotor_speed_rpm)?;
        TurbineModel::new(self, &mesh.finer())?.estimate_errors(&mut modes);
        Ok(modes)
    }
}

impl TurbineModel {
    /// The modes up to a limit (Hz) at a speed of the rotor (rpm), with names and shapes.
    ///
    /// # Errors
    /// [`TurbineError`] if the limit is not positive, or the limit or the speed is not finite.
    ///
    /// # Example
    /// See [`Turbine`](super::super::Turbine).
    pub fn modes(
        &mut self,
        limit_hz: f64,
        rotor_speed_rpm: f64,
    ) -> Result<TurbineModes, TurbineError> {
        self.modes_from(limit_hz, rotor_speed_rpm, &[])
    }

    /// As [`modes`](Self::modes), but faster with start vectors: `before` contains the modes at one
    /// or two previous speeds, those of the nearest speed last. The counts prove in the same way
    /// that no mode is missing.
    ///
    /// # Errors
    /// [`TurbineError`] if the limit is not positive, or the limit or the speed is not finite.
    pub fn modes_from(
        &mut self,
        limit_hz: f64,
        rotor_speed_rpm: f64,
        before: &[TurbineModes],
    ) -> Result<TurbineModes, TurbineError> {
        let speed = check(limit_hz, rotor_speed_rpm)?;
        let guesses = |part| guesses(part, speed, before);
        let whole = self.search(TAU * limit_hz, speed, guesses);
        Ok(self.named(whole, limit_hz, rotor_speed_rpm))
    }

    fn named(&mut self, whole: Whole, limit_hz: f64, rotor_speed_rpm: f64) -> TurbineModes {
        let (unproven_hz, growing) = (whole.unproven_hz(), whole.growing());
        let mut naming = Naming::default();
        let found = whole.found.into_iter();
        let modes = found.map(|(part, found)| self.mode(part, found, &mut naming));
        let modes = modes.collect();
        TurbineModes {
            rotor_speed_rpm,
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

    fn mode(&mut self, part: Part, found: Found, naming: &mut Naming) -> TurbineMode {
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

    /// Estimates the discretization errors of modes of this turbine on a coarser mesh: the
    /// difference between the frequency of a mode and the lower frequency with the same number on
    /// this mesh, and the error that [`Tower::soil_error`](crate::Tower::soil_error) gives. A mode
    /// without a counterpart has none.
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
        let mut finer = self.search(limit, modes.speed(), own_guesses).found;
        for mode in &mut modes.modes {
            let counterpart = finer.iter().position(|(part, _)| *part == mode.part);
            let finer_hz = counterpart.map(|place| finer.remove(place).1.w / TAU);
            let own_hz = mode.frequency.frequency_hz;
            mode.discretization_error_hz =
                finer_hz.map(|hz| (hz - own_hz).abs() + soil_error * own_hz);
        }
    }
}

/// The modes of a part at the last speed, with the frequencies expected at this speed.
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
                let steps = last.speed() - earlier.speed();
                let ratio = (speed - last.speed()) / steps;
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
