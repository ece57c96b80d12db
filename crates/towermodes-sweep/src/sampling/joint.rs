//! Means, standard deviations and correlations of all varied inputs.

use towermodes_files::{Sampling, SamplingError};

use super::correlated::Correlated;
use super::moments::{moments, of_values};
use super::values::Values;

/// The first two moments of the joint distribution of the varied inputs.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Joint {
    /// Mean and standard deviation of each input.
    pub(crate) moments: Vec<[f64; 2]>,
    /// The indices of the two inputs of each correlation, and the correlation coefficient of their
    /// values.
    pub(crate) correlations: Vec<([usize; 2], f64)>,
    /// As many directions as inputs, which vary independently with the variance 1: each as the
    /// indices of the inputs that it changes, and the amounts.
    pub(crate) directions: Vec<Vec<(usize, f64)>>,
}

impl Joint {
    /// The moments of a sampling.
    ///
    /// # Errors
    /// [`SamplingError`] for a sampling that cannot be drawn.
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
