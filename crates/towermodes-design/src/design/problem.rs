//! The design problem.

use towermodes::{Change, ModeName, Operation, Parameter, TowerDescription};

/// The unit of the search is the range of the variable, but at most this many times the present
/// value, because with a wider unit the relevant values would be too close together.
const LARGEST_UNIT: f64 = 10.0;

/// A design variable: one input value, or several that are changed together.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// The input values that it changes.
    pub change: Change,
    /// Its lowest value.
    pub low: f64,
    /// Its highest value.
    pub high: f64,
    /// The increment of allowed values, which are multiples of it, for example of plate thickness.
    pub step: Option<f64>,
}

/// The frequency band of the mode with a name. If this mode is coupled, the band also applies to
/// every other mode that shares its motion ([`Holders::bound`](towermodes::modes::Holders::bound)),
/// because a small change of the tower exchanges the names of such modes.
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

/// The problem: find a light tower within these limits. The mass is
/// [`Tower::structure_mass_kg`](towermodes::Tower::structure_mass_kg).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DesignProblem {
    /// The design variables. No two variables may change the same input value.
    pub variables: Vec<Variable>,
    /// The bands of frequencies.
    pub goals: Vec<Goal>,
    /// Pairs of input values of which the second must not exceed the first, for example the wall
    /// thickness of a can and of the can above it.
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

    /// One end of its band, Hz; none if the band has no limit there.
    pub fn limit_hz(&self, side: Side) -> Option<f64> {
        match side {
            Side::Lowest => (self.min_hz > 0.0).then_some(self.min_hz),
            Side::Highest => self.max_hz.is_finite().then_some(self.max_hz),
        }
    }
}

impl Side {
    /// Both ends.
    pub const ALL: [Self; 2] = [Self::Lowest, Self::Highest];
}

impl Variable {
    /// Its value on a tower: the mean, if it sets several input values that differ.
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

    /// Whether it sets several input values that differ on a tower.
    pub(super) fn has_different(&self, base: &TowerDescription) -> bool {
        let mut values = self.change.parameters().iter().map(|one| one.value(base));
        let first = values.next();
        self.change.operation() == Operation::Set && values.any(|value| Some(value) != first)
    }

    /// One of its bounds.
    pub(super) fn bound(&self, side: Side) -> f64 {
        match side {
            Side::Lowest => self.low,
            Side::Highest => self.high,
        }
    }

    /// The lowest and highest multiple of the step within the bounds.
    pub(super) fn multiples(&self, step: f64) -> [f64; 2] {
        /// A bound counts as a multiple if it is one up to this rounding error.
        const ROUNDING: f64 = 1e-9;
        let low = (self.low / step - ROUNDING).ceil();
        let high = (self.high / step + ROUNDING).floor();
        [low, high]
    }

    /// The size of its input values: the largest on a tower, or 1 for a factor.
    pub(super) fn size(&self, base: &TowerDescription) -> f64 {
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
}

impl DesignProblem {
    /// The original tower with other values of the variables.
    pub(super) fn tower(&self, base: &TowerDescription, values: &[f64]) -> TowerDescription {
        let mut tower = base.clone();
        for (variable, value) in self.variables.iter().zip(values) {
            variable.change.apply(&mut tower, *value);
        }
        tower
    }

    /// One end of the allowed range of diameter/wall thickness.
    pub(super) fn ratio(&self, side: Side) -> f64 {
        self.diameter_to_wall.unwrap_or_default()[side as usize]
    }
}
