//! What holds a tower as a deck says it: nothing but its clamped base, wires, or what stands in the
//! sea or on springs.

use towermodes::{Tower, TowerDescription, Wires};

use super::error::BmodesWriteError;
use super::layout::Layout;
use super::number::significant;
use super::platform::{Platform, platform};
use crate::input::Note;

/// How the base is held: `hub_conn`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Hub {
    /// It does not move.
    Clamped = 1,
    /// It moves in every direction.
    Free = 2,
    /// It moves but for z and rotation about z.
    AxiallyHeld = 3,
}

impl Hub {
    /// How many elements BModes 3.00 takes: its solver has at most 1000 unknowns, nine for each
    /// element and those of the base.
    pub(super) fn most_elements(self) -> usize {
        match self {
            Self::Clamped => 111,
            Self::Free | Self::AxiallyHeld => 110,
        }
    }
}

/// `tow_support` and what belongs to it.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Support {
    None,
    Wires(Vec<Wires>),
    Offshore(Box<Platform>),
}

/// `radius`, `hub_rad` and `draft`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ends {
    pub(super) radius_m: f64,
    pub(super) hub_rad_m: f64,
    /// Of what is offshore; the heights of the deck are those of the tower plus `shift_m`.
    pub(super) draft_m: f64,
    pub(super) shift_m: f64,
}

pub(super) fn hub_connection(tower: &Tower) -> Result<Hub, BmodesWriteError> {
    match tower.base().moves {
        [false, false, false, false, false, false] => Ok(Hub::Clamped),
        [true, true, true, true, true, true] => Ok(Hub::Free),
        [true, true, false, true, true, false] => Ok(Hub::AxiallyHeld),
        moves => {
            let names = [
                "x",
                "y",
                "z",
                "rotation about x",
                "rotation about y",
                "rotation about z",
            ];
            let held = names.into_iter().zip(moves).filter(|(_, moves)| !moves);
            let held: Vec<&str> = held.map(|(name, _)| name).collect();
            Err(BmodesWriteError::PartlyRigidBase {
                held: held.join(", "),
            })
        }
    }
}

/// Whether anything needs the block of what stands in the sea: springs, soil, water, or a base
/// below the datum.
pub(super) fn is_offshore(tower: &Tower, hub: Hub) -> bool {
    let is_surrounded = tower.pieces().iter().any(|piece| {
        let middle = piece.section_at(0.5 * (piece.base_m + piece.top_m));
        piece.environment.soil.is_some() || middle.masses.water_kg_per_m != 0.0
    });
    hub != Hub::Clamped || is_surrounded || tower.base_m() < 0.0
}

/// The length of a tower that is offshore is radius + draft − hub_rad.
pub(super) fn ends_m(tower: &Tower, is_offshore: bool) -> Ends {
    let (base_m, top_m) = (tower.base_m(), tower.top_m());
    if !is_offshore {
        return Ends {
            radius_m: top_m,
            hub_rad_m: base_m,
            draft_m: 0.0,
            shift_m: 0.0,
        };
    }
    // A radius must be positive.
    let shift_m = if top_m > 0.0 { 0.0 } else { -base_m };
    Ends {
        radius_m: top_m + shift_m,
        hub_rad_m: 0.0,
        draft_m: 0.0 - (base_m + shift_m),
        shift_m,
    }
}

pub(super) fn support(
    tower: &Tower,
    description: &TowerDescription,
    layout: &Layout,
    (hub, ends): (Hub, Option<Ends>),
    notes: &mut Vec<Note>,
) -> Result<Support, BmodesWriteError> {
    if let Some(ends) = ends {
        if ends.shift_m != 0.0 {
            let message = format!(
                "the tower ends below the datum: heights are written from its base, {} m higher",
                significant(ends.shift_m)
            );
            notes.push(Note::new(message));
        }
        let platform = platform(tower, description, layout, (hub, ends), notes)?;
        return Ok(Support::Offshore(Box::new(platform)));
    }
    if !layout.wires_at_the_base.is_empty() {
        notes.push(Note::new(
            "wires at the clamped base hold nothing and are left out",
        ));
    }
    if layout.wires_at_nodes.is_empty() {
        return Ok(Support::None);
    }
    notes.push(Note::new(
        "wire_stfness is EA/L of each wire, n of which hold the tower with n/2 EA/L cos2 of their angle: BModes 3.00 takes n EA/L cos2, \
         twice as much, and nothing vertically",
    ));
    let nodes = layout.wires_at_nodes.iter();
    let wires = nodes.map(|(index, _)| description.wires[*index]);
    Ok(Support::Wires(wires.collect()))
}
