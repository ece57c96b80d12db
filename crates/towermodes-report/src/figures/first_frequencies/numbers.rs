//! The bar in words and as a table.

use towermodes_analysis::resonance::Margin;

use super::Bar;
use super::ranges::{Lane, Range};
use crate::number::{four_digits, short};
use crate::svg::DataTable;
use crate::wording::verdict_word;

const MINUS: &str = "\u{2212}";

/// What is to be seen.
pub(super) fn description(bar: &Bar) -> String {
    let ranges: Vec<String> = bar.ranges.iter().map(range_text).collect();
    let lanes: Vec<String> = bar.lanes.iter().map(lane_text).collect();
    let kept_free = bar.ranges.iter().map(|range| between(range.kept_free_hz));
    let kept_free: Vec<String> = kept_free.collect();
    format!(
        "In operation {}; with a margin of {} % that keeps {} Hz free of natural frequencies. {}.",
        ranges.join(" and "),
        short(100.0 * bar.margin, 3),
        kept_free.join(" and "),
        lanes.join("; ")
    )
}

/// "1P excites from 0.115 to 0.2017 Hz".
fn range_text(range: &Range) -> String {
    let [low, high] = range.operation_hz.map(four_digits);
    match low == high {
        true => format!("{}P excites at {low} Hz", range.multiple),
        false => format!("{}P excites from {low} to {high} Hz", range.multiple),
    }
}

/// "0.115 to 0.2017".
fn between([low, high]: [f64; 2]) -> String {
    format!("{} to {}", four_digits(low), four_digits(high))
}

fn lane_text(lane: &Lane) -> String {
    let distances: Vec<String> = lane.margins.iter().map(margin_text).collect();
    let distances = match distances.len() {
        0 => String::new(),
        _ => format!(", where {}", distances.join(" and ")),
    };
    format!(
        "{} is at {} Hz{distances}",
        lane.label,
        four_digits(lane.frequency_hz)
    )
}

/// "3P stays 6.4 % above it".
fn margin_text(margin: &Margin) -> String {
    let side = if margin.distance > 0.0 {
        "above"
    } else {
        "below"
    };
    match margin.distance == 0.0 {
        true => format!("{}P meets it", margin.multiple),
        false => format!(
            "{}P stays {:.1} % {side} it",
            margin.multiple,
            100.0 * margin.distance.abs()
        ),
    }
}

/// "3P +6.4 %", or that it meets the mode.
pub(super) fn distance(margin: &Margin) -> String {
    if margin.distance == 0.0 {
        return format!("met by {}P", margin.multiple);
    }
    format!("{}P {} %", margin.multiple, signed_percent(margin))
}

fn signed_percent(margin: &Margin) -> String {
    if margin.distance == 0.0 {
        return "0".to_owned();
    }
    format!("{:+.1}", 100.0 * margin.distance).replace('-', MINUS)
}

/// Each mode against each excitation.
pub(super) fn table(bar: &Bar) -> DataTable {
    let header = [
        "mode",
        "frequency (Hz)",
        "error (Hz)",
        "excitation",
        "in operation (Hz)",
        "kept free (Hz)",
        "n Ω/f − 1 (%)",
        "verdict",
    ];
    let rows = bar.lanes.iter().flat_map(|lane| {
        let margins = lane.margins.iter();
        margins.filter_map(|margin| row(bar, lane, margin))
    });
    DataTable {
        header: header.map(str::to_owned).to_vec(),
        rows: rows.collect(),
    }
}

fn row(bar: &Bar, lane: &Lane, margin: &Margin) -> Option<Vec<String>> {
    let mut ranges = bar.ranges.iter();
    let range = ranges.find(|range| range.multiple == margin.multiple)?;
    Some(vec![
        lane.label.clone(),
        four_digits(lane.frequency_hz),
        short(lane.error_hz, 2),
        format!("{}P", margin.multiple),
        between(range.operation_hz),
        between(range.kept_free_hz),
        signed_percent(margin),
        verdict_word(margin.verdict).to_owned(),
    ])
}
