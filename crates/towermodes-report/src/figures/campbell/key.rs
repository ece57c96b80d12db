//! The legend of a Campbell diagram: lines, marks and shades.

use towermodes::number::percent;
use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::Campbell;

use super::lines::{Group, Shown};
use super::rays::{self, strong};
use super::shades::{ribbon_edge, window_edge, window_hz};
use crate::figures::chart::legend::{Entry, Sample, words};
use crate::number::four_digits;
use crate::svg::{Colour, Marker};
use crate::wording::counted;

/// The entries of the legend, and the number of lines of modes and of excitations without label.
pub(super) fn entries(
    campbell: &Campbell,
    shown: &Shown,
    without_label: [usize; 2],
    is_counted: bool,
) -> Vec<Entry> {
    let mut entries = modes(shown);
    entries.extend(excitations(campbell, shown));
    entries.extend(shades(campbell, shown));
    entries.extend(marks(campbell));
    entries.extend(unlabelled(without_label).map(words));
    let number = "number above a mark: coinciding marks".to_owned();
    entries.extend(is_counted.then(|| words(number)));
    let upper = "upper panel: higher modes at another scale".to_owned();
    entries.extend((shown.ends_hz.len() > 1).then(|| words(upper)));
    let change = "circle: the name of a curve changes".to_owned();
    entries.extend((!shown.changes.is_empty()).then(|| words(change)));
    entries
}

/// One entry for all lines of the same style, in the order in which they first appear; the tower
/// modes first.
fn modes(shown: &Shown) -> Vec<Entry> {
    let mut entries: Vec<Entry> = Vec::new();
    for Group { kind, .. } in &shown.groups {
        let words = kind.words();
        if !entries.iter().any(|(_, own)| *own == words) {
            let marker = kind.marker();
            entries.push((
                Sample {
                    marker,
                    ..kind.stroke().into()
                },
                words,
            ));
        }
    }
    entries
}

fn excitations(campbell: &Campbell, shown: &Shown) -> Vec<Entry> {
    let strong = strong(campbell, shown);
    let mut entries = Vec::new();
    let text = match strong[..] {
        [] => None,
        [1] => Some("1P: rotor speed".to_owned()),
        [passing] => Some(format!("{passing}P: blade passing frequency")),
        [_, passing, ..] => Some(format!(
            "1P, {passing}P: rotor speed, blade passing frequency"
        )),
    };
    entries.extend(text.map(|text| (rays::stroke(shown, true).into(), text)));
    if shown.multiples.len() > strong.len() {
        let mut text = "nP: other multiples of the rotor speed".to_owned();
        if shown.more_multiples > 0 {
            text += &format!("; {} more are not shown", shown.more_multiples);
        }
        entries.push((rays::stroke(shown, false).into(), text));
    }
    entries
}

fn shades(campbell: &Campbell, shown: &Shown) -> Vec<Entry> {
    let mut entries = Vec::new();
    if let Some([from_hz, to_hz]) = window_hz(campbell) {
        let text = format!(
            "soft-stiff with {} % margin kept: {} to {} Hz",
            percent(campbell.margin),
            four_digits(from_hz),
            four_digits(to_hz)
        );
        entries.push(((Colour::Window, window_edge()).into(), text));
    }
    if !campbell.not_checked.is_empty() {
        return entries;
    }
    let strong: Vec<String> = strong(campbell, shown)
        .into_iter()
        .map(rays::text)
        .collect();
    if strong.is_empty() {
        return entries;
    }
    let of = strong.join(" or ");
    let margin = percent(campbell.margin);
    let text = format!("within {margin} % of {of}{}", speeds_of(campbell));
    entries.push(((Colour::TooNear, ribbon_edge(true)).into(), text));
    let text = format!("within {} %", percent(2.0 * campbell.margin));
    entries.push(((Colour::Near, ribbon_edge(false)).into(), text));
    entries
}

fn marks(campbell: &Campbell) -> Vec<Entry> {
    let kinds = [
        (
            Verdict::Fail,
            (Marker::Cross, Colour::Fail),
            "margin not met: FAIL",
        ),
        (Verdict::Warn, (Marker::Triangle, Colour::Warn), "WARN"),
    ];
    let entry = |(verdict, marker, text): (Verdict, (Marker, Colour), &str)| {
        let mut all = campbell.margins.iter();
        let has = all.any(|margin| margin.verdict == verdict);
        has.then(|| (marker.into(), text.to_owned()))
    };
    kinds.into_iter().filter_map(entry).collect()
}

/// "3 lines of modes without label".
fn unlabelled([modes, excitations]: [usize; 2]) -> impl Iterator<Item = String> {
    let without = [
        (modes, "line", " of modes"),
        (excitations, "excitation", ""),
    ];
    let without = without.into_iter().filter(|(count, ..)| *count > 0);
    without.map(|(count, noun, of)| format!("{}{of} without label", counted(count, noun)))
}

/// " in operation", if the rotor has more than one speed.
fn speeds_of(campbell: &Campbell) -> &'static str {
    let rotor = &campbell.rotor;
    match rotor.lowest_rpm < rotor.highest_rpm {
        true => " in operation",
        false => "",
    }
}
