//! Mean, standard deviation, limits and quantiles of a column.

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
    /// The smallest value.
    pub min: f64,
    /// The largest value.
    pub max: f64,
    /// The quantiles at the levels [`QUANTILES`], exact, interpolated linearly between neighbours
    /// as by NumPy.
    pub quantiles: [f64; QUANTILES.len()],
}

/// The values of a column, with running mean and variance (Welford 1962).
#[derive(Debug, Clone, Default)]
pub(super) struct Values {
    values: Vec<f64>,
    mean: f64,
    squares: f64,
}

impl Values {
    pub(super) fn add(&mut self, value: f64) {
        self.values.push(value);
        let before = value - self.mean;
        self.mean += before / self.values.len() as f64;
        self.squares += before * (value - self.mean);
    }

    /// The statistics, none without values.
    pub(super) fn statistics(mut self) -> Option<Statistics> {
        self.values.sort_unstable_by(f64::total_cmp);
        let sorted = &self.values;
        let (min, max) = (*sorted.first()?, *sorted.last()?);
        let freedom = (sorted.len() - 1).max(1);
        Some(Statistics {
            count: sorted.len() as u64,
            mean: self.mean,
            deviation: (self.squares / freedom as f64).sqrt(),
            min,
            max,
            quantiles: QUANTILES.map(|level| quantile(sorted, level)),
        })
    }
}

/// The quantile of sorted values.
fn quantile(sorted: &[f64], level: f64) -> f64 {
    let last = sorted.len() - 1;
    let place = level * last as f64;
    let rank = place as usize;
    let [below, above] = [sorted[rank], sorted[(rank + 1).min(last)]];
    below + (above - below) * (place - place.floor())
}
