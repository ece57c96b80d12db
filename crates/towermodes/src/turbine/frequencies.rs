//! All natural frequencies below a limit, each between two counts.

use std::f64::consts::TAU;

use super::coupled::{Coupled, OnStillHub};
use super::error::TurbineError;
use super::gyroscopic::Gyroscopic;
use super::model::TurbineModel;
use super::search::{Found, Guess, Search};
use crate::beam::BladeFactors;
use crate::rotor::{Reactionless, reactionless};

/// The coarsest and the finest grid on which modes of negative energy are sought.
const GRIDS: std::ops::RangeInclusive<u32> = 6..=9;

/// A natural frequency of a turbine at a speed, or several that cannot be told apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoupledFrequency {
    /// The frequency, Hz.
    pub frequency_hz: f64,
    /// The lower bound, Hz: between it and the upper bound the count of negative eigenvalues
    /// changes.
    pub lower_hz: f64,
    /// The upper bound, Hz.
    pub upper_hz: f64,
    /// How many modes have this frequency.
    pub multiplicity: usize,
    /// Whether the energy of the mode in the fixed frame is negative: at the speed of the rotor, a
    /// backward whirl whose own frequency is lower than the speed. Damping makes it grow.
    pub has_negative_energy: bool,
}

/// The natural frequencies of a turbine below a limit, at a speed.
#[derive(Debug, Clone, PartialEq)]
pub struct CoupledSpectrum {
    /// The frequencies, rising. Motions that nothing resists, as the rotation of a free shaft, are
    /// not among them.
    pub frequencies: Vec<CoupledFrequency>,
    /// The limit, Hz.
    pub limit_hz: f64,
    /// Whether the counts prove that these are all, and that the turbine is stable.
    ///
    /// Where the stiffness has no negative eigenvalue this is always so. Where it has n, there are
    /// n/2 modes of negative energy, less those that are unstable: if n/2 are found, the list is
    /// complete and no mode is unstable.
    pub is_complete: bool,
    /// How many modes of negative energy there are if none is unstable; they may lie above the
    /// limit.
    pub negative_energy_expected: usize,
    /// How many were found.
    pub negative_energy_found: usize,
}

/// The part of the equations that a mode belongs to: all that moves the tower, or a harmonic of the
/// blades that does not move the hub.
pub(super) type Part = Option<Reactionless>;

/// The modes of all parts, rising, and how many of negative energy are expected and found.
pub(super) struct Whole {
    pub(super) found: Vec<(Part, Found)>,
    pub(super) negative_energy_expected: usize,
    pub(super) negative_energy_found: usize,
    pub(super) is_complete: bool,
}

impl TurbineModel {
    /// The natural frequencies up to a limit (Hz) at a speed of the rotor (rad/s).
    ///
    /// # Errors
    /// [`TurbineError`] if limit or speed is no number.
    pub fn frequencies(
        &mut self,
        limit_hz: f64,
        speed_rad_per_s: f64,
    ) -> Result<CoupledSpectrum, TurbineError> {
        check(limit_hz, speed_rad_per_s)?;
        let whole = self.search(TAU * limit_hz, speed_rad_per_s, |_| Vec::new());
        let mut frequencies: Vec<_> = whole.found.iter().map(|(_, found)| found.as_hz()).collect();
        // Those that share a frequency are one entry.
        frequencies.dedup_by(|a, b| {
            a.multiplicity > 1 && (a.lower_hz, a.upper_hz) == (b.lower_hz, b.upper_hz)
        });
        Ok(CoupledSpectrum {
            frequencies,
            limit_hz,
            is_complete: whole.is_complete,
            negative_energy_expected: whole.negative_energy_expected,
            negative_energy_found: whole.negative_energy_found,
        })
    }

    /// All modes up to a limit (rad/s) at a speed (rad/s), with guesses for each part in turn.
    pub(super) fn search<'g>(
        &mut self,
        limit: f64,
        speed: f64,
        guesses: impl Fn(Part) -> Vec<Guess<'g>>,
    ) -> Whole {
        let negative = self.negative_stiffness(speed);
        let parts: Vec<Part> = self.parts();
        let expected = negative / 2;
        let mut all = Vec::new();
        let mut found_negative = 0;
        if negative == 0 {
            for part in parts {
                let guesses = guesses(part);
                all.extend(self.in_part(part, speed, |mut search| search.rising(limit, &guesses)));
            }
        } else {
            // Modes of negative energy are backward whirls, slower than the rotor.
            let end = limit.max(speed.abs() * self.most_waves() as f64);
            for grid in GRIDS {
                all.clear();
                for part in &parts {
                    all.extend(
                        self.in_part(*part, speed, |mut search| search.on_grid(end, 1 << grid)),
                    );
                }
                found_negative = all.iter().filter(|(_, found)| found.falls()).count();
                if found_negative >= expected {
                    break;
                }
            }
        }
        all.retain(|(_, found)| found.bounds[1].w <= limit);
        all.sort_by(|(_, a), (_, b)| a.w.total_cmp(&b.w));
        Whole {
            found: all,
            negative_energy_expected: expected,
            negative_energy_found: found_negative,
            is_complete: found_negative == expected && negative.is_multiple_of(2),
        }
    }

    /// Searches in a part.
    fn in_part(
        &mut self,
        part: Part,
        speed: f64,
        search: impl FnOnce(Search<'_, dyn Gyroscopic + '_>) -> Vec<Found>,
    ) -> Vec<(Part, Found)> {
        let found = match part {
            None => {
                let mut system = Coupled { model: self, speed };
                search(Search::new(&mut system))
            }
            Some(wave) => {
                let mut system = self.on_still_hub(wave, speed);
                search(Search::new(&mut system))
            }
        };
        found.into_iter().map(|found| (part, found)).collect()
    }

    pub(super) fn on_still_hub(&self, wave: Reactionless, speed: f64) -> OnStillHub<'_> {
        OnStillHub {
            blade: self.machine.rotor.body(),
            wave,
            speed,
            factors: BladeFactors::default(),
        }
    }

    fn parts(&self) -> Vec<Part> {
        let waves = reactionless(self.machine.rotor.blades());
        std::iter::once(None).chain(waves.map(Some)).collect()
    }

    /// The most periods of a wave around the rotor.
    fn most_waves(&self) -> usize {
        (self.machine.rotor.blades() / 2).max(1)
    }
}

impl Found {
    /// Whether the count falls: the energy is negative.
    fn falls(&self) -> bool {
        self.bounds[1].negative < self.bounds[0].negative
    }

    pub(super) fn as_hz(&self) -> CoupledFrequency {
        let [low, high] = self.bounds;
        CoupledFrequency {
            frequency_hz: self.w / TAU,
            lower_hz: low.w / TAU,
            upper_hz: high.w / TAU,
            multiplicity: high.negative.abs_diff(low.negative),
            has_negative_energy: self.falls(),
        }
    }
}

pub(super) fn check(limit_hz: f64, speed_rad_per_s: f64) -> Result<(), TurbineError> {
    if !(limit_hz.is_finite() && limit_hz > 0.0) {
        return Err(TurbineError::Limit { limit_hz });
    }
    if !speed_rad_per_s.is_finite() {
        return Err(TurbineError::Speed { speed_rad_per_s });
    }
    Ok(())
}
