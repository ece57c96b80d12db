//! Statistics of many modes.

use super::sample::Sample;

/// The coverage of the errors of all modes of a class by one method.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Tally {
    ratios: Vec<f64>,
    modes: usize,
    covered: usize,
    warned: usize,
    refused: usize,
}

impl Tally {
    /// Adds a mode.
    pub fn add(&mut self, sample: &Sample) {
        self.modes += 1;
        self.covered += usize::from(sample.is_covered());
        self.warned += usize::from(sample.is_warned);
        self.ratios.extend(sample.ratio());
    }

    /// Adds a tower that a method does not solve.
    pub fn refuse(&mut self) {
        self.refused += 1;
    }

    /// Number of modes.
    pub fn modes(&self) -> usize {
        self.modes
    }

    /// Number of towers that a method did not solve.
    pub fn refused(&self) -> usize {
        self.refused
    }

    /// Modes of towers with a warning that some mode is not resolved.
    pub fn warned(&self) -> usize {
        self.warned
    }

    /// The fraction of modes whose error is at most three times the estimate.
    pub fn coverage(&self) -> f64 {
        self.covered as f64 / self.modes.max(1) as f64
    }

    /// The median of estimated/true error; none if all errors are rounding errors.
    pub fn median_ratio(&self) -> Option<f64> {
        let mut ratios = self.ratios.clone();
        ratios.sort_by(f64::total_cmp);
        ratios.get(ratios.len() / 2).copied()
    }

    /// The least estimated/true error; none if all errors are rounding errors.
    pub fn least_ratio(&self) -> Option<f64> {
        self.ratios.iter().copied().min_by(f64::total_cmp)
    }
}
