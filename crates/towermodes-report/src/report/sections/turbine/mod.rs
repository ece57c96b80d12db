//! The whole turbine with rotating rotor: the coupled Campbell diagram, its proof, and the mode
//! shapes.

mod tables;

use towermodes_analysis::whirl::{CoupledCampbell, CoupledError};

use super::super::content::TurbineResults;
use super::super::document::{Block, Statement};
use super::super::plot_command::COUPLED;
use super::{own_picture, paragraph, picture, resonance, table};
use crate::figures;
use crate::svg::Figure;
use crate::wording::{STRUCTURE_ONLY, proved};

/// The explanation of the table of the modes.
const MEANING: &str = "Each name is given to one mode only. In the order of rising frequency, each mode is named after the part of the turbine whose accumulated elastic energy exceeds the number of modes already named after it by the largest amount; \
     a mode with less than 60 % of its energy in the motion that its name states is shared with another part. \
     The bound of the solver error is the half-width of the interval in which eigenvalue counts bracket the frequency; the mesh error is the change of the frequency from this mesh to a finer mesh.";

/// The explanation of a share in place of a difference.
const OTHER_MOTION: &str = "Where the table gives a share in place of a difference, the flexible rotor spreads this motion over several modes: the mode of this name has less than 60 % of its energy in this motion, so its frequency is not compared.";

/// The explanation of frequencies on blades and on the tower.
const FRAME: &str = "A load on the tower at a frequency excites the modes listed at this frequency. On a rotating blade, a forward whirl has this frequency minus the rotor speed, a \
     backward whirl this frequency plus the rotor speed.";

pub(super) fn blocks(whole: &Result<TurbineResults, CoupledError>) -> Vec<Block> {
    let results = match whole {
        Ok(results) => results,
        Err(error) => {
            let text = format!("The turbine with rotating rotor was not solved: {error}.");
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
        ..figures::coupled_campbell_beside_conclusion(coupled)
    };
    let mut blocks = vec![
        paragraph(what(results)),
        Block::Statements(vec![
            resonance::conclusion(campbell, "Conclusion"),
            certificate(coupled),
        ]),
        picture(figure, COUPLED),
        paragraph(FRAME),
        table(tables::names(coupled)),
    ];
    if !coupled.changes().is_empty() {
        blocks.push(table(tables::changes(coupled)));
        blocks.push(paragraph(
            "A curve follows a mode by its shape. Where two curves veer and exchange their shapes, they also exchange their names; circles mark these places in the diagram.",
        ));
    }
    if !coupled.meetings.is_empty() {
        blocks.push(table(tables::meetings(coupled)));
        blocks.push(paragraph(
            "Where curves cross, both modes keep their shapes and hardly interact. Where curves veer, the modes exchange their shapes, and energy is transferred between them.",
        ));
    }
    let caption = "Distance of every excitation from every coupled mode";
    blocks.push(table(resonance::margins(campbell, caption)));
    blocks.extend(resonance::meaning(campbell));
    blocks
}

fn what(results: &TurbineResults) -> String {
    let machine = results.turbine.machine();
    let generator = match machine.generator.is_locked {
        true => "has a constant speed",
        false => "rotates freely",
    };
    format!(
        "In this section the rotor is flexible and rotates: tower, nacelle, drivetrain and {} blades vibrate together; frequencies are given in the non-rotating (fixed) frame. The \
         generator {generator}. {STRUCTURE_ONLY} Sections with the remark \"rigid rotor\" model the rotor-nacelle assembly as a rigid body.",
        machine.blades
    )
}

fn certificate(coupled: &CoupledCampbell) -> Statement {
    Statement {
        lead: "Certificate",
        text: proved(coupled),
        verdict: None,
    }
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

/// The effect of the flexible rotor on the modes of the tower.
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
