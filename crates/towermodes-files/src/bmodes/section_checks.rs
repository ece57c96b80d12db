//! What the rows of a section file must satisfy.

use super::deck::Beam;
use super::main_file::END;
use super::reader::Value;
use super::sections::{COLUMNS, Row};
use crate::diagnostic::Diagnostic;

/// What no section of such a beam has.
pub(super) fn wrong(row: &Row, beam: Beam) -> Vec<Diagnostic> {
    let is_blade = beam == Beam::Blade;
    let positive = [(3, true), (6, true), (7, is_blade), (8, true), (9, true)];
    let not_negative = [(4, true), (5, is_blade)];
    let read = |(column, is_read): (usize, bool)| is_read.then_some(column);
    let mut mistakes = Vec::new();
    for column in positive.into_iter().filter_map(read) {
        let value = &row[column];
        if value.value <= 0.0 {
            let message = format!(
                "{} is {}, but must be positive",
                COLUMNS[column], value.value
            );
            mistakes.push(value.wrong(message));
        }
    }
    for column in not_negative.into_iter().filter_map(read) {
        let value = &row[column];
        if value.value < 0.0 {
            let message = format!(
                "{} is {}, but cannot be negative",
                COLUMNS[column], value.value
            );
            mistakes.push(value.wrong(message));
        }
    }
    let no_inertia = row[4].value == 0.0 && !(is_blade && row[5].value != 0.0);
    if no_inertia {
        let message = "flp_iner is 0: nothing resists the section's acceleration in torsion";
        let hint =
            "mass_den times the squared radius of gyration; a tube has mass_den (D^2 + d^2)/16";
        mistakes.push(row[4].wrong(message).with_hint(hint));
    }
    mistakes
}

/// Checks that `sec_loc` rises from 0 to 1, steps allowed; its ends are made exactly these.
pub(super) fn check_locations(rows: &mut [Row]) -> Result<(), Diagnostic> {
    let last = rows.len() - 1;
    for (index, end, name) in [(0, 0.0, "first"), (last, 1.0, "last")] {
        let location = &mut rows[index][0];
        if (location.value - end).abs() > END {
            return Err(wrong_end(location, end, name));
        }
        location.value = end;
    }
    for index in 1..rows.len() {
        let (location, before) = (&rows[index][0], rows[index - 1][0].value);
        if location.value < before {
            let message = format!(
                "sec_loc {} is below that of the row before, {before}",
                location.value
            );
            let hint = "rows go from the root to the tip; two rows at one sec_loc are a step";
            return Err(location.wrong(message).with_hint(hint));
        }
        if index > 1 && location.value == rows[index - 2][0].value {
            let message = format!("a third row at sec_loc {}: two make a step", location.value);
            let hint = "keep the row below the step and the row above it";
            return Err(location.wrong(message).with_hint(hint));
        }
    }
    Ok(())
}

fn wrong_end(location: &Value<f64>, end: f64, name: &str) -> Diagnostic {
    let value = location.value;
    let message = format!("sec_loc of the {name} row is {value}, but must be {end}");
    let hint = if end == 1.0 && value > 1.5 {
        format!(
            "this looks like metres; sec_loc is a share of the flexible length: divide by {value}"
        )
    } else {
        "sec_loc is a share of the flexible length, from 0 at its root to 1 at the tip".to_owned()
    };
    location.wrong(message).with_hint(hint)
}
