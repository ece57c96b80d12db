//! The sections of a report, one a file.

mod assumptions;
mod elastodyn;
mod foundation;
mod frequencies;
mod input;
mod methods;
mod modes;
mod notes;
mod reproduction;
mod resonance;
mod summary;
mod surroundings;

use super::content::ReportContent;
use super::document::{Block, Document, Picture, Section};
use super::table::Table;
use crate::svg::Figure;

/// Everything that a report says.
pub(super) fn document(content: &ReportContent) -> Document {
    let section = |id, title, blocks| Section { id, title, blocks };
    let document = Document {
        title: content.heading(),
        sections: vec![
            section("summary", "Summary", summary::blocks(content)),
            section("input", "Input", input::blocks(content)),
            section("assumptions", "Assumptions", assumptions::blocks(content)),
            section(
                "frequencies",
                "Natural frequencies",
                frequencies::blocks(content),
            ),
            section("modes", "Mode shapes", modes::blocks(content)),
            section("methods", "Methods compared", methods::blocks(content)),
            section("resonance", "Resonance", resonance::blocks(content)),
            section(
                "elastodyn",
                "Shapes for ElastoDyn (OpenFAST)",
                elastodyn::blocks(content),
            ),
            section("notes", "Notes and warnings", notes::blocks(content)),
            section(
                "reproduction",
                "Reproduction",
                reproduction::blocks(content),
            ),
        ],
    };
    document.numbered()
}

fn paragraph(text: impl Into<String>) -> Block {
    Block::Paragraph(text.into())
}

fn table(table: Table) -> Block {
    Block::Table(table)
}

/// A picture that `towermodes plot --what WHAT` draws.
fn picture(figure: Figure, what: &'static str) -> Block {
    Block::Picture(Box::new(Picture {
        figure,
        number: 0,
        what,
        is_tabulated: false,
    }))
}

/// The same of a picture whose numbers are in the tables of its section.
fn tabulated_picture(figure: Figure, what: &'static str) -> Block {
    Block::Picture(Box::new(Picture {
        figure,
        number: 0,
        what,
        is_tabulated: true,
    }))
}
