//! `[[wires]]`.

use towermodes::inputs::Inputs;
use towermodes::{Place, Wires};

use super::super::inputs::read;
use super::super::schema;
use super::super::text::reading::Reading;
use super::super::text::table::{Table, every_table, with_names};
use super::super::text::values::Value;
use crate::places::TABLE;

/// All `[[wires]]` with their names.
pub(crate) fn wires(root: &Table<'_>, reading: &mut Reading) -> Option<(Vec<Wires>, Vec<String>)> {
    with_names(every_table(
        root,
        "wires",
        "set of wires",
        reading,
        set_of_wires,
    ))
}

fn set_of_wires(index: usize, value: &Value<'_>, reading: &mut Reading) -> Option<(Wires, String)> {
    let at = |key| Place::Wires { index, key };
    reading.remember(at(TABLE), value.span());
    let table = Table::of(value, "[[wires]]", &schema::WIRES, reading)?;
    let name = table.name_of("a name of wires", reading);
    let wires = read(Wires::blank(), &table, at, reading);
    // The stiffness of three or more equally spaced wires does not depend on their azimuth.
    table.number_or(0.0, "azimuth_deg", at("azimuth"), reading)?;
    Some((wires?, name?))
}
