//! `[tower.properties]`: the sections as columns of properties per length, for towers that are not
//! tubes.

use towermodes::{Place, Planes, Properties, PropertyStation};

use super::super::schema;
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::{
    Value, check_pieces, every_row, list, number, number_or_infinity,
};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// The columns that may be infinite, for a tower that is rigid in torsion or axially.
const MAY_BE_INFINITE: [&str; 2] = ["gj_n_m2", "ea_n"];

/// The columns that a table must have, with hints.
const REQUIRED: [(&str, &str); 5] = [
    ("mass_kg_per_m", "mass per length, kg/m"),
    ("ei_fore_aft_n_m2", "EI against fore-aft bending, N m2"),
    ("gj_n_m2", "torsional stiffness GJ, N m2"),
    ("ea_n", "axial stiffness EA, N"),
    (
        "polar_inertia_kg_m",
        "inertia per length about the tower's axis, kg m; density times J for a tube",
    ),
];
/// Columns of both planes that may be missing.
const ROTARY_INERTIA: [&str; 2] = [
    "rotary_inertia_fore_aft_kg_m",
    "rotary_inertia_side_side_kg_m",
];
const SHEAR_STIFFNESS: [&str; 2] = ["shear_stiffness_fore_aft_n", "shear_stiffness_side_side_n"];

/// All rows of the table.
pub(crate) fn properties(value: &Value<'_>, reading: &mut Reading) -> Option<Vec<PropertyStation>> {
    let table = Table::of(value, "[tower.properties]", &schema::PROPERTIES, reading)?;
    reading.remember(Place::Stations, value.span());
    let hint = "z_m = [heights of the rows, m], and a list as long for each other column";
    let heights = table.require("z_m", hint, reading)?;
    let heights_m = column(heights, "z_m", "height", None, reading)?;
    check_pieces(heights, heights_m.iter().copied(), reading)?;
    Columns { table, heights_m }.rows(reading)
}

/// The table with its heights; all columns have the same number of values.
struct Columns<'a> {
    table: Table<'a>,
    heights_m: Vec<f64>,
}

impl Columns<'_> {
    /// An optional column: `Some(None)` if it is absent, `None` after a mistake.
    fn optional(&self, key: &'static str, reading: &mut Reading) -> Option<Option<Vec<f64>>> {
        let Some(value) = self.table.get(key) else {
            return (!self.table.has_misspelled(key)).then_some(None);
        };
        column(value, key, key, Some(self.heights_m.len()), reading).map(Some)
    }

    fn required(&self, key: &'static str, hint: &str, reading: &mut Reading) -> Option<Vec<f64>> {
        let value = self.table.require(key, hint, reading)?;
        column(value, key, key, Some(self.heights_m.len()), reading)
    }

    fn rows(&self, reading: &mut Reading) -> Option<Vec<PropertyStation>> {
        let required = REQUIRED.map(|(key, hint)| self.required(key, hint, reading));
        let side_side = self.optional("ei_side_side_n_m2", reading);
        let rotary = self.pair(ROTARY_INERTIA, reading);
        let shear = self.pair(SHEAR_STIFFNESS, reading);
        let [mass, fore_aft, torsion, axial, polar] = required;
        let (mass, fore_aft, torsion, axial, polar) = (mass?, fore_aft?, torsion?, axial?, polar?);
        let side_side = side_side?.unwrap_or_else(|| fore_aft.clone());
        let (rotary, shear) = (rotary?, shear?);
        let properties = |i: usize| {
            let bending_n_m2 = Planes {
                fore_aft: fore_aft[i],
                side_side: side_side[i],
            };
            Properties {
                mass_kg_per_m: mass[i],
                rotary_inertia_kg_m: match &rotary {
                    Some(rotary) => rotary[i],
                    None => shared_out(polar[i], bending_n_m2),
                },
                polar_inertia_kg_m: polar[i],
                bending_n_m2,
                torsion_n_m2: torsion[i],
                axial_n: axial[i],
                shear_n: shear.as_ref().map(|shear| shear[i]),
            }
        };
        let rows = self
            .heights_m
            .iter()
            .enumerate()
            .map(|(i, height_m)| PropertyStation {
                height_m: *height_m,
                properties: properties(i),
            });
        Some(rows.collect())
    }

    /// An optional quantity of both planes; a single fore-aft column applies to both planes.
    fn pair(
        &self,
        [fore_aft, side_side]: [&'static str; 2],
        reading: &mut Reading,
    ) -> Option<Option<Vec<Planes<f64>>>> {
        let first = self.optional(fore_aft, reading);
        let second = self.optional(side_side, reading);
        let planes = |(&fore_aft, &side_side): (&f64, &f64)| Planes {
            fore_aft,
            side_side,
        };
        match (first?, second?) {
            (None, None) => Some(None),
            (Some(first), None) => Some(Some(first.into_iter().map(Planes::both).collect())),
            (Some(first), Some(second)) => {
                Some(Some(first.iter().zip(&second).map(planes).collect()))
            }
            (None, Some(_)) => {
                self.table
                    .require(fore_aft, "the other plane's column is there", reading);
                None
            }
        }
    }
}

/// The rotary inertia of both planes, as for a section of one material: in the ratio of EI, with
/// the polar inertia as their sum.
pub(crate) fn shared_out(polar_kg_m: f64, bending_n_m2: Planes<f64>) -> Planes<f64> {
    let sum = bending_n_m2.fore_aft + bending_n_m2.side_side;
    bending_n_m2.map(|ei| polar_kg_m * (ei / sum))
}

/// A list of as many numbers as the others; `place` is the name of its values in the tower's
/// checks.
fn column(
    value: &Value<'_>,
    key: &str,
    place: &'static str,
    rows: Option<usize>,
    reading: &mut Reading,
) -> Option<Vec<f64>> {
    let values = list(value, key, reading)?;
    if let Some(rows) = rows.filter(|&rows| rows != values.len()) {
        let expected = format!("{rows}, the number of values in z_m");
        let kind = DiagnosticKind::wrong_count(key, values.len(), expected);
        let hint = "every column has one value for each height";
        return reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint));
    }
    let entry = if MAY_BE_INFINITE.contains(&key) {
        number_or_infinity
    } else {
        number
    };
    every_row(values, |index, value| {
        reading.remember(Place::Station { index, key: place }, value.span());
        entry(value, key, reading)
    })
}
