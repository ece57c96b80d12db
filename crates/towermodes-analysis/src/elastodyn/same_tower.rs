//! Whether an ElastoDyn deck and another description are of the same tower.

use thiserror::Error;
use towermodes::tower::{Planes, Tower};

use super::model::TowerModel;
use super::model_difference::ModelDifference;
use super::stations::{PointMasses, Rows, RowsError, tower_rows};

/// Towers whose mass or flexibility differs by more than this fraction are different towers.
const DIFFERENT: f64 = 0.05;
/// A larger difference than this fraction gives a note.
const NOTICEABLE: f64 = 0.005;
/// Heights in decks are rounded to millimetres.
const ROUNDING_M: f64 = 1e-3;

/// The tower of a deck.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SameTower {
    /// The height at which the flexible tower of the deck begins, in the datum of the tower, m.
    pub from_m: f64,
    /// The difference between the tower and the deck.
    pub difference: ModelDifference,
}

impl SameTower {
    /// Whether mass or flexibility differs by more than 0.5 %.
    pub fn is_noticeable(&self) -> bool {
        self.difference.largest() > NOTICEABLE
    }
}

/// Why a tower is not the tower of a deck.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum OtherTower {
    /// It is shorter than the flexible tower of the deck.
    #[error(
        "its height is {height_m:.3} m, but the height of the flexible tower of the deck is {flexible_length_m:.3} m"
    )]
    TooShort {
        /// Height of the tower, m.
        height_m: f64,
        /// Length of the flexible tower of the deck, m.
        flexible_length_m: f64,
    },
    /// Mass or flexibility differs by more than 5 %.
    #[error("{0}")]
    Different(ModelDifference),
    /// The tower has no rows for ElastoDyn.
    #[error(transparent)]
    Rows(#[from] RowsError),
}

/// Compares the tower model of a deck with a tower, aligned at the top because heights may have
/// different datums.
///
/// # Errors
/// [`OtherTower`]: the tower is shorter than the flexible tower of the deck, or its mass or
/// flexibility differs by more than 5 %.
pub fn same_tower(deck: &TowerModel, tower: &Tower) -> Result<SameTower, OtherTower> {
    let from_m = tower.top_m() - deck.flexible_length_m;
    if from_m < tower.base_m() - ROUNDING_M {
        return Err(OtherTower::TooShort {
            height_m: tower.height_m(),
            flexible_length_m: deck.flexible_length_m,
        });
    }
    let from_m = from_m.max(tower.base_m());
    let difference = deck.difference_from(&model_of(tower, from_m)?);
    if difference.largest() > DIFFERENT {
        return Err(OtherTower::Different(difference));
    }
    Ok(SameTower { from_m, difference })
}

/// The ElastoDyn model of the part of a tower above a height, m.
fn model_of(tower: &Tower, from_m: f64) -> Result<TowerModel, RowsError> {
    let rows = tower_rows(tower, from_m, Rows::Accurate, PointMasses::Listed)?;
    Ok(TowerModel {
        flexible_length_m: tower.top_m() - from_m,
        stations: rows.stations,
        mass_factor: 1.0,
        stiffness_factors: Planes::both(1.0),
        // A mass at the very base does not move, and may be counted with the part below.
        concentrated_masses: rows
            .concentrated_masses
            .into_iter()
            .filter(|mass| mass.height_fraction > 1e-9)
            .collect(),
        ..TowerModel::default()
    })
}
