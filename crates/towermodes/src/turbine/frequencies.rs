//! All natural frequencies below a limit, each between two counts.

use std::f64::consts::TAU;

use super::model::TurbineModel;
use super::root::{Sample, TOLERANCE, bracket};

/// A motion slower than this, rad/s, is one that nothing resists: it is not looked at closer.
const UNRESISTED: f64 = 1e-6;
/// The coarsest and the finest grid on which modes of negative energy are sought.
const GRIDS: std::ops::RangeInclusive<u32> = 6..=12;

/// A natural frequency of a turbine at a speed, or several that cannot be told apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoupledFrequency {
    /// The frequency, Hz: the middle of its bounds.
    pub frequency_hz: f64,
    /// The lower bound, Hz: between it and the upper bound the count of negative eigenvalues
    /// changes. It is 0 for a motion that nothing resists.
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
    /// The frequencies, rising. The rotation of a free shaft, at 0, is not among them.
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

impl CoupledSpectrum {
    /// That up to a limit, rad/s, at a speed, rad/s.
    pub(super) fn of(model: &mut TurbineModel, limit: f64, speed: f64) -> Self {
        let negative = model.negative_stiffness(speed);
        let base = Sample {
            w: 0.0,
            negative: negative + usize::from(model.turns_freely()),
            log_determinant: f64::NAN,
        };
        let mut sample = |w: f64| model.sample(w, speed);
        let expected = negative / 2;
        let mut brackets = Vec::new();
        let mut found = 0;
        if negative == 0 {
            let end = sample(limit);
            isolate(base, end, &mut sample, &mut brackets);
        } else {
            // Modes of negative energy are backward whirls, slower than the rotor.
            let end = limit.max(speed.abs());
            for grid in GRIDS {
                brackets.clear();
                scan(base, end, 1 << grid, &mut sample, &mut brackets);
                let steps = brackets
                    .iter()
                    .filter(|(low, high)| high.negative < low.negative);
                found = steps.map(|(low, high)| low.negative - high.negative).sum();
                if found >= expected {
                    break;
                }
            }
        }
        let all = brackets.into_iter();
        let mut frequencies: Vec<CoupledFrequency> = all
            .map(|(low, high)| refined(low, high, &mut sample))
            .collect();
        frequencies.retain(|frequency| frequency.upper_hz * TAU <= limit);
        Self {
            frequencies,
            limit_hz: limit / TAU,
            is_complete: found == expected && negative.is_multiple_of(2),
            negative_energy_expected: expected,
            negative_energy_found: found,
        }
    }
}

/// Samples equal intervals up to `end` and isolates where counts differ.
fn scan(
    base: Sample,
    end: f64,
    intervals: usize,
    sample: &mut impl FnMut(f64) -> Sample,
    brackets: &mut Vec<(Sample, Sample)>,
) {
    let mut low = base;
    for k in 1..=intervals {
        let high = sample(end * k as f64 / intervals as f64);
        isolate(low, high, sample, brackets);
        low = high;
    }
}

/// Halves an interval until counts at both ends differ by one, or until it is a point; appends the
/// intervals in rising order.
fn isolate(
    low: Sample,
    high: Sample,
    sample: &mut impl FnMut(f64) -> Sample,
    brackets: &mut Vec<(Sample, Sample)>,
) {
    let difference = high.negative.abs_diff(low.negative);
    // The determinant is not known at 0, where a free shaft makes it vanish.
    let is_known = low.w > 0.0;
    let is_point = high.w - low.w <= 2.0 * TOLERANCE * high.w;
    match difference {
        0 => {}
        1 if is_known => brackets.push((low, high)),
        _ if is_point || high.w < UNRESISTED => brackets.push((low, high)),
        _ => {
            let middle = sample(0.5 * (low.w + high.w));
            isolate(low, middle, sample, brackets);
            isolate(middle, high, sample, brackets);
        }
    }
}

fn refined(low: Sample, high: Sample, sample: &mut impl FnMut(f64) -> Sample) -> CoupledFrequency {
    let multiplicity = high.negative.abs_diff(low.negative);
    let (low, high) = match multiplicity {
        1 => bracket(low, high, sample),
        _ => (low, high),
    };
    CoupledFrequency {
        frequency_hz: 0.5 * (low.w + high.w) / TAU,
        lower_hz: low.w / TAU,
        upper_hz: high.w / TAU,
        multiplicity,
        has_negative_energy: high.negative < low.negative,
    }
}
