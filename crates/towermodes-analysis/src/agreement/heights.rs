//! Mass and bending stiffness of two towers by height, and the largest differences.

use super::columns::{Columns, HeightRange};
use super::compared::{AgreementLimits, Compared};
use towermodes::tower::Planes;

/// Number of listed heights, besides those of the largest differences.
const LISTED_HEIGHTS: usize = 21;
/// Values by height are averages over this fraction of the height, so that a step that is 1 mm
/// higher in one file makes no difference.
const WINDOW: f64 = 0.01;
/// Number of equal intervals at whose ends the largest difference is searched, besides all
/// stations.
const SEARCHED: usize = 1000;

/// Both towers at a height.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct AgreementRow {
    /// The height in the datum of the stations, m.
    pub height_m: f64,
    /// Mass per length, kg/m: the average over `window_m` around the height.
    pub mass_kg_per_m: Compared,
    /// Bending stiffness EI, N m², averaged in the same way.
    pub bending_n_m2: Planes<Compared>,
    /// Mass from the base of the overlap up to this height with point masses, kg. The difference is
    /// a fraction of the whole mass of the first tower.
    pub mass_below_kg: Compared,
}

/// The largest difference of a quantity along the height.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LargestDifference {
    /// The height of the largest difference, m.
    pub height_m: f64,
    /// The values at this height.
    pub compared: Compared,
}

/// Two towers over their common heights.
pub(super) struct Heights<'a> {
    pub(super) columns: [&'a Columns<'a>; 2],
    pub(super) overlap: HeightRange,
    pub(super) limits: AgreementLimits,
}

impl Heights<'_> {
    /// Length over which the values are averaged, m.
    pub(super) fn window_m(&self) -> f64 {
        WINDOW * self.overlap.length_m()
    }

    /// The window around a height, shifted into the overlap at its ends.
    fn window(&self, height_m: f64) -> HeightRange {
        let HeightRange { base_m, top_m } = self.overlap;
        let half_m = 0.5 * self.window_m();
        // The ends are in order: the window is a hundredth of the distance between them.
        let middle_m = height_m.max(base_m + half_m).min(top_m - half_m);
        HeightRange {
            base_m: (middle_m - half_m).max(base_m),
            top_m: (middle_m + half_m).min(top_m),
        }
    }

    /// Averages of mass per length and EI of both towers over the window around a height.
    fn means(&self, height_m: f64) -> (Compared, Planes<Compared>) {
        let window = self.window(height_m);
        let [first, second] = self.columns.map(|columns| columns.means(window));
        let bending = |a, b| Compared::ratio(a, b, self.limits.stiffness);
        (
            Compared::ratio(first.0, second.0, self.limits.mass),
            first.1.zip(second.1, bending),
        )
    }

    /// The largest differences of mass per length and EI at any height; of equal ones the lowest.
    pub(super) fn largest(
        &self,
        stations_m: &[f64],
    ) -> (LargestDifference, Planes<LargestDifference>) {
        let at = |height_m: f64| {
            let (mass, bending) = self.means(height_m);
            let found = |compared| LargestDifference { height_m, compared };
            (found(mass), bending.map(found))
        };
        let half_m = 0.5 * self.window_m();
        let lowest_m = self.overlap.base_m + half_m;
        self.searched_m(stations_m).into_iter().map(at).fold(
            at(lowest_m),
            |(mass, bending), (other_mass, other_bending)| {
                (larger(mass, other_mass), bending.zip(other_bending, larger))
            },
        )
    }

    /// Heights at which the largest difference can occur: averages over windows have kinks where a
    /// window begins or ends at a station.
    fn searched_m(&self, stations_m: &[f64]) -> Vec<f64> {
        let half_m = 0.5 * self.window_m();
        let HeightRange { base_m, top_m } = self.overlap;
        let around = |z: &f64| [*z - half_m, *z, *z + half_m];
        let mut heights_m: Vec<f64> = self.overlap.heights_m(SEARCHED + 1).collect();
        heights_m.extend(stations_m.iter().flat_map(around));
        heights_m.retain(|z| (base_m + half_m..=top_m - half_m).contains(z));
        heights_m.sort_by(f64::total_cmp);
        heights_m.dedup();
        heights_m
    }

    /// Rows at equally spaced heights and at other heights.
    pub(super) fn rows(&self, others_m: &[f64]) -> Vec<AgreementRow> {
        let mut heights_m: Vec<f64> = self.overlap.heights_m(LISTED_HEIGHTS).collect();
        heights_m.extend(others_m);
        heights_m.sort_by(f64::total_cmp);
        heights_m.dedup_by(|a, b| (*a - *b).abs() < 1e-6 * self.overlap.length_m());
        let whole_kg = self.columns[0].mass(self.overlap).0;
        let row = |height_m: f64| {
            let (mass_kg_per_m, bending_n_m2) = self.means(height_m);
            let below = HeightRange {
                top_m: height_m,
                ..self.overlap
            };
            let [first, second] = self.columns.map(|columns| columns.mass(below).0);
            AgreementRow {
                height_m,
                mass_kg_per_m,
                bending_n_m2,
                mass_below_kg: Compared::on_scale(first, second, whole_kg, self.limits.mass),
            }
        };
        heights_m.into_iter().map(row).collect()
    }
}

fn larger(found: LargestDifference, other: LargestDifference) -> LargestDifference {
    let size = |largest: &LargestDifference| largest.compared.difference.abs();
    if size(&other) > size(&found) {
        other
    } else {
        found
    }
}
