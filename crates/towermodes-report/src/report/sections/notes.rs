//! The messages of the reader and of the library on the input and the results.

use super::super::content::ReportContent;
use super::super::document::Block;
use super::paragraph;
use crate::wording::sentence;

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let mut blocks = Vec::new();
    let warnings = &content.solution.warnings;
    if !content.circumstances.notes.is_empty() {
        blocks.push(paragraph(
            "Notes on the input: assumptions, and data that were omitted or could not be imported:",
        ));
        let notes = content.circumstances.notes.iter();
        blocks.push(Block::List(notes.map(|note| sentence(note)).collect()));
    }
    if !warnings.is_empty() {
        blocks.push(paragraph(
            "Warnings on the computation: possible input errors, and limits of the results:",
        ));
        let warnings = warnings.iter();
        let sentences = warnings.map(|warning| sentence(&warning.to_string()));
        blocks.push(Block::List(sentences.collect()));
    }
    if blocks.is_empty() {
        blocks.push(paragraph(
            "There are no notes or warnings on the input or the computation.",
        ));
    }
    blocks.push(paragraph(
        "Warnings about resonance, the shapes for ElastoDyn and the comparison of methods, if any, are given in the sections on these subjects.",
    ));
    blocks
}
