//! The excitations and modes on the bar, and their distances.

use towermodes::Family;
use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::{Campbell, Excited, FrequencyLine, Margin};

/// The frequencies of a multiple of the rotor speed in operation.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Range {
    /// The multiple.
    pub multiple: usize,
    /// From the lowest to the highest operating speed, Hz.
    pub operation_hz: [f64; 2],
    /// This range extended by the margin, Hz.
    pub kept_free_hz: [f64; 2],
}

/// A mode on the bar.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Lane {
    /// Its label: "1st fore-aft bending".
    pub label: String,
    /// Its frequency, Hz.
    pub frequency_hz: f64,
    /// The error of the frequency, Hz.
    pub error_hz: f64,
    /// The distances from the excitations on the bar, by multiple.
    pub margins: Vec<Margin>,
    /// These distances in percent with their sign: "+6.4".
    pub percents: Vec<String>,
}

impl Lane {
    /// The distances, each as a margin and in percent.
    pub fn distances(&self) -> impl Iterator<Item = (&Margin, &str)> {
        self.margins
            .iter()
            .zip(self.percents.iter().map(String::as_str))
    }

    /// The worst verdict for the excitations on the bar; none if there is no excitation.
    pub fn verdict(&self) -> Option<Verdict> {
        self.margins.iter().map(|margin| margin.verdict).max()
    }
}

/// The rotor speed and the blade passing frequency, if they were checked.
pub(super) fn ranges(campbell: &Campbell) -> Vec<Range> {
    let rotor = &campbell.rotor;
    let mut multiples = vec![1, rotor.blades];
    multiples.dedup();
    multiples.retain(|multiple| campbell.multiples.contains(multiple));
    let range = |multiple: usize| {
        let operation_hz =
            [rotor.lowest_rpm, rotor.highest_rpm].map(|rpm| multiple as f64 * rpm / 60.0);
        let [low, high] = operation_hz;
        Range {
            multiple,
            operation_hz,
            kept_free_hz: [
                low / (1.0 + campbell.margin),
                high / (1.0 - campbell.margin),
            ],
        }
    };
    multiples.into_iter().map(range).collect()
}

/// The first fore-aft and side-side modes; for a turbine at its highest operating speed.
pub(super) fn lanes(campbell: &Campbell) -> Vec<Lane> {
    let lines = || campbell.lines.iter().enumerate();
    let is_first_of = |line: &FrequencyLine, wanted: Family| match line.of {
        Excited::Tower { family, order, .. } => family == wanted && order == 1,
        Excited::Blade { .. } | Excited::Turbine { .. } => false,
    };
    let bending = [Family::ForeAft, Family::SideSide];
    let first = bending
        .into_iter()
        .filter_map(|family| lines().find(|(_, line)| is_first_of(line, family)));
    let of_turbine = campbell
        .first_bending
        .iter()
        .filter_map(|line| campbell.lines.get(*line));
    let of_turbine = of_turbine.filter(|line| matches!(line.of, Excited::Turbine { .. }));
    let first = first.map(|(_, line)| line).chain(of_turbine);
    first.filter_map(|line| lane(campbell, line)).collect()
}

fn lane(campbell: &Campbell, line: &FrequencyLine) -> Option<Lane> {
    let highest_rpm = campbell.rotor.highest_rpm;
    let from_highest = |point: &&[f64; 2]| (point[0] - highest_rpm).abs();
    let mut points = line.points.iter();
    let first = points.next()?;
    let nearest = |best, point| match from_highest(&point) < from_highest(&best) {
        true => point,
        false => best,
    };
    let [_, frequency_hz] = *points.fold(first, nearest);
    let on_bar = |margin: &&Margin| {
        let is_own = campbell.lines[margin.line].is_of_same_mode(line);
        is_own && [1, campbell.rotor.blades].contains(&margin.multiple)
    };
    let margins: Vec<Margin> = campbell.margins.iter().filter(on_bar).copied().collect();
    let percents = margins
        .iter()
        .map(|margin| campbell.distance_percent(margin))
        .collect();
    (frequency_hz > 0.0).then(|| Lane {
        label: line.label.clone(),
        frequency_hz,
        error_hz: line.error_hz,
        percents,
        margins,
    })
}
