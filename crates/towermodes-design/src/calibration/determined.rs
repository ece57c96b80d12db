//! Whether measurements and priors determine the unknowns.

use super::point::Point;
use super::singular::Singular;
use super::variable::Variable;

/// Columns of unit length with a singular value below this, relative to the largest, are linearly
/// dependent within the errors of derivatives.
const UNDETERMINED: f64 = 1e-9;
/// An unknown has no effect within the errors of derivatives if a change by its own size changes
/// the measurements by fewer standard deviations than this.
pub(super) const NO_EFFECT: f64 = 1e-6;

/// The free unknowns that neither measurements nor priors determine.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Undetermined {
    /// No measured frequency changes with these unknowns.
    NoEffect {
        names: Vec<String>,
        /// Whether a larger change of one of them changes a measured frequency.
        is_stationary: bool,
    },
    /// No measured frequency changes with these unknowns to first order, and the size of a larger
    /// change is unknown.
    NoSize(Vec<String>),
    /// Their columns are linearly dependent.
    Dependent(Vec<String>),
}

/// The names of the free unknowns that neither measurements nor priors determine: no measured
/// frequency changes with them, or their columns are linearly dependent. The result does not depend
/// on units.
pub(super) fn undetermined(
    point: &Point,
    variables: &[Variable],
    (is_free, has_effect): (&[bool], &[bool]),
) -> Option<Undetermined> {
    let lengths = point.lengths();
    let free: Vec<usize> = (0..variables.len()).filter(|j| is_free[*j]).collect();
    let names = |unknowns: &[usize]| -> Vec<String> {
        let names = unknowns.iter().map(|&j| variables[j].change.name());
        names.map(|name| format!("`{name}`")).collect()
    };
    let is_moving = |j: usize| match variables[j].scale {
        Some(scale) => lengths[j] * scale > NO_EFFECT,
        None => lengths[j] > 0.0,
    };
    let without: Vec<usize> = free.iter().copied().filter(|&j| !is_moving(j)).collect();
    let is_unknown = |j: &usize| variables[*j].scale.is_none();
    let of_no_size: Vec<usize> = without.iter().copied().filter(is_unknown).collect();
    if !of_no_size.is_empty() {
        return Some(Undetermined::NoSize(names(&of_no_size)));
    }
    if !without.is_empty() {
        return Some(Undetermined::NoEffect {
            names: names(&without),
            is_stationary: without.iter().any(|&j| has_effect[j]),
        });
    }
    let units: Vec<f64> = lengths.iter().map(|length| 1.0 / length).collect();
    let columns = point.scaled(&units, is_free);
    let singular = Singular::of(columns);
    let largest = singular.values.first().copied().unwrap_or(1.0);
    let is_small = |s: &f64| *s <= UNDETERMINED * largest;
    let direction = singular.values.iter().position(is_small)?;
    let parts = free.iter().zip(&singular.right[direction]);
    let parts = parts.filter(|(_, part)| part.abs() > 0.1);
    let parts: Vec<usize> = parts.map(|(j, _)| *j).collect();
    Some(Undetermined::Dependent(names(&parts)))
}
