//! What is to be designed.

use std::collections::HashMap;

use towermodes::{Change, ModeName, Operation, Parameter, TowerDescription};

use super::error::DesignError;

/// Bounds may be this many times as large as the present value: beyond it a unit is mistaken.
pub(super) const WIDEST: f64 = 1e3;
/// The search moves in units of the range, but of at most this many times the present value: wider
/// bounds would hide the values that matter.
const LARGEST_UNIT: f64 = 10.0;

/// A number, or several that change together, that the design chooses.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// What its value changes.
    pub change: Change,
    /// Its lowest value.
    pub low: f64,
    /// Its highest value.
    pub high: f64,
    /// The distance of allowed values, which are multiples of it: steps of plate thickness.
    pub step: Option<f64>,
}

/// The band of a frequency: of the mode with a name, and of every other mode that holds the name
/// ([`Holders`](towermodes::modes::Holders)), because where two modes share a motion, a small
/// change of the tower exchanges their names.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Goal {
    /// The name of the mode.
    pub mode: ModeName,
    /// Its lowest frequency, Hz; 0 for none.
    pub min_hz: f64,
    /// Its highest frequency, Hz; infinite for none.
    pub max_hz: f64,
}

/// One of the two ends of a range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// The lower end.
    Lowest,
    /// The upper end.
    Highest,
}

/// The lightest tower within these limits is to be found. The mass is that of
/// [`Tower::mass_kg`](towermodes::Tower::mass_kg).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DesignProblem {
    /// What is chosen. No two variables may change the same number.
    pub variables: Vec<Variable>,
    /// The bands of frequencies.
    pub goals: Vec<Goal>,
    /// Pairs of numbers of which the second must not exceed the first, such as the wall thickness
    /// of a can and of the one above it.
    pub falling: Vec<[Parameter; 2]>,
    /// The lowest and highest ratio of outer diameter to wall thickness at every station.
    pub diameter_to_wall: Option<[f64; 2]>,
    /// The largest angle between wall and axis of every piece of the tower, degrees.
    pub cone_angle_deg: Option<f64>,
}

impl Goal {
    /// Whether a frequency is in its band.
    pub fn allows(&self, hz: f64) -> bool {
        self.min_hz <= hz && hz <= self.max_hz
    }

    /// One end of its band, Hz; none if there is none.
    pub fn limit_hz(&self, side: Side) -> Option<f64> {
        match side {
            Side::Lowest => (self.min_hz > 0.0).then_some(self.min_hz),
            Side::Highest => self.max_hz.is_finite().then_some(self.max_hz),
        }
    }
}

impl Side {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Lowest, Self::Highest];
}

impl Variable {
    /// Its value on a tower: of a list of different numbers their mean.
    pub(super) fn present(&self, base: &TowerDescription) -> f64 {
        match self.change.operation() {
            Operation::Scale => 1.0,
            Operation::Add => 0.0,
            Operation::Set => {
                let numbers = self.change.parameters();
                let sum: f64 = numbers.iter().map(|number| number.value(base)).sum();
                sum / numbers.len() as f64
            }
        }
    }

    /// Whether it sets several numbers that differ on a tower.
    pub(super) fn has_different(&self, base: &TowerDescription) -> bool {
        let mut values = self.change.parameters().iter().map(|one| one.value(base));
        let first = values.next();
        self.change.operation() == Operation::Set && values.any(|value| Some(value) != first)
    }

    /// The lowest and highest multiple of the step within the bounds.
    pub(super) fn multiples(&self, step: f64) -> [f64; 2] {
        /// A bound that is a multiple up to rounding counts.
        const ROUNDING: f64 = 1e-9;
        let low = (self.low / step - ROUNDING).ceil();
        let high = (self.high / step + ROUNDING).floor();
        [low, high]
    }

    fn check(&self) -> Result<(), DesignError> {
        let variable = || self.change.name().to_owned();
        let (low, high) = (self.low, self.high);
        if !(low.is_finite() && high.is_finite() && low < high) {
            let variable = variable();
            return Err(DesignError::Bounds {
                variable,
                low,
                high,
            });
        }
        if self.change.operation() == Operation::Scale && low <= 0.0 {
            let variable = variable();
            return Err(DesignError::Factor { variable, low });
        }
        if self.is_size() && low <= 0.0 {
            let variable = variable();
            return Err(DesignError::NotPositive { variable, low });
        }
        let Some(step) = self.step else { return Ok(()) };
        let [first, last] = self.multiples(step);
        match step > 0.0 && first <= last {
            true => Ok(()),
            false => Err(DesignError::NoStep {
                variable: variable(),
                step,
                low,
                high,
            }),
        }
    }
}

impl Variable {
    /// Whether its values are diameters or wall thicknesses.
    fn is_size(&self) -> bool {
        let is_size = |number: &Parameter| {
            let name = number.to_string();
            name.ends_with(".wall") || name.ends_with(".diameter")
        };
        self.change.operation() == Operation::Set && self.change.parameters().iter().any(is_size)
    }

    /// The size of its numbers: the largest on a tower, 1 for a factor.
    fn size(&self, base: &TowerDescription) -> f64 {
        match self.change.operation() {
            Operation::Scale => 1.0,
            Operation::Set | Operation::Add => {
                let numbers = self.change.parameters().iter();
                let sizes = numbers.map(|number| number.value(base).abs());
                sizes.filter(|size| size.is_finite()).fold(0.0, f64::max)
            }
        }
    }

    /// The unit in which the search moves.
    pub(super) fn unit(&self, base: &TowerDescription) -> f64 {
        let range = self.high - self.low;
        match self.size(base) {
            0.0 => range,
            size => range.min(LARGEST_UNIT * size),
        }
    }

    /// Refuses bounds far beyond the present value.
    fn check_width(&self, base: &TowerDescription) -> Result<(), DesignError> {
        let present = self.size(base);
        let (low, high) = (self.low, self.high);
        // Of a number that is 0 no size is known, but double precision has its limits.
        let widest = match present == 0.0 {
            true => 1e15,
            false => WIDEST * present,
        };
        match low.abs().max(high.abs()) <= widest {
            true => Ok(()),
            false => Err(DesignError::Wide {
                variable: self.change.name().to_owned(),
                low,
                high,
                present,
            }),
        }
    }
}

impl DesignProblem {
    /// Refuses bounds that are far beyond the values of the tower.
    pub(super) fn check_widths(&self, base: &TowerDescription) -> Result<(), DesignError> {
        let mut variables = self.variables.iter();
        variables.try_for_each(|variable| variable.check_width(base))
    }

    /// # Errors
    /// [`DesignError`] for what contradicts itself, whatever the tower.
    pub fn check(&self) -> Result<(), DesignError> {
        if self.variables.is_empty() {
            return Err(DesignError::NoVariables);
        }
        if self.goals.is_empty() {
            return Err(DesignError::NoGoals);
        }
        self.variables.iter().try_for_each(Variable::check)?;
        self.check_numbers()?;
        for &Goal {
            mode,
            min_hz,
            max_hz,
        } in &self.goals
        {
            if !(min_hz >= 0.0 && min_hz.is_finite() && min_hz < max_hz) {
                return Err(DesignError::Band {
                    mode,
                    min_hz,
                    max_hz,
                });
            }
        }
        self.check_limits()
    }

    /// No number is changed twice.
    fn check_numbers(&self) -> Result<(), DesignError> {
        let mut changed: HashMap<Parameter, &str> = HashMap::new();
        for variable in &self.variables {
            let second = variable.change.name();
            for &parameter in variable.change.parameters() {
                if let Some(first) = changed.insert(parameter, second) {
                    return Err(DesignError::Twice {
                        parameter: parameter.to_string(),
                        first: first.to_owned(),
                        second: second.to_owned(),
                    });
                }
            }
        }
        Ok(())
    }

    fn check_limits(&self) -> Result<(), DesignError> {
        if let Some([low, high]) = self.diameter_to_wall
            && !(low >= 0.0 && low < high)
        {
            let what = "diameter/wall";
            return Err(DesignError::Limit { what, low, high });
        }
        match self.cone_angle_deg {
            Some(angle) if !(angle > 0.0 && angle < 90.0) => Err(DesignError::Limit {
                what: "cone angle in degrees",
                low: angle,
                high: 90.0,
            }),
            _ => Ok(()),
        }
    }
}
