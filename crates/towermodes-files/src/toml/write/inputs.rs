//! Writes tables from the constants that describe the fields of their structs.

use towermodes::inputs::{Given, Input, Inputs, given_inputs};

use super::text::{number, triple};
use super::writing::Writing;

/// Writes the values of a table. Optional values are omitted if they have their default.
pub(super) fn values(inputs: &dyn Inputs, writing: &mut Writing) {
    let all = given_inputs(inputs);
    let is_written =
        |(input, given): &&(&Input, Given)| !input.is_quiet || !input.is_default(*given);
    let group = |input: &Input| Some(input.key.split_once('.')?.0);
    let same = |a: &(&Input, Given), b: &(&Input, Given)| {
        group(a.0).is_some_and(|one| Some(one) == group(b.0))
    };
    for values in all.chunk_by(same) {
        let written = values.iter().filter(is_written);
        let texts = written.filter_map(|(input, given)| Some((input.key, text(*given)?)));
        match group(values[0].0) {
            None => texts.for_each(|(key, text)| writing.value(key, &text)),
            // A table in one line.
            Some(name) => {
                let entry =
                    |(key, text): (&str, String)| format!("{} = {text}", &key[name.len() + 1..]);
                let entries: Vec<String> = texts.map(entry).collect();
                if !entries.is_empty() {
                    writing.value(name, &format!("{{ {} }}", entries.join(", ")));
                }
            }
        }
    }
}

/// The text of a value; one number for two equal ones.
fn text(given: Given) -> Option<String> {
    match given {
        Given::Number(value) | Given::Optional(Some(value)) => Some(number(value)),
        Given::Pair(Some([top, bottom])) if top == bottom => Some(number(top)),
        Given::Pair(Some([top, bottom])) => Some(format!("[{}, {}]", number(top), number(bottom))),
        Given::Triple(values) => Some(triple(values)),
        Given::Count(count) => Some(count.to_string()),
        Given::Flag(flag) => Some(flag.to_string()),
        Given::Name(Some(place), names) => Some(format!("\"{}\"", names[place])),
        Given::Optional(None) | Given::Pair(None) | Given::Name(None, _) => None,
    }
}
