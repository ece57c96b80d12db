//! Means, deviations and correlations of all varied numbers.

use towermodes_files::{Sampling, SamplingError};

use super::correlated::Correlated;
use super::scores::moments;
use super::values::Values;

/// The first two moments of the joint distribution of the varied numbers.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Joint {
    /// Mean and standard deviation of each number.
    pub(crate) moments: Vec<[f64; 2]>,
    /// The two places and the coefficient of each correlation.
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
        let moments = sampling.vary.iter().map(|varied| {
            let values = Values::new(&varied.distribution)?;
            Ok(moments(&varied.distribution, &values))
        });
        let moments: Vec<[f64; 2]> = moments.collect::<Result<_, SamplingError>>()?;
        let mut directions = Correlated::of_values(sampling)?.directions(moments.len());
        for (place, amount) in directions.iter_mut().flatten() {
            *amount *= moments[*place][1];
        }
        let places = sampling.correlated_places();
        let places = places.map_err(SamplingError::from)?;
        let coefficients = sampling.correlations.iter().map(|pair| pair.coefficient);
        Ok(Self {
            correlations: places.into_iter().zip(coefficients).collect(),
            moments,
            directions,
        })
    }
}
