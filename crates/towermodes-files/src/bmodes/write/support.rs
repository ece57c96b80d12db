//! The support of a tower in a deck: only its clamped base, guy wires, or the offshore block.

use towermodes::number::Rounded;
use towermodes::{Tower, TowerDescription, Wires};

use super::base::{Ends, Hub};
use super::error::BmodesWriteError;
use super::layout::Layout;
use super::platform::{Platform, platform};
use crate::note::Note;

/// `tow_support` and its block.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Support {
    None,
    Wires(Vec<Wires>),
    Offshore(Box<Platform>),
}

pub(super) fn support(
    tower: &Tower,
    description: &TowerDescription,
    layout: &Layout,
    (hub, ends): (Hub, Option<Ends>),
    notes: &mut Vec<Note>,
) -> Result<Support, BmodesWriteError> {
    if let Some(ends) = ends {
        note_shift(ends, notes);
        let platform = platform(tower, description, layout, (hub, ends), notes)?;
        return Ok(Support::Offshore(Box::new(platform)));
    }
    if !layout.attached.wires_at_the_base.is_empty() {
        let message = "guy wires at the clamped base have no effect and are left out";
        notes.push(Note::left_out(message));
    }
    if layout.attached.wires_at_nodes.is_empty() {
        return Ok(Support::None);
    }
    notes.push(Note::compatibility(
        "wire_stfness is EA/L of each wire; n wires are a horizontal spring of n/2 EA/L cos^2 of their angle: BModes 3.00 uses n EA/L cos^2, \
         twice as much, and no vertical spring",
    ));
    let nodes = layout.attached.wires_at_nodes.iter();
    let wires = nodes.map(|(index, _)| description.wires[*index]);
    Ok(Support::Wires(wires.collect()))
}

fn note_shift(ends: Ends, notes: &mut Vec<Note>) {
    if ends.shift_m != 0.0 {
        let message = format!(
            "the tower top is below the datum: heights are written from the base, shifted by {} m",
            Rounded(ends.shift_m)
        );
        notes.push(Note::approximation(message));
    }
}
