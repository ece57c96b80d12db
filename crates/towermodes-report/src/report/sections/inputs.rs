//! The values of a table of the tower file, as rows of a report.

use towermodes::inputs::{Given, Input, Inputs, given_inputs};
use towermodes::number::Plain;

use super::super::table::Table;
use crate::number::{given, length};

/// The values of a table with their units, without those that are infinite by default; then other
/// facts.
pub(super) fn of_inputs(
    caption: &str,
    inputs: &dyn Inputs,
    others: impl IntoIterator<Item = (String, String)>,
) -> Table {
    of_inputs_but(caption, inputs, &[], others)
}

/// The same without the values of some keys.
pub(super) fn of_inputs_but(
    caption: &str,
    inputs: &dyn Inputs,
    left_out: &[&str],
    others: impl IntoIterator<Item = (String, String)>,
) -> Table {
    let mut table = Table::new(caption, ["quantity", "#value"]);
    for (name, value) in facts_but(inputs, left_out).into_iter().chain(others) {
        table.push([name, value]);
    }
    table
}

/// The values of a table with their units, without those that are infinite by default.
pub(super) fn facts(inputs: &dyn Inputs) -> Vec<(String, String)> {
    facts_but(inputs, &[])
}

fn facts_but(inputs: &dyn Inputs, left_out: &[&str]) -> Vec<(String, String)> {
    let all = given_inputs(inputs).into_iter();
    let all = all.filter(|(input, _)| !left_out.contains(&input.key));
    let facts =
        all.filter_map(|(input, value)| Some((labelled(input, value), shown(input, value)?)));
    facts.collect()
}

/// A row for each of several tables of one kind.
pub(super) fn of_list(caption: &str, all: &[impl Inputs], names: &[String]) -> Table {
    let first = all.first().map_or_else(Vec::new, |one| given_inputs(one));
    let header = first
        .iter()
        .map(|(input, value)| format!("#{}", labelled(input, *value)));
    let header: Vec<String> = header.collect();
    let mut table = Table::new(caption, header.iter().map(String::as_str));
    for one in all {
        let values = given_inputs(one).into_iter();
        table.push(values.map(|(input, value)| shown(input, value).unwrap_or_default()));
    }
    table.named(names).shortened()
}

/// The numbers of a table in a few words, each with its symbol, or with its name where it has none:
/// "φ′ 35°". Heights, which a table has in columns of their own, names, and the values of some keys
/// are not among them.
pub(super) fn in_short(inputs: &dyn Inputs, left_out: &[&str]) -> Vec<String> {
    let values = given_inputs(inputs).into_iter();
    let texts = values.filter_map(|(input, given)| {
        if input.is_height() || left_out.contains(&input.key) {
            return None;
        }
        let (meaning, unit) = (input.meaning(), input.spaced_unit);
        let (symbol, factor, unit) = input.symbol.unwrap_or((meaning, 1.0, unit));
        let text = match given {
            Given::Number(value) if input.is_quiet && value == input.default => return None,
            Given::Number(value) | Given::Optional(Some(value)) => {
                Plain(factor * value).to_string()
            }
            Given::Count(count) => count.to_string(),
            Given::Pair(Some([top, bottom])) if top == bottom => Plain(factor * top).to_string(),
            Given::Pair(Some(pair)) => {
                let [top, bottom] = pair.map(|value| Plain(factor * value));
                format!("{top} to {bottom}")
            }
            _ => return None,
        };
        Some(format!("{symbol} {text}{unit}"))
    });
    texts.collect()
}

/// "density of the water (kg/m³)".
fn labelled(input: &Input, value: Given) -> String {
    let meaning = input.meaning();
    if input.is_height() {
        return format!("{meaning} z (m)");
    }
    match (value.is_number(), input.unit()) {
        (false, _) => meaning.to_owned(),
        (true, "") => format!("{meaning} (−)"),
        (true, unit) => {
            let raised = unit.replace("m2", "m²").replace("m3", "m³");
            let raised = raised.replace("degrees", "°");
            format!("{meaning} ({raised})")
        }
    }
}

fn shown(input: &Input, value: Given) -> Option<String> {
    match value {
        Given::Number(value) if value.is_infinite() && value == input.default => None,
        Given::Number(value) | Given::Optional(Some(value)) if input.unit() == "m" => {
            Some(length(value))
        }
        Given::Number(value) | Given::Optional(Some(value)) => Some(given(value)),
        Given::Optional(None) => Some(input.otherwise.to_owned()).filter(|text| !text.is_empty()),
        Given::Pair(pair) => {
            let [top, bottom] = pair?.map(given);
            Some(format!("{top} to {bottom}"))
        }
        Given::Count(count) => Some(count.to_string()),
        Given::Triple(triple) => Some(triple.map(length).join(", ")),
        Given::Flag(flag) => Some(if flag { "yes" } else { "no" }.to_owned()),
        Given::Name(place, names) => Some(names[place?].to_owned()),
    }
}
