//! The kinds of soil of a layer, with the keys of each.

use toml::de::DeArray;
use towermodes::{Clay, LayerSoil, Place, PyRow, Rock, Sand};

use super::layer::{elastic, pair};
use crate::toml::choice::ChoiceWords;
use crate::toml::kind::TableKind;
use crate::toml::reading::Reading;
use crate::toml::schema::{self, TableSchema};
use crate::toml::table::Table;
use crate::toml::values::{every_row, list, number, row_of};

/// A kind of soil.
pub(super) struct Kind {
    pub(super) name: &'static str,
    pub(super) schema: &'static TableSchema,
    /// Whether it has the keys of a shear modulus.
    pub(super) has_shear_modulus: bool,
    pub(super) read: fn(&Table<'_>, usize, &mut Reading) -> Option<LayerSoil>,
}

impl TableKind for Kind {
    const TABLE: &str = "[[ground.layer]]";
    const WORDS: ChoiceWords = ChoiceWords {
        of_value: "the type of the soil",
        unknown: "soil of type",
        known: "types:",
    };

    fn name(&self) -> &'static str {
        self.name
    }

    fn schema(&self) -> &'static TableSchema {
        self.schema
    }
}

pub(super) static KINDS: [Kind; 5] = [
    Kind {
        name: "sand",
        schema: &schema::SAND,
        has_shear_modulus: true,
        read: sand,
    },
    Kind {
        name: "clay",
        schema: &schema::CLAY,
        has_shear_modulus: true,
        read: clay,
    },
    Kind {
        name: "elastic",
        schema: &schema::ELASTIC,
        has_shear_modulus: true,
        read: elastic,
    },
    Kind {
        name: "rock",
        schema: &schema::ROCK,
        has_shear_modulus: false,
        read: rock,
    },
    Kind {
        name: "py",
        schema: &schema::PY_TABLE,
        has_shear_modulus: true,
        read: py_table,
    },
];

fn sand(table: &Table<'_>, index: usize, reading: &mut Reading) -> Option<LayerSoil> {
    let mut optional =
        |key: &'static str| table.optional_number(key, Place::GroundLayer { index, key }, reading);
    let angle = optional("friction_angle");
    let modulus = optional("subgrade_modulus");
    let density = optional("relative_density");
    Some(LayerSoil::Sand(Sand {
        friction_angle_deg: angle?,
        subgrade_modulus_n_per_m3: modulus?,
        relative_density: density?,
    }))
}

fn clay(table: &Table<'_>, index: usize, reading: &mut Reading) -> Option<LayerSoil> {
    let at = |key| Place::GroundLayer { index, key };
    let key = "undrained_strength";
    let strength = pair(table, key, at(key), reading);
    let mut optional = |key: &'static str| table.optional_number(key, at(key), reading);
    let strain = optional("strain_at_half_strength");
    let surface = optional("strength_factor");
    let stiffness = optional("stiffness_factor");
    Some(LayerSoil::Clay(Clay {
        undrained_strength_pa: strength?,
        strain_at_half_strength: strain?,
        strength_factor: surface?,
        stiffness_factor: stiffness?,
    }))
}

fn rock(table: &Table<'_>, index: usize, reading: &mut Reading) -> Option<LayerSoil> {
    let key = "youngs_modulus";
    let modulus = pair(table, key, Place::GroundLayer { index, key }, reading);
    Some(LayerSoil::Rock(Rock {
        youngs_modulus_pa: modulus?,
    }))
}

const ROW: &str = "a row is [height in m, displacement in m, reaction in N/m]";

/// The values of a row: their names in the tower's checks and in messages.
const COLUMNS: [(&str, &str); 3] = [
    ("height", "height"),
    ("displacement", "the displacement"),
    ("reaction", "the reaction"),
];

fn py_table(table: &Table<'_>, layer: usize, reading: &mut Reading) -> Option<LayerSoil> {
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
