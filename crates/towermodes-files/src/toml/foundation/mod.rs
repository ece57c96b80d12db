//! `[foundation]`: its type, and the keys of each type. The values of a foundation by closed form
//! are described beside its fields.

mod added_mass;
mod floating;
mod springs;
mod stiffness;

use std::sync::LazyLock;

use towermodes::{Foundation, Place};

use super::inputs::read_into;
use super::schema::{self, TableSchema};
use super::text::choice::ChoiceWords;
use super::text::kind::{TableKind, kind_of, owners};
use super::text::reading::Reading;
use super::text::table::Table;
use crate::places::TABLE;

/// A type of foundation.
struct Kind {
    name: &'static str,
    schema: &'static TableSchema,
    /// A text on how it supports the tower, for hints on keys of other types.
    nature: &'static str,
    read: Read,
}

/// The way in which a foundation is read.
enum Read {
    /// By a function.
    By(fn(&Table<'_>, &mut Reading) -> Option<Foundation>),
    /// Into this blank foundation, by the descriptions of its values.
    Into(Foundation),
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

static KINDS: LazyLock<Vec<Kind>> = LazyLock::new(|| {
    let first = [CLAMPED, stiffness::KIND, springs::kind()];
    first
        .into_iter()
        .chain(closed_forms())
        .chain([floating::KIND])
        .collect()
});

/// The foundations by closed form.
fn closed_forms() -> impl Iterator<Item = Kind> {
    let blanks = Foundation::blank_forms().into_iter();
    blanks
        .zip(schema::CLOSED_FORMS.iter())
        .filter_map(|(blank, schema)| {
            let kind = blank.form()?.kind();
            Some(Kind {
                name: kind.name,
                schema,
                nature: kind.nature,
                read: Read::Into(blank),
            })
        })
}

const CLAMPED: Kind = Kind {
    name: "clamped",
    schema: &schema::CLAMPED,
    nature: "a clamped base does not move",
    read: Read::By(|_, _| Some(Foundation::Clamped)),
};

fn at(key: &'static str) -> Place {
    Place::Foundation { key }
}

/// Whether the foundation is of type "floating": a platform, or the restoring stiffness of a
/// floating substructure.
pub(super) fn floats(root: &Table<'_>) -> bool {
    let foundation = root.get("foundation");
    let table = foundation.and_then(|value| value.get_ref().as_table());
    let kind = table.and_then(|table| table.get("type"));
    kind.and_then(|kind| kind.get_ref().as_str()) == Some(floating::KIND.name)
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
    match &kind.read {
        Read::By(read) => read(&table, reading),
        Read::Into(blank) => {
            let mut foundation = blank.clone();
            read_into(foundation.form_mut()?, &table, &at, reading)?;
            Some(foundation)
        }
    }
}
