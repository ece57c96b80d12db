//! Frequencies at which the added mass of a floating platform, which depends on the frequency,
//! leaves the count uncertain.
//!
//! H decreases with the frequency where M + ½ w M′ is positive. Elsewhere an eigenvalue could cross
//! zero downwards and upwards again, so that the counts at both ends of an interval are equal
//! although the interval contains two frequencies. An interval is proved to contain no frequency
//! if matrices below and above H at all its frequencies have the same number of negative
//! eigenvalues: the matrices of [`Raise`] with bounds of the inertia of the base.

use super::super::equations::gyroscopic::Raise;
use super::super::equations::model::TurbineModel;
use crate::space::SpatialMatrix;

/// Number of times an interval is halved before the search ends.
const HALVINGS: usize = 6;

impl TurbineModel {
    /// Intervals below a limit, at a rotor speed (all rad/s), in which counts do not exclude
    /// further modes.
    pub(super) fn doubtful_in_water(&mut self, limit: f64, speed: f64) -> Vec<[f64; 2]> {
        let doubtful = self.below.water().map(|water| water.doubtful(limit));
        let mut doubtful = doubtful.unwrap_or_default();
        doubtful.retain(|interval| !self.is_empty_in_water(*interval, speed, HALVINGS));
        doubtful
    }

    /// Whether it is proved that no mode lies in an interval in which the added mass is linear.
    fn is_empty_in_water(&mut self, [from, to]: [f64; 2], speed: f64, halvings: usize) -> bool {
        let bounds = self
            .below
            .water()
            .and_then(|water| water.bounds([from, to]));
        let Some([least, most]) = bounds else {
            return false;
        };
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let (below, above) = (Raise::below(half), Raise::above(half));
        // Below: −to² M. Above: (half² − from²) M, which is less than nothing but near zero.
        let upper = if half < from { least } else { most };
        let at = (middle, speed);
        if self.count_with(most, at, below) == self.count_with(upper, at, above) {
            return true;
        }
        halvings > 0
            && self.is_empty_in_water([from, middle], speed, halvings - 1)
            && self.is_empty_in_water([middle, to], speed, halvings - 1)
    }

    /// The count with this inertia of the base instead of the inertia at the frequency.
    fn count_with(&mut self, inertia: SpatialMatrix, at: (f64, f64), raise: Raise) -> usize {
        self.fix_inertia(Some(inertia));
        let count = self.count_coupled(at, raise, self.is_locked);
        self.fix_inertia(None);
        count
    }

    fn fix_inertia(&mut self, inertia: Option<SpatialMatrix>) {
        if let Some(water) = self.below.water() {
            water.fixed = inertia;
        }
    }
}
