//! The inertia of the base of a floating tower by frequency.

use std::sync::Arc;

use super::super::parts::added_mass::AddedMassTable;
use super::super::parts::floating_platform::FloatingPlatform;
use super::base::{Base, symmetrized};
use crate::space::{SpatialMatrix, add_scaled, transform_matrix};
use crate::symmetric::eigenpairs;

/// The inertia that moves with a base: a constant part, and the added mass by frequency.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct InertiaByFrequency {
    table: Arc<AddedMassTable>,
    /// Height of the reference point of the table above the base, m.
    rise_m: f64,
    /// The inertia without the table, for the motion of the base.
    constant: SpatialMatrix,
}

impl InertiaByFrequency {
    /// The inertia of a platform under a tower with its base at `base_m`; none if its added mass
    /// does not depend on frequency.
    pub(crate) fn of(platform: &FloatingPlatform, base_m: f64) -> Option<Self> {
        let table = platform.added_mass_by_frequency.clone()?;
        let without = FloatingPlatform {
            added_mass_by_frequency: None,
            ..platform.clone()
        };
        Some(Self {
            table,
            rise_m: platform.added_mass.height_m - base_m,
            constant: Base::afloat(&without, base_m, 0.0).inertia,
        })
    }

    /// The matrices of the table.
    pub(crate) fn matrices(&self) -> impl Iterator<Item = &SpatialMatrix> + Clone {
        self.table.matrices()
    }

    /// The end of the interval around a frequency in which the added mass is linear; none where it
    /// is constant. Both are angular, rad/s.
    pub(crate) fn end_of_interval(&self, frequency: f64) -> Option<f64> {
        let mut intervals = self.table.intervals();
        intervals.find(|[_, to]| frequency < *to).map(|[_, to]| to)
    }

    /// The inertia at an angular frequency, rad/s.
    pub(crate) fn at(&self, frequency: f64) -> SpatialMatrix {
        let mut added = symmetrized(&self.table.at(frequency));
        transform_matrix(&mut added, self.rise_m);
        let mut sum = self.constant;
        add_scaled(&mut sum, 1.0, &added);
        sum
    }

    /// The intervals of angular frequency below a limit, rad/s, in which more than one mode of the
    /// same order may be: M + A + ½ω dA/dω is not positive definite at one of their ends.
    ///
    /// The stiffness less ω² times the inertia decreases with ω where that is positive definite. It
    /// is linear in ω between the ends. The tower adds inertia to that of the base tested here.
    pub(crate) fn not_monotone_below(&self, limit: f64) -> Vec<[f64; 2]> {
        let intervals = self.table.intervals().take_while(|[from, _]| *from < limit);
        let is_doubtful = |[from, to]: &[f64; 2]| {
            let ends = [self.at(*from), self.at(*to)];
            let slope = scaled_difference(&ends, 1.0 / (to - from));
            let tests = [*from, *to].into_iter().zip(&ends);
            !tests.into_iter().all(|(frequency, inertia)| {
                let mut sum = *inertia;
                add_scaled(&mut sum, 0.5 * frequency, &slope);
                is_positive_definite(&sum)
            })
        };
        intervals
            .filter(is_doubtful)
            .map(|[from, to]| [from, to.min(limit)])
            .collect()
    }

    /// Matrices below and above the inertia at all frequencies between two (rad/s) of one interval,
    /// in the sense of differences that are not negative; none if the lower one is not positive
    /// definite.
    pub(crate) fn bounds(&self, [from, to]: [f64; 2]) -> Option<[SpatialMatrix; 2]> {
        let ends = [self.at(from), self.at(to)];
        // Units in which all inertias have a similar size make the bounds narrow.
        let units: [f64; 6] = std::array::from_fn(|i| ends[0][i][i].abs().sqrt());
        if units.contains(&0.0) {
            return None;
        }
        let difference = scaled_difference(&ends, 1.0);
        let scaled: SpatialMatrix = std::array::from_fn(|i| {
            std::array::from_fn(|j| difference[i][j] / (units[i] * units[j]))
        });
        let (values, vectors) = eigenpairs(scaled);
        let mut bounds = [ends[0]; 2];
        for (value, vector) in values.iter().zip(&vectors) {
            let bound = &mut bounds[usize::from(*value > 0.0)];
            for i in 0..6 {
                for j in 0..6 {
                    bound[i][j] += value * units[i] * vector[i] * units[j] * vector[j];
                }
            }
        }
        is_positive_definite(&bounds[0]).then_some(bounds)
    }
}

/// A factor times the second matrix minus the first.
fn scaled_difference([first, second]: &[SpatialMatrix; 2], factor: f64) -> SpatialMatrix {
    std::array::from_fn(|i| std::array::from_fn(|j| factor * (second[i][j] - first[i][j])))
}

/// Decides by the signs of the pivots; a pivot within rounding errors is not positive.
fn is_positive_definite(matrix: &SpatialMatrix) -> bool {
    const ROUNDING: f64 = 1e-12;
    let mut rest = *matrix;
    for pivot in 0..6 {
        let own = rest[pivot][pivot];
        let is_positive = own > ROUNDING * matrix[pivot][pivot].abs();
        if !is_positive {
            return false;
        }
        let of_pivot = rest[pivot];
        for row in &mut rest[pivot + 1..] {
            let factor = row[pivot] / own;
            for (entry, of_pivot) in row.iter_mut().zip(of_pivot).skip(pivot + 1) {
                *entry -= factor * of_pivot;
            }
        }
    }
    true
}
