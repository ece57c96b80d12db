//! The input files, complete.

use super::super::content::ReportContent;
use super::super::document::Block;
use super::super::embedded::embedded;
use super::paragraph;

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let mut blocks = vec![paragraph(
        "The input was read from these files; they are included so that the report can be checked and reproduced without other documents. Their \
         sizes and checksums are in the section on reproduction; a file that is copied from here and saved has the same checksum, unless a difference is stated.",
    )];
    blocks.extend(
        embedded(&content.circumstances.files)
            .into_iter()
            .map(Block::File),
    );
    blocks
}
