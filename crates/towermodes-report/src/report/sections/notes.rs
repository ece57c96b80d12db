//! What the reader and the library have to say of the input and the results.

use super::super::content::ReportContent;
use super::super::document::Block;
use super::paragraph;

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let mut blocks = Vec::new();
    let warnings = &content.solution.warnings;
    if !content.notes.is_empty() {
        blocks.push(paragraph(
            "What was decided, left out or could not be taken over as the input was read:",
        ));
        blocks.push(Block::List(content.notes.clone()));
    }
    if !warnings.is_empty() {
        blocks.push(paragraph("What looks like a slip, or limits the results:"));
        let warnings = warnings.iter();
        blocks.push(Block::List(warnings.map(ToString::to_string).collect()));
    }
    if blocks.is_empty() {
        blocks.push(paragraph("There are none."));
    }
    blocks
}
