//! The search where counts may decrease: between modes of negative energy.
//!
//! Two frequencies between two counts, one of positive and one of negative energy, leave the counts
//! alike. An interval of the half width r around c has none if
//!
//! neg(H(c) − r N − r² M) = neg(H(c) + r N),
//!
//! with N ≥ ±H′(c), because H(w) is between the two matrices ([`Raise`]), so that no eigenvalue of
//! H reaches zero. Other intervals are halved, all of them in turn, until as many counts have
//! fallen as there are modes of negative energy in a stable turbine: then each rise between two
//! neighbouring counts is that of modes of positive energy alone, and nothing is missing.

use super::super::equations::gyroscopic::{Gyroscopic, Raise};
use super::super::equations::model::UNRESISTED;
use super::search::{Found, Sample, Search};

/// Number of times the whole interval is halved.
const ROUNDS: usize = 14;
/// Number of times the interval is halved before its parts are examined: large intervals are never
/// empty.
const FIRST: usize = 5;
/// Largest number of intervals of one width.
const MOST: usize = 1024;
/// Largest width of an unproven interval around a mode, in smallest widths.
const AROUND: f64 = 16.0;
/// Factor and largest number of the steps in which the end of the negative energies is searched.
const STEP: f64 = 1.25;
const STEPS: usize = 20;

/// The result of a search among modes of negative energy.
#[derive(Debug, Default)]
pub(super) struct Sought {
    pub(crate) found: Vec<Found>,
    /// Intervals, rad/s, without a mode that is known, in which two of opposite energies are not
    /// excluded.
    pub(super) unproven: Vec<[f64; 2]>,
}

impl<G: Gyroscopic + ?Sized> Search<'_, G> {
    /// All frequencies up to a limit, and all modes of negative energy above it; `expected` is the
    /// number of modes of negative energy if no mode is unstable. The search begins near `about`
    /// with the highest frequency of negative energy.
    pub(super) fn falling(&mut self, limit: f64, about: f64, expected: usize) -> Sought {
        let end = self.end_of_negative_energies(about).max(limit);
        let mut open = vec![(self.sample(UNRESISTED.min(limit)), self.sample(end))];
        for round in 0..ROUNDS {
            if self.falls() >= expected || open.len() > MOST {
                break;
            }
            let mut halves = Vec::with_capacity(2 * open.len());
            for (low, high) in open {
                if round >= FIRST && self.is_empty(low, high) {
                    continue;
                }
                let middle = self.sample(0.5 * (low.w + high.w));
                halves.extend([(low, middle), (middle, high)]);
            }
            open = halves;
        }
        let is_known = self.falls() >= expected;
        let found = self.between_samples();
        let unproven = match is_known {
            true => Vec::new(),
            false => without_mode(merged(&open), &found, end),
        };
        Sought { found, unproven }
    }

    /// A frequency above which no mode has negative energy xᴴ (K + w² M) x: there K + w² M is
    /// positive.
    fn end_of_negative_energies(&mut self, about: f64) -> f64 {
        let mut w = about;
        for _ in 0..STEPS {
            let raise = Raise {
                by_inertia: w * w,
                ..Raise::default()
            };
            if self.system.count_raised(0.0, raise) == 0 {
                break;
            }
            w *= STEP;
        }
        w
    }

    /// Whether it is proved that no frequency lies between two counts.
    fn is_empty(&mut self, low: Sample, high: Sample) -> bool {
        let count = low.negative;
        if high.negative != count {
            return false;
        }
        let (middle, half) = (0.5 * (low.w + high.w), 0.5 * (high.w - low.w));
        let (below, above) = (Raise::below(half), Raise::above(half));
        let mut is_alike = |raise| self.system.count_raised(middle, raise) == count;
        is_alike(below) && is_alike(above)
    }
}

/// Joins intervals that touch each other.
fn merged(intervals: &[(Sample, Sample)]) -> Vec<[f64; 2]> {
    let mut all: Vec<[f64; 2]> = Vec::new();
    for (low, high) in intervals {
        match all.last_mut().filter(|last| last[1] >= low.w) {
            Some(last) => last[1] = high.w,
            None => all.push([low.w, high.w]),
        }
    }
    all
}

/// The intervals without narrow ones around a mode that was found.
fn without_mode(mut intervals: Vec<[f64; 2]>, found: &[Found], end: f64) -> Vec<[f64; 2]> {
    let narrow = AROUND * end / (1 << ROUNDS) as f64;
    intervals.retain(|[from, to]| {
        let is_inside = |one: &Found| *from <= one.bounds[1].w && one.bounds[0].w <= *to;
        to - from > narrow || !found.iter().any(is_inside)
    });
    intervals
}
