//! A quantity with the usual range of towers.

use crate::inputs::{Input, Inputs, without_needed};
use crate::tower::Warning;
use crate::tower::{Ineffective, Place, Quantity, Site};

/// A quantity with the usual range of towers; an infinite limit means no limit.
#[derive(Debug, Clone, Copy)]
pub(super) struct Usual {
    quantity: Quantity,
    least: f64,
    most: f64,
}

impl Usual {
    pub(super) const fn new(quantity: Quantity, least: f64, most: f64) -> Self {
        Self {
            quantity,
            least,
            most,
        }
    }

    /// A quantity that has only a smallest value.
    pub(super) const fn at_least(quantity: Quantity, least: f64) -> Self {
        Self::new(quantity, least, f64::INFINITY)
    }

    /// A quantity that has only a largest value.
    pub(super) const fn at_most(quantity: Quantity, most: f64) -> Self {
        Self::new(quantity, f64::NEG_INFINITY, most)
    }

    pub(super) fn has(&self, value: f64) -> bool {
        (self.least..=self.most).contains(&value)
    }

    /// Warns if a value is outside the range; returns whether it is.
    pub(super) fn check(&self, value: f64, site: Site, warnings: &mut Vec<Warning>) -> bool {
        let is_outside = !self.has(value);
        if is_outside {
            warnings.push(self.warning(value, site));
        }
        is_outside
    }

    /// The ratio of a positive value to the nearest limit of the range; at most 1 inside the range.
    fn excess(&self, value: f64) -> f64 {
        (self.least / value).max(value / self.most)
    }

    fn warning(&self, value: f64, site: Site) -> Warning {
        let &Self {
            quantity,
            least,
            most,
        } = self;
        Warning::Unusual {
            quantity,
            site,
            value,
            least,
            most,
        }
    }
}

/// Warns about each value of a table that is outside its usual range (infinite values are not
/// checked), and about each value without effect because another value is missing.
pub(super) fn check_inputs(
    inputs: &dyn Inputs,
    at: impl Fn(&'static str) -> Place,
    warnings: &mut Vec<Warning>,
) {
    inputs.visit(&mut |input, given| {
        let finite = given.number().or(given.pair().map(checked_of_pair));
        let finite = finite.filter(|value| value.is_finite());
        if let (Some((quantity, [least, most])), Some(value)) = (input.usual, finite) {
            let usual = Usual::new(quantity, least, most);
            usual.check(value, Site::at(at(input.key)), warnings);
        }
    });
    for (Input { key, .. }, needed, remedy) in without_needed(inputs) {
        let (site, what) = (
            Site::at(at(key)),
            Ineffective::Without {
                key,
                needed,
                remedy,
            },
        );
        warnings.push(Warning::NoEffect { site, what });
    }
}

/// The value to check of those at top and bottom: the larger one, because the other may be zero;
/// but the smaller one if the ratio indicates another unit.
fn checked_of_pair([top, bottom]: [f64; 2]) -> f64 {
    let (smaller, larger) = (top.min(bottom), top.max(bottom));
    match smaller > 0.0 && smaller * OTHER_UNIT <= larger {
        true => smaller,
        false => larger,
    }
}

/// Largest ratio of the values at both ends of a layer: kPa in place of Pa is a factor of 1000.
const OTHER_UNIT: f64 = 300.0;

/// Warns about the positive value that is farthest outside its range, if there is one.
pub(super) fn check_worst(
    values: impl Iterator<Item = (Usual, f64, Site)>,
    warnings: &mut Vec<Warning>,
) {
    let outside = values.filter(|(usual, value, _)| !usual.has(*value));
    let worst = outside.max_by(|(a, x, _), (b, y, _)| a.excess(*x).total_cmp(&b.excess(*y)));
    warnings.extend(worst.map(|(usual, value, site)| usual.warning(value, site)));
}
