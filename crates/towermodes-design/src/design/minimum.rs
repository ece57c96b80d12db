//! Minima by sequential least squares programming (Kraft 1988; the library `slsqp`), and the least
//! violation where no tower meets all limits.

use std::cell::RefCell;

use slsqp::StopTols;

use super::error::DesignError;
use super::limits::Limit;
use super::optimality::{Optimality, optimality};
use super::scaled::Scale;

/// A limit that is violated by less, relative to its scale, is met.
pub(super) const MET: f64 = 1e-7;
/// The KKT residual of a minimum.
pub(super) const OPTIMAL: f64 = 1e-6;
/// By how much a limit is relaxed for the optimizer, which returns the best point without any
/// violation: without room, that may be the start.
const ROOM: f64 = 0.1 * MET;
/// Solves of one run of the optimizer.
const MOST_SOLVES: usize = 150;
/// Runs from one start: each begins where the last one ended, with a new estimate of curvature.
const MOST_RUNS: usize = 4;

/// A run that reduces the violation by a smaller share is the last one.
const LEAST_GAIN: f64 = 0.01;

/// What is minimized.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Least {
    /// The mass, within all limits.
    Mass,
    /// The largest violation of a frequency, within the limits of the shape.
    FrequencyViolation,
    /// The largest violation of a limit of the shape.
    ShapeViolation,
}

/// A point where the optimizer ended.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Minimum {
    /// Scaled values of all variables.
    pub(super) scaled: Vec<f64>,
    /// Mass relative to the start.
    pub(super) mass: f64,
    /// The largest limit, positive if violated.
    pub(super) violation: f64,
    /// The proof.
    pub(super) optimality: Optimality,
}

impl Minimum {
    /// Whether all limits are met.
    pub(super) fn is_feasible(&self) -> bool {
        self.violation <= MET
    }

    /// Whether it is one.
    pub(super) fn is_proved(&self) -> bool {
        self.is_feasible() && self.optimality.residual <= OPTIMAL
    }
}

/// The least mass with the free variables from several starts, until one is proved.
pub(super) fn least_mass(
    scale: &mut Scale<'_>,
    starts: &[Vec<f64>],
) -> Result<Minimum, DesignError> {
    let mut best: Option<Minimum> = None;
    let mut failure = None;
    for start in starts {
        match from_start(scale, start, Least::Mass) {
            Ok(found) if found.is_proved() => return Ok(found),
            Ok(found) => {
                let is_better = best.as_ref().is_none_or(|best| {
                    match (found.is_feasible(), best.is_feasible()) {
                        (true, true) => found.mass < best.mass,
                        (false, false) => found.violation < best.violation,
                        (is_feasible, _) => is_feasible,
                    }
                });
                if is_better {
                    best = Some(found);
                }
            }
            Err(error) => failure = Some(error),
        }
    }
    best.ok_or(failure.unwrap_or(DesignError::NoVariables))
}

/// The least mass from a start near it, with a limited number of solves.
pub(super) fn from_near(
    scale: &mut Scale<'_>,
    start: &[f64],
    most_solves: usize,
) -> Result<Minimum, DesignError> {
    let found = run_once(scale, start, Least::Mass, most_solves)?;
    ended(scale, found, Least::Mass)
}

/// Minimizes from one start.
pub(super) fn from_start(
    scale: &mut Scale<'_>,
    start: &[f64],
    least: Least,
) -> Result<Minimum, DesignError> {
    let mut found = ended(scale, start.to_vec(), least)?;
    for run in 0..MOST_RUNS {
        let next = run_once(scale, &found.scaled, least, MOST_SOLVES)?;
        let next = ended(scale, next, least)?;
        let is_better = match least {
            Least::Mass if next.is_feasible() && found.is_feasible() => {
                next.optimality.residual < found.optimality.residual
            }
            _ => next.violation < found.violation,
        };
        if run == 0 || is_better {
            let gain = found.violation - next.violation;
            // Where the violation no longer decreases, another start decides, or the least
            // violation.
            let is_stuck = !next.is_feasible() && gain < LEAST_GAIN * found.violation;
            let is_proved = match least {
                Least::Mass => next.is_proved(),
                _ => next.optimality.residual <= OPTIMAL,
            };
            found = next;
            if is_proved || is_stuck {
                break;
            }
        } else {
            break;
        }
    }
    Ok(found)
}

/// The proof of the point where a run ended.
fn ended(scale: &mut Scale<'_>, scaled: Vec<f64>, least: Least) -> Result<Minimum, DesignError> {
    let free = scale.free.clone();
    let limits = scale.limits.clone();
    let highest = scale.highest.clone();
    let at = scale.at(&scaled, true)?;
    let violation = at
        .limits
        .iter()
        .zip(&limits)
        .filter(|(_, limit)| least == Least::Mass || is_relaxed(limit, least))
        .map(|(value, _)| *value)
        .fold(0.0, f64::max);
    let mass = at.mass;
    let optimality = optimality(at, &limits, &free, [&scaled, &highest], (least, violation));
    Ok(Minimum {
        mass,
        violation,
        optimality,
        scaled,
    })
}

/// Whether a limit may be violated while the violation is minimized.
pub(super) fn is_relaxed(limit: &Limit, least: Least) -> bool {
    let is_goal = matches!(limit, Limit::Frequency { .. });
    match least {
        Least::Mass => false,
        Least::FrequencyViolation => is_goal,
        Least::ShapeViolation => !is_goal,
    }
}

/// A value that no line search accepts, for a tower that cannot be solved.
const UNSOLVED: f64 = 1e3;

/// One run of the optimizer over the free variables, and the violation if that is minimized.
fn run_once(
    scale: &mut Scale<'_>,
    start: &[f64],
    least: Least,
    most_solves: usize,
) -> Result<Vec<f64>, DesignError> {
    let free = scale.free.clone();
    let at = scale.at(start, true)?;
    let violation = at.limits.iter().fold(0.0_f64, |most, one| most.max(*one));
    let relaxed: Vec<bool> = scale.limits.iter().map(|l| is_relaxed(l, least)).collect();
    let kept: Vec<usize> = (0..relaxed.len())
        // The shape alone decides about its own violation.
        .filter(|i| least != Least::ShapeViolation || relaxed[*i])
        .collect();
    let is_phase_one = least != Least::Mass;
    let mut x: Vec<f64> = free.iter().map(|i| start[*i]).collect();
    let highest = scale.highest.clone();
    let mut bounds: Vec<(f64, f64)> = free.iter().map(|i| (0.0, highest[*i])).collect();
    if is_phase_one {
        x.push(violation);
        bounds.push((0.0, violation.max(1.0) * 2.0));
    }
    let count = free.len();
    let full = |x: &[f64]| {
        let mut scaled = start.to_vec();
        let all = free.iter().zip(x);
        all.for_each(|(&i, z)| scaled[i] = z.clamp(0.0, highest[i]));
        scaled
    };
    let scale = RefCell::new(scale);
    let objective = |x: &[f64], gradient: Option<&mut [f64]>, _: &mut ()| {
        if is_phase_one {
            if let Some(gradient) = gradient {
                gradient.fill(0.0);
                gradient[count] = 1.0;
            }
            return x[count];
        }
        let mut scale = scale.borrow_mut();
        match (scale.at(&full(&x[..count]), gradient.is_some()), gradient) {
            (Ok(at), Some(gradient)) => {
                fill(gradient, at.slopes.as_ref().map(|slopes| &slopes.mass[..]));
                at.mass
            }
            (Ok(at), None) => at.mass,
            (Err(_), gradient) => {
                fill(gradient.unwrap_or_default(), None);
                UNSOLVED
            }
        }
    };
    let constraints: Vec<_> = kept
        .iter()
        .map(|&limit| {
            let (scale, full, relaxed) = (&scale, &full, &relaxed);
            move |x: &[f64], gradient: Option<&mut [f64]>, _: &mut ()| {
                let mut scale = scale.borrow_mut();
                let slack = ROOM + if relaxed[limit] { x[count] } else { 0.0 };
                match (scale.at(&full(&x[..count]), gradient.is_some()), gradient) {
                    (Ok(at), Some(gradient)) => {
                        let slopes = at.slopes.as_ref().map(|slopes| &slopes.limits[limit][..]);
                        fill(gradient, slopes);
                        if relaxed[limit] {
                            gradient[count] = -1.0;
                        }
                        at.limits[limit] - slack
                    }
                    (Ok(at), None) => at.limits[limit] - slack,
                    (Err(_), gradient) => {
                        fill(gradient.unwrap_or_default(), None);
                        UNSOLVED
                    }
                }
            }
        })
        .collect();
    let tolerances = StopTols {
        ftol_rel: 1e-13,
        xtol_abs: vec![1e-10; x.len()],
        ..StopTols::default()
    };
    let ended = slsqp::minimize(
        objective,
        &x,
        &bounds,
        &constraints,
        (),
        most_solves,
        Some(tolerances),
    );
    // Also the end of a failed run is where the next one begins, or what is judged.
    let (Ok((_, x, _)) | Err((_, x, _))) = ended;
    Ok(match x.iter().all(|z| z.is_finite()) {
        true => full(&x[..count]),
        false => start.to_vec(),
    })
}

/// A gradient of the free variables, or zeros; the rest is zero.
fn fill(gradient: &mut [f64], with: Option<&[f64]>) {
    gradient.fill(0.0);
    let entries = gradient.iter_mut().zip(with.unwrap_or_default());
    entries.for_each(|(entry, of)| *entry = *of);
}
