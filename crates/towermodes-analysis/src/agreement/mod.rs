//! Agreement of two descriptions of one tower, and the values of one description.
//!
//! Files of different programs describe the same steel by different columns, rows and steps.
//! Therefore the comparison uses the quantities that determine a beam: mass and bending stiffness
//! EI by height, and the resulting frequencies.

mod bare;
mod columns;
mod comparable;
mod compared;
mod examination;
mod frequencies;
mod heights;
mod pair;
mod parts;
#[cfg(test)]
mod tests;

use crate::verdict::Verdict;
pub use columns::HeightRange;
pub use comparable::{Omitted, omit_one_sided};
pub use compared::{AgreementLimits, Compared};
pub use examination::{Examination, ExaminationRow, examine};
pub use frequencies::ComparedFrequency;
pub use heights::{AgreementRow, LargestDifference};
pub use pair::agree;
pub use parts::ComparedPart;

use std::fmt;

use thiserror::Error;

use columns::is_same_height;
use towermodes::SolveError;
use towermodes::tower::{Planes, TowerError};

/// One of two compared towers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WhichTower {
    /// The first tower, which is the reference.
    First,
    /// The second tower.
    Second,
}

impl fmt::Display for WhichTower {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::First => "first",
            Self::Second => "second",
        })
    }
}

/// Why two towers cannot be compared.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum AgreementError {
    /// A description is invalid.
    #[error("the {which} tower: {error}")]
    Tower {
        /// Which of the two towers.
        which: WhichTower,
        /// The invalid value.
        #[source]
        error: TowerError,
    },
    /// A tower cannot be solved.
    #[error("the {which} tower: {error}")]
    Solve {
        /// Which of the two towers.
        which: WhichTower,
        /// The error of the solver.
        #[source]
        error: SolveError,
    },
    /// The height ranges of the towers do not overlap.
    #[error(
        "the height ranges of the towers do not overlap: the first reaches from {} m to {} m, the second from {} m to {} m",
        ranges[0].base_m, ranges[0].top_m, ranges[1].base_m, ranges[1].top_m
    )]
    NothingShared {
        /// The heights of each tower.
        ranges: [HeightRange; 2],
    },
}

/// The comparison of two towers over their common heights.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Agreement {
    /// The worst verdict. Different end heights give at least WARN, and FAIL if more than a
    /// hundredth of the height of one tower is outside the other.
    pub verdict: Verdict,
    /// The heights of the first tower.
    pub first_range: HeightRange,
    /// The heights of the second tower.
    pub second_range: HeightRange,
    /// The common heights. All values but `frequencies_as_given` refer to these.
    pub overlap: HeightRange,
    /// The distance by which the second tower must be lowered to have the heights of the first, m,
    /// if both are equally long but at different heights: their datums may differ.
    pub shift_m: Option<f64>,
    /// Length over which the values by height are averaged, m.
    pub window_m: f64,
    /// Mass with outfitting and point masses, kg.
    pub mass_kg: Compared,
    /// Point masses included in the mass, kg. The difference is a fraction of the mass of the first
    /// tower. It does not affect the verdict: one file may give as point masses what the other
    /// includes in its wall.
    pub point_masses_kg: Compared,
    /// Height of the centre of mass, m. The difference is a fraction of the length of the overlap.
    pub center_of_mass_m: Compared,
    /// Bending deflection of the top of the overlap by a unit force there, clamped at its base,
    /// m/N.
    pub tip_flexibility_m_per_n: Planes<Compared>,
    /// The largest difference in mass per length, kg/m.
    pub largest_mass: LargestDifference,
    /// The largest difference in bending stiffness EI, N m².
    pub largest_bending: Planes<LargestDifference>,
    /// Values by height: at equally spaced heights, and at the largest differences.
    pub rows: Vec<AgreementRow>,
    /// Quantities of rotor-nacelle assembly, substructure, platform, moorings and water; a quantity
    /// that neither tower has is not listed.
    pub parts: Vec<ComparedPart>,
    /// The first frequencies of the overlap, clamped, with its point masses only: Euler-Bernoulli
    /// beams without rotary inertia, shear deformation and gravity, because the files of some
    /// programs do not contain these.
    pub frequencies_bare: Vec<ComparedFrequency>,
    /// The first frequencies of both whole towers as described, with rotor-nacelle assembly,
    /// foundation, surroundings, rotary inertia and shear deformation, also for floating platforms;
    /// empty if neither tower has a rotor-nacelle assembly, a foundation, surroundings or gravity.
    pub frequencies_as_given: Vec<ComparedFrequency>,
}

/// The fraction of a tower that may be outside the other without a verdict FAIL.
const FEW: f64 = 0.01;

impl Agreement {
    /// Whether both towers have the same ends within 1 mm.
    pub fn ranges_agree(&self) -> bool {
        let (first, second) = (&self.first_range, &self.second_range);
        is_same_height(first.base_m, second.base_m) && is_same_height(first.top_m, second.top_m)
    }

    /// The fraction of the longer tower that is outside the other.
    pub fn uncompared_share(&self) -> f64 {
        let lengths_m = [&self.first_range, &self.second_range].map(HeightRange::length_m);
        1.0 - self.overlap.length_m() / lengths_m.into_iter().fold(0.0, f64::max)
    }

    /// The verdict on the heights: WARN for different ends, FAIL if more than a hundredth of one
    /// tower is outside the other.
    pub fn ranges_verdict(&self) -> Verdict {
        if self.ranges_agree() {
            Verdict::Pass
        } else if self.uncompared_share() <= FEW {
            Verdict::Warn
        } else {
            Verdict::Fail
        }
    }

    /// The [`verdict`](Self::verdict) that follows from all other values.
    fn worst(&self) -> Verdict {
        let (tip, bending) = (&self.tip_flexibility_m_per_n, &self.largest_bending);
        let compared = [
            &self.mass_kg,
            &self.center_of_mass_m,
            &tip.fore_aft,
            &tip.side_side,
            &self.largest_mass.compared,
            &bending.fore_aft.compared,
            &bending.side_side.compared,
        ];
        let below = self.rows.iter().map(|row| row.mass_below_kg.verdict);
        let modes = self.frequencies_bare.iter();
        let modes = modes.chain(&self.frequencies_as_given);
        compared
            .into_iter()
            .map(|compared| compared.verdict)
            .chain(below)
            .chain(modes.map(|mode| mode.verdict))
            .chain(self.parts.iter().map(|part| part.verdict))
            .fold(self.ranges_verdict(), Verdict::max)
    }
}
