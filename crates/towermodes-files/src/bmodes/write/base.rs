//! The base of a tower in a deck: its support, and the heights of the tower ends.

use towermodes::Tower;

use super::error::BmodesWriteError;

/// The support of the base: `hub_conn`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Hub {
    /// Clamped.
    Clamped = 1,
    /// Free, or on springs.
    Free = 2,
    /// Fixed in z and in rotation about z.
    AxiallyHeld = 3,
}

impl Hub {
    /// Largest number of elements of BModes 3.00: its solver has at most 1000 unknowns, nine for
    /// each element and those of the base.
    pub(super) fn most_elements(self) -> usize {
        match self {
            Self::Clamped => 111,
            Self::Free | Self::AxiallyHeld => 110,
        }
    }
}

/// `radius`, `hub_rad` and `draft`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ends {
    pub(super) radius_m: f64,
    pub(super) hub_rad_m: f64,
    /// Depth of the base of an offshore tower, m.
    pub(super) draft_m: f64,
    /// The difference of the heights in the deck from those of the tower, m.
    pub(super) shift_m: f64,
}

/// The `hub_conn` of a tower.
///
/// # Errors
/// [`BmodesWriteError::PartlyRigidBase`].
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

/// Whether a tower needs the offshore block: for springs, soil, water, or a base below the datum.
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
