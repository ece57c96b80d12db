//! `[calibrate.unknowns]`: the input values to be fitted, with their priors and bounds.

use std::ops::Range;

use super::super::study::unquoted;
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::{Value, every_row, list, number, wrong_kind};
use super::schema::{CALIBRATE, UNKNOWN};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::measured::NamedUnknown;
use crate::sampling::SamplingError;
use crate::study::Placed;

const HINT: &str =
    "write {}, or { prior = [mean, standard deviation], bounds = [lowest, highest] }";

/// All entries in the order of the lines; the table may be missing, because the command line may
/// name the unknowns.
pub(super) fn unknowns(root: &Table<'_>, reading: &mut Reading) -> Option<Vec<NamedUnknown>> {
    let Some(value) = root.get("calibrate") else {
        return Some(Vec::new());
    };
    let calibrate = Table::of(value, CALIBRATE.name, &CALIBRATE, reading)?;
    let Some(value) = calibrate.get("unknowns") else {
        return Some(Vec::new());
    };
    let table = Table::with_any_keys(value, UNKNOWN.name, reading)?;
    let mut entries: Vec<_> = table.placed_entries().collect();
    entries.sort_by_key(|(_, span, _)| span.start);
    let read: Vec<Option<NamedUnknown>> = entries
        .into_iter()
        .map(|(name, span, value)| unknown(name, &span, value, reading))
        .collect();
    read.into_iter().collect()
}

fn unknown(
    name: &str,
    span: &Range<usize>,
    value: &Value<'_>,
    reading: &mut Reading,
) -> Option<NamedUnknown> {
    if let Some(mistake) = unquoted(name, span, value, &UNKNOWN) {
        return reading.refuse(mistake);
    }
    let what = format!("`{name}`");
    if !value.get_ref().is_table() {
        let mistake = wrong_kind(value, &what, "a table in braces, such as {}");
        return reading.refuse(mistake.with_hint(HINT));
    }
    let table = Table::of(value, what, &UNKNOWN, reading)?;
    let prior = pair(&table, "prior", reading, |[_, deviation]| {
        (deviation <= 0.0).then_some(SamplingError::Deviation { deviation })
    });
    let bounds = pair(&table, "bounds", reading, |[low, high]| {
        (low >= high).then_some(SamplingError::Range { low, high })
    });
    let name = Placed {
        value: name.to_owned(),
        span: span.clone(),
    };
    Some(NamedUnknown {
        name,
        prior: prior?,
        bounds: bounds?,
    })
}

/// Two numbers, if they are given.
fn pair(
    table: &Table<'_>,
    key: &str,
    reading: &mut Reading,
    wrong: impl Fn([f64; 2]) -> Option<SamplingError>,
) -> Option<Option<[f64; 2]>> {
    let Some(value) = table.get(key) else {
        return Some(None);
    };
    let numbers = list(value, key, reading)?;
    let numbers = every_row(numbers, |_, entry| number(entry, key, reading))?;
    let Ok(pair) = <[f64; 2]>::try_from(&numbers[..]) else {
        let kind = DiagnosticKind::wrong_count(key, numbers.len(), 2);
        return reading.refuse(Diagnostic::new(value.span(), kind).with_hint(HINT));
    };
    match wrong(pair) {
        None => Some(Some(pair)),
        Some(error) => {
            let kind = DiagnosticKind::Sampling(error);
            reading.refuse(Diagnostic::new(value.span(), kind).with_hint(HINT))
        }
    }
}
