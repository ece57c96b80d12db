//! The files of the input, word by word.

use super::super::content::ReportContent;
use super::super::document::Block;
use super::super::embedded::embedded;
use super::paragraph;

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let mut blocks = vec![paragraph(
        "The files that the input was read from, so that the report can be checked and made again without anything beside it. Their sizes and \
         sums are in the section on reproduction; a text saved from here has the same sum unless it is said that it differs.",
    )];
    blocks.extend(embedded(&content.files).into_iter().map(Block::File));
    blocks
}
