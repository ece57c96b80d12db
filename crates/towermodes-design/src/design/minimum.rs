//! Local minima by sequential least squares programming (Kraft 1988; the library `slsqp`): of the
//! mass, or of the largest violation if the search meets not all limits.

use std::cell::RefCell;
use std::rc::Rc;

use slsqp::StopTols;

use super::error::DesignError;
use super::limits::Limit;
use super::optimality::{Least, Optimality, optimality};
use super::towers::{Point, Towers};

/// A limit counts as met if its violation, relative to its scale, is smaller.
pub(super) const MET: f64 = 1e-7;
/// The largest KKT residual of a minimum.
pub(super) const OPTIMAL: f64 = 1e-6;
/// The relaxation of a limit for the optimizer. The optimizer returns the best point without any
/// violation, which due to rounding may be the start; therefore the best point with twice this
/// relaxation is assessed too.
const ROOM: f64 = 0.1 * MET;
/// Largest number of solves of one run of the optimizer.
const MOST_SOLVES: usize = 150;
/// Largest number of runs from one start: each begins where the last one ended, with a new estimate
/// of curvature.
const MOST_RUNS: usize = 4;
/// A value that every line search rejects, for a tower that cannot be solved.
const UNSOLVED: f64 = 1e3;

/// A point where the optimizer ended.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Minimum {
    /// Scaled values of all variables.
    pub(super) scaled: Vec<f64>,
    /// Mass relative to the start.
    pub(super) mass: f64,
    /// The largest violation of a limit that the search may violate; positive if it is violated.
    pub(super) violation: f64,
    /// The residuals of the conditions of a minimum.
    pub(super) optimality: Optimality,
}

impl Minimum {
    /// Whether all limits are met.
    pub(super) fn is_feasible(&self) -> bool {
        self.violation <= MET
    }

    /// Whether it is closer to a minimum: compared first by violation, then by optimality.
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

/// The least mass from a start near the minimum, with a limited number of solves.
pub(super) fn from_near(
    towers: &mut Towers<'_>,
    start: &[f64],
    free: &[usize],
    most_solves: usize,
) -> Result<Minimum, DesignError> {
    run_once(towers, start, (free, Least::Mass), most_solves)
}

/// The optimality of the point where a run ended.
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
    let violation = towers.at(start, true)?.violation();
    let mut x: Vec<f64> = free.iter().map(|i| start[*i]).collect();
    let mut bounds: Vec<(f64, f64)> = free.iter().map(|i| (0.0, towers.highest[*i])).collect();
    if least != Least::Mass {
        x.push(violation);
        bounds.push((0.0, violation.max(1.0) * 2.0));
    }
    let tolerances = StopTols {
        ftol_rel: 1e-13,
        xtol_abs: vec![1e-10; x.len()],
        ..StopTols::default()
    };
    let run = Run {
        limits: towers.limits.clone(),
        highest: towers.highest.clone(),
        towers: RefCell::new(towers),
        best: RefCell::new(((f64::INFINITY, f64::INFINITY), Vec::new())),
        start,
        free,
        least,
    };
    let counted = (0..run.limits.len()).filter(|place| least.counts(&run.limits[*place]));
    let limit = |place| {
        let run = &run;
        move |x: &[f64], gradient: Option<&mut [f64]>, _: &mut ()| run.limit(place, x, gradient)
    };
    let ended = slsqp::minimize(
        |x: &[f64], gradient: Option<&mut [f64]>, _: &mut ()| run.objective(x, gradient),
        &x,
        &bounds,
        &counted.map(limit).collect::<Vec<_>>(),
        (),
        most_solves,
        Some(tolerances),
    );
    // Also the end of a failed run is where the next one begins, or what is judged.
    let (Ok((_, x, _)) | Err((_, x, _))) = ended;
    let ends = [x, run.best.take().1].into_iter();
    let ends = ends.filter(|x| !x.is_empty() && x.iter().all(|z| z.is_finite()));
    let ends: Vec<Vec<f64>> = ends.map(|x| run.scaled(&x)).collect();
    let towers = run.towers.into_inner();
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

/// The functions of a run. Their x contains the free variables and, if a violation is minimized,
/// this violation.
struct Run<'r, 'd> {
    towers: RefCell<&'r mut Towers<'d>>,
    start: &'r [f64],
    free: &'r [usize],
    least: Least,
    limits: Vec<Limit>,
    highest: Vec<f64>,
    /// Violation and mass of the best point so far, and its x.
    best: RefCell<((f64, f64), Vec<f64>)>,
}

impl Run<'_, '_> {
    /// All scaled variables.
    fn scaled(&self, x: &[f64]) -> Vec<f64> {
        let mut scaled = self.start.to_vec();
        for (&i, z) in self.free.iter().zip(x) {
            scaled[i] = z.clamp(0.0, self.highest[i]);
        }
        scaled
    }

    /// The tower at x; none if it cannot be solved.
    fn at(&self, x: &[f64], slopes: bool) -> Option<Rc<Point>> {
        let is_number = x.iter().all(|z| !z.is_nan());
        let mut towers = self.towers.borrow_mut();
        let point = is_number.then(|| towers.at(&self.scaled(x), slopes).ok());
        point.flatten()
    }

    /// The mass, or the violation.
    fn objective(&self, x: &[f64], gradient: Option<&mut [f64]>) -> f64 {
        if self.least != Least::Mass {
            self.fill(gradient, None, 1.0);
            return x[self.free.len()];
        }
        let Some(point) = self.at(x, gradient.is_some()) else {
            self.fill(gradient, None, 0.0);
            return UNSOLVED;
        };
        let rank = (point.violation().max(2.0 * ROOM), point.mass);
        if rank < self.best.borrow().0 {
            *self.best.borrow_mut() = (rank, x.to_vec());
        }
        let slopes = point.slopes.as_ref().map(|slopes| &slopes.mass[..]);
        self.fill(gradient, slopes, 0.0);
        point.mass
    }

    /// A limit, which must not be positive; minus the violation, if the violation relaxes it.
    fn limit(&self, place: usize, x: &[f64], gradient: Option<&mut [f64]>) -> f64 {
        let Some(point) = self.at(x, gradient.is_some()) else {
            self.fill(gradient, None, 0.0);
            return UNSOLVED;
        };
        let is_relaxed = self.least.relaxes(&self.limits[place]);
        let share = if is_relaxed { -1.0 } else { 0.0 };
        let slopes = point
            .slopes
            .as_ref()
            .map(|slopes| &slopes.limits[place][..]);
        self.fill(gradient, slopes, share);
        let violation = x
            .get(self.free.len())
            .map_or(0.0, |violation| share * violation);
        point.limits[place] - ROOM + violation
    }

    /// Fills a gradient with the derivatives of the free variables, or zeros, and of the violation.
    fn fill(&self, gradient: Option<&mut [f64]>, slopes: Option<&[f64]>, of_violation: f64) {
        let Some(gradient) = gradient else { return };
        gradient.fill(0.0);
        if let Some(slopes) = slopes {
            let entries = gradient.iter_mut().zip(self.free);
            entries.for_each(|(entry, i)| *entry = slopes[*i]);
        }
        if let Some(entry) = gradient.get_mut(self.free.len()) {
            *entry = of_violation;
        }
    }
}
