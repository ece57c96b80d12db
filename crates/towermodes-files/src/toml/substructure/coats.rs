//! `coats` of a member: water and growth that move with it.

use towermodes::frame::{CoatKind, FrameCoat};

use super::super::schema;
use super::super::text::choice::{ChoiceWords, one_of};
use super::super::text::reading::Reading;
use super::super::text::table::{Table, every_table};
use super::super::text::values::Value;
use super::{ends, numbers};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

const WORDS: ChoiceWords = ChoiceWords {
    of_value: "the coat's kind",
    unknown: "coat of kind",
    known: "kinds:",
};

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Solid,
    AddedMass,
}

const KINDS: [(&str, Kind); 2] = [("solid", Kind::Solid), ("added-mass", Kind::AddedMass)];

/// All coats of a member.
pub(super) fn coats(member: &Table<'_>, reading: &mut Reading) -> Option<Vec<FrameCoat>> {
    every_table(member, "coats", "coat", reading, coat)
}

fn coat(_: usize, value: &Value<'_>, reading: &mut Reading) -> Option<FrameCoat> {
    let table = Table::of(value, "a coat", &schema::SUBSTRUCTURE_COAT, reading)?;
    let range = match table.get("range") {
        Some(value) => numbers(value, "range", 2, reading).and_then(|ends| ends.try_into().ok()),
        None => Some([0.0, 1.0]),
    };
    let hint = "kind = \"solid\" or \"added-mass\"";
    let kind = table
        .require("kind", hint, reading)
        .and_then(|value| one_of(value, WORDS, &KINDS, reading));
    let density = required(&table, "density", "kg/m3", reading);
    let Some(kind) = kind else {
        // Their mistakes are reported beside that of the kind.
        for key in OF_SOLID.iter().chain(&OF_ADDED_MASS) {
            or(0.0, &table, key, reading);
        }
        return None;
    };
    let density = density?;
    let kind = match kind {
        Kind::Solid => solid(&table, density, reading)?,
        Kind::AddedMass => added_mass(&table, density, reading)?,
    };
    Some(FrameCoat {
        range: range?,
        kind,
    })
}

const OF_SOLID: [&str; 2] = ["outer_radius", "inner_radius"];
const OF_ADDED_MASS: [&str; 3] = ["radius", "across", "along"];

fn required(table: &Table<'_>, key: &str, hint: &str, reading: &mut Reading) -> Option<[f64; 2]> {
    let value = table.require(key, hint, reading)?;
    ends(value, key, reading)
}

fn or(default: f64, table: &Table<'_>, key: &str, reading: &mut Reading) -> Option<[f64; 2]> {
    match table.get(key) {
        Some(value) => ends(value, key, reading),
        None => Some([default; 2]),
    }
}

fn solid(table: &Table<'_>, density: [f64; 2], reading: &mut Reading) -> Option<CoatKind> {
    for key in OF_ADDED_MASS {
        let hint = "it belongs to kind = \"added-mass\"";
        table.refuse_unused(key, "at a coat of kind \"solid\"", hint, reading)?;
    }
    Some(CoatKind::Solid {
        density_kg_per_m3: density,
        outer_radius_m: required(table, "outer_radius", "m", reading)?,
        inner_radius_m: or(0.0, table, "inner_radius", reading)?,
    })
}

fn added_mass(table: &Table<'_>, density: [f64; 2], reading: &mut Reading) -> Option<CoatKind> {
    for key in OF_SOLID {
        let hint = "it belongs to kind = \"solid\"";
        table.refuse_unused(key, "at a coat of kind \"added-mass\"", hint, reading)?;
    }
    if density[0] != density[1] {
        let span = table.get("density").map_or(0..0, |value| value.span());
        let kind = DiagnosticKind::wrong_count("density of the water", 2, 1);
        return reading.refuse(Diagnostic::new(span, kind));
    }
    Some(CoatKind::AddedMass {
        density_kg_per_m3: density[0],
        radius_m: required(table, "radius", "of member and growth, m", reading)?,
        across: or(1.0, table, "across", reading)?,
        along: or(0.0, table, "along", reading)?,
    })
}
