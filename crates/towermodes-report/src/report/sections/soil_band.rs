//! Frequencies and verdicts for softer and stiffer soil.

use towermodes::number::Plain;
use towermodes_analysis::soil_band::{BandMode, SoilBand};

use super::super::document::Block;
use super::super::table::{Cell, Table};
use super::{paragraph, table};
use crate::number::{NOTHING, four_digits, typeset};
use crate::wording::verdict_word;

pub(super) fn blocks(band: &SoilBand) -> Vec<Block> {
    let mut blocks = vec![
        paragraph(
            "The stiffness of soil is rarely known better than within a factor of two. Therefore the tower is solved again with the stiffness of \
             soil and foundation multiplied by other factors; nothing else changes.",
        ),
        table(frequencies(band)),
    ];
    blocks.extend(band.failed.iter().map(|failed| {
        paragraph(format!(
            "With the factor {} the tower cannot be solved: {}.",
            Plain(failed.factor),
            failed.reason
        ))
    }));
    blocks.extend(band.shared.iter().map(|shared| {
        let (factor, modes) = (Plain(shared.factor), &shared.modes);
        paragraph(format!("With the factor {factor}: {modes}."))
    }));
    blocks.extend(conclusion(band).map(paragraph));
    blocks
}

fn frequencies(band: &SoilBand) -> Table {
    let has_verdicts = band.has_verdicts();
    let mut header = vec!["mode".to_owned()];
    for factor in &band.factors {
        header.push(format!("#f at factor {} (Hz)", Plain(*factor)));
        if *factor != 1.0 {
            header.push("#change (%)".to_owned());
        }
        if has_verdicts {
            header.push("verdict".to_owned());
        }
    }
    let title = match has_verdicts {
        true => {
            "Natural frequencies for softer and stiffer soil, with the worst verdict of each mode"
        }
        false => "Natural frequencies for softer and stiffer soil",
    };
    let mut table = Table::new(title, header.iter().map(String::as_str));
    for mode in &band.modes {
        let cells =
            (0..band.factors.len()).flat_map(|place| cells(band, mode, place, has_verdicts));
        table.push(
            std::iter::once(Cell::from(mode.label.clone()))
                .chain(cells)
                .collect::<Vec<_>>(),
        );
    }
    table
}

/// Frequency, change and verdict of a mode at a factor.
fn cells(band: &SoilBand, mode: &BandMode, place: usize, has_verdicts: bool) -> Vec<Cell> {
    let at = mode.at[place];
    let hz = at.map_or(NOTHING.to_owned(), |at| four_digits(at.frequency_hz));
    let mut cells = vec![Cell::from(hz)];
    if place != band.of_input() {
        let change = mode.change(band, place);
        let change = change.map_or(NOTHING.to_owned(), |change| {
            typeset(&format!("{:+.1}", 100.0 * change))
        });
        cells.push(change.into());
    }
    if has_verdicts {
        let verdict = at.and_then(|at| at.verdict);
        cells.push(verdict.map_or(NOTHING.into(), Cell::from));
    }
    cells
}

/// The sentence on which verdicts depend on the soil.
fn conclusion(band: &SoilBand) -> Option<String> {
    if !band.has_verdicts() {
        return None;
    }
    let changing = band.modes.iter().filter(|mode| mode.changes_verdict());
    let each = changing.map(|mode| {
        let words = mode.at.iter().map(|at| match at.and_then(|at| at.verdict) {
            Some(verdict) => verdict_word(verdict),
            None => NOTHING,
        });
        format!("{} ({})", mode.label, words.collect::<Vec<_>>().join(", "))
    });
    let each: Vec<String> = each.collect();
    Some(match each.is_empty() {
        true => "No verdict depends on the stiffness of the soil in this band.".to_owned(),
        false => format!(
            "The verdict depends on the stiffness of the soil for: {}.",
            each.join("; ")
        ),
    })
}
