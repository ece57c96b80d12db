//! `[drivetrain]`.

use towermodes::{Drivetrain, Place};

use super::super::schema;
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use crate::places::TABLE;

/// The drivetrain: `Some(None)` if there is none, `None` after a mistake.
pub(crate) fn drivetrain(root: &Table<'_>, reading: &mut Reading) -> Option<Option<Drivetrain>> {
    let Some(value) = root.get("drivetrain") else {
        return Some(None);
    };
    let at = |key| Place::Drivetrain { key };
    reading.remember(at(TABLE), value.span());
    let table = Table::of(value, "[drivetrain]", &schema::DRIVETRAIN, reading)?;
    let (key, hint) = ("rotor_inertia", "rotor and hub about the shaft, kg m2");
    let rotor = table.required_number(key, hint, at(key), reading);
    let key = "generator_inertia";
    let generator = table.number_or(0.0, key, at(key), reading);
    let ratio = table.number_or(1.0, "gear_ratio", at("gear_ratio"), reading);
    Some(Some(Drivetrain {
        rotor_inertia_kg_m2: rotor?,
        generator_inertia_kg_m2: generator?,
        gear_ratio: ratio?,
    }))
}
