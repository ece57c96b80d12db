//! Tables whose values are described beside their fields: written by these descriptions.

use towermodes::inputs::{Given, Inputs, given_inputs};

use super::writing::Writing;

/// The values of a table. Quiet ones are left out where they have their default, unless another
/// value that is written needs them.
pub(super) fn values(inputs: &dyn Inputs, writing: &mut Writing) {
    let all = given_inputs(inputs);
    let is_written = |(input, given): &(&towermodes::inputs::Input, Given)| match *given {
        Given::Number(value) => !input.is_quiet || value != input.default,
        Given::Optional(value) => value.is_some(),
        Given::Flag(flag) => flag || !input.is_quiet,
        Given::Name(place, _) => place.is_some_and(|place| place != 0 || !input.is_quiet),
    };
    let written = all.iter().filter(|value| is_written(value));
    let needed: Vec<&str> = written
        .filter_map(|(input, _)| Some(input.needs?.0))
        .collect();
    for (input, given) in &all {
        if is_written(&(input, *given)) || needed.contains(&input.key) {
            value(input.key, *given, writing);
        }
    }
}

fn value(key: &str, given: Given, writing: &mut Writing) {
    match given {
        Given::Number(value) | Given::Optional(Some(value)) => writing.number(key, value),
        Given::Flag(flag) => writing.value(key, &flag.to_string()),
        Given::Name(Some(place), names) => writing.value(key, &format!("\"{}\"", names[place])),
        Given::Optional(None) | Given::Name(None, _) => {}
    }
}
