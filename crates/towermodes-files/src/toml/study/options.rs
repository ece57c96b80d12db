//! `[sweep.reading]`: options for reading the base, if its format leaves a choice.

use super::super::text::reading::Reading;
use super::super::text::table::{Table, suggestion};
use super::super::text::values::{Value, every_row, list, number, text, truth, whole};
use super::schema::READING;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::input::{MemberEnds, ReadOptions, RotorLock, TowerPart};

/// The parts of a turbine by name.
const PARTS: [(&str, TowerPart); 3] = [
    ("all", TowerPart::All),
    ("tower", TowerPart::Tower),
    ("monopile", TowerPart::Monopile),
];

/// The states of a rotor, by name.
const ROTORS: [(&str, RotorLock); 2] = [("locked", RotorLock::Locked), ("free", RotorLock::Free)];

/// The ends of members of a floating platform, by name.
const MEMBER_ENDS: [(&str, MemberEnds); 3] = [
    ("balance", MemberEnds::Balance),
    ("cut", MemberEnds::Cut),
    ("whole", MemberEnds::Whole),
];

/// The options, by default those of [`ReadOptions::default`]; `None` after a mistake.
pub(super) fn options(sweep: &Table<'_>, reading: &mut Reading) -> Option<ReadOptions> {
    let default = ReadOptions::default();
    let Some(value) = sweep.get("reading") else {
        return Some(default);
    };
    let table = Table::of(value, READING.name, &READING, reading)?;
    let keys = [
        "no_rna",
        "no_gravity",
        "bmodes_quirks",
        "clamped",
        "equilibrium",
    ];
    let flags = keys.map(|key| flag(&table, key, reading));
    let heights = ["tower_height", "tower_base"].map(|key| height(&table, key, reading));
    let part = named(&table, "part", &PARTS, reading);
    let rotor = named(&table, "rotor", &ROTORS, reading);
    let member_ends = named(&table, "member_ends", &MEMBER_ENDS, reading);
    let subset = table.get("subset").map(|value| subset(value, reading));
    let [
        without_rna,
        without_gravity,
        bmodes_quirks,
        clamped,
        at_equilibrium,
    ] = flags;
    let [tower_height_m, tower_base_m] = heights;
    Some(ReadOptions {
        bmodes_quirks: bmodes_quirks?,
        tower_height_m: tower_height_m?,
        tower_base_m: tower_base_m?,
        without_rna: without_rna?,
        part: part?,
        hawc2_subset: subset.map_or(Some(None), |found| found.map(Some))?,
        rotor: rotor?,
        without_gravity: without_gravity?,
        clamped: clamped?,
        at_equilibrium: at_equilibrium?,
        member_ends: member_ends?,
    })
}

fn flag(table: &Table<'_>, key: &str, reading: &mut Reading) -> Option<bool> {
    match table.get(key) {
        None => Some(false),
        Some(value) => truth(value, key, reading),
    }
}

fn height(table: &Table<'_>, key: &str, reading: &mut Reading) -> Option<Option<f64>> {
    match table.get(key) {
        None => Some(None),
        Some(value) => number(value, key, reading).map(Some),
    }
}

/// A choice by name; the first is the default.
fn named<T: Copy, const N: usize>(
    table: &Table<'_>,
    key: &'static str,
    choices: &[(&'static str, T); N],
    reading: &mut Reading,
) -> Option<T> {
    let Some(value) = table.get(key) else {
        return Some(choices[0].1);
    };
    let name = text(value, key, reading)?;
    let found = choices.iter().find(|(own, _)| *own == name);
    found.map(|(_, choice)| *choice).or_else(|| {
        let hint = suggestion(name, &choices.map(|(own, _)| own), "there are");
        let kind = DiagnosticKind::UnknownName {
            what: key,
            name: name.to_owned(),
        };
        reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint))
    })
}

/// Set and subset of a HAWC2 file, from 1.
fn subset(value: &Value<'_>, reading: &mut Reading) -> Option<(usize, usize)> {
    let entries = list(value, "subset", reading)?;
    let numbers = every_row(entries, |_, entry| whole(entry, "subset", 1, reading))?;
    match numbers[..] {
        [set, subset] => Some((set as usize, subset as usize)),
        _ => {
            let kind = DiagnosticKind::wrong_count("subset", numbers.len(), 2);
            let mistake = Diagnostic::new(value.span(), kind);
            reading.refuse(mistake.with_hint("set and subset, for example [1, 2]"))
        }
    }
}
