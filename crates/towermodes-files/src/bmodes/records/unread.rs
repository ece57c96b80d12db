//! Values of a deck that are not read because of a preceding count or switch: BModes ignores them
//! without a message.

use super::parameters::{self as p, Parameter};
use super::reader::{Reader, Value};
use crate::records::{Items, Line, Lines, MAX_COUNT};

/// Values that are not read: the byte in the main file of the count or switch, and the note.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Unread {
    pub(crate) at: usize,
    pub(crate) message: String,
    /// Whether they are soil values, which are not relevant to a floating platform.
    pub(crate) is_soil: bool,
}

impl Unread {
    pub(crate) fn new(at: usize, message: impl Into<String>) -> Self {
        Self {
            at,
            message: message.into(),
            is_soil: false,
        }
    }
}

/// The wires, platform, added mass or soil after `tow_support = 0`.
pub(super) fn after_no_support(reader: &Reader<'_>, tow_support: &Value<usize>) -> Option<Unread> {
    let shows = [
        &p::N_ATTACHMENTS,
        &p::MASS_PFORM,
        &p::N_SECS_M_DISTR,
        &p::N_SECS_K_DISTR,
    ];
    let given = |line: Line<'_>| {
        let parameter =
            Parameter::after_value(line).filter(|parameter| shows.contains(parameter))?;
        let value = line
            .first()?
            .number("")
            .ok()
            .filter(|value| *value != 0.0)?;
        Some((parameter.name, value))
    };
    let (name, value) = reader.lines.clone().find_map(given)?;
    let message = format!(
        "tow_support is 0, so the lines after it are not read, as in BModes, although {name} is {value} there; \
         write tow_support = 1 for guy wires or 2 for a platform or monopile"
    );
    Some(Unread::new(tow_support.span.start, message))
}

/// The wires after `n_attachments = 0` in a deck whose `tow_support` announces wires.
pub(super) fn no_attachments(reader: &Reader<'_>, n_attachments: &Value<usize>) -> Unread {
    let stiffness = |line: Line<'_>| {
        let is_stiffness = Parameter::after_numbers(line) == Some(&p::WIRE_STFNESS);
        let stiffness = line.first().filter(|_| is_stiffness)?.number("").ok()?;
        (stiffness != 0.0).then_some(stiffness)
    };
    let given = reader.lines.clone().find_map(stiffness);
    let message = match given {
        Some(stiffness) => format!(
            "n_attachments is 0, so the tower has no guy wires, as in BModes, although tow_support is 1 and wire_stfness is {stiffness:e} N/m below; \
             write the number of heights at which guy wires are attached"
        ),
        None => "n_attachments is 0, so the tower has no guy wires although tow_support is 1; write tow_support = 0, or the number of heights at which guy wires are attached".to_owned(),
    };
    Unread::new(n_attachments.span.start, message)
}

/// The sets of wires beyond `n_attachments`, if each of the four following lines has values for
/// them.
pub(super) fn sets_of_wires(reader: &Reader<'_>, n_attachments: &Value<usize>) -> Option<Unread> {
    let lines = reader.lines.clone().filter(|line| !line.is_blank());
    let given = lines.take(4).map(numbers).min()?;
    let read = n_attachments.value;
    let message = format!(
        "n_attachments is {read}, but the lines below give {given} sets of guy wires: only the first {read} are read, as in BModes"
    );
    (given > read).then(|| Unread::new(n_attachments.span.start, message))
}

/// The values of a table whose number of rows is 0, unless they are all zero, as in templates.
pub(super) fn table_of_no_rows(
    lines: &Lines<'_>,
    [count, _, values]: p::Table,
    at: usize,
) -> Option<Unread> {
    let line = lines.clone().nth(1)?;
    let given = values_of(line);
    if given.iter().all(|value| *value == 0.0) {
        return None;
    }
    let message = format!(
        "{name} is 0, so the {given} values of {} below are not read, as in BModes; write {name} = {given} to use them",
        values.name,
        name = count.name,
        given = given.len()
    );
    Some(Unread {
        is_soil: count == &p::N_SECS_K_DISTR,
        ..Unread::new(at, message)
    })
}

/// The number of numbers at the beginning of a line.
fn numbers(line: Line<'_>) -> usize {
    values_of(line).len()
}

/// The numbers at the beginning of a line, with repeats.
fn values_of(line: Line<'_>) -> Vec<f64> {
    let mut items = Items::new(line);
    let mut values = Vec::new();
    while let Ok(Some(item)) = items.next_item() {
        let Ok(value) = item.token.number("") else {
            break;
        };
        let room = MAX_COUNT.saturating_sub(values.len());
        values.extend(std::iter::repeat_n(value, item.repeats.min(room)));
    }
    values
}
