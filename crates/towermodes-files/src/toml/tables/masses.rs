//! `[rna]` and `[[point_mass]]`.

use towermodes::{Inertia, Place, PointMass, Rna};

use super::super::schema;
use super::super::text::reading::Reading;
use super::super::text::table::{Table, every_table, with_names};
use super::super::text::values::Value;
use super::body::{center, inertia_if_any};
use crate::places::TABLE;

/// The rotor-nacelle assembly.
pub(crate) fn rna(value: &Value<'_>, reading: &mut Reading) -> Option<Rna> {
    let at = |key| Place::Rna { key };
    let table = Table::of(value, "[rna]", &schema::RNA, reading)?;
    reading.remember(at(TABLE), value.span());
    let hint = "mass in kg; leave [rna] out if there is none";
    let mass = table.required_number("mass", hint, at("mass"), reading);
    let hint = "[x fore-aft, y side-side, z up] from the tower top, m";
    let center = match table.get("center") {
        Some(value) => center(value, hint, at("center"), reading),
        None => Some([0.0; 3]),
    };
    let inertia = inertia_if_any(&table, at("inertia"), reading);
    Some(Rna {
        mass_kg: mass?,
        center_m: center?,
        inertia_kg_m2: inertia?,
    })
}

/// Whether the file gives an inertia of zero to the rotor-nacelle assembly; one that is left out
/// may have been forgotten.
pub(crate) fn is_point_mass(root: &Table<'_>, rna: Option<&Rna>) -> bool {
    let table = root.get("rna").and_then(|rna| rna.get_ref().as_table());
    let has_inertia = table.is_some_and(|table| table.contains_key("inertia"));
    has_inertia && rna.is_some_and(|rna| rna.inertia_kg_m2 == Inertia::default())
}

/// All `[[point_mass]]` with their names.
pub(crate) fn point_masses(
    root: &Table<'_>,
    reading: &mut Reading,
) -> Option<(Vec<PointMass>, Vec<String>)> {
    with_names(every_table(root, "point_mass", "mass", reading, point_mass))
}

fn point_mass(
    index: usize,
    value: &Value<'_>,
    reading: &mut Reading,
) -> Option<(PointMass, String)> {
    let at = |key| Place::PointMass { index, key };
    let table = Table::of(value, "[[point_mass]]", &schema::POINT_MASS, reading)?;
    reading.remember(at(TABLE), value.span());
    let name = table.name_of("a point mass's name", reading);
    let hint = "height in m, in the datum of the stations";
    let height = table.required_number("height", hint, at("height"), reading);
    let mass = table.required_number("mass", "mass in kg", at("mass"), reading);
    let inertia = inertia_if_any(&table, at("inertia"), reading);
    let mass = PointMass {
        height_m: height?,
        mass_kg: mass?,
        inertia_kg_m2: inertia?,
    };
    Some((mass, name?))
}
