//! Tables whose values are described beside their fields: read by these descriptions.

use towermodes::Place;
use towermodes::inputs::{Given, Input, Inputs};

use super::reading::Reading;
use super::table::{Table, suggestion};
use super::values::{number, number_or_infinity, text, truth};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// Reads the values of a table into a blank one; none after a mistake. `at` gives the place of a
/// key.
pub(super) fn read<T: Inputs>(
    mut inputs: T,
    table: &Table<'_>,
    at: impl Fn(&'static str) -> Place,
    reading: &mut Reading,
) -> Option<T> {
    read_into(&mut inputs, table, &at, reading)?;
    Some(inputs)
}

/// The same in place.
pub(super) fn read_into(
    inputs: &mut dyn Inputs,
    table: &Table<'_>,
    at: &dyn Fn(&'static str) -> Place,
    reading: &mut Reading,
) -> Option<()> {
    let (mut is_complete, mut is_chosen) = (true, true);
    let mut missing = None;
    inputs.update(&mut |input, given| {
        // Another key decides that it is there: without a default it must be given.
        let is_needed = !input.is_required && matches!(given, Given::Number(n) if n.is_nan());
        if is_needed && table.get(input.key).is_none() {
            missing = missing.or(Some((input, given)));
            return given;
        }
        let read = value(input, given, table, at(input.key), reading);
        is_complete &= read.is_some();
        match (read, given) {
            // Any choice, so that a wrong name is the only mistake.
            (None, Given::Name(_, names)) => {
                is_chosen = false;
                Given::Name(Some(0), names)
            }
            (read, given) => read.unwrap_or(given),
        }
    });
    let mut idle = Vec::new();
    inputs.idle(&mut |input, _| idle.push(input));
    let mut is_idle = false;
    for input in idle.into_iter().filter(|_| is_chosen) {
        is_idle |= refuse_idle(input, table, reading).is_none();
    }
    is_complete &= !is_idle;
    if let Some((input, given)) = missing {
        // Beside a value that has no effect, that one is the mistake.
        if !is_idle {
            table.require(input.key, &hint(input, given), reading);
        }
        return None;
    }
    is_complete.then_some(())
}

/// A value of a table, or what stands for it where it is left out.
fn value(
    input: &'static Input,
    blank: Given,
    table: &Table<'_>,
    place: Place,
    reading: &mut Reading,
) -> Option<Given> {
    let value = match input.is_required {
        true => table.require(input.key, &hint(input, blank), reading)?,
        false => match table.get(input.key) {
            Some(value) => value,
            None => return Some(blank),
        },
    };
    if let Some((needed, remedy)) = input.needs
        && !table.has(needed)
    {
        let because = format!("without `{needed}`");
        table.refuse_unused(input.key, because, remedy, reading)?;
    }
    reading.remember(place, value.span());
    match blank {
        Given::Number(_) | Given::Optional(_) if input.may_be_infinite => {
            number_or_infinity(value, input.key, reading).map(|number| blank.with_number(number))
        }
        Given::Number(_) | Given::Optional(_) => {
            number(value, input.key, reading).map(|number| blank.with_number(number))
        }
        Given::Flag(_) => truth(value, input.key, reading).map(Given::Flag),
        Given::Name(_, names) => {
            let name = text(value, input.meaning(), reading)?;
            if let Some(place) = names.iter().position(|known| *known == name) {
                return Some(Given::Name(Some(place), names));
            }
            let hint = suggestion(name, names, "names:");
            let (what, name) = (input.meaning(), name.to_owned());
            let kind = DiagnosticKind::UnknownName { what, name };
            reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint))
        }
    }
}

/// Refuses a value that has no effect beside the others.
fn refuse_idle(input: &Input, table: &Table<'_>, reading: &mut Reading) -> Option<()> {
    let (because, remedy) = match (input.yields_to, input.needs) {
        (Some(other), _) => (format!("beside `{other}`"), "keep one of the two"),
        (None, None) => ("here".to_owned(), "remove it"),
        (None, Some((needed, remedy))) => match table.get(needed) {
            Some(value) => {
                let choice = value.get_ref().as_str().unwrap_or_default();
                (format!("with {needed} = \"{choice}\""), "remove it")
            }
            None if table.has_misspelled(needed) => return Some(()),
            None => (format!("without `{needed}`"), remedy),
        },
    };
    table.refuse_unused(input.key, because, remedy, reading)
}

/// What a file is told that lacks a required value.
fn hint(input: &Input, blank: Given) -> String {
    match (input.hint, blank, input.unit()) {
        ("", Given::Name(_, names), _) => {
            format!("{} = \"{}\"", input.key, names.join("\" or \""))
        }
        ("", _, "") => input.meaning().to_owned(),
        ("", _, unit) => format!("{} in {unit}", input.meaning()),
        (hint, ..) => hint.to_owned(),
    }
}
