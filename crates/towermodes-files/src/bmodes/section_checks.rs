//! The rules for the rows of a section file.

use super::deck::Beam;
use super::main_file::END;
use super::parameters::COLUMNS;
use super::reader::Value;
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// A row as it is written.
pub(super) type Row = [Value<f64>; COLUMNS.len()];

/// The values that no section of such a beam can have.
pub(super) fn wrong(row: &Row, beam: Beam) -> Vec<Diagnostic> {
    let is_blade = beam == Beam::Blade;
    // Column, whether zero is allowed, whether the beam uses it.
    let rules = [
        (3, false, true),
        (6, false, true),
        (7, false, is_blade),
        (8, false, true),
        (9, false, true),
        (4, true, true),
        (5, true, is_blade),
    ];
    let mut mistakes = Vec::new();
    for (column, may_be_zero, is_used) in rules {
        let value = &row[column];
        let is_right = value.value > 0.0 || (may_be_zero && value.value == 0.0);
        if is_used && !is_right {
            let rule = if may_be_zero {
                "non-negative"
            } else {
                "positive"
            };
            let (name, _) = COLUMNS[column];
            mistakes.push(value.wrong(DiagnosticKind::out_of_range(name, value.value, rule)));
        }
    }
    let no_inertia = row[4].value == 0.0 && !(is_blade && row[5].value != 0.0);
    if no_inertia {
        let rule = "positive: it is the section's inertia in torsion";
        let kind = DiagnosticKind::out_of_range("flp_iner", 0.0, rule);
        let hint =
            "mass_den times the squared radius of gyration; a tube has mass_den (D^2 + d^2)/16";
        mistakes.push(row[4].wrong(kind).with_hint(hint));
    }
    mistakes
}

/// Checks that `sec_loc` increases from 0 to 1, with steps; its ends are set to exactly these.
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
            let kind = DiagnosticKind::not_rising("sec_loc", location.value, before, "");
            let hint = "rows go from the root to the tip; two rows at one sec_loc are a step";
            return Err(location.wrong(kind).with_hint(hint));
        }
        if index > 1 && location.value == rows[index - 2][0].value {
            let what = format!("sec_loc {}", location.value);
            let kind = DiagnosticKind::Repeated { what, times: 3 };
            let hint = "two rows make a step: keep the one below it and the one above it";
            return Err(location.wrong(kind).with_hint(hint));
        }
    }
    Ok(())
}

fn wrong_end(location: &Value<f64>, end: f64, name: &str) -> Diagnostic {
    let value = location.value;
    let what = format!("sec_loc of the {name} row");
    let kind = DiagnosticKind::out_of_range(what, value, end.to_string());
    let fraction = "sec_loc is a fraction of the flexible length";
    let hint = if end == 1.0 && value > 1.5 {
        format!("this looks like metres; {fraction}: divide by {value}")
    } else {
        format!("{fraction}, from 0 at its root to 1 at the tip")
    };
    location.wrong(kind).with_hint(hint)
}
