//! Finds a design, checks it and describes it.

use std::fmt;

use towermodes::{Certificate, Family, ModeName, Operation, Solver, Tower, TowerDescription};

use super::confirm::{Reached, confirmed};
use super::error::DesignError;
use super::limits::Limit;
use super::minimum::{Least, MET, Minimum, OPTIMAL, from_start, least_mass};
use super::point::{End, Point};
use super::problem::{DesignProblem, Goal, Side};
use super::scaled::Scale;
use super::steps::in_steps;

/// The lightest tower of a design.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// The tower.
    pub tower: TowerDescription,
    /// The value of each variable before: of a list of different numbers their mean.
    pub before: Vec<f64>,
    /// Whether that is the mean of different numbers.
    pub before_is_mean: Vec<bool>,
    /// The value of each variable, in steps or with eight significant digits.
    pub values: Vec<f64>,
    /// Mass of the original tower and of this one, kg.
    pub mass_kg: [f64; 2],
    /// The goals and the frequencies of this tower, from an ordinary solve.
    pub reached: Vec<Reached>,
    /// The certificate of this solve.
    pub certificate: Certificate,
    /// The steps, if a variable has some.
    pub steps: Option<Steps>,
    /// The limits that keep the tower from being lighter, those with the largest effect first; of
    /// the minimum without steps.
    pub active: Vec<ActiveLimit>,
    /// |∇m + Σ λᵢ ∇gᵢ| / |∇m| at the minimum without steps, with each variable relative to its
    /// range: 0 at an exact one (Karush 1939; Kuhn & Tucker 1951).
    pub kkt_residual: f64,
    /// How many towers were solved.
    pub solves: usize,
}

/// What is known of a tower in steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Steps {
    /// The mass of the minimum without steps, kg: no tower in steps is lighter, if that minimum is
    /// the only one.
    pub without_steps_kg: f64,
    /// Whether no change by one step, and no exchange of two, that the derivatives predict to be
    /// lighter makes a lighter tower; otherwise the search ended after its number of solves.
    pub is_searched: bool,
}

/// A limit that keeps a tower from being lighter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ActiveLimit {
    /// The limit.
    pub limit: Limit,
    /// The mass that is saved per unit by which the limit is relaxed, kg per unit: per Hz, per unit
    /// of the variable, per unit of the ratio, per degree, per m of a difference.
    pub kg_per_unit: f64,
    /// The same per percent of the limit; none for a limit that is 0.
    pub kg_per_percent: Option<f64>,
}

/// That no tower meets all limits, and the nearest one.
#[derive(Debug, Clone, PartialEq)]
pub struct Infeasible {
    /// The violated limits, the worst first.
    pub violated: Vec<Conflict>,
    /// The limits that prevent a nearer tower, in words.
    pub in_the_way: Vec<String>,
    /// The values of the variables of the nearest tower.
    pub values: Vec<f64>,
    /// Modes of equal frequency by symmetry whose bands exclude each other.
    pub equal: Vec<[ModeName; 2]>,
}

/// A limit that no tower meets together with the others.
#[derive(Debug, Clone, PartialEq)]
pub struct Conflict {
    /// The limit.
    pub limit: Limit,
    /// The limit in words: "fore-aft 1 at least 0.3 Hz".
    pub wanted: String,
    /// How near the nearest tower comes, in words: "0.284 Hz".
    pub nearest: String,
}

impl Design {
    /// Whether the conditions of a minimum are met up to rounding, by the minimum without steps.
    pub fn is_proved(&self) -> bool {
        self.kkt_residual <= OPTIMAL
    }
}

impl fmt::Display for Infeasible {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = Vec::new();
        for Conflict {
            wanted, nearest, ..
        } in &self.violated
        {
            text.push(format!("{wanted} (nearest: {nearest})"));
        }
        write!(f, "no tower meets {}", text.join(" and "))?;
        if !self.in_the_way.is_empty() {
            write!(f, "; what prevents it: {}", self.in_the_way.join(", "))?;
        }
        for [first, second] in &self.equal {
            write!(
                f,
                "; {first} and {second} have the same frequency, because the tower is equal in both directions, so that their bands must overlap"
            )?;
        }
        Ok(())
    }
}

/// Finds the lightest tower within the limits of a design.
///
/// The minimum is proved by its KKT residual. It is a local one; the optimizer begins at the
/// values of the original tower.
///
/// # Errors
/// [`DesignError`]; [`DesignError::Infeasible`] if no tower meets the limits.
///
/// # Example
/// The wall thickness of the lightest tower of given diameters with a first frequency of at least
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
/// assert!(found.is_proved() && found.reached[0].is_met());
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
    let options = solver.options.clone();
    problem.check()?;
    problem.check_widths(base)?;
    let before: Vec<f64> = problem
        .variables
        .iter()
        .map(|of| of.present(base))
        .collect();
    let mut scale = Scale::new(problem, base, &options, solver);
    let present = scale.scaled(&before);
    let starts = starts(&mut scale, &before)?;
    let minimum = minimum(&mut scale, &starts)?;
    let active = active(&scale, &minimum);
    let without_steps_kg = minimum.mass * scale.mass_kg;
    let is_stepped = problem.variables.iter().any(|of| of.step.is_some());
    let (scaled, steps) = match is_stepped {
        false => (minimum.scaled.clone(), None),
        true => match in_steps(&mut scale, &minimum.scaled, &present)? {
            Some((scaled, is_searched)) => {
                let steps = Steps {
                    without_steps_kg,
                    is_searched,
                };
                (scaled, Some(steps))
            }
            None => {
                let kg = without_steps_kg;
                return Err(DesignError::NoCombination { kg });
            }
        },
    };
    let found = confirmed(&mut scale, scaled)?;
    let masses = [base, &found.tower].map(|tower| Tower::new(tower.clone()));
    let [before_kg, after_kg] = masses.map(|tower| tower.map(|tower| tower.mass_kg()));
    let variables = problem.variables.iter();
    Ok(Design {
        mass_kg: [before_kg?, after_kg?],
        tower: found.tower,
        before,
        before_is_mean: variables.map(|of| of.has_different(base)).collect(),
        values: found.values,
        reached: found.reached,
        certificate: found.certificate,
        steps,
        active,
        kkt_residual: minimum.optimality.residual,
        solves: scale.solves,
    })
}

/// Where the optimizer begins: at the present values, in the middle of the bounds, at their ends.
/// A tower that cannot be solved is left out; the mass of the first is the unit of mass.
fn starts(scale: &mut Scale<'_>, before: &[f64]) -> Result<Vec<Vec<f64>>, DesignError> {
    let count = before.len();
    let all = [
        scale.scaled(before),
        vec![0.5; count],
        vec![1.0; count],
        vec![0.0; count],
    ];
    let mut starts = Vec::new();
    let mut failure = None;
    for start in all {
        match scale.at(&start, false) {
            Ok(at) if starts.is_empty() => {
                scale.mass_kg = at.point.mass_kg;
                starts.push(start);
            }
            Ok(_) => starts.push(start),
            Err(error) => failure = failure.or(Some(error)),
        }
    }
    scale.forget();
    match failure {
        Some(failure @ (DesignError::Sensitivity(_) | DesignError::Tower(_)))
            if starts.is_empty() =>
        {
            Err(DesignError::NoStart(Box::new(failure)))
        }
        Some(failure) if starts.is_empty() => Err(failure),
        _ => Ok(starts),
    }
}

/// The lightest tower.
///
/// # Errors
/// [`DesignError::Infeasible`].
fn minimum(scale: &mut Scale<'_>, starts: &[Vec<f64>]) -> Result<Minimum, DesignError> {
    let found = least_mass(scale, &starts[..1])?;
    if found.is_proved() {
        return Ok(found);
    }
    if found.is_feasible() {
        let other = least_mass(scale, &starts[1..]);
        let other = other
            .ok()
            .filter(|other| other.is_feasible() && (other.is_proved() || other.mass < found.mass));
        return Ok(other.unwrap_or(found));
    }
    let shape = least_violation(scale, &found, starts, Least::ShapeViolation)?;
    if shape.violation > MET {
        return Err(infeasible(scale, &shape));
    }
    let nearest = least_violation(scale, &shape, starts, Least::FrequencyViolation)?;
    if nearest.violation > MET {
        return Err(infeasible(scale, &nearest));
    }
    let again = least_mass(scale, std::slice::from_ref(&nearest.scaled))?;
    match again.is_feasible() {
        true => Ok(again),
        // The tower with the least violation meets all limits, although the lightest is not found.
        false => from_start(scale, &nearest.scaled, Least::Mass),
    }
}

/// The least violation from the point where the mass was minimized; from other starts only if that
/// is not proved to be a minimum.
fn least_violation(
    scale: &mut Scale<'_>,
    from: &Minimum,
    starts: &[Vec<f64>],
    least: Least,
) -> Result<Minimum, DesignError> {
    let mut nearest = from_start(scale, &from.scaled, least)?;
    for start in starts {
        if nearest.violation <= MET || nearest.optimality.residual <= OPTIMAL {
            break;
        }
        let other = from_start(scale, start, least)?;
        let is_nearer = match least {
            Least::FrequencyViolation => is_nearer(scale, &other, &nearest),
            _ => other.violation < nearest.violation,
        };
        if is_nearer {
            nearest = other;
        }
    }
    Ok(nearest)
}

/// Whether the frequencies of a point within the limits of the shape are nearer to their bands.
fn is_nearer(scale: &mut Scale<'_>, other: &Minimum, nearest: &Minimum) -> bool {
    let limits = scale.limits.clone();
    let Ok(at) = scale.at(&other.scaled, false) else {
        return false;
    };
    let mut of_shape = limits.iter().zip(&at.limits);
    let is_within =
        of_shape.all(|(limit, value)| matches!(limit, Limit::Frequency { .. }) || *value <= MET);
    is_within && other.violation < nearest.violation
}

/// What stands in the way, at the nearest tower.
fn infeasible(scale: &mut Scale<'_>, nearest: &Minimum) -> DesignError {
    let problem = scale.problem;
    let limits = scale.limits.clone();
    let values = scale.values(&nearest.scaled);
    let tower = scale.tower(&nearest.scaled);
    let at = match scale.at(&nearest.scaled, false) {
        Ok(at) => at.clone(),
        Err(error) => return error,
    };
    let mut violated: Vec<(f64, Conflict)> = Vec::new();
    for (limit, value) in limits.iter().zip(&at.limits) {
        // The multipliers name those that decide; others are violated as much.
        if *value > MET {
            let conflict = Conflict {
                limit: *limit,
                wanted: problem.words(limit),
                nearest: problem.nearest(limit, &at.point, &tower),
            };
            violated.push((*value, conflict));
        }
    }
    violated.sort_by(|a, b| b.0.total_cmp(&a.0));
    let is_violated = |limit: &Limit| violated.iter().any(|(_, of)| of.limit == *limit);
    let active = nearest.optimality.active.iter();
    let in_the_way = active
        .filter(|(limit, multiplier)| *multiplier > 1e-9 && !is_violated(limit))
        .map(|(limit, _)| problem.words(limit))
        .collect();
    DesignError::Infeasible(Box::new(Infeasible {
        equal: excluded_by_symmetry(&problem.goals, &at.point),
        in_the_way,
        values,
        violated: violated.into_iter().map(|(_, conflict)| conflict).collect(),
    }))
}

/// The pairs of fore-aft and side-side modes of one order that have the same frequency, although
/// their bands exclude each other.
fn excluded_by_symmetry(goals: &[Goal], at: &Point) -> Vec<[ModeName; 2]> {
    /// Equal up to rounding.
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

/// The multipliers of the active limits in units.
fn active(scale: &Scale<'_>, minimum: &Minimum) -> Vec<ActiveLimit> {
    let tower = scale.tower(&minimum.scaled);
    let all = minimum.optimality.active.iter();
    let all = all.filter(|(_, multiplier)| *multiplier > 1e-9);
    let mut active: Vec<ActiveLimit> = all
        .map(|(limit, multiplier)| {
            let (value, per_unit) = scale.unit(limit, &tower);
            let kg_per_unit = multiplier * scale.mass_kg * per_unit;
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

impl DesignProblem {
    /// A limit in words: "fore-aft 1 at least 0.3 Hz".
    pub fn words(&self, limit: &Limit) -> String {
        let end = |side: Side| match side {
            Side::Lowest => "at least",
            Side::Highest => "at most",
        };
        match *limit {
            Limit::Bound { variable, side } => {
                let of = &self.variables[variable];
                let bound = match side {
                    Side::Lowest => of.low,
                    Side::Highest => of.high,
                };
                let unit = match (of.change.operation(), of.change.unit()) {
                    (Operation::Scale, _) | (_, "") => String::new(),
                    (_, unit) => format!(" {unit}"),
                };
                format!("{} {} {}{unit}", of.change.name(), end(side), short(bound))
            }
            Limit::Frequency { goal, side } => {
                let goal = &self.goals[goal];
                let hz = match side {
                    Side::Lowest => goal.min_hz,
                    Side::Highest => goal.max_hz,
                };
                format!("{} {} {} Hz", goal.mode, end(side), short(hz))
            }
            Limit::Falling { below, above } => format!("{above} at most {below}"),
            Limit::DiameterToWall { station, side } => {
                let [low, high] = self.diameter_to_wall.unwrap_or_default();
                let ratio = match side {
                    Side::Lowest => low,
                    Side::Highest => high,
                };
                let (end, ratio) = (end(side), short(ratio));
                format!("diameter/wall at stations[{station}] {end} {ratio}")
            }
            Limit::ConeAngle { station } => {
                let angle = short(self.cone_angle_deg.unwrap_or_default());
                format!("cone angle above stations[{station}] at most {angle} degrees")
            }
        }
    }

    /// The value of a limited quantity on a tower, in words.
    fn nearest(&self, limit: &Limit, at: &Point, tower: &TowerDescription) -> String {
        let station = |i: usize| &tower.stations[i];
        match *limit {
            Limit::Frequency { goal, side } => {
                let End { mode, hz } = at.end(goal, side);
                match mode == self.goals[goal].mode {
                    true => format!("{} Hz", short(hz)),
                    false => format!("{} Hz, of {mode}, which shares its motion", short(hz)),
                }
            }
            Limit::Falling { below, above } => format!(
                "{} above {}",
                short(above.value(tower)),
                short(below.value(tower))
            ),
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
}

/// A number with six significant digits, without zeros at the end.
fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    format!("{rounded}")
}
