//! The names in a design file, found in the tower.

use towermodes::{Change, Operation, Parameter, TowerDescription};

use crate::design_study::{DesignChoice, DesignChoices, DesignEach, DesignStudy, DesignVariable};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;

impl DesignStudy {
    /// The variables and limits of the design file for a tower.
    ///
    /// # Errors
    /// [`ReadError::Mistakes`] at each name that is not an input value of the tower, at an input
    /// value that two variables change, and at options that the input values do not allow.
    pub fn choices(&self, tower: &TowerDescription) -> Result<DesignChoices, ReadError> {
        let mut choices = DesignChoices::default();
        let mut mistakes = Vec::new();
        for (entry, variable) in self.variables.iter().enumerate() {
            match groups(variable, tower) {
                Ok(groups) => add((entry, variable), &groups, tower, &mut choices),
                Err(kind) => mistakes.push(Diagnostic::new(variable.name.span.clone(), kind)),
            }
        }
        mistakes.extend(self.repeated(&choices));
        match mistakes.is_empty() {
            true => Ok(choices),
            false => Err(ReadError::mistakes(&self.source, mistakes)),
        }
    }

    /// The mistake of an input value that two variables change, at the second.
    fn repeated(&self, choices: &DesignChoices) -> Option<Diagnostic> {
        let mut changed: std::collections::HashMap<Parameter, &str> = Default::default();
        for choice in &choices.variables {
            for &number in choice.change.parameters() {
                let Some(first) = changed.insert(number, choice.change.name()) else {
                    continue;
                };
                // The last entry that has the number is the second one.
                let of_name = |one: &&DesignVariable| {
                    let is_it = one.name.value.trim() == choice.change.name();
                    is_it || one.each != DesignEach::All
                };
                let place = self.variables.iter().rfind(of_name);
                let span = place.map_or(0..0, |variable| variable.name.span.clone());
                let what = format!("{number}, which `{first}` also changes,");
                let kind = DiagnosticKind::Repeated { what, times: 2 };
                let hint = "each input value may belong to only one variable";
                return Some(Diagnostic::new(span, kind).with_hint(hint));
            }
        }
        None
    }
}

/// The input values of a variable, in groups that have one value each.
fn groups(
    variable: &DesignVariable,
    tower: &TowerDescription,
) -> Result<Vec<Vec<Parameter>>, DiagnosticKind> {
    let change = Change::parse(&variable.name.value, tower).map_err(DiagnosticKind::Parameter)?;
    let numbers = change.parameters().to_vec();
    let needs_set = variable.each != DesignEach::All || variable.step.is_some();
    if needs_set && change.operation() != Operation::Set {
        let key = if variable.step.is_some() {
            "step"
        } else {
            "each"
        };
        return Err(DiagnosticKind::UnusedKey {
            key: key.to_owned(),
            because: "with scale(…) and add(…); give the plain names of the input values"
                .to_owned(),
        });
    }
    let by_height = |is_together: &dyn Fn([f64; 2], usize) -> bool| {
        let mut groups: Vec<Vec<Parameter>> = Vec::new();
        let mut last_m = f64::NAN;
        for (index, number) in numbers.iter().enumerate() {
            let height_m = height_m(*number, tower)?;
            match groups.last_mut() {
                Some(group) if is_together([last_m, height_m], index) => group.push(*number),
                _ => groups.push(vec![*number]),
            }
            last_m = height_m;
        }
        Some(groups)
    };
    let grouped = match variable.each {
        DesignEach::All => Some(vec![numbers.clone()]),
        DesignEach::Number => Some(numbers.iter().map(|number| vec![*number]).collect()),
        DesignEach::Height => by_height(&|[below, above], _| below == above),
        DesignEach::Can => by_height(&|[below, above], _| below < above),
    };
    grouped.ok_or_else(|| {
        DiagnosticKind::wrong_type(
            format!(
                "`{}` with each = \"height\" or \"can\"",
                variable.name.value
            ),
            "input values of stations, such as stations[*].wall",
            "other input values",
        )
    })
}

/// The height of the station to which an input value belongs.
fn height_m(number: Parameter, tower: &TowerDescription) -> Option<f64> {
    let name = number.to_string();
    let index = name.strip_prefix("stations[")?.split_once(']')?.0;
    let station = tower.stations.get(index.parse::<usize>().ok()?)?;
    Some(station.height_m)
}

fn add(
    (entry, variable): (usize, &DesignVariable),
    groups: &[Vec<Parameter>],
    tower: &TowerDescription,
    choices: &mut DesignChoices,
) {
    for group in groups {
        let name = match (variable.each, &group[..]) {
            (DesignEach::All, _) => variable.name.value.clone(),
            (_, [one]) => one.to_string(),
            (_, several) => {
                let names: Vec<String> = several.iter().map(Parameter::to_string).collect();
                format!("set({})", names.join(", "))
            }
        };
        // The names are those of numbers that were found.
        if let Ok(change) = Change::parse(&name, tower) {
            choices.variables.push(DesignChoice {
                change,
                entry,
                between: variable.between,
                step: variable.step,
            });
        }
    }
    if variable.is_falling {
        let pairs = groups.windows(2);
        let pairs = pairs.filter_map(|pair| Some([*pair[0].first()?, *pair[1].first()?]));
        choices.falling.extend(pairs);
    }
}
