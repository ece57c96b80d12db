//! All natural frequencies below a limit, each between two counts.

use std::f64::consts::TAU;

use super::super::description::rad_per_s;
use super::super::equations::coupled::{Coupled, OnStillHub};
use super::super::equations::gyroscopic::Gyroscopic;
use super::super::equations::model::TurbineModel;
use super::super::error::TurbineError;
use super::search::{Found, Guess, Search};
use crate::beam::BladeFactors;
use crate::rotor::{Reactionless, reactionless};

/// A natural frequency of a turbine at a speed, or several frequencies that the computation cannot
/// separate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoupledFrequency {
    /// The frequency, Hz.
    pub frequency_hz: f64,
    /// The lower bound, Hz: between it and the upper bound the count of negative eigenvalues
    /// changes.
    pub lower_hz: f64,
    /// The upper bound, Hz.
    pub upper_hz: f64,
    /// Number of modes with this frequency.
    pub multiplicity: usize,
    /// Whether the energy of the mode in the fixed frame is negative: a backward whirl that is
    /// slower in the rotating frame than the rotor turns, so that it runs forward in the fixed
    /// frame. Damping in the fixed frame makes it grow.
    pub has_negative_energy: bool,
}

/// The natural frequencies of a turbine below a limit, at a speed.
#[derive(Debug, Clone, PartialEq)]
pub struct CoupledSpectrum {
    /// The frequencies, rising. Motions without stiffness, such as the rotation of a free shaft,
    /// are not included.
    pub frequencies: Vec<CoupledFrequency>,
    /// Upper limit of the frequencies in the list, Hz.
    pub limit_hz: f64,
    /// Whether eigenvalue counts prove that the list is complete and that the turbine is stable.
    ///
    /// Where the stiffness has no negative eigenvalue this is always so. Where it has n, there are
    /// n/2 modes of negative energy, less those that are unstable: if n/2 are found, the list is
    /// complete and no mode is unstable.
    pub is_complete: bool,
    /// Intervals, Hz, in which counts do not exclude two more modes, one of positive and one of
    /// negative energy; they may lie above the limit. There are none if the list is complete.
    pub unproven_hz: Vec<[f64; 2]>,
    /// Least number of unstable modes, whose amplitude grows without limit: the number of missing
    /// modes of negative energy, if no interval is unproven; 0 if there is no unstable mode, or if
    /// this is not known. (Two modes of opposite energies beside a third within some 1/1000 of the
    /// range that is searched are not excluded.)
    pub growing: usize,
    /// Number of motions without stiffness, such as yaw of a platform without moorings: they are
    /// slower than 1e-5 rad/s (1.6e-6 Hz) and not in the list. The rotation of a free shaft is not
    /// counted.
    pub unresisted: usize,
    /// How many modes of negative energy there are if none is unstable; they may lie above the
    /// limit.
    pub negative_energy_expected: usize,
    /// Number of modes of negative energy that were found.
    pub negative_energy_found: usize,
}

/// The part of the equations to which a mode belongs: the part that moves the tower, or a harmonic
/// of the blades that does not move the hub.
pub(crate) type Part = Option<Reactionless>;

/// The modes of all parts, in increasing frequency, and what is proved about them.
#[derive(Debug, Default)]
pub(crate) struct Whole {
    pub(crate) found: Vec<(Part, Found)>,
    pub(crate) negative_energy_expected: usize,
    pub(crate) negative_energy_found: usize,
    pub(crate) is_complete: bool,
    /// Number of unstable modes if no mode is missing.
    growing: usize,
    /// Intervals in which two more modes are not excluded, rad/s.
    pub(super) unproven: Vec<[f64; 2]>,
    pub(crate) unresisted: usize,
}

impl TurbineModel {
    /// The natural frequencies up to a limit (Hz) at a speed of the rotor (rpm).
    ///
    /// # Errors
    /// [`TurbineError`] if the limit is not positive, or the limit or the speed is not finite.
    pub fn frequencies(
        &mut self,
        limit_hz: f64,
        rotor_speed_rpm: f64,
    ) -> Result<CoupledSpectrum, TurbineError> {
        let speed = check(limit_hz, rotor_speed_rpm)?;
        let whole = self.search(TAU * limit_hz, speed, |_| Vec::new());
        let mut frequencies: Vec<_> = whole.found.iter().map(|(_, found)| found.as_hz()).collect();
        // Modes with the same frequency are one entry.
        frequencies.dedup_by(|a, b| {
            a.multiplicity > 1 && (a.lower_hz, a.upper_hz) == (b.lower_hz, b.upper_hz)
        });
        Ok(CoupledSpectrum {
            frequencies,
            limit_hz,
            is_complete: whole.is_complete,
            unproven_hz: whole.unproven_hz(),
            growing: whole.growing(),
            unresisted: whole.unresisted,
            negative_energy_expected: whole.negative_energy_expected,
            negative_energy_found: whole.negative_energy_found,
        })
    }

    /// All modes up to a limit (rad/s) at a speed (rad/s), with guesses for each part in turn.
    pub(crate) fn search<'g>(
        &mut self,
        limit: f64,
        speed: f64,
        guesses: impl Fn(Part) -> Vec<Guess<'g>>,
    ) -> Whole {
        let mut whole = match self.negative_stiffness_at(speed) {
            0 => self.search_rising(limit, speed, guesses),
            _ => self.search_falling(limit, speed),
        };
        whole.found.retain(|(_, found)| found.bounds[1].w <= limit);
        let frequency = |(_, found): &(Part, Found)| found.w;
        whole
            .found
            .sort_by(|a, b| frequency(a).total_cmp(&frequency(b)));
        whole
    }

    /// All modes if the stiffness has no negative eigenvalue.
    fn search_rising<'g>(
        &mut self,
        limit: f64,
        speed: f64,
        guesses: impl Fn(Part) -> Vec<Guess<'g>>,
    ) -> Whole {
        let mut whole = Whole {
            is_complete: true,
            ..Whole::default()
        };
        for part in self.parts() {
            let guesses = guesses(part);
            let rising =
                |mut search: Search<'_, dyn Gyroscopic + '_>| search.rising(limit, &guesses);
            let (base, found) = self.in_part(part, speed, rising);
            whole.unresisted += base;
            whole
                .found
                .extend(found.into_iter().map(|found| (part, found)));
        }
        whole.unresisted -= self.free_rotations().min(whole.unresisted);
        whole.unproven = self.doubtful_in_water(limit, speed);
        whole.is_complete = whole.unproven.is_empty();
        whole
    }

    /// All modes if the stiffness has negative eigenvalues.
    fn search_falling(&mut self, limit: f64, speed: f64) -> Whole {
        let mut whole = Whole {
            is_complete: true,
            unresisted: self.unresisted,
            ..Whole::default()
        };
        // Whirl modes of blades with positive energy have a higher frequency than the rotor speed.
        let about = speed.abs() * self.most_waves() as f64;
        let still = self.unresisted + self.free_rotations();
        for part in self.parts() {
            let (twice, sought) = self.in_part(part, speed, |mut search| {
                let twice = twice_expected(part, search.base(limit), still);
                (twice, search.falling(limit, about, twice.div_ceil(2)))
            });
            let falling = sought.found.iter().filter(|found| found.falls()).count();
            whole.negative_energy_expected += twice / 2;
            whole.negative_energy_found += falling;
            whole.is_complete &= twice == 2 * falling;
            whole.growing += twice.saturating_sub(2 * falling).div_ceil(2);
            whole.unproven.extend(sought.unproven);
            let found = sought.found.into_iter();
            whole.found.extend(found.map(|found| (part, found)));
        }
        // The proof requires an inertia that does not depend on the frequency.
        whole.is_complete &= self.below.water().is_none();
        whole
    }

    /// The rotation of a free shaft: 1, or 0 if the generator is locked.
    fn free_rotations(&self) -> usize {
        usize::from(!self.is_locked)
    }

    /// Searches in a part.
    fn in_part<T>(
        &mut self,
        part: Part,
        speed: f64,
        search: impl FnOnce(Search<'_, dyn Gyroscopic + '_>) -> T,
    ) -> T {
        match part {
            None => {
                let mut system = Coupled { model: self, speed };
                search(Search::new(&mut system))
            }
            Some(wave) => {
                let mut system = self.on_still_hub(wave, speed);
                search(Search::new(&mut system))
            }
        }
    }

    pub(crate) fn on_still_hub(&self, wave: Reactionless, speed: f64) -> OnStillHub<'_> {
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

    /// Largest number of periods of a wave around the rotor.
    fn most_waves(&self) -> usize {
        (self.machine.rotor.blades() / 2).max(1)
    }
}

/// Twice the number of modes of a part that have negative energy if none is unstable, by its count
/// at the lower end and the number of motions that nothing resists; odd if one diverges.
///
/// A wave that runs with the rotation counts at zero the modes that it has of negative energy, and
/// the same wave against the rotation counts as many and has none.
fn twice_expected(part: Part, base: usize, still: usize) -> usize {
    match part {
        None => base.saturating_sub(still),
        Some(Reactionless::Forward(_)) => 2 * base,
        Some(Reactionless::Backward(_)) => 0,
        Some(Reactionless::Alternating(_)) => base,
    }
}

impl Whole {
    pub(crate) fn unproven_hz(&self) -> Vec<[f64; 2]> {
        let intervals = self.unproven.iter();
        intervals.map(|ends| ends.map(|w| w / TAU)).collect()
    }

    /// Number of unstable modes, whose amplitude grows without limit, as far as it is known.
    pub(crate) fn growing(&self) -> usize {
        match self.unproven.is_empty() {
            true => self.growing,
            false => 0,
        }
    }
}

impl Found {
    /// Whether the count decreases at this frequency, which means that the mode has negative
    /// energy.
    fn falls(&self) -> bool {
        self.bounds[1].negative < self.bounds[0].negative
    }

    pub(crate) fn as_hz(&self) -> CoupledFrequency {
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

/// The rotor speed, rad/s.
///
/// # Errors
/// [`TurbineError`] if the limit (Hz) is not positive, or limit or speed (rpm) is not finite.
pub(crate) fn check(limit_hz: f64, rotor_speed_rpm: f64) -> Result<f64, TurbineError> {
    if !(limit_hz.is_finite() && limit_hz > 0.0) {
        return Err(TurbineError::Limit { limit_hz });
    }
    match rad_per_s(rotor_speed_rpm) {
        speed if speed.is_finite() => Ok(speed),
        _ => Err(TurbineError::Speed { rotor_speed_rpm }),
    }
}
