//! The result of a fit and its statistics.

use towermodes::modes::SharedMotion;
use towermodes::{ModeName, TowerDescription};

use super::fit::Found;
use super::pairing::{Ambiguity, Pairing};
use super::point::{AtBound, Point};
use super::problem::{Prior, Problem};
use super::singular::Singular;
use super::variable::Variable;

/// Input values of a tower fitted to measured frequencies.
#[derive(Debug, Clone, PartialEq)]
pub struct Calibration {
    /// The unknowns, in the order of the problem.
    pub unknowns: Vec<Fitted>,
    /// The correlations of the unknowns, from −1 to 1; NaN for one at a bound.
    pub correlations: Vec<Vec<f64>>,
    /// The measurements, in the order of the problem.
    pub measured: Vec<Explained>,
    /// For each unknown the share of its variance that comes from each measurement, then from each
    /// prior in the order of the unknowns that have one; the sum is 1. The measurement with the
    /// largest share mainly determines the unknown. Empty for an unknown at a bound.
    pub shares: Vec<Vec<f64>>,
    /// Combinations of the unknowns and their accuracy from the measurements alone, the most
    /// accurate first.
    pub directions: Vec<Direction>,
    /// Sum of the squared residuals of measurements and priors, in standard deviations.
    pub chi_square: f64,
    /// Number of measurements and priors minus the number of unknowns that are not at a bound.
    pub degrees_of_freedom: usize,
    /// Number of iterations.
    pub iterations: usize,
    /// Whether the measurements are assigned to the same modes before and after the fit.
    pub is_pairing_stable: bool,
    /// Whether the certificate of the fitted tower proves that no mode is missing.
    pub is_certified: bool,
    /// The measured names whose type of motion is shared by several modes of the fitted tower: an
    /// arbitrarily small change of an input value may give the name to another of them.
    pub shared: Vec<SharedMotion>,
    /// The tower with the fitted input values, rounded to eight digits.
    pub description: TowerDescription,
}

/// A fitted input value.
#[derive(Debug, Clone, PartialEq)]
pub struct Fitted {
    /// The name of the change.
    pub name: String,
    /// Its unit; empty for a factor.
    pub unit: &'static str,
    /// The value on the original tower; none if the values that the change sets differ there.
    pub before: Option<f64>,
    /// The fitted value.
    pub value: f64,
    /// Its standard deviation; none at a bound.
    pub deviation: Option<f64>,
    /// The values one standard deviation below and above; for a positive input value the estimate
    /// divided and multiplied by the same factor. None at a bound.
    pub interval: Option<[f64; 2]>,
    /// Whether the logarithm of the input value was fitted.
    pub is_logarithm: bool,
    /// The prior of the value.
    pub prior: Option<Prior>,
    /// The residual of its prior in standard deviations, if it has one.
    pub prior_residual: Option<f64>,
    /// The bound that the value has reached, if any.
    pub at_bound: Option<AtBound>,
    /// Whether at least one measured frequency changes with the input value, at the fitted value or
    /// next to it.
    pub has_effect: bool,
}

/// A measurement and the frequencies of the tower before and after the fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Explained {
    /// The mode.
    pub mode: ModeName,
    /// Measured frequency, Hz.
    pub measured_hz: f64,
    /// Its standard deviation, Hz.
    pub deviation_hz: f64,
    /// The frequency of the original tower, Hz.
    pub before_hz: f64,
    /// Frequency of the fitted tower, Hz.
    pub fitted_hz: f64,
    /// (fitted − measured)/deviation.
    pub residual: f64,
    /// The bounds that prevent a nearer frequency: the unknowns, from 0, and which of their bounds.
    pub held_by: Vec<(usize, AtBound)>,
    /// Another mode that may have been measured.
    pub ambiguity: Option<Ambiguity>,
    /// The share of the type of motion that its name states in the energy of the mode of the fitted
    /// tower.
    pub share: f64,
}

/// A combination of the unknowns, and how well the measurements alone determine it.
#[derive(Debug, Clone, PartialEq)]
pub struct Direction {
    /// The singular value of the weighted Jacobian: the change of all measurements together, in
    /// standard deviations, if the unknowns change by [`parts`](Self::parts).
    pub singular_value: f64,
    /// The change of each unknown, as a vector of length 1: for positive input values of the
    /// logarithm (0.1 is about 10 %), for others in the unit [`scales`](Self::scales).
    pub parts: Vec<f64>,
    /// The unit of each part: 1 for a logarithm.
    pub scales: Vec<f64>,
}

/// Computes the statistics of the result from the last point of the iteration.
pub(super) fn result(
    problem: &Problem,
    variables: &[Variable],
    pairing: &Pairing,
    before: &Point,
    found: &Found,
    description: TowerDescription,
) -> Calibration {
    let spread = Spread::of(found);
    let point = &found.point;
    let data = problem.measured.len();
    let priors: Vec<usize> = (0..variables.len())
        .filter(|&j| variables[j].prior.is_some())
        .collect();
    let unknowns = variables.iter().enumerate().map(|(j, variable)| {
        let prior_row = priors.iter().position(|&one| one == j);
        Fitted {
            prior: problem.unknowns[j].prior,
            prior_residual: prior_row.map(|row| point.residuals[data + row]),
            has_effect: found.has_effect[j],
            ..fitted(variable, point.x[j], spread.deviation(j))
        }
    });
    let unknowns: Vec<Fitted> = unknowns.collect();
    let free = found.is_free.iter().filter(|is_free| **is_free).count();
    Calibration {
        correlations: spread.correlations(variables.len()),
        shares: (0..variables.len()).map(|j| spread.shares(j)).collect(),
        measured: explained(problem, variables, pairing, [before, point]),
        directions: directions(variables, point, data),
        chi_square: point.chi_square(),
        degrees_of_freedom: point.residuals.len().saturating_sub(free),
        iterations: found.iterations,
        is_pairing_stable: pairing.is_stable,
        is_certified: pairing.is_certified,
        shared: pairing.shared.clone(),
        unknowns,
        description,
    }
}

fn fitted(variable: &Variable, x: f64, deviation: Option<f64>) -> Fitted {
    let value = variable.value(x);
    let [low, high] = variable.bounds;
    let at_bound = match deviation {
        Some(_) => None,
        None if x <= low => Some(AtBound::Lower),
        None if x >= high => Some(AtBound::Upper),
        None => None,
    };
    Fitted {
        name: variable.change.name().to_owned(),
        unit: variable.change.unit(),
        before: variable.present,
        value,
        deviation: deviation.map(|deviation| deviation * variable.slope(x)),
        interval: deviation.map(|d| [variable.value(x - d), variable.value(x + d)]),
        is_logarithm: variable.is_logarithm,
        prior: None,
        prior_residual: None,
        at_bound,
        has_effect: true,
    }
}

fn explained(
    problem: &Problem,
    variables: &[Variable],
    pairing: &Pairing,
    [before, point]: [&Point; 2],
) -> Vec<Explained> {
    let one = |index: usize| {
        let measured = &problem.measured[index];
        Explained {
            mode: pairing.names[index],
            measured_hz: measured.frequency_hz,
            deviation_hz: measured.deviation_hz,
            before_hz: before.frequencies_hz[index],
            fitted_hz: point.frequencies_hz[index],
            residual: point.residuals[index],
            held_by: point.held_by(variables, index),
            ambiguity: pairing.ambiguities[index],
            share: pairing.shares[index],
        }
    };
    (0..problem.measured.len()).map(one).collect()
}

/// The singular values of the rows of the Jacobian that belong to measurements, without priors.
fn directions(variables: &[Variable], point: &Point, data: usize) -> Vec<Direction> {
    let all = variables.iter().zip(&point.x);
    let scales: Vec<f64> = all
        .map(|(variable, x)| {
            let own = Some(x.abs()).filter(|size| *size > 0.0);
            variable.scale.or(own).unwrap_or(1.0)
        })
        .collect();
    let all = point.columns.iter().zip(&scales);
    let columns = all.map(|(column, scale)| {
        let rows = column.iter().take(data);
        rows.map(|c| c * scale).collect()
    });
    let singular = Singular::of(columns.collect());
    let found = singular.values.into_iter().zip(singular.right);
    found
        .map(|(singular_value, parts)| Direction {
            singular_value,
            parts,
            scales: scales.clone(),
        })
        .collect()
}

/// Covariance and gains of the unknowns that are not at a bound.
struct Spread {
    /// The index of each unknown among the free unknowns.
    place: Vec<Option<usize>>,
    covariance: Vec<Vec<f64>>,
    gains: Vec<Vec<f64>>,
}

impl Spread {
    fn of(found: &Found) -> Self {
        let mut free = 0;
        let place = found.is_free.iter().map(|is_free| {
            is_free.then(|| {
                free += 1;
                free - 1
            })
        });
        let place: Vec<Option<usize>> = place.collect();
        let columns = found.point.columns.iter().zip(&found.is_free);
        let columns = columns.filter(|(_, is_free)| **is_free);
        let columns: Vec<Vec<f64>> = columns.map(|(column, _)| column.clone()).collect();
        // Columns of length 1, so that units do not matter.
        let lengths: Vec<f64> = columns
            .iter()
            .map(|column| column.iter().map(|c| c * c).sum::<f64>().sqrt())
            .collect();
        let scaled = columns.iter().zip(&lengths);
        let scaled = scaled.map(|(column, length)| column.iter().map(|c| c / length).collect());
        let singular = Singular::of(scaled.collect());
        let mut covariance = singular.covariance();
        for (i, row) in covariance.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry /= lengths[i] * lengths[j];
            }
        }
        let mut gains = singular.gains();
        for (row, length) in gains.iter_mut().zip(&lengths) {
            row.iter_mut().for_each(|gain| *gain /= length);
        }
        Self {
            place,
            covariance,
            gains,
        }
    }

    fn deviation(&self, j: usize) -> Option<f64> {
        self.place[j].map(|k| self.covariance[k][k].sqrt())
    }

    fn correlations(&self, n: usize) -> Vec<Vec<f64>> {
        let entry = |i: usize, j: usize| match (self.place[i], self.place[j]) {
            (Some(_), Some(_)) if i == j => 1.0,
            (Some(a), Some(b)) => {
                self.covariance[a][b] / (self.covariance[a][a] * self.covariance[b][b]).sqrt()
            }
            _ => f64::NAN,
        };
        (0..n)
            .map(|i| (0..n).map(|j| entry(i, j)).collect())
            .collect()
    }

    fn shares(&self, j: usize) -> Vec<f64> {
        let Some(k) = self.place[j] else {
            return Vec::new();
        };
        let squares = self.gains[k].iter().map(|gain| gain * gain);
        let sum: f64 = squares.clone().sum();
        squares.map(|square| square / sum).collect()
    }
}
