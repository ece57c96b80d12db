//! The input values that the page has changed.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use towermodes_files::{Setting, SettingError, TowerInput};

/// The origin of the input values, in notes and errors.
const PAGE: &str = "the page";

/// The input values that differ from the file, by their names in the tower file. All others have
/// the values of the file.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Name and value, in the units of the tower file.
    pub numbers: BTreeMap<String, f64>,
    /// Whether they belong to the tower of the comparison.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub is_of_other: bool,
}

impl State {
    /// The input values in which a description differs from that of a file.
    pub fn between(file: &TowerInput, changed: &TowerInput) -> Self {
        let all = towermodes::Parameter::all(&file.description);
        let pairs = all.into_iter().map(|one| {
            let values = [file, changed].map(|input| one.value(&input.description));
            (one, values)
        });
        let different = pairs.filter(|(_, [old, new])| old != new);
        let numbers = different.map(|(one, [_, new])| (one.to_string(), new));
        Self {
            numbers: numbers.collect(),
            is_of_other: false,
        }
    }

    /// The fragment of the page's address with these input values: `#rna.mass=360000`; empty if
    /// there are none. Characters that are not allowed in an address are percent-encoded.
    pub fn fragment(&self) -> String {
        let encoded = |name: &str| name.replace('[', "%5B").replace(']', "%5D");
        let numbers = self.settings().into_iter();
        let numbers = numbers.map(|one| encoded(&one.to_string()));
        let numbers: Vec<String> = numbers.collect();
        match numbers.is_empty() {
            true => String::new(),
            false => format!("#{}", numbers.join("&")),
        }
    }

    /// The input with these values.
    pub(crate) fn apply(&self, file: &TowerInput) -> Result<TowerInput, SettingError> {
        let mut input = file.clone();
        input.set(&self.settings(), PAGE)?;
        Ok(input)
    }

    /// The input values as settings of the command line.
    pub(crate) fn settings(&self) -> Vec<Setting> {
        let numbers = self.numbers.iter();
        let setting = |(name, value): (&String, &f64)| Setting::new(name.clone(), *value);
        numbers.map(setting).collect()
    }
}
