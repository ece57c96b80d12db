//! Two descriptions of one tower: whether they agree, and where they do not.
//!
//! Two files of different programs may describe the same steel by different columns, rows and
//! steps. What is compared is what a beam feels of them: masses and EI by height, and the
//! frequencies that follow.

mod bare;
mod columns;
mod compared;
mod examination;
mod frequencies;
mod heights;
mod pair;
#[cfg(test)]
mod tests;

use crate::verdict::Verdict;
pub use columns::HeightRange;
pub use compared::{AgreementLimits, Compared};
pub use examination::{Examination, ExaminationRow, examine};
pub use frequencies::ComparedFrequency;
pub use heights::{AgreementRow, LargestDifference};
pub use pair::agree;

use std::fmt;

use thiserror::Error;

use columns::is_same_height;
use towermodes::SolveError;
use towermodes::tower::{Planes, TowerError};

/// Which of two towers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WhichTower {
    /// The one that the other is compared with.
    First,
    /// The other.
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
    /// A description is none of a tower.
    #[error("the {which} tower: {error}")]
    Tower {
        /// Which of the two.
        which: WhichTower,
        /// What is wrong.
        #[source]
        error: TowerError,
    },
    /// A tower cannot be solved.
    #[error("the {which} tower: {error}")]
    Solve {
        /// Which of the two.
        which: WhichTower,
        /// Why.
        #[source]
        error: SolveError,
    },
    /// No height is on both.
    #[error(
        "the towers share no height: the first reaches from {} m to {} m, the second from {} m to {} m",
        ranges[0].base_m, ranges[0].top_m, ranges[1].base_m, ranges[1].top_m
    )]
    NothingShared {
        /// From where to where each reaches.
        ranges: [HeightRange; 2],
    },
}

/// How two towers compare over the heights they share.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Agreement {
    /// The worst verdict of all. Towers that do not have the same ends are at least a warning, and
    /// fail if more than a hundredth of one is not in the other.
    pub verdict: Verdict,
    /// The heights of the first tower.
    pub first_range: HeightRange,
    /// The heights of the second tower.
    pub second_range: HeightRange,
    /// The heights they share, to which all but
    /// [`frequencies_as_given`](Self::frequencies_as_given) refers.
    pub overlap: HeightRange,
    /// How far the second must be lowered for both to reach from one height to one, m, if they are
    /// equally long and not at one height: they may have different datums.
    pub shift_m: Option<f64>,
    /// Length that values by height are means over, m.
    pub window_m: f64,
    /// Mass with outfitting and point masses, kg.
    pub mass_kg: Compared,
    /// The point masses in it, kg; the difference is a share of the first tower's mass, and no part
    /// of the verdict: what one file has as point masses the other may have in its wall.
    pub point_masses_kg: Compared,
    /// Height of the centre of mass, m; the difference is a share of the overlap's length.
    pub center_of_mass_m: Compared,
    /// Deflection of the overlap's top by a unit force there, from bending, if its base is clamped,
    /// m/N.
    pub tip_flexibility_m_per_n: Planes<Compared>,
    /// Where the masses per length (kg/m) are furthest apart.
    pub largest_mass: LargestDifference,
    /// Where EI (N m²) is furthest apart.
    pub largest_bending: Planes<LargestDifference>,
    /// By height: at equal distances, and where they are furthest apart.
    pub rows: Vec<AgreementRow>,
    /// The first frequencies of the overlap, clamped, with its point masses and nothing else:
    /// Euler-Bernoulli beams without rotary inertia, shear deformation and weights, because the
    /// files of some programs have none of these.
    pub frequencies_bare: Vec<ComparedFrequency>,
    /// The first frequencies of both whole towers as they are described, with machine, foundation,
    /// surroundings, rotary inertia and shear deformation; none if neither has a machine, a
    /// foundation, surroundings or weights.
    pub frequencies_as_given: Vec<ComparedFrequency>,
}

/// The share of a tower that the other may lack.
const FEW: f64 = 0.01;

impl Agreement {
    /// Whether both towers reach from one height to one, within 1 mm.
    pub fn ranges_agree(&self) -> bool {
        let (first, second) = (&self.first_range, &self.second_range);
        is_same_height(first.base_m, second.base_m) && is_same_height(first.top_m, second.top_m)
    }

    /// How much of the longer tower the other has no part of.
    pub fn uncompared_share(&self) -> f64 {
        let lengths_m = [&self.first_range, &self.second_range].map(HeightRange::length_m);
        1.0 - self.overlap.length_m() / lengths_m.into_iter().fold(0.0, f64::max)
    }

    /// The [`verdict`](Self::verdict) that follows from all other values.
    fn worst(&self) -> Verdict {
        let ranges = if self.ranges_agree() {
            Verdict::Pass
        } else if self.uncompared_share() <= FEW {
            Verdict::Warn
        } else {
            Verdict::Fail
        };
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
            .fold(ranges, Verdict::max)
    }
}
