//! The same modes by different methods: what is followed is family and order, not the place in the
//! list, which meshes change.

use towermodes::Warning;
use towermodes::modes::Family;
use towermodes::tower::Tower;
use towermodes::{ModeKey, Options, Solution, SolveError, Workspace, solve_until};

/// A mode that is followed from method to method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FollowedMode {
    /// The kind of motion.
    pub family: Family,
    /// Order within the family, from 1.
    pub order: usize,
    /// The frequency that the others are compared with, that of the spectral beam, Hz.
    pub frequency_hz: f64,
    /// Whether the side-side mode of the same order has this frequency too; it is not followed
    /// then.
    pub is_pair: bool,
    /// Which mode it is by any method: families may change from one to another where motions are
    /// coupled.
    key: ModeKey,
}

impl FollowedMode {
    /// What it is: "1st fore-aft bending", or "1st bending" for a pair.
    pub fn label(&self) -> String {
        let label = self.family.label(self.order);
        if self.is_pair {
            match self.family {
                Family::Surge => "surge and sway".to_owned(),
                Family::Pitch => "pitch and roll".to_owned(),
                _ => label.replace("fore-aft ", ""),
            }
        } else {
            label
        }
    }

    /// f/f_mode − 1 of a frequency (Hz) that it has elsewhere; 0 if both are, as of motions that
    /// nothing resists.
    pub(super) fn relative_difference(&self, frequency_hz: Option<f64>) -> Option<f64> {
        match (frequency_hz?, self.frequency_hz) {
            (f, limit) if f == limit => Some(0.0),
            (_, 0.0) => None,
            (f, limit) => Some(f / limit - 1.0),
        }
    }

    /// Its frequency in a solution, if it is there, Hz.
    pub(super) fn frequency_in(&self, solution: &Solution) -> Option<f64> {
        let mode = solution.modes.iter().find(|mode| mode.key() == self.key)?;
        Some(mode.frequency_hz)
    }
}

/// The modes of a solution, a pair once.
pub(super) fn followed(tower: &Tower, solution: &Solution) -> Vec<FollowedMode> {
    let pairs = tower.planes_are_equal();
    let modes = solution.modes.iter();
    modes
        .filter(|mode| !mode.key().is_turned)
        .map(|mode| FollowedMode {
            family: mode.family,
            order: mode.order,
            frequency_hz: mode.frequency_hz,
            is_pair: pairs && mode.key().subsystem == 0,
            key: mode.key(),
        })
        .collect()
}

/// Modes that are not there below so many times the highest frequency that is followed are not
/// looked for above.
pub(super) const REACH: f64 = 4.0;
/// … and no more modes than this for each one that is followed are looked for.
const MOST_FOR_EACH: usize = 16;

/// Solves until all that are followed are there, there are no more, or what is missing is too far
/// off to be one of them.
pub(super) fn solve_for(
    tower: &Tower,
    options: &Options,
    modes: &[FollowedMode],
    workspace: &mut Workspace,
) -> Result<Solution, SolveError> {
    let followed = modes.iter().map(|mode| 1 + usize::from(mode.is_pair)).sum();
    let options = Options {
        modes: followed,
        ..options.clone()
    };
    let reach_hz = REACH * highest_hz(modes);
    solve_until(tower, &options, workspace, |solution| {
        let has_all = modes
            .iter()
            .all(|mode| mode.frequency_in(solution).is_some());
        let is_beyond = solution.certificate.below_hz > reach_hz;
        has_all || is_beyond || solution.modes.len() >= MOST_FOR_EACH * followed
    })
}

/// The highest frequency that is followed, Hz.
fn highest_hz(modes: &[FollowedMode]) -> f64 {
    let frequencies_hz = modes.iter().map(|mode| mode.frequency_hz);
    frequencies_hz.fold(0.0, f64::max)
}

/// Says that modes were not found, though a solution has more than were looked at.
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
