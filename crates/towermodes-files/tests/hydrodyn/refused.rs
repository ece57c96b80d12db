//! What is refused, at its place.

use towermodes_files::ReadError;
use towermodes_testing::Says;

use super::texts::{Layout, WAMIT_1, WAMIT_HST, deck, read, read_with};

/// The mistake: its file, its line and its message.
fn refusal(changes: &[(&str, &str)], wamit: [&str; 2]) -> (String, String, String) {
    let text = deck(Layout::V31, changes);
    let Err(ReadError::Mistakes {
        source_file,
        mistakes,
    }) = read_with(&text, wamit)
    else {
        panic!("not refused: {changes:?}");
    };
    let (line, _) = mistakes[0].line_and_column(&source_file.text);
    let line = source_file.text.lines().nth(line - 1).unwrap_or_default();
    (
        source_file.name.clone(),
        line.to_owned(),
        mistakes[0].message(),
    )
}

#[test]
fn a_wrong_member_or_table_is_refused_at_its_row() {
    let rows = [
        ("NMembers", "7 1 3 1 1 1 0.5 1 F", "7 1 3", "joint `3`"),
        (
            "NMembers",
            "7 1 2 1 5 1 0.5 1 F",
            "7 1 2",
            "property set `5`",
        ),
        ("NMembers", "7 1 1 1 1 1 0.5 1 F", "7 1 1", "at one point"),
        ("NMembers", "7 1 2 1 1 1 0.5 4 F", "7 1 2", "MCoefMod"),
        ("NMembers", "7 1 2 1 1 1 0.5 2 F", "7 1 2", "NCoefDpth"),
        ("NMembers", "7 1 2 1 1 1 0.5 3 F", "7 1 2", "NCoefMembers"),
        ("NPropSets", "1 4.0 2.1", "1 4.0", "PropThck"),
        ("NPropSets", "1 -4.0 0.1", "1 -4.0", "PropD"),
        (
            "NJoints",
            "1 0 0 -30 1 0\n1 0 0 10 1 0",
            "1 0 0 10",
            "joint 1",
        ),
        ("NFillGroups", "1 9 -5 1000", "1 9", "member `9`"),
        ("NFillGroups", "4 1 -5 1000", "4 1", "FillNumM"),
        (
            "NFillGroups",
            "1 1 -5 1000\n1 1 -5 1000",
            "1 1",
            "lists of filled members",
        ),
        ("NMGDepths", "0 -0.1 1100", "0 -0.1", "MGThck"),
        ("PotMod", "2", "2 PotMod", "fluid-impulse"),
        ("AddCLin", "0 0 0 x 0 0", "-------", "no `AddCLin`"),
    ];
    for (table, text, line, message) in rows {
        let mut changes = vec![(table, text)];
        if table != "NFillGroups" {
            changes.push(("NFillGroups", ""));
        }
        let (file, at, found) = refusal(&changes, [WAMIT_1, WAMIT_HST]);
        assert_eq!(file, "HydroDyn.dat");
        assert!(at.starts_with(line), "{table}: {at}: {found}");
        found.says(message);
    }
}

#[test]
fn a_file_that_ends_early_is_refused() {
    let text = deck(Layout::V31, &[]);
    let end = text.find("NMembers").expect("members");
    let end = text[..end].rfind('\n').expect("a line");
    let error = read_with(&text[..end], [WAMIT_1, WAMIT_HST]).expect_err("no members");
    error.says("the HydroDyn file has no `NMembers`");
}

#[test]
fn a_wrong_file_of_wamit_is_refused_at_its_line() {
    let with = |first: &str| WAMIT_1.replacen("-1 1 1 2.0", first, 1);
    let without = |period: &str| {
        let lines = WAMIT_1.lines().filter(|line| !line.starts_with(period));
        lines.collect::<Vec<_>>().join("\n")
    };
    let added = [
        (without("-1 "), "zero frequency"),
        (without("0 "), "infinite frequency"),
        (with("-1 1 7 2.0"), "second body"),
        (with("-1 0 1 2.0"), "from 1"),
        (with("-1 1 1"), "at least 4"),
        (with("-1 1 1 x"), "a number"),
        (with("-1 3 3 2.0"), "entry (3, 3)"),
        (
            without("-1 3 3"),
            "entry (3, 3) of the added mass at zero frequency",
        ),
        (with("-1 1 5 9.0\n-1 5 1 -9.0\n-1 1 1 2.0"), "not symmetric"),
    ];
    for (text, message) in added {
        let (file, _, found) = refusal(&[("PotMod", "1")], [&text, WAMIT_HST]);
        assert_eq!(file, "body.1");
        found.says(message);
    }
    for (text, message) in [
        ("", "empty"),
        ("3 3", "at least 3"),
        ("3 9 1.0", "second body"),
    ] {
        let (file, _, found) = refusal(&[("PotMod", "1")], [WAMIT_1, text]);
        assert_eq!(file, "body.hst");
        found.says(message);
    }
    let (_, line, found) = refusal(&[("PotMod", "1"), ("NBody", "2")], [WAMIT_1, WAMIT_HST]);
    assert_eq!(line, "2 NBody - bodies");
    found.says("one rigid body");
}

/// A rectangular member of the body with potential flow has no water of its own, and needs no
/// section; one with strip theory or filling does.
#[test]
fn rectangular_members_need_a_section_where_they_have_a_part() {
    let rows = |geometry: u8, flow: &str| {
        format!("1 1 2 1 1 1 0.5 1 F\n2 1 2 9 9 {geometry} 0.5 1 {flow}")
    };
    let text = |members: &str, fillings: &str| {
        deck(
            Layout::V41,
            &[("NMembers", members), ("NFillGroups", fillings)],
        )
    };
    let input = read(&text(&rows(2, "T"), "")).unwrap_or_else(|error| panic!("{error}"));
    let names: Vec<&str> = input.members.iter().map(|member| &*member.name).collect();
    assert_eq!(names, ["1"]);
    for (members, fillings) in [
        (rows(2, "F"), ""),
        (rows(2, "T"), "1 2 -5 1000"),
        (rows(1, "T"), ""),
    ] {
        let error = read(&text(&members, fillings)).expect_err("no such section");
        error.says("property set `9`");
    }
    let error = read(&text(&rows(3, "F"), "")).expect_err("no such form");
    error.says("1 (circular) or 2 (rectangular)");
}

/// The hull of GeoFile is not read.
#[test]
fn nonlinear_hydrostatics_have_a_note() {
    let said = |value: u8| {
        let text = deck(Layout::V41, &[("PotMod", "1")]);
        let text = text.replace(
            "1 NBody - bodies\n",
            &format!("1 NBody - bodies\n{value} FKMod - x\n\"hull.stl\" GeoFile - x\n"),
        );
        let input = read(&text).unwrap_or_else(|error| panic!("{error}"));
        let mut notes = input.notes.iter().map(ToString::to_string);
        notes.any(|note| note.contains("FKMod is not 0"))
    };
    assert!(!said(0));
    assert!(said(1));
}

/// Without its volume the body has no buoyancy, and there is no static balance.
#[test]
fn a_body_without_volume_is_doubted() {
    let text = deck(Layout::V31, &[("PotMod", "1")]);
    for (volume, expected) in [("100", 0), ("0", 1)] {
        let text = text.replace("100 PtfmVol0", &format!("{volume} PtfmVol0"));
        let input = read_with(&text, [WAMIT_1, WAMIT_HST]).expect("a file");
        let notes = input.notes.iter().map(ToString::to_string);
        let doubts = notes.filter(|note| note.contains("PtfmVol0 is 0, so the buoyancy"));
        assert_eq!(doubts.count(), expected, "{volume}");
    }
}

/// Damping, drag and waves change no mode: one note names all that is not used.
#[test]
fn what_modes_do_not_need_is_one_note() {
    let text = deck(Layout::V31, &[("PotMod", "1")]);
    let input = read_with(&text, [WAMIT_1, WAMIT_HST]).expect("a file");
    let notes: Vec<String> = input.notes.iter().map(ToString::to_string).collect();
    let unused: Vec<&String> = notes
        .iter()
        .filter(|note| note.contains("not used"))
        .collect();
    assert_eq!(unused.len(), 1, "{notes:?}");
    unused[0].says("no damping, drag and waves: AddBLin, AddBQuad");
}
