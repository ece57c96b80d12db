//! The same modes by different methods, identified by subsystem and order, because the position in
//! the list depends on the mesh.

use towermodes::Warning;
use towermodes::modes::{Family, Shares};
use towermodes::tower::Tower;
use towermodes::{Mode, ModeKey, Options, Solution, SolveError, Solver};

/// A mode that is followed from method to method.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FollowedMode {
    /// The kind of motion.
    pub family: Family,
    /// Order within the family, from 1.
    pub order: usize,
    /// Its name: "1st fore-aft bending", or "1st bending" for a pair.
    pub label: String,
    /// Whether the side-side mode of the same order has the same frequency; it is then not in the
    /// list.
    pub is_pair: bool,
    /// The frequency of the reference solution, Hz.
    pub frequency_hz: f64,
    /// The shares of the types of motion in its energy, in the reference solution.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub shares: Shares,
    /// The identity of the mode for any method: its family may differ between methods if motions
    /// are coupled.
    #[cfg_attr(feature = "serde", serde(skip))]
    key: ModeKey,
}

impl FollowedMode {
    /// The relative difference f/f_reference − 1 of a frequency (Hz); 0 if both are 0.
    fn relative_difference(&self, frequency_hz: Option<f64>) -> Option<f64> {
        match (frequency_hz?, self.frequency_hz) {
            (f, limit) if f == limit => Some(0.0),
            (_, 0.0) => None,
            (f, limit) => Some(f / limit - 1.0),
        }
    }

    /// Its frequency in a solution, Hz, if the solution has the mode.
    fn frequency_in(&self, solution: &Solution) -> Option<f64> {
        let mode = solution.modes.iter().find(|mode| mode.key() == self.key)?;
        Some(mode.frequency_hz)
    }
}

/// The frequency (Hz) of each followed mode in a solution, and its relative difference from the
/// reference; none if the solution lacks the mode.
pub(super) fn compared(
    modes: &[FollowedMode],
    solution: &Solution,
) -> (Vec<Option<f64>>, Vec<Option<f64>>) {
    let pair = |mode: &FollowedMode| {
        let frequency_hz = mode.frequency_in(solution);
        (frequency_hz, mode.relative_difference(frequency_hz))
    };
    modes.iter().map(pair).unzip()
}

/// The modes of a solution; a repeated pair is listed once.
pub(super) fn followed(tower: &Tower, solution: &Solution) -> Vec<FollowedMode> {
    let pairs = tower.planes_are_equal();
    let followed = |mode: &Mode| {
        let key = mode.key();
        let is_pair = pairs && key.subsystem == 0;
        FollowedMode {
            family: mode.family,
            order: mode.order,
            label: if is_pair {
                pair_label(mode)
            } else {
                mode.label()
            },
            is_pair,
            frequency_hz: mode.frequency_hz,
            shares: mode.shares,
            key,
        }
    };
    let modes = solution.modes.iter();
    modes
        .filter(|mode| !mode.key().is_turned)
        .map(followed)
        .collect()
}

/// The name of both modes of a pair.
fn pair_label(mode: &Mode) -> String {
    match mode.family {
        Family::Surge => "surge and sway".to_owned(),
        Family::Pitch => "pitch and roll".to_owned(),
        _ => mode.label().replace("fore-aft ", ""),
    }
}

/// Modes are searched up to this multiple of the highest followed frequency, …
pub(super) const REACH: f64 = 4.0;
/// … and among at most this many modes for each followed mode.
const MOST_FOR_EACH: usize = 16;

/// Solves until the list contains all followed modes, the tower has no more modes, or the missing
/// ones are outside these limits.
pub(super) fn solve_for(
    tower: &Tower,
    options: &Options,
    modes: &[FollowedMode],
    solver: &mut Solver,
) -> Result<Solution, SolveError> {
    let followed = modes.iter().map(|mode| 1 + usize::from(mode.is_pair)).sum();
    let options = Options {
        modes: followed,
        points: 2,
        ..options.clone()
    };
    let reach_hz = REACH * highest_hz(modes);
    let reaches = |solution: &Solution| {
        let mut frequencies = modes.iter().map(|mode| mode.frequency_in(solution));
        solution.certificate.below_hz > reach_hz || frequencies.all(|hz| hz.is_some())
    };
    solver.with(options, |solver| {
        let most = MOST_FOR_EACH * followed;
        solver.until(most, |solver| solver.solve(tower), reaches)
    })
}

/// The highest followed frequency, Hz.
fn highest_hz(modes: &[FollowedMode]) -> f64 {
    let frequencies_hz = modes.iter().map(|mode| mode.frequency_hz);
    frequencies_hz.fold(0.0, f64::max)
}

/// The warning that modes were not found although the tower has more modes than were computed.
pub(super) fn not_found(modes: &[FollowedMode], solution: &Solution) -> Option<Warning> {
    let missing = modes
        .iter()
        .filter(|mode| mode.frequency_in(solution).is_none());
    let missing = missing.count();
    let has_more = solution.modes.len() < solution.degrees_of_freedom;
    (missing > 0 && has_more).then_some(Warning::NotFound {
        method: solution.method,
        segments: solution.segments,
        missing,
        below_hz: solution.certificate.below_hz,
    })
}
