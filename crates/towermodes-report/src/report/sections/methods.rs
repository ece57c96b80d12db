//! The frequencies of all methods.

use towermodes::Method;
use towermodes_analysis::study::{Column, Comparison};

use super::super::content::ReportContent;
use super::super::document::Block;
use super::super::table::Table;
use super::frequencies::hinges;
use super::{paragraph, table, tabulated_picture};
use crate::figures;
use crate::number::{NOTHING, digits, signed_percent};

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let comparison = match &content.comparison {
        Ok(comparison) => comparison,
        Err(error) => {
            return vec![paragraph(format!(
                "The methods were not compared: {error}."
            ))];
        }
    };
    let mut blocks = vec![
        paragraph(reference(content, comparison)),
        // Tables break across pages of paper, pictures do not.
        tabulated_picture(figures::error(comparison), "error"),
        table(of_methods(content, comparison)),
        table(differences(comparison)),
    ];
    // Warnings on the input are in the section on notes and warnings.
    let of_input = content.tower.warnings();
    let warnings = comparison.warnings.iter();
    let warnings = warnings.filter(|warning| !of_input.contains(warning));
    let warnings: Vec<String> = warnings.map(ToString::to_string).collect();
    if !warnings.is_empty() {
        blocks.push(paragraph("Warnings on the reference solution:"));
        blocks.push(Block::List(warnings));
    }
    blocks
}

/// The reference of the differences, and the differences that do not converge to zero.
fn reference(content: &ReportContent, comparison: &Comparison) -> String {
    let text = "All methods of the program for the same tower. The method spectral converges exponentially; its result is the reference solution. The \
                differences of the other methods are discretization errors at the given number of segments; they decrease with more segments.";
    let tower = &content.tower;
    let rotates = content.options.rotary_inertia && tower.has_rotary_inertia();
    let lacks = match (rotates, tower.shears()) {
        (true, true) => "rotary inertia and shear deformation",
        (true, false) => "rotary inertia",
        (false, true) => "shear deformation",
        (false, false) => return text.to_owned(),
    };
    let has_bmodes = |column: &Column| column.method == Method::Bmodes;
    if !comparison.columns.iter().any(has_bmodes) {
        return text.to_owned();
    }
    format!(
        "{text} The differences of bmodes in bending are an exception: its element lacks {lacks}, which the reference includes, so they do \
         not converge to zero."
    )
}

fn of_methods(content: &ReportContent, comparison: &Comparison) -> Table {
    let mut table = Table::new(
        "The methods compared",
        [
            "method",
            "description",
            "#segments or elements",
            "#degree",
            "#degrees of freedom",
        ],
    );
    for column in &comparison.columns {
        table.push([
            column.method.name().to_owned(),
            format!(
                "{}{}",
                column.method.description(),
                hinges(column.method, &content.options)
            ),
            column.segments.to_string(),
            column
                .degree
                .map_or(NOTHING.to_owned(), |degree| degree.to_string()),
            column.degrees_of_freedom.to_string(),
        ]);
    }
    table
}

/// The differences of every method except the reference.
fn differences(comparison: &Comparison) -> Table {
    let others = || {
        let columns = comparison.columns.iter();
        columns.filter(|column| column.method != Method::Spectral)
    };
    let names: Vec<String> = others()
        .map(|column| format!("#{} (%)", column.method.name()))
        .collect();
    let header = ["mode", "#spectral (Hz)"].into_iter();
    let mut table = Table::new(
        "Relative differences of the frequencies from the reference solution",
        header.chain(names.iter().map(String::as_str)),
    );
    for (index, mode) in comparison.modes.iter().enumerate() {
        let mut row = vec![mode.label.clone(), digits(mode.frequency_hz, 6)];
        row.extend(others().map(|column| difference(column, index)));
        table.push(row);
    }
    table.shortened()
}

fn difference(column: &Column, mode: usize) -> String {
    let difference = column.relative_differences[mode];
    difference.map_or(NOTHING.to_owned(), signed_percent)
}
