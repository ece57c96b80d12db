//! The limits of a design: their texts, and the limits of the shape as linear functions of the
//! input values of the tower.

use towermodes::{Operation, Parameter, TowerDescription};

use super::problem::{DesignProblem, Side, Variable};

/// One limit of a design.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Limit {
    /// A bound of a variable, by the index of the variable.
    Bound {
        /// The index of the variable.
        variable: usize,
        /// The lower or the upper bound.
        side: Side,
    },
    /// An end of a frequency band, by the index of its goal.
    Frequency {
        /// The index of the goal.
        goal: usize,
        /// The lower or the upper end.
        side: Side,
    },
    /// An input value must not exceed the one below it.
    Falling {
        /// The input value below.
        below: Parameter,
        /// The input value above.
        above: Parameter,
    },
    /// The ratio of diameter to wall thickness at a station.
    DiameterToWall {
        /// The station, from 0.
        station: usize,
        /// The lower or the upper end of the range.
        side: Side,
    },
    /// The angle of the cone between a station and the next one above.
    ConeAngle {
        /// The lower station, from 0.
        station: usize,
    },
}

/// A limit of the shape: Σ coefficient · input value ≤ 0, in units of `scale`.
#[derive(Debug, Clone)]
pub(super) struct Row {
    pub(super) limit: Limit,
    terms: Vec<(Parameter, f64)>,
    scale: f64,
}

impl Row {
    /// Its value for a tower: positive if the limit is violated.
    pub(super) fn value(&self, tower: &TowerDescription) -> f64 {
        let terms = self.terms.iter();
        let sum: f64 = terms.map(|(number, of)| of * number.value(tower)).sum();
        sum / self.scale
    }

    /// The derivative of the limit with respect to the value of a variable; `base` is the original
    /// tower.
    pub(super) fn derivative(&self, variable: &Variable, base: &TowerDescription) -> f64 {
        let numbers = variable.change.parameters();
        let of_terms = self.terms.iter().map(|(number, coefficient)| {
            match (numbers.contains(number), variable.change.operation()) {
                (false, _) => 0.0,
                (true, Operation::Scale) => coefficient * number.value(base),
                (true, Operation::Set | Operation::Add) => *coefficient,
            }
        });
        of_terms.sum::<f64>() / self.scale
    }

    /// The limit in its unit, and the change of its value per unit of relaxation.
    pub(super) fn unit(&self, problem: &DesignProblem, tower: &TowerDescription) -> (f64, f64) {
        let (value, raw) = match self.limit {
            Limit::DiameterToWall { station, side } => (
                problem.ratio(side),
                tower.stations[station].wall_thickness_m,
            ),
            Limit::ConeAngle { station } => {
                let degrees = problem.cone_angle_deg.unwrap_or_default();
                let [below, above] = [station, station + 1].map(|i| tower.stations[i].height_m);
                let per_radian = 2.0 * (above - below) / degrees.to_radians().cos().powi(2);
                (degrees, per_radian.to_radians())
            }
            _ => (0.0, 1.0),
        };
        (value, raw / self.scale)
    }
}

/// The limits of the shape of a tower, without those whose input values no variable changes.
pub(super) fn rows(problem: &DesignProblem, base: &TowerDescription) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for &[below, above] in &problem.falling {
        rows.push(Row {
            limit: Limit::Falling { below, above },
            terms: vec![(above, 1.0), (below, -1.0)],
            scale: 1.0,
        });
    }
    for station in 0..base.stations.len() {
        rows.extend(ratios(problem, station, base));
        rows.extend(cones(problem, station, base));
    }
    rows.retain(|row| {
        let changes = |variable: &Variable| row.derivative(variable, base) != 0.0;
        problem.variables.iter().any(changes)
    });
    for row in &mut rows {
        row.scale = range(row, problem, base);
    }
    rows
}

/// The largest change of a row by the variables within their bounds: its natural unit.
fn range(row: &Row, problem: &DesignProblem, base: &TowerDescription) -> f64 {
    let variables = problem.variables.iter();
    let changes = variables.map(|one| row.derivative(one, base).abs() * one.unit(base));
    changes.fold(f64::MIN_POSITIVE, f64::max)
}

fn number(name: &str, station: usize, base: &TowerDescription) -> Option<Parameter> {
    Parameter::parse(&format!("stations[{station}].{name}"), base).ok()
}

/// lowest · wall ≤ diameter ≤ highest · wall.
fn ratios(problem: &DesignProblem, station: usize, base: &TowerDescription) -> Vec<Row> {
    let numbers = (
        number("diameter", station, base),
        number("wall", station, base),
    );
    let (Some([low, high]), (Some(diameter), Some(wall))) = (problem.diameter_to_wall, numbers)
    else {
        return Vec::new();
    };
    let row = |side, of_diameter: f64, of_wall: f64| Row {
        limit: Limit::DiameterToWall { station, side },
        terms: vec![(diameter, of_diameter), (wall, of_wall)],
        scale: 1.0,
    };
    let mut rows = Vec::new();
    if high.is_finite() {
        rows.push(row(Side::Highest, 1.0, -high));
    }
    if low > 0.0 {
        rows.push(row(Side::Lowest, -1.0, low));
    }
    rows
}

/// |difference of the radii| ≤ tan(angle) · difference of the heights, in both directions.
fn cones(problem: &DesignProblem, station: usize, base: &TowerDescription) -> Vec<Row> {
    let of = |name: &str| {
        let below = number(name, station, base)?;
        Some([below, number(name, station + 1, base)?])
    };
    let (Some(angle), Some([diameter, next]), Some([height, above])) =
        (problem.cone_angle_deg, of("diameter"), of("height"))
    else {
        return Vec::new();
    };
    let both = 2.0 * angle.to_radians().tan();
    let is_step = base.stations[station].height_m == base.stations[station + 1].height_m;
    let row = |sign: f64| Row {
        limit: Limit::ConeAngle { station },
        terms: vec![
            (diameter, sign),
            (next, -sign),
            (height, both),
            (above, -both),
        ],
        scale: 1.0,
    };
    match is_step {
        true => Vec::new(),
        false => vec![row(1.0), row(-1.0)],
    }
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
                let unit = match (of.change.operation(), of.change.unit()) {
                    (Operation::Scale, _) | (_, "") => String::new(),
                    (_, unit) => format!(" {unit}"),
                };
                let bound = short(of.bound(side));
                format!("{} {} {bound}{unit}", of.change.name(), end(side))
            }
            Limit::Frequency { goal, side } => {
                let goal = &self.goals[goal];
                let hz = [goal.min_hz, goal.max_hz][side as usize];
                format!("{} {} {} Hz", goal.mode, end(side), short(hz))
            }
            Limit::Falling { below, above } => format!("{above} at most {below}"),
            Limit::DiameterToWall { station, side } => {
                let (end, ratio) = (end(side), short(self.ratio(side)));
                format!("diameter/wall at stations[{station}] {end} {ratio}")
            }
            Limit::ConeAngle { station } => {
                let angle = short(self.cone_angle_deg.unwrap_or_default());
                format!("cone angle above stations[{station}] at most {angle} degrees")
            }
        }
    }
}

/// A number with six significant digits, without zeros at the end.
pub(super) fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    format!("{rounded}")
}
