//! `[water]`.

use towermodes::inputs::Inputs;
use towermodes::{Place, Water};

use super::super::inputs::read;
use super::super::schema;
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use crate::places::TABLE;

/// The water around the tower: `Some(None)` if there is none, `None` after a mistake.
pub(crate) fn water(root: &Table<'_>, reading: &mut Reading) -> Option<Option<Water>> {
    let Some(value) = root.get("water") else {
        return Some(None);
    };
    let at = |key| Place::Water { key };
    reading.remember(at(TABLE), value.span());
    let table = Table::of(value, "[water]", &schema::WATER, reading)?;
    read(Water::blank(), &table, at, reading).map(Some)
}
