//! The first bending frequencies of two towers.

use super::compared::Compared;
use super::{AgreementError, WhichTower};
use crate::verdict::Verdict;
use towermodes::Method;
use towermodes::modes::Family;
use towermodes::solve_until;
use towermodes::tower::Tower;
use towermodes::{Options, Solution, Workspace};

/// The modes that are compared.
const WANTED: [(Family, usize); 4] = [
    (Family::ForeAft, 1),
    (Family::SideSide, 1),
    (Family::ForeAft, 2),
    (Family::SideSide, 2),
];

/// A mode that is not among so many is not looked for further: coupled motions have other names.
const MOST_MODES: usize = 32;

/// The frequency of a mode of two towers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComparedFrequency {
    /// The kind of motion.
    pub family: Family,
    /// Order within the family, from 1.
    pub order: usize,
    /// Those of the first and the second tower, Hz; none where coupled motions have no such mode.
    pub frequencies_hz: [Option<f64>; 2],
    /// Both, if both are there.
    pub compared: Option<Compared>,
}

impl ComparedFrequency {
    /// What it is: "1st fore-aft bending".
    pub fn label(&self) -> String {
        self.family.label(self.order)
    }

    /// What the difference is worth; a mode that only one tower has is a warning.
    pub fn verdict(&self) -> Verdict {
        self.compared
            .map_or(Verdict::Warn, |compared| compared.verdict)
    }
}

/// The first two frequencies in each plane, by the spectral beam; those that neither tower has are
/// left out.
pub(super) fn frequencies(
    towers: [&Tower; 2],
    rotary_inertia: bool,
    limit: f64,
) -> Result<Vec<ComparedFrequency>, AgreementError> {
    let options = Options {
        method: Method::Spectral,
        rotary_inertia,
        modes: WANTED.len(),
        ..Options::default()
    };
    let mut workspace = Workspace::default();
    let mut solved = |tower: &Tower, which: WhichTower| {
        solve_until(tower, &options, &mut workspace, has_all)
            .map_err(|error| AgreementError::Solve { which, error })
    };
    let first = solved(towers[0], WhichTower::First)?;
    let second = solved(towers[1], WhichTower::Second)?;
    let compared = |(family, order): (Family, usize)| {
        let frequency = |solution: &Solution| Some(solution.mode(family, order)?.frequency_hz);
        let frequencies_hz = [frequency(&first), frequency(&second)];
        ComparedFrequency {
            family,
            order,
            frequencies_hz,
            compared: match frequencies_hz {
                [Some(first), Some(second)] => Some(Compared::ratio(first, second, limit)),
                _ => None,
            },
        }
    };
    let modes = WANTED.into_iter().map(compared);
    Ok(modes
        .filter(|mode| mode.frequencies_hz != [None, None])
        .collect())
}

fn has_all(solution: &Solution) -> bool {
    let is_there = |(family, order): &(Family, usize)| solution.mode(*family, *order).is_some();
    WANTED.iter().all(is_there) || solution.modes.len() >= MOST_MODES
}
