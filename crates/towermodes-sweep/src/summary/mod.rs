//! Statistics of a sweep: of each column, of failures, and of violated resonance margins.

mod failures;
mod statistics;

pub use failures::FailureKind;
pub use statistics::{QUANTILES, Statistics};

use towermodes::{ModeName, Rotor};
use towermodes_analysis::resonance::CampbellOptions;

use crate::rows::results::Results;
use crate::slice::{SliceError, Slices};
use crate::sweep::Sweep;
use failures::Failures;
use statistics::Values;

/// The resonance check of a summary: a rotor, the required distance and the multiples of the rotor
/// speed.
#[derive(Debug, Clone, PartialEq)]
pub struct MarginCheck {
    /// The rotor.
    pub rotor: Rotor,
    /// The required distance |n Ω/f − 1|, for example 0.05.
    pub margin: f64,
    /// The multiples n of the rotor speed.
    pub multiples: Vec<usize>,
}

impl MarginCheck {
    /// The check of a rotor with the options of a Campbell diagram.
    pub fn new(rotor: Rotor, options: &CampbellOptions) -> Self {
        Self {
            rotor,
            margin: options.margin,
            multiples: options.multiples_of(&rotor),
        }
    }

    /// The natural frequencies whose distance from a multiple n of the rotor speed is below the
    /// required distance m at some operating speed Ω, Hz: n Ω₁/(1 + m) to n Ω₂/(1 − m).
    pub fn range_hz(&self, multiple: usize) -> [f64; 2] {
        let n = multiple as f64 / 60.0;
        let low = n * self.rotor.lowest_rpm / (1.0 + self.margin);
        let high = n * self.rotor.highest_rpm / (1.0 - self.margin);
        [low, high]
    }
}

impl Sweep {
    /// The resonance check with the rotor of the base and the default options; none if the base has
    /// no rotor or lacks parts of the structure, or if a change varies the rotor speed.
    pub fn margin_check(&self) -> Option<MarginCheck> {
        let mut varied = self.changes().iter().flat_map(|change| change.parameters());
        if varied.any(|parameter| parameter.is_of_rotor()) {
            return None;
        }
        if !self.base().missing_parts.is_empty() {
            return None;
        }
        let rotor = self.base().rotor?;
        Some(MarginCheck::new(rotor, &CampbellOptions::default()))
    }
}

/// Statistics of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// Number of rows.
    pub rows: u64,
    /// Number of rows that failed or lack a mode.
    pub failed: u64,
    /// These rows grouped by message, the most frequent first.
    pub failures: Vec<FailureKind>,
    /// Number of failed rows of the kinds that are not counted separately.
    pub other_failures: u64,
    /// Mass of the tower and of the members of a substructure, kg.
    pub mass_kg: Option<Statistics>,
    /// The modes.
    pub modes: Vec<ModeSummary>,
    /// Whether the rows are known to be independent, as in random sampling: then
    /// [`MarginSummary::standard_error`] applies. For results in memory it is not known.
    pub rows_are_independent: bool,
}

/// Statistics of a mode of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeSummary {
    /// The mode.
    pub name: ModeName,
    /// Its extrapolated frequency, Hz, with the number of rows that have the mode; none if no row
    /// has it.
    pub frequency_hz: Option<Statistics>,
    /// Its largest error, Hz.
    pub largest_error_hz: f64,
    /// Number of rows with an excitation within the required distance, by multiple of the rotor
    /// speed.
    pub margins: Vec<MarginSummary>,
}

/// How many rows have an excitation within the required distance of a mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MarginSummary {
    /// The multiple n of the rotor speed.
    pub multiple: usize,
    /// Number of rows in which |n Ω/f − 1| is below the required distance in operation, with the
    /// frequency f of the row.
    pub violated: u64,
    /// The smallest and largest number of violated rows within the errors of the frequencies
    /// (without extrapolation): with all frequencies of a row's error interval violating the
    /// distance, and with at least one of them.
    pub violated_within_errors: [u64; 2],
    /// Number of rows that contain the mode.
    pub count: u64,
}

impl MarginSummary {
    /// The number of violated rows divided by the number of rows that contain the mode. It
    /// estimates a probability if the rows are drawn from distributions; failed rows are not
    /// counted.
    pub fn probability(&self) -> f64 {
        self.violated as f64 / self.count as f64
    }

    /// The same ratio with the smallest and largest number of violated rows within the errors of
    /// the frequencies.
    pub fn probability_within_errors(&self) -> [f64; 2] {
        self.violated_within_errors
            .map(|violated| violated as f64 / self.count as f64)
    }

    /// The standard error of the probability for independent random rows, √(p (1 − p)/n). It
    /// applies if [`Summary::rows_are_independent`]: rows of a Latin hypercube or a Sobol sequence
    /// are distributed more evenly, and those of a grid or a table are not random. If no row or
    /// every row is violated it is 0: then the probability is below about 3/n or above 1 − 3/n with
    /// 95 % confidence.
    pub fn standard_error(&self) -> f64 {
        let p = self.probability();
        (p * (1.0 - p) / self.count as f64).sqrt()
    }

    /// The interval that contains the probability with 95 % confidence, if the rows are
    /// independent: the interval of E. B. Wilson (1927), which is valid also if no row or every row
    /// is violated.
    pub fn interval(&self) -> [f64; 2] {
        /// The normal quantile of 97.5 %.
        const Z: f64 = 1.959_963_984_540_054;
        let (p, n) = (self.probability(), self.count as f64);
        let square = Z * Z / n;
        let middle = (p + 0.5 * square) / (1.0 + square);
        let half = Z * (p * (1.0 - p) / n + 0.25 * square / n).sqrt() / (1.0 + square);
        let [low, high] = [middle - half, middle + half];
        // Rounding may leave the range.
        [
            if self.violated == 0 { 0.0 } else { low },
            if self.violated == self.count {
                1.0
            } else {
                high
            },
        ]
    }
}

/// Counts the rows that violate resonance margins.
#[derive(Debug, Clone, PartialEq)]
pub struct MarginCounts<'a> {
    check: Option<&'a MarginCheck>,
    /// The counts by mode, then by multiple.
    counts: Vec<Vec<MarginSummary>>,
}

impl<'a> MarginCounts<'a> {
    /// Counts for this number of modes, without any rows.
    pub fn new(modes: usize, check: Option<&'a MarginCheck>) -> Self {
        let multiples = check.map_or(&[][..], |check| &check.multiples);
        let margins = multiples.iter().map(|multiple| MarginSummary {
            multiple: *multiple,
            violated: 0,
            violated_within_errors: [0; 2],
            count: 0,
        });
        Self {
            check,
            counts: vec![margins.collect(); modes],
        }
    }

    /// Counts the rows of results.
    pub fn add(&mut self, results: &Results) {
        let Some(check) = self.check else { return };
        for (mode, margins) in self.counts.iter_mut().enumerate() {
            let frequencies = results.frequencies_hz(mode);
            for (hz, error_hz) in frequencies.zip(results.errors_hz(mode)) {
                // Neither a motion without stiffness nor a mode that the row lacks.
                if hz.is_nan() || hz <= 0.0 {
                    continue;
                }
                for margin in margins.iter_mut() {
                    let [low_hz, high_hz] = check.range_hz(margin.multiple);
                    let is_inside = |from_hz: f64, to_hz: f64| low_hz < from_hz && to_hz < high_hz;
                    let counts = [error_hz, 0.0, -error_hz];
                    let [least, found, most] =
                        counts.map(|by_hz| u64::from(is_inside(hz - by_hz, hz + by_hz)));
                    margin.count += 1;
                    margin.violated += found;
                    margin.violated_within_errors[0] += least;
                    margin.violated_within_errors[1] += most;
                }
            }
        }
    }

    /// The counts by mode, then by multiple; no multiples without a check.
    pub fn counts(&self) -> &[Vec<MarginSummary>] {
        &self.counts
    }
}

impl Results {
    /// Statistics of these results, with a resonance check if one is given.
    pub fn summary(&self, check: Option<&MarginCheck>) -> Summary {
        let mut counted = Counted::new(self.modes.len(), check);
        counted.add(self);
        counted.summary(&self.modes)
    }
}

impl Slices<'_> {
    /// Statistics of the results of all slices, with a resonance check if one is given. It needs
    /// eight bytes for each frequency and mass of the rows.
    ///
    /// # Errors
    /// [`SliceError`] for a slice that cannot be read or is incomplete.
    pub fn summary(&self, check: Option<&MarginCheck>) -> Result<Summary, SliceError> {
        let modes = self.sweep().modes();
        let mut counted = Counted::new(modes.len(), check);
        self.each(&mut |results| counted.add(&results))?;
        Ok(Summary {
            rows_are_independent: self.source().is_independent(),
            ..counted.summary(modes)
        })
    }
}

/// The data of rows, added one block after another.
struct Counted<'a> {
    rows: u64,
    failures: Failures,
    mass_kg: Values,
    /// The frequencies by mode.
    frequency_hz: Vec<Values>,
    largest_error_hz: Vec<f64>,
    margins: MarginCounts<'a>,
}

impl<'a> Counted<'a> {
    fn new(modes: usize, check: Option<&'a MarginCheck>) -> Self {
        Self {
            rows: 0,
            failures: Failures::default(),
            mass_kg: Values::default(),
            frequency_hz: vec![Values::default(); modes],
            largest_error_hz: vec![0.0; modes],
            margins: MarginCounts::new(modes, check),
        }
    }

    fn add(&mut self, results: &Results) {
        self.margins.add(results);
        self.rows += results.rows() as u64;
        for (row, sentence) in results.failures.iter() {
            self.failures.add(row, sentence);
        }
        add_all(&mut self.mass_kg, results.mass_kg.iter().copied());
        for (mode, values) in self.frequency_hz.iter_mut().enumerate() {
            add_all(values, results.frequencies_hz(mode));
            let largest = &mut self.largest_error_hz[mode];
            // NaN is not larger than any number.
            *largest = results.errors_hz(mode).fold(*largest, f64::max);
        }
    }

    fn summary(self, modes: &[ModeName]) -> Summary {
        let frequencies = self.frequency_hz.into_iter().enumerate();
        let modes = frequencies.map(|(mode, values)| ModeSummary {
            name: modes[mode],
            frequency_hz: values.statistics(),
            largest_error_hz: self.largest_error_hz[mode],
            margins: self.margins.counts()[mode].clone(),
        });
        let modes = modes.collect();
        let failed = self.failures.count;
        let (failures, other_failures) = self.failures.kinds();
        Summary {
            rows: self.rows,
            failed,
            failures,
            other_failures,
            mass_kg: self.mass_kg.statistics(),
            modes,
            rows_are_independent: false,
        }
    }
}

/// Adds the values that are not NaN.
fn add_all(values: &mut Values, new: impl Iterator<Item = f64>) {
    new.filter(|value| !value.is_nan())
        .for_each(|value| values.add(value));
}
