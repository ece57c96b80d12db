//! What moves a frequency: its elasticities.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use towermodes::{Change, Options, Parameter, TowerDescription};
use towermodes_analysis::influence::{Influence, Influences, influences};

use super::explorer::Explorer;
use super::refusal::Refusal;
use super::sheet::column_of;
use super::state::State;

/// A question for the elasticities of a mode.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct ElasticityQuestion {
    /// The changed numbers.
    #[serde(flatten)]
    pub state: State,
    /// The number of the mode in the list, from 1.
    pub mode: usize,
}

/// Percent of a frequency per percent of each number.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Elasticities {
    /// The name of the mode: "1st fore-aft bending".
    pub mode: String,
    /// By the name of the number; those that are zero or have no derivative are left out.
    pub elasticities: BTreeMap<String, f64>,
    /// Percent of the frequency per percent of a factor on all numbers of a column, by the name of
    /// the column: `stations[*].wall`. It is no sum of the others: percent of a height are percent
    /// of the height of the tower.
    pub columns: BTreeMap<String, f64>,
}

impl Explorer {
    /// The elasticities of one mode with respect to all numbers.
    ///
    /// # Errors
    /// [`Refusal`].
    pub fn elasticities(&self, question: &ElasticityQuestion) -> Result<Elasticities, Refusal> {
        if question.mode == 0 {
            let message = "the number of the mode is 0; modes are counted from 1";
            return Err(Refusal::of(&message));
        }
        let (input, _) = self.changed(&question.state)?;
        let options = Options {
            modes: question.mode,
            points: 2,
            ..self.options(&input)
        };
        let description = &input.description;
        let columns = columns(description);
        let mut changes = Change::every(description);
        changes.extend(columns.iter().map(|(_, factor)| factor.clone()));
        let of = self.solver().with(options, |solver| {
            influences(description, Some(&changes), solver)
        });
        of.map(|of| Elasticities::new(&of, question.mode, description, &columns))
            .map_err(|error| Refusal::of(&error))
    }
}

impl Elasticities {
    /// The elasticities of the mode with a number, from 1; none of a mode that is not in the list.
    /// Numbers that change together, such as the heights of both ends of a step, share one. The
    /// factors of columns are the last influences.
    fn new(
        of: &Influences,
        mode: usize,
        description: &TowerDescription,
        columns: &[(String, Change)],
    ) -> Self {
        let index = mode.saturating_sub(1);
        let of_mode = |number: &Influence| number.elasticities.get(index).copied().flatten();
        let (numbers, factors) = of.numbers.split_at(of.numbers.len() - columns.len());
        let mut elasticities = BTreeMap::new();
        for number in numbers {
            let change = Change::parse(&number.name, description);
            let (Some(elasticity), Ok(change)) = (of_mode(number), change) else {
                continue;
            };
            let names = change.parameters().iter().map(ToString::to_string);
            elasticities.extend(names.map(|name| (name, elasticity)));
        }
        let factors = columns.iter().zip(factors);
        let factors = factors.filter_map(|((name, _), of)| Some((name.clone(), of_mode(of)?)));
        let label = of.modes.get(index).map(|mode| mode.label.clone());
        Self {
            mode: label.unwrap_or_default(),
            elasticities,
            columns: factors.collect(),
        }
    }
}

/// The columns by name, each with the factor on all its numbers; infinite ones have no multiple.
fn columns(description: &TowerDescription) -> Vec<(String, Change)> {
    let mut numbers: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for parameter in Parameter::all(description) {
        let is_finite = parameter.value(description).is_finite();
        if let Some(column) = column_of(parameter).filter(|_| is_finite) {
            let own = numbers.entry(column).or_default();
            own.push(parameter.to_string());
        }
    }
    let factor = |(column, names): (String, Vec<String>)| {
        let factor = Change::parse(&format!("scale({})", names.join(",")), description);
        Some((column, factor.ok()?))
    };
    numbers.into_iter().filter_map(factor).collect()
}
