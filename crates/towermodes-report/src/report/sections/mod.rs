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
mod verdicts;

use super::content::ReportContent;
use super::document::{Block, Document, Picture, Section};
use super::table::Table;
use crate::svg::Figure;

/// The addition to the headings of the model with a rigid rotor if the model with a flexible rotor
/// governs.
const RIGID: &str = " (rigid rotor)";

/// The whole report: first the main results, then their basis, and at the end the details for a
/// checker.
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
    with_numbers(document.numbered())
}

/// The document with the data of its pictures in an appendix.
fn with_numbers(mut document: Document) -> Document {
    let blocks: Vec<Block> = document.numbers().into_iter().map(Block::Numbers).collect();
    if !blocks.is_empty() {
        document.sections.push(Section {
            is_appendix: true,
            ..section("numbers", "Data of the figures".to_owned(), blocks)
        });
    }
    document
}

fn body(content: &ReportContent) -> Vec<Section> {
    let section = |id, title: &str, blocks| section(id, title.to_owned(), blocks);
    let of_rigid = |id, title, blocks| of_rigid(content, id, title, blocks);
    let mut sections = vec![
        section("summary", "Summary", summary::blocks(content)),
        section("input", "Input", input::blocks(content)),
        section("assumptions", "Assumptions", assumptions::blocks(content)),
    ];
    // The model that governs is the first of the results.
    if let Some(whole) = &content.turbine {
        let blocks = turbine::blocks(whole);
        sections.push(section("turbine", "Turbine with rotating rotor", blocks));
    }
    let frequencies = frequencies::blocks(content);
    sections.push(of_rigid("frequencies", "Natural frequencies", frequencies));
    sections.push(of_rigid(
        "resonance",
        "Resonance",
        resonance::blocks(content),
    ));
    // After the resonance that they explain.
    if let Some(band) = &content.soil_band {
        sections.push(of_rigid("soil", "Soil stiffness", soil_band::blocks(band)));
    }
    if content.influences.is_some() {
        let influences = sensitivities::blocks(content);
        sections.push(of_rigid("sensitivities", "Sensitivities", influences));
    }
    let elastodyn = elastodyn::blocks(content);
    sections.extend([
        of_rigid("modes", "Mode shapes", modes::blocks(content)),
        section("elastodyn", "Shapes for ElastoDyn (OpenFAST)", elastodyn),
        section("notes", "Notes and warnings", notes::blocks(content)),
        section(
            "reproduction",
            "Reproduction",
            reproduction::blocks(content),
        ),
    ]);
    sections
}

fn appendices(content: &ReportContent) -> Vec<Section> {
    let appendix = |section: Section| Section {
        is_appendix: true,
        ..section
    };
    let methods = methods::blocks(content);
    let files = section("files", "Input files".to_owned(), files::blocks(content));
    vec![
        appendix(of_rigid(content, "methods", "Methods compared", methods)),
        appendix(files),
    ]
}

fn section(id: &'static str, title: String, blocks: Vec<Block>) -> Section {
    Section {
        id,
        title,
        is_appendix: false,
        blocks,
    }
}

/// A section on the tower with a rigid rotor-nacelle assembly; its title states this if another
/// section describes the turbine with its flexible rotor.
fn of_rigid(content: &ReportContent, id: &'static str, title: &str, blocks: Vec<Block>) -> Section {
    let model = match &content.turbine {
        Some(Ok(_)) => RIGID,
        Some(Err(_)) | None => "",
    };
    section(id, format!("{title}{model}"), blocks)
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

/// As [`picture`], for a picture whose data are in the tables of its section.
fn tabulated_picture(figure: Figure, what: &'static str) -> Block {
    Block::Picture(Box::new(Picture {
        figure,
        number: 0,
        what: Some(what),
        is_tabulated: true,
    }))
}

/// A picture that `towermodes plot` does not draw.
fn own_picture(figure: Figure) -> Block {
    Block::Picture(Box::new(Picture {
        figure,
        number: 0,
        what: None,
        is_tabulated: false,
    }))
}
