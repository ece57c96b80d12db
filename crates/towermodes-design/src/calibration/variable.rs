//! The unknowns as coordinates: the logarithm for positive input values, the value itself for
//! others.

use towermodes::number::Rounded;
use towermodes::{Change, Operation, Parameter, TowerDescription};

use super::error::CalibrationError;
use super::problem::{Problem, Unknown};

/// An unknown as a coordinate of the fit.
#[derive(Debug, Clone)]
pub(super) struct Variable {
    pub(super) change: Change,
    /// Whether the coordinate is the logarithm of the value.
    pub(super) is_logarithm: bool,
    /// Start of the iteration.
    pub(super) start: f64,
    /// The value on the original tower; none if the values that the change sets differ there.
    pub(super) present: Option<f64>,
    /// Mean and standard deviation of the coordinate.
    pub(super) prior: Option<[f64; 2]>,
    /// The range of the coordinate.
    pub(super) bounds: [f64; 2],
    /// A change of the coordinate that is large for this input value; none for an input value that
    /// is 0 and has neither prior nor bounds.
    pub(super) scale: Option<f64>,
}

impl Variable {
    /// The value of the change at a coordinate.
    pub(super) fn value(&self, x: f64) -> f64 {
        if self.is_logarithm { x.exp() } else { x }
    }

    /// d(value)/d(coordinate).
    pub(super) fn slope(&self, x: f64) -> f64 {
        if self.is_logarithm { x.exp() } else { 1.0 }
    }
}

/// Every unknown as a coordinate.
pub(super) fn variables(problem: &Problem) -> Result<Vec<Variable>, CalibrationError> {
    let of = |unknown| variable(unknown, &problem.base);
    problem.unknowns.iter().map(of).collect()
}

/// Changes a description to the values at coordinates.
pub(super) fn apply(variables: &[Variable], x: &[f64], description: &mut TowerDescription) {
    for (variable, x) in variables.iter().zip(x) {
        variable.change.apply(description, variable.value(*x));
    }
}

/// As [`apply`], with values rounded to eight digits, as they are written to a file.
pub(super) fn apply_rounded(variables: &[Variable], x: &[f64], description: &mut TowerDescription) {
    for (variable, x) in variables.iter().zip(x) {
        let value = variable.value(*x);
        let rounded = format!("{value:.7e}").parse().unwrap_or(value);
        variable.change.apply(description, rounded);
    }
}

fn variable(unknown: &Unknown, base: &TowerDescription) -> Result<Variable, CalibrationError> {
    let change = unknown.change.clone();
    let present = present_value(&change, base);
    if is_positive(&change, base) {
        check_positive(unknown, present)?;
    }
    let mean = unknown.prior.map(|prior| prior.mean);
    let usable = present.filter(|value| value.is_finite());
    let start = usable.or(mean);
    let Some(start) = start.or(unknown.bounds.map(|[low, high]| 0.5 * (low + high))) else {
        return Err(no_start(unknown, base, present));
    };
    let lowest = unknown.bounds.map_or(0.0, |[low, _]| low);
    let values = [Some(start), mean];
    let is_logarithm = is_positive(&change, base)
        && values.into_iter().flatten().all(|value| value > 0.0)
        && lowest >= 0.0;
    let coordinate = |value: f64| if is_logarithm { value.ln() } else { value };
    let bounds = match unknown.bounds {
        Some(bounds) => bounds.map(coordinate),
        // A mass of 0 may grow; it cannot become negative.
        None if is_positive(&change, base) && !is_logarithm => [0.0, f64::INFINITY],
        None => [f64::NEG_INFINITY, f64::INFINITY],
    };
    let prior = unknown.prior.map(|prior| match is_logarithm {
        true => {
            let variance = (prior.deviation / prior.mean).powi(2).ln_1p();
            [prior.mean.ln() - 0.5 * variance, variance.sqrt()]
        }
        false => [prior.mean, prior.deviation],
    });
    Ok(Variable {
        scale: scale(unknown, base, is_logarithm, start),
        is_logarithm,
        start: coordinate(start).clamp(bounds[0], bounds[1]),
        present,
        prior,
        bounds,
        change,
    })
}

/// Refuses a mean or bounds that contradict a positive input value. Only an input value that is 0
/// on the tower may have the mean 0.
fn check_positive(unknown: &Unknown, present: Option<f64>) -> Result<(), CalibrationError> {
    let change = || unknown.change.name().to_owned();
    if let Some([_, high]) = unknown.bounds
        && high <= 0.0
    {
        let change = change();
        return Err(CalibrationError::BoundsNotPositive { change, high });
    }
    match unknown.prior.map(|prior| prior.mean) {
        Some(mean) if mean < 0.0 || mean == 0.0 && present != Some(0.0) => {
            let change = change();
            Err(CalibrationError::PriorNotPositive { change, mean })
        }
        _ => Ok(()),
    }
}

fn scale(
    unknown: &Unknown,
    base: &TowerDescription,
    is_logarithm: bool,
    start: f64,
) -> Option<f64> {
    let numbers = unknown.change.parameters().iter();
    let sizes = numbers.map(|number| number.value(base).abs());
    let size = sizes.filter(|size| size.is_finite()).fold(0.0, f64::max);
    let of_prior = unknown.prior.map(|prior| prior.deviation);
    let of_bounds = unknown.bounds.map(|[low, high]| high - low);
    let of_value = Some(start.abs()).filter(|size| *size > 0.0);
    let of_numbers = Some(size).filter(|size| *size > 0.0);
    match is_logarithm {
        true => Some(1.0),
        false => of_prior.or(of_bounds).or(of_value).or(of_numbers),
    }
}

fn no_start(unknown: &Unknown, base: &TowerDescription, present: Option<f64>) -> CalibrationError {
    let values = unknown.change.parameters().iter().map(|p| p.value(base));
    let (found, remedy) = match present {
        Some(value) => (
            Rounded(value).to_string(),
            "give it a prior or bounds, or a finite number in the tower file",
        ),
        None => {
            let low = values.clone().fold(f64::INFINITY, f64::min);
            let high = values.fold(f64::NEG_INFINITY, f64::max);
            (
                format!("values from {} to {}", Rounded(low), Rounded(high)),
                "fit scale(…) or add(…), or give it a prior",
            )
        }
    };
    CalibrationError::NoStart {
        change: unknown.change.name().to_owned(),
        found,
        remedy,
    }
}

/// The value of a change on the original tower; none if the values that it sets differ.
fn present_value(change: &Change, base: &TowerDescription) -> Option<f64> {
    match change.operation() {
        Operation::Scale => Some(1.0),
        Operation::Add => Some(0.0),
        Operation::Set => {
            let mut values = change.parameters().iter().map(|p| p.value(base));
            let first = values.next()?;
            values.all(|value| value == first).then_some(first)
        }
    }
}

/// Whether the value of a change is always positive: a factor, a stiffness, a mass, a thickness;
/// not a height, a distance from the axis or a product of inertia.
fn is_positive(change: &Change, base: &TowerDescription) -> bool {
    let is_amount =
        |parameter: &Parameter| parameter.nature().is_amount() && parameter.value(base) >= 0.0;
    match change.operation() {
        Operation::Scale => true,
        Operation::Set => change.parameters().iter().all(is_amount),
        Operation::Add => false,
    }
}
