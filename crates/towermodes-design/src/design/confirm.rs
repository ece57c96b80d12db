//! The tower that was found, solved with the options of `solve`: its frequencies, and whether it
//! meets all limits.

use towermodes::modes::Holders;
use towermodes::{
    Certificate, DEFAULT_SEGMENTS, Mode, ModeName, Options, Solution, Tower, TowerDescription,
};

use super::error::DesignError;
use super::problem::Goal;
use super::steps::multiple;
use super::towers::{End, Towers};

/// A goal and the frequency of the tower that was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Reached {
    /// The goal.
    pub goal: Goal,
    /// The frequency of the original tower, Hz; none if it has no such mode.
    pub before_hz: Option<f64>,
    /// The extrapolated frequency of the tower found, Hz.
    pub after_hz: f64,
    /// The error of its discretization and computation, without extrapolation, Hz.
    pub error_hz: f64,
    /// The share of the type of motion that its name states in the energy of the mode.
    pub share: f64,
    /// The other modes that share the motion of the named mode, by increasing frequency, if the
    /// named mode is coupled: the band applies to them too.
    pub others: Vec<OtherHolder>,
}

/// A mode that shares the motion of the mode of a goal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OtherHolder {
    /// The name of this mode.
    pub mode: ModeName,
    /// Its extrapolated frequency, Hz.
    pub hz: f64,
    /// The share of the goal's type of motion in its energy.
    pub share: f64,
}

impl Reached {
    /// Whether the frequency of the mode, and of each other mode to which the band applies, is in
    /// the band.
    pub fn is_met(&self) -> bool {
        let others = self.others.iter().map(|other| other.hz);
        let mut all = others.chain([self.after_hz]);
        all.all(|hz| self.goal.allows(hz))
    }
}

/// A tower that was found, with the results of its solution.
pub(super) struct Confirmed {
    pub(super) values: Vec<f64>,
    pub(super) tower: TowerDescription,
    pub(super) reached: Vec<Reached>,
    pub(super) certificate: Certificate,
    /// The limits, scaled: positive if they are violated.
    pub(super) limits: Vec<f64>,
}

impl Confirmed {
    /// The largest violation.
    pub(super) fn violation(&self) -> f64 {
        self.limits.iter().copied().fold(0.0, f64::max)
    }
}

/// The solution of the original tower with the options of `solve`; none if it cannot be solved.
pub(super) fn original(towers: &mut Towers<'_>) -> Option<Solution> {
    let tower = Tower::new(towers.base.clone()).ok()?;
    let options = options(towers);
    towers.solution(&tower, options, |_| true).ok()
}

/// The options of `solve` for a tower: its default number of segments, if this number is larger
/// than that of the design.
fn options(towers: &Towers<'_>) -> Options {
    let own = towers.options;
    Options {
        points: 2,
        heights_m: Vec::new(),
        segments: own
            .segments
            .filter(|segments| *segments >= DEFAULT_SEGMENTS),
        ..own.clone()
    }
}

/// The tower with scaled values, rounded as they are written, and solved.
pub(super) fn confirmed(
    towers: &mut Towers<'_>,
    scaled: &[f64],
    before: Option<&Solution>,
) -> Result<Confirmed, DesignError> {
    let values = written(towers, scaled);
    let description = towers.problem.tower(towers.base, &values);
    let tower = Tower::new(description.clone())?;
    let goals = &towers.problem.goals;
    let has_all = |after: &Solution| {
        let mut goals = goals.iter();
        goals.all(|goal| reached(goal, after, before, false).is_some())
    };
    let after = towers.solution(&tower, options(towers), has_all)?;
    let all = goals.iter().map(|goal| {
        let reached = reached(goal, &after, before, true);
        reached.ok_or(DesignError::NoMode {
            mode: goal.mode,
            modes: after.modes.len(),
        })
    });
    let all = all.collect::<Result<Vec<_>, DesignError>>()?;
    let (reached, ends): (Vec<Reached>, Vec<[End; 2]>) = all.into_iter().unzip();
    Ok(Confirmed {
        limits: towers.limit_values(&ends, &description),
        certificate: after.certificate,
        tower: description,
        values,
        reached,
    })
}

/// The modes of a solution to which a goal applies: those with the lowest and the highest
/// frequency; none if one of these modes may be above the list.
fn reached(
    goal: &Goal,
    after: &Solution,
    before: Option<&Solution>,
    is_last: bool,
) -> Option<(Reached, [End; 2])> {
    let name = goal.mode;
    let modes = &after.modes;
    let holders = Holders::bound(name, modes.iter().map(|mode| (mode.name(), &mode.shares)))?;
    if !holders.is_complete && !is_last {
        return None;
    }
    let end = |mode: &Mode| End {
        mode: mode.name(),
        hz: mode.extrapolated_hz,
    };
    let ends = || holders.places.iter().map(|place| end(&modes[*place]));
    let by_hz = |a: &End, b: &End| a.hz.total_cmp(&b.hz);
    let others = holders.others().map(|place| OtherHolder {
        mode: modes[place].name(),
        hz: modes[place].extrapolated_hz,
        share: modes[place].shares.of(name.family),
    });
    let own = &modes[holders.named];
    let before = before.and_then(|before| before.mode(name.family, name.order));
    let reached = Reached {
        goal: *goal,
        before_hz: before.map(|mode| mode.extrapolated_hz),
        after_hz: own.extrapolated_hz,
        error_hz: own.error_hz(),
        share: own.share(),
        others: others.collect(),
    };
    Some((reached, [ends().min_by(by_hz)?, ends().max_by(by_hz)?]))
}

/// The values as they are written: stepped values and bounds exactly, other values with eight
/// digits.
fn written(towers: &Towers<'_>, scaled: &[f64]) -> Vec<f64> {
    let values = towers.values(scaled);
    let pairs = towers.problem.variables.iter().zip(values);
    pairs
        .map(|(variable, value)| match variable.step {
            Some(step) => multiple((value / step).round(), step),
            None => eight_digits(value).clamp(variable.low, variable.high),
        })
        .collect()
}

fn eight_digits(value: f64) -> f64 {
    format!("{value:.7e}").parse().unwrap_or(value)
}
