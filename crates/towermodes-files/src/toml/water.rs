//! `[water]`.

use towermodes::{Place, Water};

use super::reading::Reading;
use super::schema;
use super::table::Table;
use super::values::truth;
use crate::places::TABLE;

/// Density of sea water, kg/m³.
const SEA_KG_PER_M3: f64 = 1025.0;
/// Added mass coefficient of a cylinder in potential flow.
const CYLINDER: f64 = 1.0;

/// The water around the tower: `Some(None)` if there is none, `None` after a mistake.
pub(super) fn water(root: &Table<'_>, reading: &mut Reading) -> Option<Option<Water>> {
    let Some(value) = root.get("water") else {
        return Some(None);
    };
    let at = |key| Place::Water { key };
    reading.remember(at(TABLE), value.span());
    let table = Table::of(value, "[water]", &schema::WATER, reading)?;
    let hint = "height of the surface in m, in the datum of the stations";
    let level = table.required_number("level", hint, at("level"), reading);
    let bed = table.optional_number("bed", at("bed"), reading);
    let density = table.number_or(SEA_KG_PER_M3, "density", at("density"), reading);
    let key = "added_mass_coefficient";
    let coefficient = table.number_or(CYLINDER, key, at(key), reading);
    let flooded = table
        .get("flooded")
        .map_or(Some(false), |value| truth(value, "flooded", reading));
    Some(Some(Water {
        level_m: level?,
        bed_m: bed?,
        density_kg_per_m3: density?,
        added_mass_coefficient: coefficient?,
        flooded: flooded?,
    }))
}
