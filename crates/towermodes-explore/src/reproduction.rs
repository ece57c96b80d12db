//! The lines that reproduce a state: for a shell, and for Python.

use std::collections::{BTreeMap, HashMap};

use serde::Serialize;
use towermodes::Parameter;
use towermodes::number::Plain;
use towermodes_files::{Setting, TowerInput, rewritten};
use towermodes_report::report::quoted;

use super::explorer::Explorer;
use super::sheet::column_of;
use super::state::State;
use super::take::left_out;

/// The lines that reproduce a state.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Reproduction {
    /// Commands for a POSIX shell.
    pub shell: String,
    /// A script for Python.
    pub python: String,
    /// Data of the old file that the tower file of the state does not contain, in sentences.
    pub left_out: Vec<String>,
}

impl Reproduction {
    pub(crate) fn new(explorer: &Explorer, state: &State) -> Self {
        let commands = ["solve", "explore"].map(|name| explorer.command(name, state));
        Self {
            shell: commands.join("\n") + "\n",
            python: python(explorer, state),
            left_out: explorer.left_out(state),
        }
    }
}

impl Explorer {
    /// The lines that reproduce a state.
    pub fn reproduce(&self, state: &State) -> Reproduction {
        Reproduction::new(self, state)
    }

    /// Data that the tower file of a state does not contain; none for an impossible tower.
    fn left_out(&self, state: &State) -> Vec<String> {
        let file = &self.exploration.input;
        let changed = state.apply(file);
        let sentences =
            |changed: TowerInput| left_out(file, &rewritten(file, &changed.description));
        changed.map(sentences).unwrap_or_default()
    }

    /// A shell command for the file with the input values of a state.
    pub(crate) fn command(&self, name: &str, state: &State) -> String {
        let words = self.words(name, state);
        let words: Vec<String> = words.iter().map(|word| quoted(word)).collect();
        words.join(" ")
    }

    /// The same command as separate arguments.
    pub(crate) fn words(&self, name: &str, state: &State) -> Vec<String> {
        let of = &self.exploration;
        let mut words = vec!["towermodes".to_owned(), name.to_owned()];
        // A file that looks like an option comes last.
        let is_dashed = of.file.starts_with('-') && of.file != "-";
        words.extend((!is_dashed).then(|| of.file.clone()));
        words.extend(of.reading.iter().chain(&of.solving).cloned());
        // A plain solve compares nothing with the rotor.
        if name != "solve" {
            words.extend(of.rotating.iter().cloned());
        }
        if let Some(other) = self.other().filter(|_| name == "explore") {
            words.extend(["--against".to_owned(), other.exploration.file.clone()]);
        }
        for setting in self.settings(state) {
            words.extend(["--set".to_owned(), setting.to_string()]);
        }
        if is_dashed {
            words.extend(["--".to_owned(), of.file.clone()]);
        }
        words
    }

    /// The input values of a state; a column whose values all have the same factor is one setting.
    pub(crate) fn settings(&self, state: &State) -> Vec<Setting> {
        let columns = self.whole_columns(state);
        let is_in_column = |name: &str| columns.iter().any(|of| of.names.iter().any(|n| n == name));
        let singles = state.settings().into_iter();
        let singles = singles.filter(|setting| !is_in_column(setting.name()));
        let mut singles: Vec<Setting> = singles.collect();
        // In the order of the tower file: stations[2] before stations[10].
        let all = Parameter::all(&self.exploration.input.description).into_iter();
        let places: HashMap<String, usize> = all.map(|one| one.to_string()).zip(0..).collect();
        singles.sort_by_key(|setting| places.get(setting.name()).copied());
        let factors = columns.iter();
        let factors = factors.map(|of| Setting::new(format!("scale({})", of.column), of.factor));
        factors.chain(singles).collect()
    }

    /// The columns of which the state multiplies every input value by the same factor.
    fn whole_columns(&self, state: &State) -> Vec<WholeColumn> {
        if state.numbers.is_empty() {
            return Vec::new();
        }
        let description = &self.exploration.input.description;
        let mut columns: BTreeMap<String, Vec<(String, f64)>> = BTreeMap::new();
        for parameter in Parameter::all(description) {
            if let Some(column) = column_of(parameter) {
                let own = columns.entry(column).or_default();
                own.push((parameter.to_string(), parameter.value(description)));
            }
        }
        let whole = columns.into_iter().filter_map(|(column, numbers)| {
            let factor = common_factor(&numbers, state)?;
            let parameters = Parameter::parse_every(&column, description).ok()?;
            let names = numbers
                .into_iter()
                .map(|(name, _)| name)
                .collect::<Vec<_>>();
            (parameters.len() == names.len()).then_some(WholeColumn {
                column,
                names,
                factor,
            })
        });
        whole.collect()
    }
}

/// A column whose input values are all multiplied by one factor.
struct WholeColumn {
    column: String,
    names: Vec<String>,
    factor: f64,
}

/// The factor by which each input value of the file must be multiplied to give that of the state,
/// for at least two input values.
///
/// The page rounds products to twelve digits, so that no input field has seventeen.
fn common_factor(numbers: &[(String, f64)], state: &State) -> Option<f64> {
    const ROUNDED: f64 = 1e-11;
    let changed = |name: &String| state.numbers.get(name).copied();
    let has_multiple = |old: f64| old != 0.0 && old.is_finite();
    let (first, old) = numbers.iter().find(|(_, old)| has_multiple(*old))?;
    let quotient = changed(first)? / old;
    // The factor of a slider has few digits.
    let factor = (1e6 * quotient).round() / 1e6;
    let is_multiple = |(name, old): &(String, f64)| {
        let (new, product) = (changed(name).unwrap_or(*old), old * factor);
        // What is rigid stays so.
        new == product || (new - product).abs() <= ROUNDED * product.abs()
    };
    (numbers.len() > 1 && numbers.iter().all(is_multiple)).then_some(factor)
}

/// The Python script. Options that exist only in the command line are omitted.
fn python(explorer: &Explorer, state: &State) -> String {
    let of = &explorer.exploration;
    let mut text = String::from("import towermodes as tm\n\n");
    text.push_str(&format!("tower = tm.read({})\n", python_text(&of.file)));
    let settings = explorer.settings(state);
    if !settings.is_empty() {
        text.push_str("tower = tower.with_({\n");
        for setting in settings {
            let (name, value) = (python_text(setting.name()), Plain(setting.value()));
            text.push_str(&format!("    {name}: {value},\n"));
        }
        text.push_str("})\n");
    }
    text.push_str("print(tower.solve())\n");
    if !(of.reading.is_empty() && of.solving.is_empty()) {
        let options = of.reading.iter().chain(&of.solving).cloned();
        let options: Vec<String> = options.collect();
        text.push_str(&format!(
            "# The page was computed with the options {}: give read and solve the same.\n",
            options.join(" ")
        ));
    }
    text
}

fn python_text(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
