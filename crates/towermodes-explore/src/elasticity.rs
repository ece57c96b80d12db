//! What moves a frequency: its elasticities.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use towermodes::{Change, Options, TowerDescription};
use towermodes_analysis::influence::{Influences, influences};

use super::explorer::Explorer;
use super::refusal::Refusal;
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
}

impl Explorer {
    /// The elasticities of one mode with respect to all numbers.
    ///
    /// # Errors
    /// [`Refusal`].
    pub fn elasticities(&self, question: &ElasticityQuestion) -> Result<Elasticities, Refusal> {
        if question.mode == 0 {
            let message = "the number of the mode is 0; modes are counted from 1".to_owned();
            return Err(Refusal::new(message, None, Vec::new()));
        }
        let (input, _) = self.changed(&question.state)?;
        let options = Options {
            modes: question.mode,
            points: 2,
            ..self.options(&input)
        };
        let of = self.solver().with(options, |solver| {
            influences(&input.description, None, solver)
        });
        of.map(|of| Elasticities::new(&of, question.mode, &input.description))
            .map_err(|error| Refusal::new(error.to_string(), None, Vec::new()))
    }
}

impl Elasticities {
    /// The elasticities of the mode with a number, from 1; none of a mode that is not in the list.
    /// Numbers that change together, such as the heights of both ends of a step, share one.
    pub(crate) fn new(of: &Influences, mode: usize, description: &TowerDescription) -> Self {
        let index = mode.saturating_sub(1);
        let mut elasticities = BTreeMap::new();
        for number in &of.numbers {
            let elasticity = number.elasticities.get(index).copied().flatten();
            let change = Change::parse(&number.name, description);
            let (Some(elasticity), Ok(change)) = (elasticity, change) else {
                continue;
            };
            let names = change.parameters().iter().map(ToString::to_string);
            elasticities.extend(names.map(|name| (name, elasticity)));
        }
        let label = of.modes.get(index).map(|mode| mode.label.clone());
        Self {
            mode: label.unwrap_or_default(),
            elasticities,
        }
    }
}
