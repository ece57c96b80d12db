//! `[design.frequencies]`: the frequency bands of a design.

use std::ops::Range;

use super::super::study::refuse_keys;
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::{Value, number, wrong_kind};
use super::positive;
use super::schema::FREQUENCY;
use super::variable::range;
use crate::design_study::{DesignBand, DesignFrequency};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

const HINT: &str = "write { min = 0.3 }, { max = 0.4 }, { between = [0.3, 0.4] } in Hz, or { between = \"1P-3P\", margin = 0.1 } for the window between two multiples of the rotor speed";

/// All entries, in the order of the lines.
pub(super) fn frequencies(
    value: &Value<'_>,
    reading: &mut Reading,
) -> Option<Vec<DesignFrequency>> {
    let table = Table::with_any_keys(value, FREQUENCY.name, reading)?;
    let mut entries: Vec<_> = table.placed_entries().collect();
    entries.sort_by_key(|(_, span, _)| span.start);
    if entries.is_empty() {
        let what = "a mode in [design.frequencies]".to_owned();
        let mistake = Diagnostic::new(value.span(), DiagnosticKind::Missing { what });
        return reading.refuse(mistake.with_hint("add for example \"fore-aft 1\" = { min = 0.3 }"));
    }
    let read: Vec<Option<DesignFrequency>> = entries
        .into_iter()
        .map(|(name, span, value)| frequency(name, &span, value, reading))
        .collect();
    read.into_iter().collect()
}

fn frequency(
    name: &str,
    span: &Range<usize>,
    value: &Value<'_>,
    reading: &mut Reading,
) -> Option<DesignFrequency> {
    let mode = match name.parse() {
        Ok(mode) => Some(mode),
        Err(error) => {
            let kind = DiagnosticKind::ModeName(error);
            reading.refuse(Diagnostic::new(span.clone(), kind))
        }
    };
    let what = format!("`{name}`");
    if !value.get_ref().is_table() {
        return reading.refuse(wrong_kind(value, &what, "a band in braces").with_hint(HINT));
    }
    let table = Table::of(value, &what, &FREQUENCY, reading)?;
    let band = band(&table, &what, reading);
    Some(DesignFrequency {
        mode: mode?,
        band: band?,
        span: span.clone(),
    })
}

fn band(table: &Table<'_>, what: &str, reading: &mut Reading) -> Option<DesignBand> {
    let Some(between) = table.get("between") else {
        refuse_keys(table, &["margin"], "without between = \"1P-3P\"", reading);
        return of_ends(table, what, reading);
    };
    refuse_keys(table, &["min", "max"], "together with `between`", reading);
    if let Some(text) = between.get_ref().as_str() {
        let Some(multiples) = multiples(text) else {
            let mistake = wrong_kind(between, "between", "two frequencies or two multiples");
            return reading.refuse(mistake.with_hint(HINT));
        };
        let margin = table.get("margin").map(|value| margin(value, reading));
        let margin = margin.map_or(Some(None), |margin| margin.map(Some))?;
        return Some(DesignBand::Multiples(multiples, margin));
    }
    refuse_keys(table, &["margin"], "without between = \"1P-3P\"", reading);
    let [low, high] = range(between, "between", HINT, reading)?;
    let high = positive(between, "between", high, reading)?;
    match low >= 0.0 {
        true => Some(DesignBand::Hz([low, high])),
        false => {
            let kind = DiagnosticKind::out_of_range("between", low, "0 or positive");
            reading.refuse(Diagnostic::new(between.span(), kind))
        }
    }
}

/// `min` and `max`, at least one of them.
fn of_ends(table: &Table<'_>, what: &str, reading: &mut Reading) -> Option<DesignBand> {
    let mut end = |key: &str| {
        table.get(key).map(|value| {
            let hz = number(value, key, reading)?;
            positive(value, key, hz, reading)
        })
    };
    let (min, max) = (end("min"), end("max"));
    match (min, max) {
        (None, None)
            if ["min", "max", "between"]
                .iter()
                .any(|key| table.has_misspelled(key)) =>
        {
            None
        }
        (None, None) => {
            let what = format!("the band of {what}");
            let mistake = Diagnostic::new(table.span.clone(), DiagnosticKind::Missing { what });
            reading.refuse(mistake.with_hint(HINT))
        }
        (min, max) => {
            let (low, high) = (
                min.unwrap_or(Some(0.0))?,
                max.unwrap_or(Some(f64::INFINITY))?,
            );
            if low < high {
                return Some(DesignBand::Hz([low, high]));
            }
            let span = table.get("min").map_or(table.span.clone(), Value::span);
            let rule = format!("below max, {high}");
            let kind = DiagnosticKind::out_of_range("min", low, rule);
            reading.refuse(Diagnostic::new(span, kind))
        }
    }
}

/// `1P-3P`.
fn multiples(text: &str) -> Option<[usize; 2]> {
    let (lower, upper) = text.split_once('-')?;
    let multiple = |text: &str| {
        let number = text.trim().strip_suffix(['P', 'p'])?;
        number.parse::<usize>().ok().filter(|number| *number <= 100)
    };
    let (lower, upper) = (multiple(lower)?, multiple(upper)?);
    (lower < upper).then_some([lower, upper])
}

fn margin(value: &Value<'_>, reading: &mut Reading) -> Option<f64> {
    let margin = number(value, "margin", reading)?;
    match (0.0..1.0).contains(&margin) {
        true => Some(margin),
        false => {
            let rule = "a fraction from 0 to below 1, for example 0.1 for 10 %";
            let kind = DiagnosticKind::out_of_range("margin", margin, rule);
            reading.refuse(Diagnostic::new(value.span(), kind))
        }
    }
}
