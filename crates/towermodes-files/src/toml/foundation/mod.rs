//! `[foundation]`: its type, and which keys belong to which.

mod choice;
mod floating;
mod footings;
mod half_space;
mod pile;
mod springs;
mod stiffness;

pub(super) use footings::FOOTING_FORMULAS;
pub(super) use pile::{BEAM_FORMULAS, FORMULAS, PROFILES, SPRING_FORMULAS, SpringFormula};

use towermodes::{Foundation, Place};

use super::reading::Reading;
use super::schema::{self, FOUNDATIONS, TableSchema};
use super::table::{Table, suggestion};
use super::values::{Value, text};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::places::TABLE;

/// A type of foundation.
struct Kind {
    name: &'static str,
    schema: &'static TableSchema,
    /// How it holds the tower, for hints on keys of other types.
    nature: &'static str,
    read: fn(&Table<'_>, &mut Reading) -> Option<Foundation>,
}

static KINDS: [Kind; 10] = [
    CLAMPED,
    stiffness::KIND,
    springs::KIND,
    half_space::KIND,
    footings::CIRCULAR,
    footings::RECTANGULAR,
    footings::CAISSON,
    pile::MONOPILE,
    pile::WINKLER_PILE,
    floating::KIND,
];

const CLAMPED: Kind = Kind {
    name: "clamped",
    schema: &schema::CLAMPED,
    nature: "a clamped base does not move",
    read: |_, _| Some(Foundation::Clamped),
};

fn at(key: &'static str) -> Place {
    Place::Foundation { key }
}

/// Refuses a key that has no effect because of another one.
fn without_effect<T>(
    table: &Table<'_>,
    key: &str,
    because: &str,
    hint: &str,
    reading: &mut Reading,
) -> Option<T> {
    let place = table.get(key)?.span();
    let kind = DiagnosticKind::UnusedKey {
        key: key.to_owned(),
        because: because.to_owned(),
    };
    reading.refuse(Diagnostic::new(place, kind).with_hint(hint))
}

/// The foundation; clamped by default.
pub(super) fn foundation(root: &Table<'_>, reading: &mut Reading) -> Option<Foundation> {
    let Some(value) = root.get("foundation") else {
        return Some(Foundation::Clamped);
    };
    reading.remember(at(TABLE), value.span());
    let kind = kind(value, reading)?;
    let name = kind.schema.name;
    let elsewhere = |key: &str| foreign(key, kind);
    let table = Table::with_elsewhere(value, name, kind.schema, elsewhere, reading)?;
    (kind.read)(&table, reading)
}

/// The type of a foundation; without a known type its other keys cannot be checked.
fn kind(value: &Value<'_>, reading: &mut Reading) -> Option<&'static Kind> {
    let has_type = |value: &Value<'_>| {
        let table = value.get_ref().as_table();
        table.is_none_or(|table| table.contains_key("type"))
    };
    let name = "[foundation]";
    let table = if has_type(value) {
        Table::with_any_keys(value, name, reading)?
    } else {
        let schemas = FOUNDATIONS.iter();
        let known = schemas.flat_map(|schema| schema.key_names()).collect();
        Table::with_known_keys(value, name, known, |_| None, reading)?
    };
    let names = KINDS.each_ref().map(|kind| kind.name);
    let hint = format!("type = \"{}\"", names.join("\" or \""));
    let value = table.require("type", &hint, reading)?;
    reading.remember(at("type"), value.span());
    let name = text(value, "the foundation's type", reading)?;
    KINDS.iter().find(|kind| kind.name == name).or_else(|| {
        let hint = suggestion(name, &names, "types:");
        let (what, name) = ("foundation of type", name.to_owned());
        let kind = DiagnosticKind::UnknownName { what, name };
        reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint))
    })
}

/// The hint on a key that belongs to foundations of other types.
fn foreign(key: &str, kind: &Kind) -> Option<String> {
    let owners: Vec<String> = KINDS
        .iter()
        .filter(|other| other.schema.key(key).is_some())
        .map(|other| format!("\"{}\"", other.name))
        .collect();
    (!owners.is_empty()).then(|| {
        let owners = owners.join(" or ");
        format!("it belongs to type = {owners}; {}", kind.nature)
    })
}
