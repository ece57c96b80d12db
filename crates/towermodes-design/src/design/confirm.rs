//! The tower found, solved as any tower: its frequencies, and that it meets all limits.

use towermodes::modes::Holders;
use towermodes::{
    Certificate, DEFAULT_SEGMENTS, Mode, ModeName, Options, Solution, Tower, TowerDescription,
};

use super::error::DesignError;
use super::moves::multiple;
use super::point::{End, tower_with};
use super::problem::Goal;
use super::scaled::Scale;
use super::steps::met_again;

/// Solves before a tower is given up that violates limits by rounding.
const MOST_ROUNDS: usize = 12;
/// A limit that is exceeded by less, scaled, is met: rounding of its sum.
const ROUNDING: f64 = 1e-12;
/// A violated limit is tightened by this many times the violation, and by this much more: the next
/// values are rounded anew.
const TIGHTER: (f64, f64) = (2.0, 2e-9);
/// More modes are not searched.
const MOST_MODES: usize = 64;

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
    /// The share of the family of its name in the energy of the mode.
    pub share: f64,
    /// The other modes that hold the name, by rising frequency: the band is theirs too.
    pub others: Vec<OtherHolder>,
}

/// A mode that holds the name of a goal beside the one that has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OtherHolder {
    /// Its own name.
    pub mode: ModeName,
    /// Its extrapolated frequency, Hz.
    pub hz: f64,
    /// The share of the goal's family in its energy.
    pub share: f64,
}

impl Reached {
    /// Whether the frequency of the mode, and of each other that holds its name, is in the band.
    pub fn is_met(&self) -> bool {
        let others = self.others.iter().map(|other| other.hz);
        let mut all = others.chain([self.after_hz]);
        all.all(|hz| self.goal.allows(hz))
    }
}

/// A tower found, with what a solve says about it.
pub(super) struct Confirmed {
    pub(super) values: Vec<f64>,
    pub(super) tower: TowerDescription,
    pub(super) reached: Vec<Reached>,
    pub(super) certificate: Certificate,
    /// The largest violation, scaled.
    violation: f64,
}

/// The tower with scaled values, written with few digits and solved. Where rounding, or the mesh of
/// the solve, violates a limit, the limit is tightened by as much and the tower is searched again.
pub(super) fn confirmed(
    scale: &mut Scale<'_>,
    mut scaled: Vec<f64>,
) -> Result<Confirmed, DesignError> {
    let before = Tower::new(scale.base.clone())?;
    let before = scale.solution(&before, &options(scale, None)).ok();
    let mut best: Option<Confirmed> = None;
    for _ in 0..MOST_ROUNDS {
        let (confirmed, limits) = solved(scale, &scaled, before.as_ref())?;
        let is_met = confirmed.violation <= ROUNDING;
        let is_better = |best: &Confirmed| confirmed.violation < best.violation;
        if best.as_ref().is_none_or(is_better) {
            best = Some(confirmed);
        }
        if is_met {
            break;
        }
        for (room, value) in scale.room.iter_mut().zip(limits) {
            if value > ROUNDING {
                *room += TIGHTER.0 * value + TIGHTER.1;
            }
        }
        scale.forget();
        match met_again(scale, &scaled)? {
            Some(next) => scaled = next,
            None => break,
        }
    }
    best.ok_or(DesignError::NoGoals)
}

/// How a tower is solved by `solve`: with its default number of segments, if that is finer than the
/// one of the design.
fn options(scale: &Scale<'_>, modes: Option<usize>) -> Options {
    let own = scale.options;
    let is_coarse = own
        .segments
        .is_some_and(|segments| segments < DEFAULT_SEGMENTS);
    Options {
        points: 2,
        heights_m: Vec::new(),
        segments: own.segments.filter(|_| !is_coarse),
        modes: modes.unwrap_or(own.modes),
        ..own.clone()
    }
}

/// The tower with scaled values, and its limits, scaled.
fn solved(
    scale: &mut Scale<'_>,
    scaled: &[f64],
    before: Option<&Solution>,
) -> Result<(Confirmed, Vec<f64>), DesignError> {
    let problem = scale.problem;
    let values = written(scale, scaled);
    let description = tower_with(problem, scale.base, &values);
    let tower = Tower::new(description.clone())?;
    let mut options = options(scale, None);
    loop {
        let after = scale.solution(&tower, &options)?;
        let is_last = options.modes >= MOST_MODES;
        let all = problem.goals.iter();
        let all = all.map(|goal| reached(goal, &after, before, is_last).ok_or(goal.mode));
        match all.collect::<Result<Vec<_>, ModeName>>() {
            Ok(all) => {
                let (reached, ends): (Vec<Reached>, Vec<[End; 2]>) = all.into_iter().unzip();
                let limits = scale.limit_values(&ends, &description);
                let confirmed = Confirmed {
                    violation: limits.iter().copied().fold(0.0, f64::max),
                    certificate: after.certificate,
                    tower: description,
                    values,
                    reached,
                };
                return Ok((confirmed, limits));
            }
            Err(mode) if is_last => {
                let modes = options.modes;
                return Err(DesignError::NoMode { mode, modes });
            }
            Err(_) => options.modes = (2 * options.modes).min(MOST_MODES),
        }
    }
}

/// What a solution has of a goal, and the lowest and the highest frequency of its holders; none if
/// the mode, or another holder, may be above the list.
fn reached(
    goal: &Goal,
    after: &Solution,
    before: Option<&Solution>,
    is_last: bool,
) -> Option<(Reached, [End; 2])> {
    let name = goal.mode;
    let modes = &after.modes;
    let holders = Holders::of(name, modes.iter().map(|mode| (mode.name(), &mode.shares)))?;
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

/// The values as they are written: steps, bounds, and other values with eight digits.
fn written(scale: &Scale<'_>, scaled: &[f64]) -> Vec<f64> {
    let values = scale.values(scaled);
    let pairs = scale.problem.variables.iter().zip(values);
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
