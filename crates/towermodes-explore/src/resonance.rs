//! The resonance check as a page shows it: the lines of its diagram, the rows of its table, its
//! conclusion.

use serde::Serialize;
use towermodes::number::{four_digits, with_error};
use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::{Campbell, Excited, Margin};

/// The resonance check of a tower or of a turbine.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Resonance {
    /// The worst verdict: `pass`, `warn`, `fail`, or `undecided` if nothing is checked.
    pub word: Verdict,
    /// The conclusion in sentences, then the remarks of the check.
    pub conclusion: Vec<String>,
    /// Whether there are verdicts.
    pub is_checked: bool,
    /// The lowest and the highest operating speed, rpm; none if they are unknown.
    pub operation_rpm: Option<[f64; 2]>,
    /// The number of blades.
    pub blades: usize,
    /// The required distance, as a fraction of the natural frequency.
    pub margin: f64,
    /// The multiples of the rotor speed.
    pub multiples: Vec<usize>,
    /// The lines, in the order of the table of `campbell`.
    pub lines: Vec<DiagramLine>,
    /// The distance of each mode from each multiple, in the order of the table of `campbell`.
    pub rows: Vec<DiagramRow>,
}

/// A natural frequency against the rotor speed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DiagramLine {
    /// The name of the mode.
    pub label: String,
    /// The number of a tower mode in the list, from 1.
    pub mode: Option<usize>,
    /// The index of the curve of a turbine, from 0. Lines with the same index are parts of one
    /// curve.
    pub curve: Option<usize>,
    /// The class of the mode: `tower`, `blades`, …
    pub class: &'static str,
    /// Rotor speed (rpm) and frequency (Hz).
    pub points: Vec<[f64; 2]>,
}

/// The distance of an excitation from a natural frequency.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DiagramRow {
    /// The name of the mode.
    pub label: String,
    /// The multiple of the rotor speed.
    pub multiple: usize,
    /// The operating speed at which both are closest, rpm.
    pub nearest_rpm: f64,
    /// The excitation frequency at this rotor speed, Hz.
    pub excitation_hz: f64,
    /// The natural frequency at this rotor speed, Hz.
    pub natural_hz: f64,
    /// The natural frequency with the digits that its error leaves.
    pub frequency: String,
    /// Excitation over natural frequency − 1.
    pub distance: f64,
    /// The distance as text: "+7.3 %".
    pub distance_text: String,
    /// The verdict.
    pub verdict: Verdict,
    /// Whether `campbell` lists the row without `--all`.
    pub is_near: bool,
}

/// The verdict on a mode.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Verdicted {
    /// The verdict: `pass`, `warn` or `fail`.
    pub word: Verdict,
    /// The excitation and its distance: "3P at 0.345 Hz, +7.3 %".
    pub text: String,
}

impl Resonance {
    /// The resonance check of a diagram, with its verdict and remarks.
    pub(crate) fn new(
        campbell: &Campbell,
        word: Verdict,
        remarks: impl Iterator<Item = String>,
    ) -> Self {
        let rotor = &campbell.rotor;
        let operation_rpm = [rotor.lowest_rpm, rotor.highest_rpm];
        Self {
            word,
            conclusion: campbell.conclusion().into_iter().chain(remarks).collect(),
            is_checked: campbell.not_checked.is_empty(),
            operation_rpm: campbell.speeds_are_known().then_some(operation_rpm),
            blades: rotor.blades,
            margin: campbell.margin,
            multiples: campbell.multiples.clone(),
            lines: lines(campbell),
            rows: rows(campbell),
        }
    }
}

fn lines(campbell: &Campbell) -> Vec<DiagramLine> {
    let lines = campbell.lines.iter();
    let line = lines.map(|line| {
        let (mode, curve) = match line.of {
            Excited::Tower { number, .. } => (Some(number), None),
            Excited::Turbine { curve, .. } => (None, Some(curve)),
            Excited::Blade { .. } => (None, None),
        };
        DiagramLine {
            label: line.label.clone(),
            mode,
            curve,
            class: line.class().name(),
            points: line.points.clone(),
        }
    });
    line.collect()
}

fn rows(campbell: &Campbell) -> Vec<DiagramRow> {
    let row = |margin: &Margin| {
        let line = &campbell.lines[margin.line];
        DiagramRow {
            label: line.label.clone(),
            multiple: margin.multiple,
            nearest_rpm: margin.nearest_rpm,
            excitation_hz: margin.excitation_hz,
            natural_hz: margin.natural_hz,
            frequency: with_error(margin.natural_hz, margin.natural_hz, line.error_hz)
                .trim()
                .to_owned(),
            distance: margin.distance,
            distance_text: campbell.distance_text(margin),
            verdict: margin.verdict,
            is_near: campbell.is_listed(margin),
        }
    };
    campbell.margins.iter().map(row).collect()
}

/// The verdict on a tower mode, with the excitation that determines it.
pub(crate) fn verdict_on(campbell: &Campbell, number: usize) -> Option<Verdicted> {
    let is_own = |excited| matches!(excited, Excited::Tower { number: n, .. } if n == number);
    if !campbell.not_checked.is_empty() {
        return None;
    }
    let line = campbell.lines.iter().find(|line| is_own(line.of))?;
    let worst = campbell.decisive(line)?;
    let multiple = worst.multiple;
    let text = match (campbell.missing_from_rpm(worst), worst.distance) {
        (Some(rpm), _) => format!("{multiple}P: no mode from {} rpm", four_digits(rpm)),
        (None, 0.0) => format!(
            "{multiple}P crosses at {} rpm",
            four_digits(worst.nearest_rpm)
        ),
        (None, _) => {
            let excitation = four_digits(worst.excitation_hz);
            let distance = campbell.distance_percent(worst);
            format!("{multiple}P at {excitation} Hz, {distance} %")
        }
    };
    let word = worst.verdict;
    Some(Verdicted { word, text })
}
