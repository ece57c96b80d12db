//! The input values of a tower by name, as text.

use towermodes::number::Plain;
use towermodes::{Parameter, TowerDescription};

use super::text::{name_line, text_table};

/// A row per input value: name, value, unit, meaning.
pub(crate) fn parameters(description: &TowerDescription, listed: &[Parameter]) -> String {
    let row = |parameter: &Parameter| {
        [
            parameter.to_string(),
            Plain(parameter.value(description)).to_string(),
            parameter.unit().to_owned(),
            match description.part_names.of(parameter.place()) {
                Some(name) => format!("{} of {name}", parameter.meaning()),
                None => parameter.meaning().to_owned(),
            },
        ]
    };
    let header = ["name", "value", "unit", "meaning"];
    let table = text_table(header, listed.iter().map(row), [1]);
    format!("{}{table}\n", name_line(&description.name))
}
