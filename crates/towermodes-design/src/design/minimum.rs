//! Local minima by sequential least squares programming (Kraft 1988; the library `slsqp`): of the
//! mass, or of the violation where a search does not meet all limits.

use std::cell::RefCell;
use std::rc::Rc;

use slsqp::StopTols;

use super::error::DesignError;
use super::optimality::{Least, Optimality, optimality};
use super::towers::Towers;

/// A limit that is violated by less, relative to its scale, is met.
pub(super) const MET: f64 = 1e-7;
/// The KKT residual of a minimum.
pub(super) const OPTIMAL: f64 = 1e-6;
/// By how much a limit is relaxed for the optimizer. It returns the best point without any
/// violation, which rounding may make the start; so the best point with twice this room is judged
/// too.
const ROOM: f64 = 0.1 * MET;
/// Solves of one run of the optimizer.
const MOST_SOLVES: usize = 150;
/// Runs from one start: each begins where the last one ended, with a new estimate of curvature.
const MOST_RUNS: usize = 4;
/// A value that no line search accepts, for a tower that cannot be solved.
const UNSOLVED: f64 = 1e3;

/// A point where the optimizer ended.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Minimum {
    /// Scaled values of all variables.
    pub(super) scaled: Vec<f64>,
    /// Mass relative to the start.
    pub(super) mass: f64,
    /// The largest limit that may be violated, positive if it is.
    pub(super) violation: f64,
    /// How well the conditions of a minimum hold.
    pub(super) optimality: Optimality,
}

impl Minimum {
    /// Whether all limits are met.
    pub(super) fn is_feasible(&self) -> bool {
        self.violation <= MET
    }

    /// Whether it is nearer to a minimum: first by its violation, then by the conditions.
    fn is_better_than(&self, other: &Self) -> bool {
        let rank = |of: &Self| (of.violation.max(MET), of.optimality.residual);
        rank(self) < rank(other)
    }
}

/// Minimizes over the free variables from one start.
pub(super) fn minimum(
    towers: &mut Towers<'_>,
    start: &[f64],
    free: &[usize],
    least: Least,
) -> Result<Minimum, DesignError> {
    let mut found = judged(towers, start.to_vec(), free, least)?;
    for run in 0..MOST_RUNS {
        let next = run_once(towers, &found.scaled, (free, least), MOST_SOLVES)?;
        // The first run may leave a point that only looks like a minimum.
        if run > 0 && !next.is_better_than(&found) {
            break;
        }
        found = next;
        let is_met = least != Least::Mass || found.is_feasible();
        if is_met && found.optimality.residual <= OPTIMAL {
            break;
        }
    }
    Ok(found)
}

/// The least mass from a start near it, with a limited number of solves.
pub(super) fn from_near(
    towers: &mut Towers<'_>,
    start: &[f64],
    free: &[usize],
    most_solves: usize,
) -> Result<Minimum, DesignError> {
    run_once(towers, start, (free, Least::Mass), most_solves)
}

/// What is known of the point where a run ended.
fn judged(
    towers: &mut Towers<'_>,
    scaled: Vec<f64>,
    free: &[usize],
    least: Least,
) -> Result<Minimum, DesignError> {
    let at = towers.at(&scaled, true)?;
    let limits = towers.limits.iter().zip(&at.limits);
    let violation = limits
        .filter(|(limit, _)| least == Least::Mass || least.relaxes(limit))
        .map(|(_, value)| *value)
        .fold(0.0, f64::max);
    let optimality = match &at.slopes {
        Some(slopes) => optimality(towers, slopes, (&at, &scaled), free, (least, violation)),
        None => Optimality::none(),
    };
    Ok(Minimum {
        mass: at.mass,
        violation,
        optimality,
        scaled,
    })
}

/// One run of the optimizer over the free variables, and the violation if that is minimized.
fn run_once(
    towers: &mut Towers<'_>,
    start: &[f64],
    (free, least): (&[usize], Least),
    most_solves: usize,
) -> Result<Minimum, DesignError> {
    let count = free.len();
    let at = towers.at(start, true)?;
    let mut x: Vec<f64> = free.iter().map(|i| start[*i]).collect();
    let mut bounds: Vec<(f64, f64)> = free.iter().map(|i| (0.0, towers.highest[*i])).collect();
    let is_mass = least == Least::Mass;
    if !is_mass {
        let violation = at.violation();
        x.push(violation);
        bounds.push((0.0, violation.max(1.0) * 2.0));
    }
    let limits = towers.limits.clone();
    let highest = towers.highest.clone();
    let full = |x: &[f64]| {
        let mut scaled = start.to_vec();
        let all = free.iter().zip(x);
        all.for_each(|(&i, z)| scaled[i] = z.clamp(0.0, highest[i]));
        scaled
    };
    let towers = RefCell::new(towers);
    // Violation and mass of the best point so far, and its values.
    let best = RefCell::new(((f64::INFINITY, f64::INFINITY), Vec::new()));
    // The objective, or a limit by its place: what the tower has of it, and how much of the
    // violation, the last element of x, is added.
    let function = |limit: Option<usize>| {
        let (towers, full, best) = (&towers, &full, &best);
        let share = match limit.map(|place| least.relaxes(&limits[place])) {
            None if is_mass => 0.0,
            None => 1.0,
            Some(is_relaxed) => -f64::from(u8::from(is_relaxed)),
        };
        move |x: &[f64], gradient: Option<&mut [f64]>, _: &mut ()| -> f64 {
            let violation = x.get(count).map_or(0.0, |violation| share * violation);
            let point = match is_mass || limit.is_some() {
                true => {
                    let mut towers = towers.borrow_mut();
                    let found = match x.iter().any(|z| z.is_nan()) {
                        true => Err(DesignError::NoVariables),
                        false => towers.at(&full(x), gradient.is_some()),
                    };
                    match found {
                        Ok(point) => {
                            let rank = (point.violation().max(2.0 * ROOM), point.mass);
                            if limit.is_none() && rank < best.borrow().0 {
                                *best.borrow_mut() = (rank, x.to_vec());
                            }
                            Some(point)
                        }
                        Err(_) => {
                            gradient.unwrap_or_default().fill(0.0);
                            return UNSOLVED;
                        }
                    }
                }
                false => None,
            };
            if let Some(gradient) = gradient {
                gradient.fill(0.0);
                if let Some(slopes) = point.as_ref().and_then(|point| point.slopes.as_ref()) {
                    let row = limit.map_or(&slopes.mass, |place| &slopes.limits[place]);
                    let entries = gradient.iter_mut().zip(free);
                    entries.for_each(|(entry, i)| *entry = row[*i]);
                }
                if let Some(entry) = gradient.get_mut(count) {
                    *entry = share;
                }
            }
            let of_tower = point.map(|point: Rc<_>| match limit {
                Some(place) => point.limits[place] - ROOM,
                None => point.mass,
            });
            of_tower.unwrap_or_default() + violation
        }
    };
    let counted = (0..limits.len()).filter(|place| least.counts(&limits[*place]));
    let constraints: Vec<_> = counted.map(|place| function(Some(place))).collect();
    let tolerances = StopTols {
        ftol_rel: 1e-13,
        xtol_abs: vec![1e-10; x.len()],
        ..StopTols::default()
    };
    let ended = slsqp::minimize(
        function(None),
        &x,
        &bounds,
        &constraints,
        (),
        most_solves,
        Some(tolerances),
    );
    // Also the end of a failed run is where the next one begins, or what is judged.
    let (Ok((_, x, _)) | Err((_, x, _))) = ended;
    let ends = [x, best.take().1].into_iter().filter(|x| x.len() >= count);
    let ends: Vec<Vec<f64>> = ends
        .filter(|x| x.iter().all(|z| z.is_finite()))
        .map(|x| full(&x))
        .collect();
    let towers = towers.into_inner();
    let mut found: Option<Minimum> = None;
    for end in ends {
        let next = judged(towers, end, free, least)?;
        if found
            .as_ref()
            .is_none_or(|found| next.is_better_than(found))
        {
            found = Some(next);
        }
    }
    found.map_or_else(|| judged(towers, start.to_vec(), free, least), Ok)
}
