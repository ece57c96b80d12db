//! Tables whose values are described beside their fields: read by these descriptions.

use towermodes::Place;
use towermodes::inputs::{Given, Input, Inputs, Limit, given_inputs};

use super::text::reading::Reading;
use super::text::table::{Table, suggestion};
use super::text::values::{Value, list, number, number_or_infinity, text, truth, wrong_kind};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// Reads the values of a table into a blank struct; none after a mistake. `at` gives the place of a
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

/// Reads the values of a table into an existing struct.
pub(super) fn read_into(
    inputs: &mut dyn Inputs,
    table: &Table<'_>,
    at: &dyn Fn(&'static str) -> Place,
    reading: &mut Reading,
) -> Option<()> {
    let (groups, mut is_complete) = groups(inputs, table, at, reading);
    let mut is_chosen = true;
    let mut missing = Vec::new();
    inputs.update(&mut |input, given| {
        let (table, key) = match input.key.split_once('.') {
            None => (table, input.key),
            Some((group, key)) => match groups.iter().find(|(name, _)| *name == group) {
                Some((_, table)) => (table, key),
                None => return given,
            },
        };
        // Another key decides that it is there: without a default it must be given.
        let is_needed = !input.is_required && matches!(given, Given::Number(n) if n.is_nan());
        if is_needed && table.get(key).is_none() {
            missing.push((input, given));
            return given;
        }
        let read = value((input, key), given, table, at(input.key), reading);
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
    is_complete &= missing.is_empty();
    // Beside a value that has no effect, that one is the mistake.
    for (input, given) in missing.into_iter().filter(|_| !is_idle) {
        table.require(input.key, &hint(input, given), reading);
    }
    is_complete.then_some(())
}

/// The tables in a table, by their names, and whether all of them are tables.
fn groups<'t>(
    inputs: &dyn Inputs,
    table: &Table<'t>,
    at: &dyn Fn(&'static str) -> Place,
    reading: &mut Reading,
) -> (Vec<(&'static str, Table<'t>)>, bool) {
    let inputs = given_inputs(inputs);
    let keys = || {
        inputs
            .iter()
            .filter_map(|(input, _)| input.key.split_once('.'))
    };
    let (mut groups, mut are_tables) = (Vec::new(), true);
    let mut names: Vec<&'static str> = keys().map(|(group, _)| group).collect();
    names.dedup();
    for name in names {
        let Some(value) = table.get(name) else {
            continue;
        };
        reading.remember(at(name), value.span());
        let own = keys().filter(|(group, _)| *group == name);
        let known = own.map(|(_, key)| key).collect();
        match Table::with_known_keys(value, name, known, |_| None, reading) {
            Some(group) => groups.push((name, group)),
            None => are_tables = false,
        }
    }
    (groups, are_tables)
}

/// A value of a table, or its default if it is omitted.
fn value(
    (input, key): (&'static Input, &'static str),
    blank: Given,
    table: &Table<'_>,
    place: Place,
    reading: &mut Reading,
) -> Option<Given> {
    let value = match input.is_required {
        true => table.require(key, &hint(input, blank), reading)?,
        false => match table.get(key) {
            Some(value) => value,
            None => return Some(blank),
        },
    };
    reading.remember(place, value.span());
    match blank {
        Given::Number(_) | Given::Optional(_) if input.may_be_infinite => {
            number_or_infinity(value, input.key, reading).map(|number| blank.with_number(number))
        }
        Given::Number(_) | Given::Optional(_) => {
            number(value, input.key, reading).map(|number| blank.with_number(number))
        }
        Given::Triple(_) => triple(value, input, reading).map(Given::Triple),
        Given::Pair(_) => pair(value, key, reading).map(|pair| Given::Pair(Some(pair))),
        Given::Count(_) => count(value, input, reading).map(Given::Count),
        Given::Flag(_) => truth(value, key, reading).map(Given::Flag),
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

/// A value that is one number, or `[top, bottom]`.
fn pair(value: &Value<'_>, key: &str, reading: &mut Reading) -> Option<[f64; 2]> {
    if value.get_ref().as_array().is_none() {
        let is_number = value.get_ref().is_float() || value.get_ref().is_integer();
        if !is_number {
            let mistake = wrong_kind(value, key, "a number, or [top, bottom]");
            return reading.refuse(mistake);
        }
        return number(value, key, reading).map(|both| [both; 2]);
    }
    let values = list(value, key, reading)?;
    if values.len() != 2 {
        let kind = DiagnosticKind::wrong_count(key, values.len(), 2);
        let hint = format!("{key} = [at the top, at the bottom of the layer]");
        return reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint));
    }
    let (top, bottom) = (
        number(&values[0], key, reading),
        number(&values[1], key, reading),
    );
    Some([top?, bottom?])
}

/// A whole number; the checks of the tower limit it.
fn count(value: &Value<'_>, input: &Input, reading: &mut Reading) -> Option<usize> {
    let count = number(value, input.key, reading)?;
    if count.fract() == 0.0 && (0.0..=1e9).contains(&count) {
        return Some(count as usize);
    }
    let least = match input.limit {
        Limit::AtLeast(least) => least,
        _ => 0,
    };
    let rule = format!("a whole number of at least {least}");
    let kind = DiagnosticKind::out_of_range(input.key, count, rule);
    reading.refuse(Diagnostic::new(value.span(), kind))
}

/// `[x, y, z]`.
fn triple(value: &Value<'_>, input: &Input, reading: &mut Reading) -> Option<[f64; 3]> {
    let values = list(value, input.key, reading)?;
    if values.len() != 3 {
        let kind = DiagnosticKind::wrong_count(input.key, values.len(), 3);
        return reading.refuse(Diagnostic::new(value.span(), kind).with_hint(input.hint));
    }
    let mut entry = |i: usize| number(&values[i], &format!("{}[{i}]", input.key), reading);
    let (x, y, z) = (entry(0), entry(1), entry(2));
    Some([x?, y?, z?])
}

/// Refuses a value that has no effect with the other values.
fn refuse_idle(input: &Input, table: &Table<'_>, reading: &mut Reading) -> Option<()> {
    let (because, remedy) = match (input.yields_to, input.needs) {
        (Some(other), _) => (format!("together with `{other}`"), "keep one of the two"),
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

/// The hint for a missing required value.
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
