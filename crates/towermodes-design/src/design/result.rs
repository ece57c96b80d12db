//! Finds a design, checks it and describes it.

use towermodes::{Certificate, Family, ModeName, Solver, Tower, TowerDescription};

use super::confirm::{Confirmed, Reached, confirmed, original};
use super::error::DesignError;
use super::limits::{Limit, short};
use super::minimum::{MET, Minimum, OPTIMAL, from_near, minimum};
use super::optimality::Least;
use super::problem::{DesignProblem, Goal};
use super::steps::{in_steps, parted};
use super::towers::{End, Point, Towers};
use super::unmet::{Conflict, Infeasible};

/// The lightest tower that a design found.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// The tower.
    pub tower: TowerDescription,
    /// The value of each variable before; the mean if it changes several different input values.
    pub before: Vec<f64>,
    /// Whether `before` is such a mean.
    pub before_is_mean: Vec<bool>,
    /// The value of each variable, in steps or with eight significant digits.
    pub values: Vec<f64>,
    /// Mass of the original tower and of this one, kg, with the members of a substructure:
    /// [`Tower::structure_mass_kg`](towermodes::Tower::structure_mass_kg).
    pub mass_kg: [f64; 2],
    /// The goals and the frequencies of this tower, from an ordinary solve.
    pub reached: Vec<Reached>,
    /// The certificate of this solve.
    pub certificate: Certificate,
    /// Data of the stepped solution, if a variable has a step.
    pub steps: Option<Steps>,
    /// The limits that prevent a lighter tower, those with the largest effect first; for the
    /// minimum without steps.
    pub active: Vec<ActiveLimit>,
    /// |∇m + Σ λᵢ ∇gᵢ| / |∇m| at the minimum without steps, with each variable relative to its
    /// range: 0 at an exact minimum (Karush 1939; Kuhn & Tucker 1951).
    pub kkt_residual: f64,
    /// Number of solved towers.
    pub solves: usize,
}

/// Results for a tower with stepped values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Steps {
    /// The mass of the minimum before its values are rounded to steps, kg.
    pub without_steps_kg: f64,
    /// Whether the search is complete: no change by one step and no exchange of two steps that the
    /// derivatives predict to be lighter gives a lighter tower. Otherwise the search ended at its
    /// limit of solves.
    pub is_searched: bool,
}

/// A limit that prevents a lighter tower.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ActiveLimit {
    /// The limit.
    pub limit: Limit,
    /// The mass that is saved per unit by which the limit is relaxed, kg per unit: per Hz, per unit
    /// of the variable, per unit of the ratio, per degree, per m of a difference.
    pub kg_per_unit: f64,
    /// Change of the mass per percent of the limit, kg; none for a limit that is 0.
    pub kg_per_percent: Option<f64>,
}

impl Design {
    /// Whether the first-order conditions of a local minimum are satisfied up to rounding, without
    /// steps.
    pub fn is_stationary(&self) -> bool {
        self.kkt_residual <= OPTIMAL
    }
}

/// Finds a light tower within the limits of a design: a local minimum of the mass, starting from
/// the original tower. A lighter tower may exist elsewhere.
///
/// # Errors
/// [`DesignError`]; [`DesignError::Infeasible`] if no tower is found that meets the limits.
///
/// # Example
/// The wall thickness of a light tower of given diameters with a first frequency of at least
/// 0.3 Hz:
/// ```
/// use towermodes::{
///     Change, Material, Rna, Solver, Station, Tower, TowerDescription,
/// };
/// use towermodes_design::design::{DesignProblem, Goal, Variable, design};
///
/// let base = TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.030), Station::new(87.6, 3.87, 0.030)],
///     rna: Rna::point(350e3),
///     ..TowerDescription::default()
/// };
/// let wall = |name: &str| -> Result<Variable, towermodes::ParameterError> {
///     let change = Change::parse(name, &base)?;
///     Ok(Variable { change, low: 0.010, high: 0.060, step: None })
/// };
/// let mode = "fore-aft 1".parse()?;
/// let problem = DesignProblem {
///     variables: vec![wall("stations[0].wall")?, wall("stations[1].wall")?],
///     goals: vec![Goal { mode, min_hz: 0.3, max_hz: f64::INFINITY }],
///     ..DesignProblem::default()
/// };
/// let found = design(&base, &problem, &mut Solver::default())?;
/// assert!(found.is_stationary() && found.reached[0].is_met());
/// // Walls of 27 and 19 mm give 0.3002 Hz, with more mass:
/// let stations = vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)];
/// let known = Tower::new(TowerDescription { stations, ..base.clone() })?;
/// assert!(found.mass_kg[1] < known.mass_kg());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn design(
    base: &TowerDescription,
    problem: &DesignProblem,
    solver: &mut Solver,
) -> Result<Design, DesignError> {
    design_while(base, problem, solver, &mut || true)
}

/// As [`design`], but cancelled when `goes_on` returns false before a tower is solved.
///
/// # Errors
/// As [`design`], and [`DesignError::GivenUp`].
pub fn design_while(
    base: &TowerDescription,
    problem: &DesignProblem,
    solver: &mut Solver,
    goes_on: &mut dyn FnMut() -> bool,
) -> Result<Design, DesignError> {
    let options = solver.options.clone();
    problem.check()?;
    problem.check_widths(base)?;
    let variables = problem.variables.iter();
    let before: Vec<f64> = variables.map(|of| of.present(base)).collect();
    let mut towers = Towers::new(problem, base, &options, (solver, goes_on));
    let present = towers.scaled(&before);
    let all: Vec<usize> = (0..before.len()).collect();
    let start = start(&mut towers, &present)?;
    let minimum = lightest(&mut towers, &start, &all)?;
    let active = active(&towers, &minimum);
    let without_steps_kg = minimum.mass * towers.mass_kg;
    let search = Search {
        minimum: &minimum.scaled,
        present: &present,
        kg: without_steps_kg,
    };
    let (found, is_searched) = search.met(&mut towers)?;
    let masses = [base, &found.tower].map(|tower| Tower::new(tower.clone()));
    let [before_kg, after_kg] = masses.map(|tower| tower.map(|tower| tower.structure_mass_kg()));
    let variables = problem.variables.iter();
    Ok(Design {
        mass_kg: [before_kg?, after_kg?],
        tower: found.tower,
        before,
        before_is_mean: variables.map(|of| of.has_different(base)).collect(),
        values: found.values,
        reached: found.reached,
        certificate: found.certificate,
        steps: is_searched.map(|is_searched| Steps {
            without_steps_kg,
            is_searched,
        }),
        active,
        kkt_residual: minimum.optimality.residual,
        solves: towers.solves,
    })
}

/// The start of the optimizer: the present values, otherwise the middle of the bounds or their
/// ends, if a tower can be solved there. The mass of this tower is the unit of mass.
fn start(towers: &mut Towers<'_>, present: &[f64]) -> Result<Vec<f64>, DesignError> {
    let part = |part: f64| {
        towers
            .highest
            .iter()
            .map(|highest| part * highest)
            .collect()
    };
    let starts = [present.to_vec(), part(0.5), part(1.0), part(0.0)];
    let mut failure = None;
    for start in starts {
        match towers.begin_at(&start) {
            Ok(()) => return Ok(start),
            Err(error) => failure = failure.or(Some(error)),
        }
    }
    Err(match failure {
        Some(failure @ (DesignError::Sensitivity(_) | DesignError::Tower(_))) => {
            DesignError::NoStart(Box::new(failure))
        }
        other => other.unwrap_or(DesignError::NoVariables),
    })
}

/// The lightest tower that is found, without stepped values.
///
/// # Errors
/// [`DesignError::Infeasible`] if the smallest violation found is larger than rounding errors.
fn lightest(towers: &mut Towers<'_>, start: &[f64], all: &[usize]) -> Result<Minimum, DesignError> {
    let found = minimum(towers, start, all, Least::Mass)?;
    if found.is_feasible() {
        return Ok(found);
    }
    let mut nearest = found.scaled;
    for least in [Least::ShapeViolation, Least::FrequencyViolation] {
        let found = minimum(towers, &nearest, all, least)?;
        if !found.is_feasible() {
            return Err(infeasible(towers, &found));
        }
        nearest = found.scaled;
    }
    minimum(towers, &nearest, all, Least::Mass)
}

/// The search for a tower with stepped values that meets all limits with the values as they are
/// written.
struct Search<'s> {
    minimum: &'s [f64],
    present: &'s [f64],
    /// The mass without stepped values.
    kg: f64,
}

impl Search<'_> {
    /// The tower found, and whether all moves by steps were tried; none without steps. If rounding
    /// or the mesh of the final solve violates a limit, the limit is tightened by this amount and
    /// the search is repeated.
    fn met(&self, towers: &mut Towers<'_>) -> Result<(Confirmed, Option<bool>), DesignError> {
        /// Largest number of towers tried.
        const MOST: usize = 12;
        /// A limit counts as met if its scaled violation is smaller than this rounding error.
        const ROUNDING: f64 = 1e-12;
        let before = original(towers);
        let (stepped, others) = parted(towers);
        let (mut scaled, mut is_searched) = match stepped.is_empty() {
            true => (self.minimum.to_vec(), None),
            false => self.in_steps(towers)?,
        };
        let mut best = confirmed(towers, &scaled, before.as_ref())?;
        for _ in 1..MOST {
            if best.violation() <= ROUNDING {
                break;
            }
            towers.tighten(&best.limits, ROUNDING);
            match met_again(towers, &scaled, &others)? {
                Some(moved) => scaled = moved,
                None if is_searched.is_some() => (scaled, is_searched) = self.in_steps(towers)?,
                None => break,
            }
            let next = confirmed(towers, &scaled, before.as_ref())?;
            if next.violation() < best.violation() {
                best = next;
            }
        }
        Ok((best, is_searched))
    }

    fn in_steps(&self, towers: &mut Towers<'_>) -> Result<(Vec<f64>, Option<bool>), DesignError> {
        let found = in_steps(towers, self.minimum, self.present)?;
        let (scaled, is_searched) = found.ok_or(DesignError::NoCombination { kg: self.kg })?;
        Ok((scaled, Some(is_searched)))
    }
}

/// Values near given ones that meet all limits after these were tightened slightly; none if no
/// change of the free variables gives such values.
fn met_again(
    towers: &mut Towers<'_>,
    scaled: &[f64],
    free: &[usize],
) -> Result<Option<Vec<f64>>, DesignError> {
    /// Largest number of solves of this search, which begins near its result.
    const MOST_SOLVES: usize = 150;
    let moved = moved_within(towers, scaled, free)?;
    if moved.is_some() || free.is_empty() {
        return Ok(moved);
    }
    let found = from_near(towers, scaled, free, MOST_SOLVES)?;
    Ok(found.is_feasible().then_some(found.scaled))
}

/// The free variables changed slightly, so that the limits are met to first order: repeated
/// projection onto each violated limit in turn (Kaczmarz 1937).
fn moved_within(
    towers: &mut Towers<'_>,
    scaled: &[f64],
    free: &[usize],
) -> Result<Option<Vec<f64>>, DesignError> {
    /// Largest number of repetitions.
    const MOST_TURNS: usize = 10_000;
    let at = towers.at(scaled, true)?;
    let limits: &[Vec<f64>] = at.slopes.as_ref().map_or(&[], |slopes| &slopes.limits);
    let mut next = scaled.to_vec();
    for _ in 0..MOST_TURNS {
        let values = at.limits.iter().zip(limits).map(|(value, row)| {
            let change: f64 = free.iter().map(|&i| row[i] * (next[i] - scaled[i])).sum();
            (value + change, row)
        });
        let worst = values.max_by(|a, b| a.0.total_cmp(&b.0));
        let Some((value, row)) = worst.filter(|(value, _)| *value > 0.0) else {
            return Ok(Some(next));
        };
        let square: f64 = free.iter().map(|&i| row[i] * row[i]).sum();
        if square == 0.0 {
            return Ok(None);
        }
        for &i in free {
            // A little further, so that the last turns end.
            let moved = next[i] - 1.001 * value * row[i] / square;
            next[i] = moved.clamp(0.0, towers.highest[i]);
        }
    }
    Ok(None)
}

/// The limits that prevent a solution, at the nearest tower.
fn infeasible(towers: &mut Towers<'_>, nearest: &Minimum) -> DesignError {
    let problem = towers.problem;
    let tower = towers.tower(&nearest.scaled);
    let at = match towers.at(&nearest.scaled, false) {
        Ok(at) => at,
        Err(error) => return error,
    };
    let mut violated: Vec<(f64, Conflict)> = Vec::new();
    for (limit, value) in towers.limits.iter().zip(&at.limits) {
        // The multipliers name those that decide; others are violated as much.
        if *value > MET {
            let conflict = Conflict {
                limit: *limit,
                wanted: problem.words(limit),
                nearest: nearest_words(problem, limit, &at, &tower),
            };
            violated.push((*value, conflict));
        }
    }
    violated.sort_by(|a, b| b.0.total_cmp(&a.0));
    // Where the mode with the name meets the limit, the shared motion prevents it, not a bound.
    let is_met_by_name = |limit: &Limit| match *limit {
        Limit::Frequency { goal, .. } => problem.goals[goal].allows(at.named_hz[goal]),
        _ => false,
    };
    let is_prevented = !violated.iter().all(|(_, of)| is_met_by_name(&of.limit));
    let is_violated = |limit: &Limit| violated.iter().any(|(_, of)| of.limit == *limit);
    let active = nearest.optimality.active.iter().filter(|_| is_prevented);
    let in_the_way = active
        .filter(|(limit, multiplier)| *multiplier > 1e-9 && !is_violated(limit))
        .map(|(limit, _)| problem.words(limit))
        .collect();
    DesignError::Infeasible(Box::new(Infeasible {
        equal: excluded_by_symmetry(&problem.goals, &at),
        in_the_way,
        values: towers.values(&nearest.scaled),
        violated: violated.into_iter().map(|(_, conflict)| conflict).collect(),
    }))
}

/// The nearest value that was found for a violated limit, in words.
fn nearest_words(
    problem: &DesignProblem,
    limit: &Limit,
    at: &Point,
    tower: &TowerDescription,
) -> String {
    let station = |i: usize| &tower.stations[i];
    match *limit {
        Limit::Frequency { goal, side } => {
            let End { mode, hz } = at.ends[goal][side as usize];
            let (named, hz) = (problem.goals[goal].mode, short(hz));
            match mode == named {
                true => format!("{hz} Hz"),
                false => format!(
                    "{hz} Hz, of {mode}; the limit holds for every mode that shares the motion of {named}, and {named} itself has {} Hz",
                    short(at.named_hz[goal])
                ),
            }
        }
        Limit::Falling { below, above } => {
            let [above, below] = [above, below].map(|number| short(number.value(tower)));
            format!("{above} above {below}")
        }
        Limit::DiameterToWall { station: i, .. } => {
            short(station(i).outer_diameter_m / station(i).wall_thickness_m)
        }
        Limit::ConeAngle { station: i } => {
            let (below, above) = (station(i), station(i + 1));
            let radii = (above.outer_diameter_m - below.outer_diameter_m).abs() / 2.0;
            let angle = (radii / (above.height_m - below.height_m)).atan();
            format!("{} degrees", short(angle.to_degrees()))
        }
        Limit::Bound { .. } => String::new(),
    }
}

/// The pairs of fore-aft and side-side modes of one order that have the same frequency, although
/// their bands exclude each other.
fn excluded_by_symmetry(goals: &[Goal], at: &Point) -> Vec<[ModeName; 2]> {
    /// Two frequencies count as equal if their relative difference is smaller.
    const EQUAL: f64 = 1e-9;
    let of = |family| {
        let all = goals.iter().zip(&at.ends);
        let is_alone = |goal: &Goal, ends: &[End; 2]| ends.iter().all(|end| end.mode == goal.mode);
        let all =
            all.filter(move |(goal, ends)| goal.mode.family == family && is_alone(goal, ends));
        all.map(|(goal, [lowest, _])| (goal, lowest.hz))
    };
    let mut pairs = Vec::new();
    for (first, hz) in of(Family::ForeAft) {
        for (second, other_hz) in of(Family::SideSide) {
            let is_pair =
                first.mode.order == second.mode.order && (hz - other_hz).abs() <= EQUAL * hz.abs();
            if is_pair && (first.max_hz < second.min_hz || second.max_hz < first.min_hz) {
                pairs.push([first.mode, second.mode]);
            }
        }
    }
    pairs
}

/// The multipliers of the active limits in physical units.
fn active(towers: &Towers<'_>, minimum: &Minimum) -> Vec<ActiveLimit> {
    let tower = towers.tower(&minimum.scaled);
    let all = minimum.optimality.active.iter();
    let all = all.filter(|(_, multiplier)| *multiplier > 1e-9);
    let mut active: Vec<ActiveLimit> = all
        .map(|(limit, multiplier)| {
            let (value, per_unit) = towers.unit(limit, &tower);
            let kg_per_unit = multiplier * towers.mass_kg * per_unit;
            ActiveLimit {
                limit: *limit,
                kg_per_unit,
                kg_per_percent: (value != 0.0).then(|| kg_per_unit * value.abs() / 100.0),
            }
        })
        .collect();
    let effect = |of: &ActiveLimit| of.kg_per_percent.unwrap_or(0.0);
    active.sort_by(|a, b| effect(b).total_cmp(&effect(a)));
    active
}
