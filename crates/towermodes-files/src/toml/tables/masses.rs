//! `[rna]` and `[[point_mass]]`.

use towermodes::inputs::Inputs;
use towermodes::{Inertia, Place, PointMass, Rna};

use super::super::inputs::read;
use super::super::schema;
use super::super::text::reading::Reading;
use super::super::text::table::{Table, every_table, with_names};
use super::super::text::values::Value;
use crate::places::TABLE;

/// The rotor-nacelle assembly.
pub(crate) fn rna(value: &Value<'_>, reading: &mut Reading) -> Option<Rna> {
    let at = |key| Place::Rna { key };
    let table = Table::of(value, "[rna]", &schema::RNA, reading)?;
    reading.remember(at(TABLE), value.span());
    read(Rna::blank(), &table, at, reading)
}

/// Whether the file gives zero inertia for the rotor-nacelle assembly explicitly; an omitted
/// inertia may have been forgotten.
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
    let mass = read(PointMass::blank(), &table, at, reading);
    Some((mass?, name?))
}
