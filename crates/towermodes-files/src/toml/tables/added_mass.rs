//! `[[added_mass]]`: tables of mass that moves with the tower transversely.

use toml::de::DeArray;
use towermodes::{AddedMassRow, Place};

use super::super::schema;
use super::super::text::reading::Reading;
use super::super::text::table::{Table, every_table, with_names};
use super::super::text::values::{Value, every_row, list, number, row_of};
use crate::places::TABLE;

const ROW: &str = "a row is [height in m, mass per length in kg/m]";

/// All `[[added_mass]]` with their names.
pub(crate) fn added_mass(
    root: &Table<'_>,
    reading: &mut Reading,
) -> Option<(Vec<Vec<AddedMassRow>>, Vec<String>)> {
    with_names(every_table(
        root,
        "added_mass",
        "table of added mass",
        reading,
        table,
    ))
}

fn table(
    index: usize,
    value: &Value<'_>,
    reading: &mut Reading,
) -> Option<(Vec<AddedMassRow>, String)> {
    let of_row = |row, key| Place::AddedMass {
        table: index,
        row,
        key,
    };
    reading.remember(of_row(0, TABLE), value.span());
    let table = Table::of(value, "[[added_mass]]", &schema::ADDED_MASS, reading)?;
    let name = table.name_of("an added mass's name", reading);
    let hint = "rows = [[height, mass per length], ...] from the bottom to the surface";
    let rows = table.require("rows", hint, reading)?;
    reading.remember(of_row(0, "rows"), rows.span());
    let rows = list(rows, "rows", reading)?;
    let rows = every_row(rows, |row, value| {
        let what = format!("row {} of the added mass", row + 1);
        let expected = |count| (count != 2).then(|| "2".to_owned());
        let values = row_of(value, &what, ROW, expected, reading)?;
        added_mass_row(values, |key| of_row(row, key), reading)
    });
    Some((rows?, name?))
}

fn added_mass_row(
    values: &DeArray<'_>,
    at: impl Fn(&'static str) -> Place,
    reading: &mut Reading,
) -> Option<AddedMassRow> {
    let mut value = |column: usize, key: &'static str, what: &str| {
        let value = &values[column];
        reading.remember(at(key), value.span());
        number(value, what, reading)
    };
    let (height, mass) = (value(0, "height", "height"), value(1, "mass", "added mass"));
    Some(AddedMassRow {
        height_m: height?,
        mass_kg_per_m: mass?,
    })
}
