//! Data that only one of two descriptions has, omitted before a comparison.

use std::fmt;

use towermodes::Rna;
use towermodes::tower::TowerDescription;

use super::WhichTower;

/// Data that only one of two descriptions has and that a comparison omits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Omitted {
    /// The rotor-nacelle assembly of this tower.
    Rna(WhichTower),
    /// Gravity of this tower.
    Gravity(WhichTower),
}

impl fmt::Display for Omitted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rna(which) => write!(
                f,
                "only the {which} file has a rotor-nacelle assembly; it is omitted, and the towers are compared without RNA"
            ),
            Self::Gravity(which) => write!(
                f,
                "only the {which} file has gravity; it is omitted, and the towers are compared without gravity"
            ),
        }
    }
}

/// Omits data that only one of two descriptions has: a rotor-nacelle assembly, and gravity if the
/// format of that description always has gravity (`gravity_is_implied`).
pub fn omit_one_sided(
    [first, second]: [&mut TowerDescription; 2],
    gravity_is_implied: [bool; 2],
) -> Vec<Omitted> {
    let mut omitted = Vec::new();
    if let Some(which) = only(!first.rna.is_absent(), !second.rna.is_absent()) {
        (first.rna, second.rna) = (Rna::default(), Rna::default());
        omitted.push(Omitted::Rna(which));
    }
    let has_gravity = |tower: &TowerDescription| tower.gravity_m_per_s2 != 0.0;
    let lone = match only(has_gravity(first), has_gravity(second)) {
        Some(WhichTower::First) if gravity_is_implied[0] => Some((WhichTower::First, first)),
        Some(WhichTower::Second) if gravity_is_implied[1] => Some((WhichTower::Second, second)),
        _ => None,
    };
    if let Some((which, tower)) = lone {
        tower.gravity_m_per_s2 = 0.0;
        omitted.push(Omitted::Gravity(which));
    }
    omitted
}

/// The tower for which this is true, if it is true for only one of two towers.
fn only(first: bool, second: bool) -> Option<WhichTower> {
    match (first, second) {
        (true, false) => Some(WhichTower::First),
        (false, true) => Some(WhichTower::Second),
        _ => None,
    }
}
