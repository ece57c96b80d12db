//! Mean, deviation, limits and quantiles of a column.

use super::order::Selection;

/// The levels of the quantiles of a summary.
pub const QUANTILES: [f64; 7] = [0.001, 0.01, 0.05, 0.5, 0.95, 0.99, 0.999];

/// Statistics of the values of a column, without those that were not computed.
#[derive(Debug, Clone, PartialEq)]
pub struct Statistics {
    /// Number of values.
    pub count: u64,
    /// Mean.
    pub mean: f64,
    /// Standard deviation of the population, estimated with n − 1; 0 for one value.
    pub deviation: f64,
    /// The smallest.
    pub min: f64,
    /// The largest.
    pub max: f64,
    /// The quantiles at the levels [`QUANTILES`], exact, interpolated linearly between neighbours
    /// as by NumPy.
    pub quantiles: [f64; QUANTILES.len()],
}

/// Mean and spread of values that come one after the other (Welford 1962).
#[derive(Debug, Clone)]
pub(super) struct Moments {
    pub(super) count: u64,
    mean: f64,
    squares: f64,
    min: f64,
    max: f64,
}

impl Default for Moments {
    fn default() -> Self {
        Self {
            count: 0,
            mean: 0.0,
            squares: 0.0,
            min: f64::INFINITY,
            max: f64::NEG_INFINITY,
        }
    }
}

impl Moments {
    pub(super) fn add(&mut self, value: f64) {
        self.count += 1;
        let before = value - self.mean;
        self.mean += before / self.count as f64;
        self.squares += before * (value - self.mean);
        self.min = self.min.min(value);
        self.max = self.max.max(value);
    }

    /// The ranks that the quantiles need: two for each.
    pub(super) fn ranks(&self) -> Vec<u64> {
        let places = QUANTILES.map(|level| self.place(level));
        let pairs = places.iter().map(|place| *place as u64);
        let last = self.count.saturating_sub(1);
        pairs
            .flat_map(|rank| [rank, (rank + 1).min(last)])
            .collect()
    }

    fn place(&self, level: f64) -> f64 {
        level * self.count.saturating_sub(1) as f64
    }

    /// The statistics, none without values.
    pub(super) fn statistics(&self, selection: &Selection) -> Option<Statistics> {
        let values = selection.values();
        let quantile = |index: usize| {
            let place = self.place(QUANTILES[index]);
            let [below, above] = [values[2 * index], values[2 * index + 1]];
            below + (above - below) * (place - place.floor())
        };
        let freedom = self.count.saturating_sub(1).max(1);
        (self.count > 0).then(|| Statistics {
            count: self.count,
            mean: self.mean,
            deviation: (self.squares / freedom as f64).sqrt(),
            min: self.min,
            max: self.max,
            quantiles: std::array::from_fn(quantile),
        })
    }
}
