//! Checks of a problem: contradictions, and goals that its tower cannot have.

use std::collections::HashMap;

use towermodes::inputs::Nature;
use towermodes::{Operation, Parameter, TowerDescription};

use super::error::{DesignError, WIDEST};
use super::problem::{DesignProblem, Goal, Variable};

impl Variable {
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

    /// Whether the input values that it changes are always positive, such as diameters.
    fn is_size(&self) -> bool {
        let is_size = |number: &Parameter| number.nature() == Nature::Size;
        self.change.operation() == Operation::Set && self.change.parameters().iter().any(is_size)
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
    /// [`DesignError`] for a contradiction within the problem, whatever the tower.
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

    /// No input value is changed twice.
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
