//! Means, deviations and correlations of all varied numbers.

use towermodes_files::{Sampling, SamplingError};

use super::correlated::Correlated;
use super::moments::{moments, of_values};
use super::values::Values;

/// The first two moments of the joint distribution of the varied numbers.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Joint {
    /// Mean and standard deviation of each number.
    pub(crate) moments: Vec<[f64; 2]>,
    /// The two places of each correlation and its coefficient, that of the values.
    pub(crate) correlations: Vec<([usize; 2], f64)>,
    /// As many directions as numbers, which vary independently with the variance 1: each has the
    /// places of the numbers that it moves, and by how much.
    pub(crate) directions: Vec<Vec<(usize, f64)>>,
}

impl Joint {
    /// The moments of a sampling.
    ///
    /// # Errors
    /// [`SamplingError`] for what cannot be drawn.
    pub(crate) fn of(sampling: &Sampling) -> Result<Self, SamplingError> {
        sampling.check()?;
        let values = sampling.vary.iter();
        let values: Result<Vec<Values>, _> = values.map(|v| Values::new(&v.distribution)).collect();
        let values = values?;
        let pairs = sampling.vary.iter().zip(&values);
        let moments: Vec<[f64; 2]> = pairs.map(|(v, of)| moments(&v.distribution, of)).collect();
        let places = sampling.correlated_places();
        let places = places.map_err(SamplingError::from)?;
        let pairs = places.iter().zip(&sampling.correlations);
        let of_values = pairs.map(|(pair, correlation)| {
            let scaled = pair.map(|place| (&values[place], moments[place]));
            of_values(scaled, correlation.coefficient)
        });
        let coefficients: Vec<f64> = of_values.collect();
        let correlated = Correlated::with(sampling, &coefficients)?;
        let mut directions = correlated.directions(moments.len());
        for (place, amount) in directions.iter_mut().flatten() {
            *amount *= moments[*place][1];
        }
        Ok(Self {
            correlations: places.into_iter().zip(coefficients).collect(),
            moments,
            directions,
        })
    }
}
