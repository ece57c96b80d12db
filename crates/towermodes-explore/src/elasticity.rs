//! The elasticities of a frequency.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use towermodes::number::digits;
use towermodes::{Change, Options, Parameter, Solver, TowerDescription};
use towermodes_analysis::influence::{Influence, Influences, influences};

use super::explorer::{Explorer, Wanted};
use super::linked::Linked;
use super::refusal::Refusal;
use super::sheet::{also_in, column_of};
use super::state::State;

/// Time limit of an answer to a question for given names, ms: the page asks again for the remaining
/// names, unless it has asked another question by then.
const BUDGET_MS: f64 = 300.0;
/// Number of sliders in the first batch. Each batch solves the tower once.
const FIRST_BATCH: usize = 8;
/// A batch that takes less time than this, ms, is followed by a larger one.
const QUICK_MS: f64 = 60.0;
/// The ratio of the sizes of these batches.
const GROWTH: usize = 16;

/// A question for the elasticities of a mode.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct ElasticityQuestion {
    /// The changed input values.
    #[serde(flatten)]
    pub state: State,
    /// The number of the mode in the list, from 1.
    pub mode: usize,
    /// Its name: "1st fore-aft bending". Sensitivities are computed on another mesh, on which modes
    /// with nearly equal frequencies can have another order.
    #[serde(default)]
    pub label: Option<String>,
    /// The names of the parameters and columns to compute, the most urgent first; all if absent.
    #[serde(default)]
    pub names: Option<Vec<String>>,
}

/// The elasticities of a frequency: its change in percent for a 1 % change of each input value.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Elasticities {
    /// The name of the mode: "1st fore-aft bending".
    pub mode: String,
    /// The elasticities, by the name of the input value.
    pub elasticities: BTreeMap<String, f64>,
    /// Change of the frequency in percent for a 1 % change of a factor on all input values of a
    /// column, by the name of the column: `stations[*].wall`. This is not the sum of the other
    /// elasticities, because for a height 1 % means 1 % of the tower height.
    pub columns: BTreeMap<String, f64>,
    /// Why an input value or a column has no elasticity, by its name.
    pub reasons: BTreeMap<String, NoElasticity>,
    /// The requested names that are not yet answered.
    pub left: Vec<String>,
    /// Duration, ms.
    pub answer_ms: f64,
}

/// A derivative below this is due to rounding, % per unit: a change by 10¹² units, the size of
/// stiffnesses, would change the frequency by 10⁻¹³ %.
const ROUNDING_PERCENT: f64 = 1e-25;

/// Why a number has no elasticity.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct NoElasticity {
    /// The text instead of the elasticity: for an input value that is zero the derivative, "−0.72
    /// %/m".
    pub short: String,
    /// The reason in a sentence.
    pub text: String,
}

/// A slider of the page: an input value with those that move with it, or a column.
struct Slider {
    name: String,
    change: Change,
    /// The names of the input values; empty for a column.
    numbers: Vec<String>,
}

impl Explorer {
    /// The elasticities of one mode with respect to the sliders. The computation ends when `wanted`
    /// returns false.
    ///
    /// # Errors
    /// [`Refusal`].
    pub fn elasticities(
        &self,
        question: &ElasticityQuestion,
        wanted: Wanted<'_>,
    ) -> Result<Elasticities, Refusal> {
        let started = self.now_ms();
        if question.mode == 0 {
            let message = "the number of the mode is 0; modes are counted from 1";
            return Err(Refusal::of(&message));
        }
        let (input, _) = self.changed(&question.state)?;
        let mut left = self.sliders(&input.description, question.names.as_deref());
        let mut found = Elasticities::none(question);
        // A solver of its own: the page asks on while it runs.
        let mut solver = Solver::new(Options {
            // A mode with nearly the same frequency may come first.
            modes: question.mode + 1,
            points: 2,
            ..self.options(&input)
        });
        let mut size = match question.names {
            Some(_) => FIRST_BATCH,
            None => left.len(),
        };
        while !left.is_empty() && (question.names.is_none() || self.now_ms() - started < BUDGET_MS)
        {
            if !wanted() {
                return Err(Refusal::of(&"the elasticities were cancelled"));
            }
            let begun = self.now_ms();
            let batch: Vec<Slider> = left.drain(..size.min(left.len())).collect();
            let changes: Vec<Change> = batch.iter().map(|one| one.change.clone()).collect();
            let of = influences(&input.description, Some(&changes), &mut solver);
            found.add(&batch, &of.map_err(|error| Refusal::of(&error))?, question);
            if self.now_ms() - begun < QUICK_MS {
                size = size.saturating_mul(GROWTH);
            }
        }
        found.left = left.into_iter().map(|one| one.name).collect();
        found.answer_ms = self.now_ms() - started;
        Ok(found)
    }

    /// The sliders with these names, in this order, or all sliders. The file determines which input
    /// values move together.
    fn sliders(&self, description: &TowerDescription, names: Option<&[String]>) -> Vec<Slider> {
        let linked = Linked::of(&self.exploration.input);
        let columns = columns(&linked, description);
        let places = names.into_iter().flatten().enumerate();
        let places: BTreeMap<&str, usize> =
            places.map(|(place, name)| (name.as_str(), place)).collect();
        let is_asked = |name: &str| names.is_none() || places.contains_key(name);
        let singles = linked.with_sliders().filter(|one| !one.is_of_rotor());
        let singles = singles.filter(|one| is_asked(&one.to_string()));
        let singles = singles.filter_map(|one| single(&linked, one, description));
        let columns = columns.into_iter().filter(|one| is_asked(&one.name));
        let mut sliders: Vec<Slider> = singles.chain(columns).collect();
        sliders.sort_by_key(|one| places.get(one.name.as_str()).copied());
        sliders
    }
}

impl Elasticities {
    fn none(question: &ElasticityQuestion) -> Self {
        Self {
            mode: question.label.clone().unwrap_or_default(),
            elasticities: BTreeMap::new(),
            columns: BTreeMap::new(),
            reasons: BTreeMap::new(),
            left: Vec::new(),
            answer_ms: 0.0,
        }
    }

    /// Adds the elasticities of the mode of the question with respect to a batch of sliders.
    fn add(&mut self, batch: &[Slider], of: &Influences, question: &ElasticityQuestion) {
        let named = question.label.as_ref();
        let named = named.and_then(|label| of.modes.iter().position(|mode| mode.label == *label));
        let index = named.unwrap_or(question.mode - 1);
        let Some(mode) = of.modes.get(index) else {
            return;
        };
        self.mode.clone_from(&mode.label);
        for (slider, influence) in batch.iter().zip(&of.numbers) {
            match influence.elasticities[index] {
                Some(elasticity) if slider.numbers.is_empty() => {
                    self.columns.insert(slider.name.clone(), elasticity);
                }
                Some(elasticity) => {
                    let names = slider.numbers.iter().cloned();
                    self.elasticities
                        .extend(names.map(|name| (name, elasticity)));
                }
                None => {
                    let reason = NoElasticity::of(influence, index);
                    self.reasons.insert(slider.name.clone(), reason);
                }
            }
        }
    }
}

impl NoElasticity {
    fn of(influence: &Influence, mode: usize) -> Self {
        if let Err(reason) = influence.derivatives[mode] {
            return Self {
                short: String::new(),
                text: format!("No elasticity: {reason}."),
            };
        }
        // One percent of zero is zero; so little is left by rounding.
        let percent = influence.percent_per_unit(mode).unwrap_or(0.0);
        let percent = if percent.abs() < ROUNDING_PERCENT {
            0.0
        } else {
            percent
        };
        let unit = influence.unit;
        let size = digits(percent.abs(), 2);
        let number = match (percent == 0.0, percent < 0.0) {
            (true, _) => "0".to_owned(),
            (_, true) => format!("−{size}"),
            (_, false) => format!("+{size}"),
        };
        let per_unit = if unit.is_empty() { "" } else { "/" };
        let short = format!("{number} %{per_unit}{unit}");
        Self {
            text: format!(
                "The value is 0, so it has no elasticity: the frequency changes by {short}."
            ),
            short,
        }
    }
}

/// The slider of an input value with those that move with it.
fn single(linked: &Linked, leader: Parameter, description: &TowerDescription) -> Option<Slider> {
    let change = Change::parse(&linked.change("add", leader), description).ok()?;
    let numbers = linked.moved_by(leader).into_iter();
    Some(Slider {
        name: leader.to_string(),
        change,
        numbers: numbers.map(|one| one.to_string()).collect(),
    })
}

/// The columns by name, each with the factor on all its input values; columns with infinite values
/// are omitted, because a factor does not change these.
fn columns(linked: &Linked, description: &TowerDescription) -> Vec<Slider> {
    let mut numbers: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for &parameter in linked.numbers() {
        if !parameter.value(description).is_finite() {
            continue;
        }
        let columns = column_of(parameter).into_iter();
        let columns = columns.chain(also_in(parameter, linked));
        for column in columns {
            numbers
                .entry(column)
                .or_default()
                .push(parameter.to_string());
        }
    }
    let factor = |(name, names): (String, Vec<String>)| {
        let change = Change::parse(&format!("scale({})", names.join(",")), description).ok()?;
        Some(Slider {
            name,
            change,
            numbers: Vec::new(),
        })
    };
    numbers.into_iter().filter_map(factor).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;
    use std::sync::atomic::{AtomicU32, Ordering};

    use towermodes_files::{Input, ReadOptions, read};

    use super::{BUDGET_MS, ElasticityQuestion};
    use crate::explorer::{Exploration, Explorer};
    use crate::state::State;

    fn explorer(clock: fn() -> f64) -> Explorer {
        let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
        let file = examples.join("monopile.toml");
        let Ok(Input::Tower(input)) = read(&file, &ReadOptions::default()) else {
            panic!("no tower");
        };
        let report = Box::new(|_, _: &[String]| Err("no report".to_owned()));
        Explorer::new(Exploration::of_file(
            *input,
            "monopile.toml".to_owned(),
            report,
            clock,
        ))
    }

    fn question(names: Option<Vec<String>>) -> ElasticityQuestion {
        ElasticityQuestion {
            state: State::default(),
            mode: 1,
            label: Some("1st fore-aft bending".to_owned()),
            names,
        }
    }

    /// A clock on which every reading takes half the time limit of an answer.
    fn slow() -> f64 {
        static LOOKS: AtomicU32 = AtomicU32::new(0);
        0.5 * BUDGET_MS * f64::from(LOOKS.fetch_add(1, Ordering::Relaxed))
    }

    /// A slow model is answered in parts, the first requested names first, and each part ends in
    /// time; the mode is identified by its label.
    #[test]
    fn slow_answers_come_in_parts() {
        let explorer = explorer(slow);
        let names = [
            "rna.mass",
            "stations[*].wall",
            "stations[0].wall",
            "stations[1].height",
            "stations[1].wall",
            "stations[2].wall",
            "stations[3].wall",
            "stations[3].height",
            "stations[3].diameter",
            "foundation.lateral",
        ];
        let mut left: Vec<String> = names.map(str::to_owned).to_vec();
        let mut parts = 0;
        let mut known = Vec::new();
        while !left.is_empty() {
            let of = explorer.elasticities(&question(Some(left.clone())), &|| true);
            let of = of.expect("elasticities");
            assert_eq!(of.mode, "1st fore-aft bending");
            assert!(of.left.len() < left.len(), "nothing is answered");
            known.extend(of.elasticities.into_keys().chain(of.columns.into_keys()));
            left = of.left;
            parts += 1;
        }
        assert_eq!(parts, 2);
        // A joint is one slider of two stations and the point mass that stands there.
        for name in names
            .iter()
            .chain(&["stations[2].height", "point_mass[0].height"])
        {
            assert!(known.iter().any(|one| one == name), "{name}: {known:?}");
        }
    }

    #[test]
    fn an_answer_that_nobody_wants_is_given_up() {
        let explorer = explorer(|| 0.0);
        let refused = explorer.elasticities(&question(None), &|| false);
        let refused = refused.expect_err("nobody waits");
        assert!(refused.refused.message.contains("cancelled"));
    }
}
