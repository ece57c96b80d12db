//! The whole turbine with its turning rotor: the coupled Campbell diagram, what it proves, and how
//! the modes move.

mod tables;

use towermodes_analysis::whirl::CoupledError;

use super::super::content::TurbineResults;
use super::super::document::{Block, Statement};
use super::super::mark::Mark;
use super::super::plot_command::COUPLED;
use super::resonance::{margins, meaning};
use super::{own_picture, paragraph, picture, table};
use crate::figures;
use crate::svg::Figure;
use crate::wording::{STRUCTURE_ONLY, proved};

/// What the table of the modes means.
const MEANING: &str = "Each name is that of one mode. Going up in frequency, a mode gets the part of the turbine whose elastic energy so far exceeds the number of its names by most; \
     a mode with less than 60 % of its energy in its name shares it with another part. \
     Counts prove the frequency of the model within the given half-width; the error of the mesh is the change of the frequency to a finer mesh.";

/// Why a share stands in place of a difference.
const OTHER_MOTION: &str = "Where a share stands in place of a difference, the mode of this name has less than 60 % of its energy in this motion, which the flexible rotor spreads over several modes, so it is not compared.";

/// What the frequencies mean for blades and tower.
const FRAME: &str = "What acts on the tower with a frequency excites the modes that have it here. On a blade, which turns, a forward whirl has this frequency less the rotor speed, a \
     backward whirl this frequency plus the rotor speed.";

pub(super) fn blocks(whole: &Result<TurbineResults, CoupledError>) -> Vec<Block> {
    let results = match whole {
        Ok(results) => results,
        Err(error) => {
            let text = format!("The turbine with its turning rotor was not solved: {error}.");
            return vec![paragraph(text)];
        }
    };
    let mut blocks = diagram(results);
    blocks.extend(against_rigid(results));
    blocks.extend(modes(results));
    blocks
}

/// The conclusion, the diagram, its curves and the distances.
fn diagram(results: &TurbineResults) -> Vec<Block> {
    let coupled = &results.coupled;
    let campbell = &coupled.campbell;
    let figure = Figure {
        name: COUPLED.to_owned(),
        ..figures::coupled_campbell(coupled)
    };
    let mut blocks = vec![
        paragraph(what(results)),
        Block::Statements(conclusion(results)),
        picture(figure, COUPLED),
        paragraph(FRAME),
        table(tables::names(coupled)),
    ];
    if !coupled.changes().is_empty() {
        blocks.push(table(tables::changes(coupled)));
        blocks.push(paragraph(
            "A curve follows a mode by its shape. Where two curves veer and exchange their shapes, they exchange their names too; the diagram marks the places with circles.",
        ));
    }
    if !coupled.meetings.is_empty() {
        blocks.push(table(tables::meetings(coupled)));
        blocks.push(paragraph(
            "Curves that cross keep their shapes: the modes hardly act on each other. Curves that veer exchange them, and energy flows between the modes.",
        ));
    }
    let caption = "Distance of every excitation from every coupled mode";
    blocks.push(table(margins(campbell, caption)));
    blocks.extend(meaning(campbell));
    blocks
}

fn what(results: &TurbineResults) -> String {
    let machine = results.turbine.machine();
    let generator = match machine.generator.is_locked {
        true => "is held at the constant speed",
        false => "turns freely",
    };
    format!(
        "In this section the rotor is flexible and turns: tower, nacelle, drivetrain and {} blades vibrate together, and frequencies are those in axes that do not turn. The \
         generator {generator}. {STRUCTURE_ONLY} The other sections take the rotor-nacelle assembly as a rigid body.",
        machine.blades
    )
}

/// The conclusion of the coupled diagram.
pub(super) fn resonance(results: &TurbineResults) -> Statement {
    let coupled = &results.coupled;
    Statement {
        lead: "Resonance of the turbine",
        text: coupled.campbell.conclusion().join(" "),
        verdict: Some(coupled.verdict())
            .filter(|_| coupled.campbell.not_checked.is_empty())
            .map(Mark::of),
    }
}

fn conclusion(results: &TurbineResults) -> Vec<Statement> {
    let coupled = &results.coupled;
    vec![
        resonance(results),
        Statement {
            lead: "Certificate",
            text: proved(coupled),
            verdict: None,
        },
    ]
}

/// The modes at the highest operating speed, as a table, as stills and animated.
fn modes(results: &TurbineResults) -> Vec<Block> {
    let Some(modes) = results.at_highest() else {
        return Vec::new();
    };
    let mut blocks = vec![table(tables::modes(modes)), paragraph(MEANING)];
    if !modes.modes.is_empty() {
        let turbine = &results.turbine;
        blocks.push(own_picture(figures::whirl(turbine, modes)));
        blocks.push(Block::Whirl(figures::whirl_animation(turbine, modes)));
    }
    blocks
}

/// What the flexible rotor makes of the modes of the tower.
fn against_rigid(results: &TurbineResults) -> Vec<Block> {
    if results.against.is_empty() {
        return Vec::new();
    }
    let rotor = &results.coupled.campbell.rotor;
    let mut blocks = vec![table(tables::against_rigid(&results.against, rotor))];
    let changes = results
        .against
        .iter()
        .flat_map(|row| [row.at_rest, row.at_highest]);
    if changes.flatten().any(|change| change.difference.is_none()) {
        blocks.push(paragraph(OTHER_MOTION));
    }
    blocks
}
