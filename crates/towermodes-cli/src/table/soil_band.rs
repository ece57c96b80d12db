//! Frequencies and verdicts over a band of soil stiffness, as text.

use towermodes::number::Plain;
use towermodes_analysis::soil_band::{BandMode, BandValue, SoilBand};
use towermodes_report::wording::{counted, verdict_word};

use super::text::{align_right, plain_table, wrapped};

/// A row for each first bending mode and each mode whose verdict changes; a column for each factor.
pub fn soil_band(band: &SoilBand) -> String {
    let modes: Vec<&BandMode> = band.of_interest().collect();
    let mut table = plain_table();
    let factors = band.factors.iter().map(|factor| match factor {
        1.0 => "soil as given".to_owned(),
        factor => format!("soil x {}", Plain(*factor)),
    });
    let header = std::iter::once("mode".to_owned()).chain(factors);
    table.set_header(header);
    for mode in &modes {
        let cells = (0..band.factors.len()).map(|place| cell(band, mode, place));
        table.add_row(std::iter::once(mode.label.clone()).chain(cells));
    }
    align_right(&mut table, 1..=band.factors.len());
    let mut text = format!("{}\n", table.trim_fmt());
    for failed in &band.failed {
        let sentence = format!(
            "With soil x {} the tower cannot be solved: {}.",
            Plain(failed.factor),
            failed.reason
        );
        text += &(wrapped(&sentence) + "\n");
    }
    for shared in &band.shared {
        let sentence = format!("With soil x {}: {}.", Plain(shared.factor), shared.modes);
        text += &(wrapped(&sentence) + "\n");
    }
    let others = band.modes.len() - modes.len();
    if others > 0 && band.has_verdicts() && band.failed.is_empty() {
        let keep = if others == 1 {
            "has the same verdict"
        } else {
            "have the same verdicts"
        };
        text += &format!(
            "{} {keep} for all soil factors\n",
            counted(others, "other mode")
        );
    }
    text
}

/// "0.2410 Hz -1.8 % WARN"; "-" if there is no such mode.
fn cell(band: &SoilBand, mode: &BandMode, place: usize) -> String {
    let Some(at) = &mode.at[place] else {
        return "-".to_owned();
    };
    let BandValue {
        frequency_hz,
        verdict,
        ..
    } = at;
    let mut cell = format!("{frequency_hz:.4} Hz");
    if let Some(change) = mode.change(band, place) {
        cell += &format!(" {:+.1} %", 100.0 * change);
    }
    if let Some(verdict) = verdict {
        cell += &format!(" {}", verdict_word(*verdict));
    }
    cell
}
