//! A tower as a deck of BModes 3.00: its main file and its table of sections.

mod deck;
mod elements;
mod error;
mod layout;
mod lines;
mod loads;
mod number;
mod platform;
mod section;
mod sections;
mod spread;
mod support;
mod tip;

use towermodes::{Shear, Tower, TowerDescription};

use crate::input::Note;

pub use error::BmodesWriteError;

/// How a deck is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BmodesWriteOptions {
    /// What the deck calls the file of its sections.
    pub sections_file: String,
    /// How many elements there are at least; as many more as steps, masses and wires demand, and no
    /// more than BModes takes.
    pub elements: usize,
    /// How many modes the deck asks for.
    pub modes: usize,
}

impl Default for BmodesWriteOptions {
    fn default() -> Self {
        Self {
            sections_file: "tower_sections.dat".into(),
            elements: 60,
            modes: 20,
        }
    }
}

/// The two files of a deck.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BmodesFiles {
    /// The main file, `.bmi`.
    pub deck: String,
    /// The file of the sections, which the main file names.
    pub sections: String,
    /// What the deck holds otherwise than the tower, or not at all.
    pub notes: Vec<Note>,
}

/// Writes a tower as a deck of BModes 3.00; `description` is what the tower was made of.
///
/// # Errors
/// [`BmodesWriteError`] where a deck could only hold another tower.
pub fn write_bmodes(
    tower: &Tower,
    description: &TowerDescription,
    options: &BmodesWriteOptions,
) -> Result<BmodesFiles, BmodesWriteError> {
    let mut notes = Vec::new();
    let sections_file = deck::quoted(&options.sections_file)?;
    let hub = support::hub_connection(tower)?;
    let is_offshore = support::is_offshore(tower, hub);
    let ends = support::ends_m(tower, is_offshore);
    let layout = layout::Layout::new(tower, description, is_offshore, &mut notes);
    let multiplier = section::side_side_multiplier(tower, &layout)?;
    let rows = sections::rows(tower, &layout, &mut notes);
    let borders = elements::borders(&layout, hub.most_elements(), options.elements, &mut notes);
    let offshore = is_offshore.then_some(ends);
    let support = support::support(tower, description, &layout, (hub, offshore), &mut notes)?;
    let tip = tip::body(description, &layout, &mut notes);
    said_of_the_whole(tower, description, multiplier, &mut notes);
    let deck = deck::Deck {
        title: tower.name(),
        sections_file: &sections_file,
        modes: options.modes.max(1),
        tip: &tip,
        multiplier,
        borders: &borders,
        hub,
        ends,
        support: &support,
        wire_nodes: &elements::wire_nodes(&layout, &borders),
    };
    Ok(BmodesFiles {
        deck: deck.text(),
        sections: sections::text(tower.name(), &rows),
        notes,
    })
}

/// What BModes computes without, and where it reads its own files wrongly.
fn said_of_the_whole(
    tower: &Tower,
    description: &TowerDescription,
    multiplier: f64,
    notes: &mut Vec<Note>,
) {
    let gravity = tower.gravity_m_per_s2();
    if gravity != 0.0 && !tower.base().floats {
        notes.push(Note::new(format!(
            "BModes has no gravity: the weights ({gravity} m/s2) are left out"
        )));
    }
    if let Some(rotor) = tower.rotor() {
        notes.push(Note::new(format!(
            "a tower's deck has no rotor: its {} blades and its speeds ({} to {} rpm) are left out",
            rotor.blades, rotor.lowest_rpm, rotor.highest_rpm
        )));
    }
    if tower.shears() {
        let model = match description.shear {
            _ if description.stations.is_empty() => "the table's shear stiffness",
            Shear::Coefficient(_) => "the shear coefficient",
            _ => "Cowper's shear coefficient",
        };
        notes.push(Note::new(format!(
            "BModes has no shear deformation: {model} is left out"
        )));
    }
    if multiplier != 1.0 {
        notes.push(Note::new(format!(
            "the side-side bending stiffness is {multiplier} times the fore-aft one and is written as edge_stff_mult: \
             BModes 3.00 swaps flp_stff_mult and edge_stff_mult of a tower, and would make fore-aft what is side-side"
        )));
    }
}
