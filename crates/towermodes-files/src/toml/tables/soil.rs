//! `[[soil]]`: layers of springs around the tower.

use toml::de::DeArray;
use towermodes::{Place, SoilRow, SoilStiffness};

use super::super::schema;
use super::super::text::reading::Reading;
use super::super::text::table::{Table, every_table, with_names};
use super::super::text::values::{Value, every_row, list, number, row_of};
use crate::places::TABLE;

const ROW: &str = "a row is [height in m, spring in x, spring in y] in N/m2, then, if wanted, in z (N/m2), in torsion and against rotation about x and y (N)";

/// The values of a row: their names in the tower's checks and in messages.
const COLUMNS: [(&str, &str); 7] = [
    ("height", "height"),
    ("x", "the soil spring in x"),
    ("y", "the soil spring in y"),
    ("z", "the soil spring in z"),
    ("torsion", "the soil spring in torsion"),
    ("rotation_x", "the soil spring against rotation about x"),
    ("rotation_y", "the soil spring against rotation about y"),
];

/// All `[[soil]]` with their names.
pub(crate) fn soil(
    root: &Table<'_>,
    reading: &mut Reading,
) -> Option<(Vec<Vec<SoilRow>>, Vec<String>)> {
    with_names(every_table(root, "soil", "layer", reading, layer))
}

fn layer(index: usize, value: &Value<'_>, reading: &mut Reading) -> Option<(Vec<SoilRow>, String)> {
    let layer = index;
    let at = |key| Place::Soil { layer, row: 0, key };
    reading.remember(at(TABLE), value.span());
    let table = Table::of(value, "[[soil]]", &schema::SOIL, reading)?;
    let name = table.name_of("a soil's name", reading);
    let hint = "rows = [[height, spring in x, spring in y], ...] from the bottom to the surface";
    let rows = table.require("rows", hint, reading)?;
    reading.remember(at("rows"), rows.span());
    let rows = list(rows, "rows", reading)?;
    let first = rows.iter().next().and_then(|row| row.get_ref().as_array());
    let length = first.map(|row| row.len()).filter(|&length| is_row(length));
    let rows = every_row(rows, |row, value| {
        let what = format!("row {} of the soil", row + 1);
        let values = row_of(value, &what, ROW, |count| expected(count, length), reading)?;
        soil_row(values, |key| Place::Soil { layer, row, key }, reading)
    });
    Some((rows?, name?))
}

/// Whether a row has a valid number of values; the springs against rotation are given as a pair.
fn is_row(length: usize) -> bool {
    matches!(length, 3..=5 | 7)
}

/// The expected number of values of a row, if its number is wrong: that of the first row.
fn expected(count: usize, length: Option<usize>) -> Option<String> {
    match length {
        _ if !is_row(count) => Some("3 to 5 or 7".to_owned()),
        Some(length) if length != count => Some(format!("{length} as the first row")),
        _ => None,
    }
}

/// A row from its values; missing values are zero.
fn soil_row(
    values: &DeArray<'_>,
    at: impl Fn(&'static str) -> Place,
    reading: &mut Reading,
) -> Option<SoilRow> {
    let mut row = [Some(0.0); COLUMNS.len()];
    for ((value, (key, what)), entry) in values.iter().zip(COLUMNS).zip(&mut row) {
        reading.remember(at(key), value.span());
        *entry = number(value, what, reading);
    }
    let [height, x, y, z, torsion, rotation_x, rotation_y] = row;
    Some(SoilRow {
        height_m: height?,
        stiffness: SoilStiffness {
            x_n_per_m2: x?,
            y_n_per_m2: y?,
            z_n_per_m2: z?,
            torsion_n: torsion?,
            rotation_x_n: rotation_x?,
            rotation_y_n: rotation_y?,
        },
    })
}
