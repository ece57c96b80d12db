//! The bar as text and as a table.

use towermodes_analysis::resonance::Margin;

use super::Bar;
use super::ranges::{Lane, Range};
use crate::number::{four_digits, short, typeset};
use crate::svg::DataTable;
use crate::wording::verdict_word;

/// The figure as text.
pub(super) fn description(bar: &Bar) -> String {
    let ranges: Vec<String> = bar.ranges.iter().map(range_text).collect();
    let lanes: Vec<String> = bar.lanes.iter().map(lane_text).collect();
    let kept_free = bar.ranges.iter().map(|range| between(range.kept_free_hz));
    let kept_free: Vec<String> = kept_free.collect();
    format!(
        "In operation {}; with the margin of {} % natural frequencies must lie outside {} Hz. {}.",
        ranges.join(" and "),
        short(100.0 * bar.margin, 3),
        kept_free.join(" and "),
        lanes.join("; ")
    )
}

/// "1P covers 0.1150 to 0.2017 Hz".
fn range_text(range: &Range) -> String {
    let [low, high] = range.operation_hz.map(four_digits);
    match low == high {
        true => format!("{}P is at {low} Hz", range.multiple),
        false => format!("{}P covers {low} to {high} Hz", range.multiple),
    }
}

/// "0.1150 to 0.2017".
fn between([low, high]: [f64; 2]) -> String {
    format!("{} to {}", four_digits(low), four_digits(high))
}

fn lane_text(lane: &Lane) -> String {
    let distances = lane.distances().map(distance_text).collect::<Vec<String>>();
    let distances = match distances.len() {
        0 => String::new(),
        _ => format!(": {}", distances.join(" and ")),
    };
    format!(
        "{} is at {} Hz{distances}",
        lane.label,
        four_digits(lane.frequency_hz)
    )
}

/// "3P is 6.4 % above it".
fn distance_text((margin, percent): (&Margin, &str)) -> String {
    let side = match margin.distance > 0.0 {
        true => "above",
        false => "below",
    };
    let size = percent.trim_start_matches(['+', '-']);
    match margin.distance == 0.0 {
        true => format!("{}P crosses it", margin.multiple),
        false => format!("{}P is {size} % {side} it", margin.multiple),
    }
}

/// "3P +6.4 %", or that the excitation crosses the mode.
pub(super) fn distance((margin, percent): (&Margin, &str)) -> String {
    match margin.distance == 0.0 {
        true => format!("crossed by {}P", margin.multiple),
        false => format!("{}P {} %", margin.multiple, typeset(percent)),
    }
}

/// The distance of each mode from each excitation.
pub(super) fn table(bar: &Bar) -> DataTable {
    let header = [
        "mode",
        "frequency (Hz)",
        "error (Hz)",
        "excitation",
        "range in operation (Hz)",
        "range with margin (Hz)",
        "distance (%)",
        "verdict",
    ];
    let rows = bar.lanes.iter().flat_map(|lane| {
        let distances = lane.distances();
        distances.filter_map(|distance| row(bar, lane, distance))
    });
    DataTable::new(header, rows)
}

fn row(bar: &Bar, lane: &Lane, (margin, percent): (&Margin, &str)) -> Option<Vec<String>> {
    let mut ranges = bar.ranges.iter();
    let range = ranges.find(|range| range.multiple == margin.multiple)?;
    Some(vec![
        lane.label.clone(),
        four_digits(lane.frequency_hz),
        short(lane.error_hz, 2),
        format!("{}P", margin.multiple),
        between(range.operation_hz),
        between(range.kept_free_hz),
        match margin.distance == 0.0 {
            true => "0".to_owned(),
            false => typeset(percent),
        },
        verdict_word(margin.verdict).to_owned(),
    ])
}
