//! `[foundation]`: its type, and which keys belong to which.

mod floating;
mod half_space;
mod springs;
mod stiffness;

use towermodes::{Foundation, Place};

use super::table::{Keys, Table, suggestion};
use super::values::{Value, text};
use super::{Reading, TABLE};
use crate::diagnostic::Diagnostic;

/// A type of foundation.
struct Kind {
    name: &'static str,
    keys: Keys,
    /// How it holds the tower, for those who gave it a key of another type.
    nature: &'static str,
    read: fn(&Table<'_>, &mut Reading) -> Option<Foundation>,
}

static KINDS: [Kind; 5] = [
    CLAMPED,
    stiffness::KIND,
    springs::KIND,
    half_space::KIND,
    floating::KIND,
];

const CLAMPED: Kind = Kind {
    name: "clamped",
    keys: Keys { known: &["type"] },
    nature: "a clamped base does not move",
    read: |_, _| Some(Foundation::Clamped),
};

/// The keys of all types, for a foundation that does not say which it is.
static OF_ANY_TYPE: Keys = Keys {
    known: &[
        "type",
        "matrix",
        "mass",
        "lateral",
        "rocking",
        "vertical",
        "torsion",
        "coupling",
        "radius",
        "embedment",
        "soil_shear_modulus",
        "soil_poissons_ratio",
        "center",
        "inertia",
        "added_mass",
        "added_mass_height",
        "hydrostatic",
        "hydrostatic_height",
        "mooring",
        "mooring_height",
    ],
};

fn at(key: &'static str) -> Place {
    Place::Foundation { key }
}

/// What the base stands on; clamped unless told.
pub(super) fn foundation(root: &Table<'_>, reading: &mut Reading) -> Option<Foundation> {
    let Some(value) = root.get("foundation") else {
        return Some(Foundation::Clamped);
    };
    reading.remember(at(TABLE), value.span());
    let kind = kind(value, reading)?;
    let name = format!("[foundation] of type \"{}\"", kind.name);
    let table = Table::with_elsewhere(value, name, &kind.keys, |key| foreign(key, kind), reading)?;
    (kind.read)(&table, reading)
}

/// The type that a foundation says it has; if there is none of that name, its other keys cannot be
/// judged.
fn kind(value: &Value<'_>, reading: &mut Reading) -> Option<&'static Kind> {
    let has_type = |value: &Value<'_>| {
        let table = value.get_ref().as_table();
        table.is_none_or(|table| table.contains_key("type"))
    };
    let table = if has_type(value) {
        Table::with_any_keys(value, "[foundation]", reading)?
    } else {
        Table::of(value, "[foundation]", &OF_ANY_TYPE, reading)?
    };
    let names = KINDS.each_ref().map(|kind| kind.name);
    let hint = format!("type = \"{}\"", names.join("\" or \""));
    let value = table.require("type", &hint, reading)?;
    reading.remember(at("type"), value.span());
    let name = text(value, "the foundation's type", reading)?;
    let found = KINDS.iter().find(|kind| kind.name == name);
    if found.is_none() {
        let message = format!("there is no foundation of type `{name}`");
        let hint = suggestion(name, &names, "there are");
        reading.mistake(Diagnostic::new(value.span(), message).with_hint(hint));
    }
    found
}

/// What to say of a key that belongs to foundations of other types.
fn foreign(key: &str, kind: &Kind) -> Option<String> {
    let owners: Vec<String> = KINDS
        .iter()
        .filter(|other| other.keys.known.contains(&key))
        .map(|other| format!("\"{}\"", other.name))
        .collect();
    (!owners.is_empty()).then(|| {
        let owners = owners.join(" or ");
        format!("it belongs to type = {owners}; {}", kind.nature)
    })
}

#[cfg(test)]
mod tests {
    use super::{KINDS, OF_ANY_TYPE};

    #[test]
    fn the_keys_of_any_type_are_those_of_all_types() {
        let mut all: Vec<&str> = KINDS
            .iter()
            .flat_map(|kind| kind.keys.known)
            .copied()
            .collect();
        let mut listed = OF_ANY_TYPE.known.to_vec();
        all.sort_unstable();
        all.dedup();
        listed.sort_unstable();
        assert_eq!(listed, all);
    }
}
