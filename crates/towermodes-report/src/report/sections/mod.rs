//! The sections of a report, one per file.

mod assumptions;
mod bodies;
mod elastodyn;
mod files;
mod foundation;
mod frequencies;
mod ground;
mod input;
mod inputs;
mod methods;
mod modes;
mod notes;
mod reproduction;
mod resonance;
mod sensitivities;
mod soil_band;
mod substructure;
mod summary;
mod surroundings;
mod turbine;

use super::content::ReportContent;
use super::document::{Block, Document, Picture, Section};
use super::table::Table;
use crate::svg::Figure;

/// The whole report: the results that decide, then what they are based on, and at the end the
/// details for a checker.
pub(super) fn document(content: &ReportContent) -> Document {
    let title_block = content.circumstances.title_block.given().into_iter();
    let document = Document {
        title: content.heading(),
        title_block: title_block
            .map(|(name, value)| (name, value.to_owned()))
            .collect(),
        sections: body(content)
            .into_iter()
            .chain(appendices(content))
            .collect(),
    };
    document.numbered()
}

fn body(content: &ReportContent) -> Vec<Section> {
    let section = |id, title, blocks| Section {
        id,
        title,
        is_appendix: false,
        blocks,
    };
    let influences = sensitivities::blocks(content);
    let influences = section("sensitivities", "Sensitivities", influences);
    let mut sections = vec![
        section("summary", "Summary", summary::blocks(content)),
        section("input", "Input", input::blocks(content)),
        section("assumptions", "Assumptions", assumptions::blocks(content)),
        section(
            "frequencies",
            "Natural frequencies",
            frequencies::blocks(content),
        ),
        section("resonance", "Resonance", resonance::blocks(content)),
        section("modes", "Mode shapes", modes::blocks(content)),
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
    ];
    // After the resonance that they explain.
    let mut explaining = Vec::new();
    if let Some(whole) = &content.turbine {
        let blocks = turbine::blocks(whole);
        explaining.push(section("turbine", "Turbine with rotating rotor", blocks));
    }
    if let Some(band) = &content.soil_band {
        let blocks = soil_band::blocks(band);
        explaining.push(section("soil", "Soil stiffness", blocks));
    }
    if content.influences.is_some() {
        explaining.push(influences);
    }
    let mut places = sections.iter();
    let resonance = places.position(|section| section.id == "resonance");
    let after = resonance.map_or(0, |at| at + 1);
    sections.splice(after..after, explaining);
    sections
}

fn appendices(content: &ReportContent) -> Vec<Section> {
    let appendix = |id, title, blocks| Section {
        id,
        title,
        is_appendix: true,
        blocks,
    };
    vec![
        appendix("methods", "Methods compared", methods::blocks(content)),
        appendix("files", "Input files", files::blocks(content)),
    ]
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
        what: Some(what),
        is_tabulated: false,
    }))
}

/// The same for a picture whose numbers are in the tables of its section.
fn tabulated_picture(figure: Figure, what: &'static str) -> Block {
    Block::Picture(Box::new(Picture {
        figure,
        number: 0,
        what: Some(what),
        is_tabulated: true,
    }))
}

/// A picture that only reports have.
fn own_picture(figure: Figure) -> Block {
    Block::Picture(Box::new(Picture {
        figure,
        number: 0,
        what: None,
        is_tabulated: false,
    }))
}
