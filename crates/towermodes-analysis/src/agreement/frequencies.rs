//! The first bending frequencies of two towers.

use super::compared::Compared;
use super::{AgreementError, WhichTower};
use crate::verdict::Verdict;
use towermodes::Method;
use towermodes::modes::Family;
use towermodes::tower::Tower;
use towermodes::{Options, Solution, Solver};

/// The modes that are compared: all of them for a floating tower, otherwise those of the tower.
const WANTED: [(Family, usize); 10] = [
    (Family::Surge, 1),
    (Family::Sway, 1),
    (Family::Heave, 1),
    (Family::Roll, 1),
    (Family::Pitch, 1),
    (Family::Yaw, 1),
    (Family::ForeAft, 1),
    (Family::SideSide, 1),
    (Family::ForeAft, 2),
    (Family::SideSide, 2),
];

/// The modes to compare for these towers.
fn wanted(towers: [&Tower; 2]) -> &'static [(Family, usize)] {
    let floats = towers
        .into_iter()
        .any(|tower| tower.linear_platform().is_some());
    match floats {
        true => &WANTED,
        false => &WANTED[6..],
    }
}

/// Largest number of modes solved to find a mode: coupled motions may have other names.
const MOST_MODES: usize = 32;

/// The frequency of a mode of two towers.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ComparedFrequency {
    /// The name of the mode: "1st fore-aft bending".
    pub label: String,
    /// Frequency of the first tower, Hz; none if the tower has no such mode because its motions are
    /// coupled.
    pub first_hz: Option<f64>,
    /// Frequency of the second tower, Hz; none if the tower has no such mode because its motions
    /// are coupled.
    pub second_hz: Option<f64>,
    /// The relative difference second/first − 1, if both towers have the mode.
    pub difference: Option<f64>,
    /// The verdict on the difference; a mode of only one tower is a warning.
    pub verdict: Verdict,
}

/// The first two frequencies in each plane by the method spectral, and the rigid-body frequencies
/// of a floating platform, without modes that neither tower has.
pub(super) fn frequencies(
    towers: [&Tower; 2],
    rotary_inertia: bool,
    limit: f64,
) -> Result<Vec<ComparedFrequency>, AgreementError> {
    let wanted = wanted(towers);
    let options = Options {
        method: Method::Spectral,
        rotary_inertia,
        modes: wanted.len(),
        points: 2,
        ..Options::default()
    };
    let solved = |tower: &Tower, which: WhichTower| {
        let mut solver = Solver::new(options.clone());
        let has_all = |solution: &Solution| has_all(solution, wanted);
        let solution = solver.until(usize::MAX, |solver| solver.solve(tower), has_all);
        solution.map_err(|error| AgreementError::Solve { which, error })
    };
    let first = solved(towers[0], WhichTower::First)?;
    let second = solved(towers[1], WhichTower::Second)?;
    let modes = wanted.iter().map(|mode| {
        let hz = |solution: &Solution| Some(solution.mode(mode.0, mode.1)?.frequency_hz);
        compared(*mode, hz(&first), hz(&second), limit)
    });
    Ok(modes
        .filter(|mode| mode.first_hz.is_some() || mode.second_hz.is_some())
        .collect())
}

fn compared(
    (family, order): (Family, usize),
    first_hz: Option<f64>,
    second_hz: Option<f64>,
    limit: f64,
) -> ComparedFrequency {
    let both = first_hz.zip(second_hz);
    let compared = both.map(|(first, second)| Compared::ratio(first, second, limit));
    ComparedFrequency {
        label: family.label(order),
        first_hz,
        second_hz,
        difference: compared.map(|compared| compared.difference),
        verdict: compared.map_or(Verdict::Warn, |compared| compared.verdict),
    }
}

fn has_all(solution: &Solution, wanted: &[(Family, usize)]) -> bool {
    let is_there = |(family, order): &(Family, usize)| solution.mode(*family, *order).is_some();
    wanted.iter().all(is_there) || solution.modes.len() >= MOST_MODES
}
