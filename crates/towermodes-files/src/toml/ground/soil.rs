//! The kinds of soil of a layer, and the rows of a table.

use std::sync::LazyLock;

use toml::de::DeArray;
use towermodes::{LayerSoil, Place, PyRow};

use super::super::text::choice::ChoiceWords;
use super::super::text::kind::TableKind;
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::{every_row, list, number, row_of};
use crate::toml::schema::{self, TableSchema};

/// A kind of soil.
pub(super) struct Kind {
    pub(super) schema: &'static TableSchema,
    /// The soil with blank values.
    pub(super) blank: LayerSoil,
}

impl TableKind for Kind {
    const TABLE: &str = "[[ground.layer]]";
    const WORDS: ChoiceWords = ChoiceWords {
        of_value: "the type of the soil",
        unknown: "soil of type",
        known: "types:",
    };

    fn name(&self) -> &'static str {
        self.blank.kind()
    }

    fn schema(&self) -> &'static TableSchema {
        self.schema
    }
}

pub(super) static KINDS: LazyLock<Vec<Kind>> = LazyLock::new(|| {
    let kind = |blank: LayerSoil| Kind {
        schema: schema::layer(&blank),
        blank,
    };
    LayerSoil::blanks().map(kind).into()
});

const ROW: &str = "a row is [height in m, displacement in m, reaction in N/m]";

/// The values of a row: their names in the tower's checks and in messages.
const COLUMNS: [(&str, &str); 3] = [
    ("height", "height"),
    ("displacement", "the displacement"),
    ("reaction", "the reaction"),
];

/// The rows of a table of p-y curves.
pub(super) fn py_table(
    table: &Table<'_>,
    layer: usize,
    reading: &mut Reading,
) -> Option<LayerSoil> {
    let hint = "rows = [[height, displacement, reaction], ...] from the top to the bottom";
    let rows = list(table.require("rows", hint, reading)?, "rows", reading)?;
    let rows = every_row(rows, |row, value| {
        let what = format!("row {} of the layer", row + 1);
        let expected = |count| (count != COLUMNS.len()).then(|| "3".to_owned());
        let values = row_of(value, &what, ROW, expected, reading)?;
        py_row(values, |key| Place::GroundRow { layer, row, key }, reading)
    });
    rows.map(LayerSoil::Table)
}

fn py_row(
    values: &DeArray<'_>,
    at: impl Fn(&'static str) -> Place,
    reading: &mut Reading,
) -> Option<PyRow> {
    let mut row = [None; COLUMNS.len()];
    for ((value, (key, what)), entry) in values.iter().zip(COLUMNS).zip(&mut row) {
        reading.remember(at(key), value.span());
        *entry = number(value, what, reading);
    }
    let [height, displacement, reaction] = row;
    Some(PyRow {
        height_m: height?,
        displacement_m: displacement?,
        reaction_n_per_m: reaction?,
    })
}
