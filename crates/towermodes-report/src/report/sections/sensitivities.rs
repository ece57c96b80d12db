//! The influence of the input values on the frequencies.

use towermodes::Operation;
use towermodes::number::{Plain, four_digits};
use towermodes_analysis::influence::{Influence, Influences, NEGLIGIBLE, Tolerances};

use super::super::content::ReportContent;
use super::super::document::Block;
use super::super::table::Table;
use super::{own_picture, paragraph, table};
use crate::figures;
use crate::number::NOTHING;

/// Largest number of modes, because more columns do not fit on paper.
const MODES: usize = 4;
/// Largest number of rows.
const ROWS: usize = 40;

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let influences = match &content.influences {
        None => return Vec::new(),
        Some(Ok(influences)) => influences,
        Some(Err(error)) => {
            return vec![paragraph(format!(
                "The frequencies were not differentiated: {error}."
            ))];
        }
    };
    let figure = figures::tornado(&content.description, influences, &Tolerances::default());
    vec![
        paragraph(
            "Elasticity: change of each frequency in percent for a 1 % change of each input value (for a height: 1 % of the \
             height of the tower). Rows at the same height are a step and move together.",
        ),
        own_picture(figure),
        table(elasticities(influences)),
    ]
}

fn elasticities(influences: &Influences) -> Table {
    let modes = influences.modes.iter().take(MODES);
    let names: Vec<String> = modes
        .map(|mode| format!("#{} ({} Hz)", mode.label, four_digits(mode.frequency_hz)))
        .collect();
    let header = ["input", "#value", "unit"].into_iter();
    let mut table = Table::new(
        "Elasticities of the lowest frequencies, the largest first",
        header.chain(names.iter().map(String::as_str)),
    );
    let matters = |number: &&Influence| number.largest() >= NEGLIGIBLE;
    for number in influences.ranked().into_iter().filter(matters).take(ROWS) {
        let mut row = vec![number.name.clone(), value(number), number.unit.to_owned()];
        row.extend(number.elasticities.iter().take(MODES).map(elasticity));
        table.push(row);
    }
    table
}

/// The value in the table; the value of a step is omitted.
fn value(number: &Influence) -> String {
    match number.operation {
        Operation::Add => NOTHING.to_owned(),
        Operation::Set | Operation::Scale => Plain(number.value).to_string(),
    }
}

fn elasticity(elasticity: &Option<f64>) -> String {
    match elasticity {
        None => NOTHING.to_owned(),
        Some(value) if value.abs() < 5e-5 => "0".to_owned(),
        Some(value) => {
            let sign = if *value < 0.0 { "−" } else { "+" };
            format!("{sign}{:.4}", value.abs())
        }
    }
}
