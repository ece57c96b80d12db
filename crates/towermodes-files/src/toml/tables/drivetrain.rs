//! `[drivetrain]`.

use towermodes::inputs::Inputs;
use towermodes::{Drivetrain, Place};

use super::super::inputs::read;
use super::super::schema;
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use crate::places::TABLE;

/// The drivetrain: `Some(None)` if there is none, `None` after a mistake.
pub(crate) fn drivetrain(root: &Table<'_>, reading: &mut Reading) -> Option<Option<Drivetrain>> {
    let Some(value) = root.get("drivetrain") else {
        return Some(None);
    };
    let at = |key| Place::Drivetrain { key };
    reading.remember(at(TABLE), value.span());
    let table = Table::of(value, "[drivetrain]", &schema::DRIVETRAIN, reading)?;
    read(Drivetrain::blank(), &table, at, reading).map(Some)
}
