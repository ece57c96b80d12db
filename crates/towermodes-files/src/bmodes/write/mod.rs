//! A tower as a deck of BModes 3.00: its main file and its table of sections.

mod base;
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

use towermodes::tower::Rpm;
use towermodes::{LossFactors, Shear, Tower, TowerDescription};

use crate::note::Note;

pub use error::BmodesWriteError;

/// Options for writing a deck.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BmodesWriteOptions {
    /// The name of the section file in the deck.
    pub sections_file: String,
    /// The smallest number of elements. Steps, masses and wires may need more; BModes has an upper
    /// limit.
    pub elements: usize,
    /// The number of modes that the deck requests.
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
    /// The section file, which the main file names.
    pub sections: String,
    /// Notes on the differences between deck and tower.
    pub notes: Vec<Note>,
}

/// Writes a tower as a deck of BModes 3.00; `description` is the description of the tower.
///
/// Point masses, and guy wires in a deck with an offshore block, are distributed over a short part
/// of the tower, because a deck cannot store them otherwise; a note gives the length.
///
/// # Errors
/// [`BmodesWriteError`] if a deck cannot represent the tower.
pub fn write_bmodes(
    tower: &Tower,
    description: &TowerDescription,
    options: &BmodesWriteOptions,
) -> Result<BmodesFiles, BmodesWriteError> {
    let mut notes = Vec::new();
    let sections_file = deck::quoted(&options.sections_file)?;
    let hub = base::hub_connection(tower)?;
    let is_offshore = base::is_offshore(tower, hub);
    let ends = base::ends_m(tower, is_offshore);
    let layout = layout::Layout::new(tower, description, is_offshore, &mut notes);
    let multiplier = section::side_side_multiplier(tower, &layout)?;
    let rows = sections::rows(tower, &layout, &mut notes);
    let borders = elements::borders(&layout, hub.most_elements(), options.elements, &mut notes);
    let offshore = is_offshore.then_some(ends);
    let support = support::support(tower, description, &layout, (hub, offshore), &mut notes)?;
    let tip = tip::body(description, &layout, &mut notes);
    note_whole(tower, description, multiplier, &mut notes);
    let deck = deck::Deck {
        title: &title(tower),
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

/// Notes on effects that BModes does not model, and on errors in reading its own files.
fn note_whole(
    tower: &Tower,
    description: &TowerDescription,
    multiplier: f64,
    notes: &mut Vec<Note>,
) {
    let gravity = tower.gravity_m_per_s2();
    if gravity != 0.0 && !tower.base().floats {
        let message = format!("BModes has no gravity: {gravity} m/s2 is left out");
        notes.push(Note::left_out(message));
    }
    if let Some(rotor) = tower.rotor() {
        notes.push(Note::left_out(format!(
            "a tower deck has no rotor: its {} blades and its speeds ({} to {} rpm) are left out",
            rotor.blades,
            Rpm(rotor.lowest_rpm),
            Rpm(rotor.highest_rpm)
        )));
    }
    if tower.missing_parts().is_some() {
        notes.push(Note::left_out(
            "the parts of the structure that this model lacks are named only in the title: results of the written deck look complete",
        ));
    }
    if description.damping.loss_factors != LossFactors::default() {
        notes.push(Note::left_out(
            "a deck has no damping: the loss factors are left out",
        ));
    }
    if tower.shears() {
        notes.push(shear_note(description));
    }
    if multiplier != 1.0 {
        notes.push(Note::compatibility(format!(
            "the side-side bending stiffness is {multiplier} times the fore-aft one and is written as edge_stff_mult: \
             BModes 3.00 swaps flp_stff_mult and edge_stff_mult of a tower and would exchange fore-aft and side-side"
        )));
    }
}

fn shear_note(description: &TowerDescription) -> Note {
    let model = match description.shear {
        _ if description.stations.is_empty() => "the table's shear stiffness",
        Shear::Coefficient(_) => "the shear coefficient",
        _ => "Cowper's shear coefficient",
    };
    Note::left_out(format!(
        "BModes has no shear deformation: {model} is left out"
    ))
}

/// The name of the tower, after a warning if it lacks parts of the structure.
fn title(tower: &Tower) -> String {
    match tower.missing_parts() {
        Some(missing) => format!("WARNING: {missing}. {}", tower.name()),
        None => tower.name().to_owned(),
    }
}
