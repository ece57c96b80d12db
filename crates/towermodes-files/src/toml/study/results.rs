//! `[sweep.results]`: the results that are computed and written for each row.

use towermodes::{MAX_SEGMENTS, Method, ModeName};

use super::super::text::reading::Reading;
use super::super::text::table::{Table, suggestion};
use super::super::text::values::{Value, every_row, text, truth, whole, wrong_kind};
use super::schema::RESULTS;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::study::{SweepModes, SweepResults};

/// The results, by default those of [`SweepResults::default`]; `None` after a mistake.
pub(super) fn results(sweep: &Table<'_>, reading: &mut Reading) -> Option<SweepResults> {
    let default = SweepResults::default();
    let Some(value) = sweep.get("results") else {
        return Some(default);
    };
    let table = Table::of(value, RESULTS.name, &RESULTS, reading)?;
    let modes = table.get("modes").map(|value| modes(value, reading));
    let segments = table.get("segments").map(|value| segments(value, reading));
    let method = table.get("method").map(|value| method(value, reading));
    let rotary_inertia = flag(&table, "rotary_inertia", default.rotary_inertia, reading);
    let inputs = flag(&table, "inputs", default.inputs, reading);
    Some(SweepResults {
        modes: modes.unwrap_or(Some(default.modes))?,
        segments: segments.map_or(Some(None), |found| found.map(Some))?,
        method: method.map_or(Some(None), |found| found.map(Some))?,
        rotary_inertia: rotary_inertia?,
        inputs: inputs?,
    })
}

fn flag(table: &Table<'_>, key: &str, default: bool, reading: &mut Reading) -> Option<bool> {
    match table.get(key) {
        None => Some(default),
        Some(value) => truth(value, key, reading),
    }
}

/// A number of modes, or a list of their names.
fn modes(value: &Value<'_>, reading: &mut Reading) -> Option<SweepModes> {
    let hint = "a number of modes, or a list of names, for example [\"fore-aft 1\", \"torsion 1\"]";
    if let Some(names) = value.get_ref().as_array() {
        let named = every_row(names, |_, name| mode_name(name, reading))?;
        if named.is_empty() {
            let kind = DiagnosticKind::wrong_count("modes", 0, "one or more");
            return reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint));
        }
        return match repeated(&named) {
            None => Some(SweepModes::Named(named)),
            Some(index) => {
                let (what, times) = (format!("the mode `{}`", named[index]), 2);
                let kind = DiagnosticKind::Repeated { what, times };
                reading.refuse(Diagnostic::new(names[index].span(), kind))
            }
        };
    }
    if value.get_ref().is_str() || value.get_ref().is_table() {
        let mistake = wrong_kind(value, "modes", "a number or a list of names");
        return reading.refuse(mistake.with_hint(hint));
    }
    whole(value, "modes", 1, reading).map(|count| SweepModes::Lowest(count as usize))
}

/// The index of the first name that occurs earlier in the list.
fn repeated(names: &[ModeName]) -> Option<usize> {
    (1..names.len()).find(|&index| names[..index].contains(&names[index]))
}

pub(in crate::toml) fn mode_name(value: &Value<'_>, reading: &mut Reading) -> Option<ModeName> {
    match text(value, "the name of a mode", reading)?.parse() {
        Ok(name) => Some(name),
        Err(error) => {
            let kind = DiagnosticKind::ModeName(error);
            reading.refuse(Diagnostic::new(value.span(), kind))
        }
    }
}

pub(in crate::toml) fn segments(value: &Value<'_>, reading: &mut Reading) -> Option<usize> {
    let found = whole(value, "segments", 1, reading)?;
    if found <= MAX_SEGMENTS as u64 {
        return Some(found as usize);
    }
    let rule = format!("at most {MAX_SEGMENTS}");
    let kind = DiagnosticKind::out_of_range("segments", found as f64, rule);
    reading.refuse(Diagnostic::new(value.span(), kind))
}

pub(in crate::toml) fn method(value: &Value<'_>, reading: &mut Reading) -> Option<Method> {
    let name = text(value, "method", reading)?;
    Method::named(name).or_else(|| {
        let names = Method::ALL.map(Method::name);
        let hint = suggestion(name, &names, "there are");
        let what = "method";
        let kind = DiagnosticKind::UnknownName {
            what,
            name: name.to_owned(),
        };
        reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint))
    })
}
