//! A part of a tower and its input values.

use crate::inputs::Nature;
use crate::tower::{Place, TowerDescription};

/// The index of a part and of a row in it; 0 where there is none.
pub(super) type Indices = [usize; 2];

/// A part of a tower that the tower file has once, as a list, or as a list of lists.
pub(super) struct Part {
    /// Its name in the tower file with `[]` for each index: `soil[].rows[]`.
    pub(super) name: &'static str,
    /// Its name in messages.
    pub(super) noun: &'static str,
    /// Number of such parts in the description.
    pub(super) count: fn(&TowerDescription) -> usize,
    /// Number of rows of one part; 1 for a part without rows.
    pub(super) rows: fn(&TowerDescription, usize) -> usize,
    /// Whether its two indices may be exchanged: the entries of a symmetric matrix.
    pub(super) is_symmetric: bool,
    /// Its input values.
    pub(super) keys: &'static [Key],
}

/// An input value of a part.
pub(super) struct Key {
    /// Its name in the part; empty if the part is the number.
    pub(super) name: &'static str,
    /// Its unit.
    pub(super) unit: &'static str,
    /// Its meaning in words.
    pub(super) meaning: &'static str,
    /// The kind of the value.
    pub(super) nature: Nature,
    /// Its place for errors.
    pub(super) place: fn(Indices) -> Place,
    /// Its value, if the description has it.
    pub(super) get: fn(&TowerDescription, Indices) -> Option<f64>,
    /// Sets its value, if the description has it.
    pub(super) set: fn(&mut TowerDescription, Indices, f64) -> Option<()>,
    /// Whether it is in the list of all input values; other values can only be named.
    pub(super) is_listed: fn(&TowerDescription, Indices) -> bool,
}

/// For an input value that is listed if its part is in the description.
pub(super) fn is_there(_: &TowerDescription, _: Indices) -> bool {
    true
}

/// The first of one or two expressions.
macro_rules! first_of {
    ($first:expr $(, $second:expr)?) => {
        $first
    };
}
pub(super) use first_of;

/// The numbers of a part that are fields of one type. The first two lines give the part for
/// reading and for writing, the third its place for a key; each other line is key, nature, unit,
/// meaning and field, and `listed` with the condition if the number is not always listed.
macro_rules! fields {
    (
        get |$d:ident, $i:ident| $part:expr;
        set |$dm:ident, $im:ident| $part_mut:expr;
        place |$at:ident, $key:ident| $place:expr;
        $($name:literal $nature:ident $unit:literal $meaning:literal, $place_key:literal $field:ident $(. $inner:ident)? $([$n:literal])? $(, listed $listed:expr)?;)+
    ) => {
        &[$(
            crate::parameter::part::Key {
                name: $name,
                unit: $unit,
                meaning: $meaning,
                nature: crate::inputs::Nature::$nature,
                place: |$at| { let _ = $at; let $key = $place_key; $place },
                get: |$d, $i| { let _ = $i; Some($part.$field$(.$inner)?$([$n])?) },
                set: |$dm, $im, value| { let _ = $im; $part_mut.$field$(.$inner)?$([$n])? = value; Some(()) },
                is_listed: crate::parameter::part::first_of!($($listed,)? crate::parameter::part::is_there),
            }
        ),+]
    };
}
pub(super) use fields;
