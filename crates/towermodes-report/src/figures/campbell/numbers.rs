//! The data of a Campbell diagram: a row for each rotor speed, a column for each mode.

use towermodes::tower::Rpm;
use towermodes_analysis::resonance::{Campbell, FrequencyLine};

use crate::svg::DataTable;

/// The largest number of excitations with a column; all others are multiples of the first.
const EXCITATIONS: usize = 12;

/// The frequencies at each rotor speed: modes, then excitations. Where a mode takes over the name
/// of another one, the cell contains the frequencies of both.
pub(super) fn table(campbell: &Campbell) -> DataTable {
    let mut modes = campbell.lines_by_mode();
    modes.retain(|lines| lines.iter().any(|line| !line.points.is_empty()));
    let multiples = campbell.multiples.iter().take(EXCITATIONS);
    let multiples: Vec<usize> = multiples.copied().collect();
    let names = modes.iter().map(|lines| format!("{} (Hz)", lines[0].label));
    let excitations = multiples.iter().map(|multiple| format!("{multiple}P (Hz)"));
    let header = std::iter::once("rotor speed (rpm)".to_owned());
    let row = |rpm: f64| {
        let of_modes = modes.iter().map(|lines| at(lines, rpm));
        let of_excitations = multiples.iter().map(|n| four(*n as f64 * rpm / 60.0));
        let cells = std::iter::once(Rpm(rpm).to_string());
        cells.chain(of_modes).chain(of_excitations).collect()
    };
    DataTable {
        header: header.chain(names).chain(excitations).collect(),
        rows: speeds(campbell).into_iter().map(row).collect(),
    }
}

/// The rotor speeds of the points, and those at the ends of the operating range, rpm.
fn speeds(campbell: &Campbell) -> Vec<f64> {
    let lines = campbell.lines.iter().filter(|line| !is_level(line));
    let points = lines.flat_map(|line| line.points.iter().map(|[rpm, _]| *rpm));
    let rotor = &campbell.rotor;
    let mut speeds: Vec<f64> = points
        .chain([rotor.lowest_rpm, rotor.highest_rpm])
        .collect();
    speeds.sort_by(f64::total_cmp);
    speeds.dedup();
    speeds
}

/// Whether the frequency is the same at every speed.
fn is_level(line: &FrequencyLine) -> bool {
    line.points.windows(2).all(|pair| pair[0][1] == pair[1][1])
}

/// The frequency of a mode at a speed; two frequencies where two of its lines join; empty if it has
/// none.
fn at(lines: &[&FrequencyLine], rpm: f64) -> String {
    let of_line = |line: &&FrequencyLine| {
        let mut points = line.points.iter();
        let point = match is_level(line) {
            true => points.next(),
            false => points.find(|point| point[0] == rpm),
        };
        point.map(|[_, hz]| four(*hz))
    };
    let mut texts: Vec<String> = lines.iter().filter_map(of_line).collect();
    texts.dedup();
    texts.join(" \u{2192} ")
}

fn four(hz: f64) -> String {
    format!("{hz:.4}")
}
