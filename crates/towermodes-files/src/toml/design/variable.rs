//! `[design.variables]`: the design variables.

use std::ops::Range;

use super::super::study::unquoted;
use super::super::text::choice::{ChoiceWords, one_of};
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::{Value, every_row, list, number, wrong_kind};
use super::positive;
use super::schema::VARIABLE;
use crate::design_study::{DesignEach, DesignVariable};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::study::Placed;

const HINT: &str = "write { between = [lowest, highest] }, with step, each and order if needed";

/// The names of the groupings of input values into variables.
const EACH: [(&str, DesignEach); 3] = [
    ("number", DesignEach::Number),
    ("height", DesignEach::Height),
    ("can", DesignEach::Can),
];

/// All entries, in the order of the lines.
pub(super) fn variables(value: &Value<'_>, reading: &mut Reading) -> Option<Vec<DesignVariable>> {
    let table = Table::with_any_keys(value, VARIABLE.name, reading)?;
    let mut entries: Vec<_> = table.placed_entries().collect();
    entries.sort_by_key(|(_, span, _)| span.start);
    if entries.is_empty() {
        let what = "a variable in [design.variables]".to_owned();
        let mistake = Diagnostic::new(value.span(), DiagnosticKind::Missing { what });
        return reading.refuse(mistake.with_hint(super::LEAST));
    }
    let read: Vec<Option<DesignVariable>> = entries
        .into_iter()
        .map(|(name, span, value)| variable(name, &span, value, reading))
        .collect();
    read.into_iter().collect()
}

fn variable(
    name: &str,
    span: &Range<usize>,
    value: &Value<'_>,
    reading: &mut Reading,
) -> Option<DesignVariable> {
    if let Some(mistake) = unquoted(name, span, value, &VARIABLE) {
        return reading.refuse(mistake);
    }
    let what = format!("`{name}`");
    if !value.get_ref().is_table() {
        return reading.refuse(wrong_kind(value, &what, "bounds in braces").with_hint(HINT));
    }
    let table = Table::of(value, &what, &VARIABLE, reading)?;
    let between = table.require("between", HINT, reading);
    let between = between.and_then(|value| range(value, "between", HINT, reading));
    let step = table.get("step").map(|value| {
        let step = number(value, "step", reading)?;
        positive(value, "step", step, reading)
    });
    let each = match table.get("each") {
        None => Some(DesignEach::All),
        Some(value) => one_of(value, words("each"), &EACH, reading),
    };
    let is_falling = match table.get("order") {
        None => Some(false),
        Some(value) => {
            let orders = [("falling", true), ("free", false)];
            let order = one_of(value, words("order"), &orders, reading);
            if each == Some(DesignEach::All) {
                let hint = "add each = \"can\", \"height\" or \"number\", so that there are several values";
                table.refuse_unused("order", "without `each`", hint, reading);
            }
            order
        }
    };
    let step = step.map_or(Some(None), |step| step.map(Some))?;
    Some(DesignVariable {
        name: Placed {
            value: name.to_owned(),
            span: span.clone(),
        },
        between: between?,
        step,
        each: each?,
        is_falling: is_falling?,
    })
}

fn words(key: &'static str) -> ChoiceWords {
    ChoiceWords {
        known: "there are",
        ..ChoiceWords::of(key)
    }
}

/// Two numbers, the first lower than the second.
pub(super) fn range(
    value: &Value<'_>,
    what: &str,
    hint: &str,
    reading: &mut Reading,
) -> Option<[f64; 2]> {
    let values = list(value, what, reading)?;
    let found = every_row(values, |_, entry| number(entry, what, reading))?;
    let [low, high] = found[..] else {
        let kind = DiagnosticKind::wrong_count(what, found.len(), 2);
        return reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint));
    };
    if low < high {
        return Some([low, high]);
    }
    let kind = DiagnosticKind::Sampling(crate::sampling::SamplingError::Range { low, high });
    reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint))
}
