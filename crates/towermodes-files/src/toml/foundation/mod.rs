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

use super::choice::ChoiceWords;
use super::kind::{TableKind, kind_of, owners};
use super::reading::Reading;
use super::schema::{self, TableSchema};
use super::table::Table;
use crate::places::TABLE;

/// A type of foundation.
struct Kind {
    name: &'static str,
    schema: &'static TableSchema,
    /// How it holds the tower, for hints on keys of other types.
    nature: &'static str,
    read: fn(&Table<'_>, &mut Reading) -> Option<Foundation>,
}

impl TableKind for Kind {
    const TABLE: &str = "[foundation]";
    const WORDS: ChoiceWords = ChoiceWords {
        of_value: "the foundation's type",
        unknown: "foundation of type",
        known: "types:",
    };

    fn name(&self) -> &'static str {
        self.name
    }

    fn schema(&self) -> &'static TableSchema {
        self.schema
    }
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

/// The foundation; clamped by default.
pub(super) fn foundation(root: &Table<'_>, reading: &mut Reading) -> Option<Foundation> {
    let Some(value) = root.get("foundation") else {
        return Some(Foundation::Clamped);
    };
    reading.remember(at(TABLE), value.span());
    let kind = kind_of(value, at("type"), &KINDS, reading)?;
    let name = kind.schema.name;
    let elsewhere = |key: &str| Some(format!("{}; {}", owners(key, &KINDS)?, kind.nature));
    let table = Table::with_elsewhere(value, name, kind.schema, elsewhere, reading)?;
    (kind.read)(&table, reading)
}
