//! Correlated input values: from independent normal scores to correlated values.

use towermodes_files::{CorrelationError, Sampling, SamplingError};

use super::cholesky::{Excluded, cholesky};

/// The inputs that have correlations, and the linear relation of their scores to independent
/// scores: the rows of the Cholesky factor of the correlation matrix of the scores.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Correlated {
    /// The indices of these inputs among all inputs, in increasing order.
    places: Vec<usize>,
    /// The factor L with R = L Lᵀ: row i has the columns 0 to i.
    factor: Vec<Vec<f64>>,
}

impl Correlated {
    /// The correlated inputs of a sampling, with the coefficients of their scores.
    ///
    /// # Errors
    /// [`SamplingError::Correlation`] for a coefficient that is impossible with the others.
    pub(super) fn new(sampling: &Sampling) -> Result<Self, SamplingError> {
        let given = sampling.correlations.iter().map(|pair| pair.coefficient);
        Self::with(sampling, &given.collect::<Vec<_>>())
    }

    /// As [`new`](Self::new), with other coefficients of the pairs.
    ///
    /// # Errors
    /// [`SamplingError::Correlation`] as of [`new`](Self::new).
    pub(super) fn with(sampling: &Sampling, coefficients: &[f64]) -> Result<Self, SamplingError> {
        let pairs = sampling.correlated_places();
        let pairs = pairs.map_err(SamplingError::from)?;
        let places = members(&pairs);
        let mut given = Lower::of(&places, None);
        let mut scores = Lower::of(&places, 0.0);
        for (index, pair) in pairs.iter().enumerate() {
            let [first, second] = pair.map(|place| member(&places, place));
            scores.0[second][first] = coefficients[index];
            given.0[second][first] = Some(index);
        }
        let factor = cholesky(&scores.0);
        let factor =
            factor.map_err(|excluded| contradiction(sampling, &places, &given, excluded))?;
        Ok(Self { places, factor })
    }

    /// Whether an input, by its index among all inputs, is correlated with another.
    pub(super) fn has(&self, place: usize) -> bool {
        self.places.binary_search(&place).is_ok()
    }

    /// Transforms the independent scores of these inputs into correlated ones.
    pub(super) fn correlate(&self, scores: &mut [f64]) {
        // A row needs the scores before it as they were.
        for (row, place) in self.factor.iter().zip(&self.places).rev() {
            let terms = row.iter().zip(&self.places);
            scores[*place] = terms.map(|(factor, at)| factor * scores[*at]).sum();
        }
    }

    /// The indices of these inputs among all inputs.
    pub(super) fn places(&self) -> &[usize] {
        &self.places
    }

    /// The columns of the factor for all `count` inputs: the independent directions in which they
    /// vary, each as the indices of the inputs that it changes, with factors.
    pub(super) fn directions(&self, count: usize) -> Vec<Vec<(usize, f64)>> {
        let direction = |place: usize| match self.places.binary_search(&place) {
            Err(_) => vec![(place, 1.0)],
            Ok(column) => {
                let rows = self.factor.iter().zip(&self.places).skip(column);
                let moved = rows.map(|(row, place)| (*place, row[column]));
                moved.filter(|(_, factor)| *factor != 0.0).collect()
            }
        };
        (0..count).map(direction).collect()
    }
}

/// The lower triangle of a matrix: row i has the columns 0 to i − 1.
struct Lower<T>(Vec<Vec<T>>);

impl<T: Clone> Lower<T> {
    fn of(places: &[usize], entry: T) -> Self {
        let rows = 0..places.len();
        Self(rows.map(|row| vec![entry.clone(); row]).collect())
    }
}

/// All indices in the pairs, in increasing order.
fn members(pairs: &[[usize; 2]]) -> Vec<usize> {
    let mut places: Vec<usize> = pairs.iter().flatten().copied().collect();
    places.sort_unstable();
    places.dedup();
    places
}

/// The position of an index in an increasing list that contains it.
fn member(places: &[usize], place: usize) -> usize {
    places.partition_point(|other| *other < place)
}

/// The error for a coefficient that is impossible with the others.
fn contradiction(
    sampling: &Sampling,
    places: &[usize],
    given: &Lower<Option<usize>>,
    excluded: Excluded,
) -> SamplingError {
    let [first, second] = excluded.pair;
    let of_pair = given.0[second][first];
    let name = |member: usize| sampling.vary[places[member]].name.trim().to_owned();
    // A pair that is not in the list is reported at the last correlation of its second number.
    let of_row = given.0[second].iter().flatten().max();
    let error = CorrelationError::Contradiction {
        between: [name(first), name(second)],
        coefficient: of_pair.map(|index| sampling.correlations[index].coefficient),
        limits: excluded.limits,
    };
    (of_pair.or(of_row.copied()).unwrap_or(0), error).into()
}
