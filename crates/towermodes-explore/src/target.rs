//! The lightest tower with a frequency in a band that the user gives, computed by `design` from the
//! present input values.

use serde::{Deserialize, Serialize};
use towermodes::number::four_digits;
use towermodes::{Change, ModeName, Options, Parameter, Solver, TowerDescription};
use towermodes_design::design::{Design, DesignProblem, Goal, Variable, design_while};

use super::explorer::{Explorer, Wanted};
use super::linked::Linked;
use super::refusal::Refusal;
use super::sheet::also_in;
use super::state::State;

/// A request for a tower with a frequency in a band.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct TargetQuestion {
    /// The changed input values, from which the search begins.
    #[serde(flatten)]
    pub state: State,
    /// The name of the mode, as in a design file: `fore-aft 1`.
    pub mode: String,
    /// Its lowest frequency, Hz; none for no limit.
    pub min_hz: Option<f64>,
    /// Its highest frequency, Hz; none for no limit.
    pub max_hz: Option<f64>,
    /// The input values that may change, with their bounds.
    pub variables: Vec<TargetVariable>,
}

/// An input value, or all input values of a column by one factor: `scale(stations[*].wall)`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct TargetVariable {
    /// Its name.
    pub name: String,
    /// Its lowest value.
    pub low: f64,
    /// Its highest value.
    pub high: f64,
}

/// A tower that was found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Found {
    /// The input values in which it differs from the file.
    #[serde(flatten)]
    pub state: State,
    /// Frequency and mass before and after the search, and its limits, in sentences.
    pub sentences: Vec<String>,
    /// Number of solved towers.
    pub solves: usize,
}

impl Explorer {
    /// A light tower with the frequency of the mode in a band. The search ends when `wanted`
    /// returns false.
    ///
    /// # Errors
    /// [`Refusal`]: the request is contradictory, or no such tower is found.
    pub fn target(&self, question: &TargetQuestion, wanted: Wanted<'_>) -> Result<Found, Refusal> {
        let (input, _) = self.changed(&question.state)?;
        let base = &input.description;
        let problem = question.problem(base, self)?;
        // The search has a solver of its own: the page asks on while it runs.
        let options = self.options(&input);
        let mut solver = Solver::new(Options {
            method: options.method,
            rotary_inertia: options.rotary_inertia,
            ..Options::default()
        });
        let found = design_while(base, &problem, &mut solver, &mut || wanted());
        let found = found.map_err(|error| {
            let variable = error.variable().map(str::to_owned);
            Refusal::new(error.to_string(), None, variable.into_iter().collect())
        })?;
        let mut changed = input.clone();
        changed.description = found.tower.clone();
        Ok(Found {
            state: State::between(&self.exploration.input, &changed),
            sentences: sentences(&found),
            solves: found.solves,
        })
    }
}

impl TargetQuestion {
    fn problem(
        &self,
        base: &TowerDescription,
        explorer: &Explorer,
    ) -> Result<DesignProblem, Refusal> {
        let mode: Result<ModeName, _> = self.mode.parse();
        let input = &explorer.exploration.input;
        let (file, linked) = (&input.description, Linked::of(input));
        let variable = |of: &TargetVariable| {
            let change = Change::parse(&moved_by_slider(&of.name, file, &linked), base);
            let change = change.map_err(|error| Refusal::of(&error))?;
            Ok(Variable {
                change,
                low: of.low,
                high: of.high,
                step: None,
            })
        };
        let variables: Result<Vec<Variable>, Refusal> =
            self.variables.iter().map(variable).collect();
        Ok(DesignProblem {
            variables: variables?,
            goals: vec![Goal {
                mode: mode.map_err(|error| Refusal::of(&error))?,
                min_hz: self.min_hz.unwrap_or(0.0),
                max_hz: self.max_hz.unwrap_or(f64::INFINITY),
            }],
            ..DesignProblem::default()
        })
    }
}

/// A slider of the page as a change of all input values that it moves: linked input values are set
/// with it, and a factor on the heights of stations also multiplies the heights of point masses.
fn moved_by_slider(name: &str, file: &TowerDescription, linked: &Linked) -> String {
    let column = name
        .strip_prefix("scale(")
        .and_then(|rest| rest.strip_suffix(')'));
    if let Some(column) = column {
        let all = linked.numbers().iter();
        let also = all.filter(|one| also_in(**one, linked).as_deref() == Some(column));
        let also: String = also.map(|one| format!(",{one}")).collect();
        return format!("scale({column}{also})");
    }
    match Parameter::parse(name, file) {
        Ok(parameter) => linked.change("set", parameter),
        Err(_) => name.to_owned(),
    }
}

/// "fore-aft 1: 0.2921 → 0.3 Hz", "mass: 249.7 → 251 t".
fn sentences(found: &Design) -> Vec<String> {
    let arrow = |before: Option<f64>, after: f64| {
        let before = before.map_or_else(|| "no such mode".to_owned(), four_digits);
        format!("{before} → {}", four_digits(after))
    };
    let reached = found.reached.iter();
    let frequencies =
        reached.map(|of| format!("{}: {} Hz", of.goal.mode, arrow(of.before_hz, of.after_hz)));
    let [before_t, after_t] = found.mass_kg.map(|kg| kg / 1000.0);
    let mass = format!(
        "mass of the structure: {} t",
        arrow(Some(before_t), after_t)
    );
    let local = (!found.is_stationary())
        .then(|| "the tower meets the band, but a lighter one may exist".to_owned());
    frequencies.chain([mass]).chain(local).collect()
}
