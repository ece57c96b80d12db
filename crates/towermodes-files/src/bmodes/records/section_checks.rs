//! The rules for the rows of a section file.

use super::deck::{Beam, Section};
use super::main_file::END;
use super::parameters::Column;
use super::reader::Value;
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// The mistakes in values that are impossible for a section of such a beam.
pub(crate) fn wrong(row: &Section, beam: Beam) -> Vec<Diagnostic> {
    let is_blade = beam == Beam::Blade;
    // The column, and whether zero is allowed.
    let rules = [
        (Column::Mass, false),
        (Column::Flap, false),
        (Column::Edge, false),
        (Column::Torsion, false),
        (Column::Axial, false),
        (Column::FlapInertia, true),
        (Column::EdgeInertia, true),
    ];
    let is_used =
        |column: Column| is_blade || !matches!(column, Column::Edge | Column::EdgeInertia);
    let mistake = |(column, may_be_zero): (Column, bool)| {
        let value = &row[column];
        let is_right = value.value > 0.0 || (may_be_zero && value.value == 0.0);
        let rule = if may_be_zero {
            "non-negative"
        } else {
            "positive"
        };
        let kind = || DiagnosticKind::out_of_range(column.name(), value.value, rule);
        (is_used(column) && !is_right).then(|| value.wrong(kind()))
    };
    let mistakes = rules.into_iter().filter_map(mistake);
    mistakes.chain(without_inertia(row, is_blade)).collect()
}

/// The mistake of a section without inertia in torsion.
fn without_inertia(row: &Section, is_blade: bool) -> Option<Diagnostic> {
    let flap = &row[Column::FlapInertia];
    if flap.value != 0.0 || (is_blade && row[Column::EdgeInertia].value != 0.0) {
        return None;
    }
    let rule = "positive: it is the section's inertia in torsion";
    let kind = DiagnosticKind::out_of_range("flp_iner", 0.0, rule);
    let hint = "mass_den times the squared radius of gyration; a tube has mass_den (D^2 + d^2)/16";
    Some(flap.wrong(kind).with_hint(hint))
}

/// Checks that `sec_loc` increases from 0 to 1, with steps; its ends are set to exactly 0 and 1.
pub(super) fn check_locations(rows: &mut [Section]) -> Result<(), Diagnostic> {
    let last = rows.len() - 1;
    for (index, end, name) in [(0, 0.0, "first"), (last, 1.0, "last")] {
        let location = &mut rows[index].0[Column::Location as usize];
        if (location.value - end).abs() > END {
            return Err(wrong_end(location, end, name));
        }
        location.value = end;
    }
    let location = |index: usize| &rows[index][Column::Location];
    for index in 1..rows.len() {
        let (here, before) = (location(index), location(index - 1).value);
        if here.value < before {
            let kind = DiagnosticKind::not_rising("sec_loc", here.value, before, "");
            let hint = "rows go from the root to the tip; two rows at one sec_loc are a step";
            return Err(here.wrong(kind).with_hint(hint));
        }
        if index > 1 && here.value == location(index - 2).value {
            let what = format!("sec_loc {}", here.value);
            let kind = DiagnosticKind::Repeated { what, times: 3 };
            let hint = "a step has two rows: keep the row below the step and the row above it";
            return Err(here.wrong(kind).with_hint(hint));
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
