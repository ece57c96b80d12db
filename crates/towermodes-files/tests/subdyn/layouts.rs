//! The layouts of FAST 8 to OpenFAST 5, habits of Fortran, and notes on what is left out.

use towermodes::frame::{JointKind, MemberKind};
use towermodes_files::{Interface, NoteKind};
use towermodes_testing::{Says, rows};

use super::frequencies::solved;
use super::texts::{deck, input, read};

/// The file of [`deck`] as FAST 8 has it: fewer columns and tables, older names.
fn of_fast_8() -> String {
    let text = deck(&[
        ("NJoints", "1 0 0 -20\n2 0 0 -10\n3 0 0 0"),
        ("NInterf", "3 1 1 1 1 1 1"),
        ("NMembers", "1 1 2 1 1\n2 2 3 1 1"),
        ("NCmass", "2 8e3 1e4 2e4 3e4"),
    ]);
    let text = text.replace("NPropSetsCyl", "NPropSets");
    let text = text.replace(
        " JointType JointDirX JointDirY JointDirZ JointStiff",
        " [Coordinates]",
    );
    let text = text.replace(" MType MSpin/COSMID", " COSMID");
    let text = text.replace(
        "CIRCULAR BEAM CROSS-SECTION PROPERTIES",
        "MEMBER X-SECTION PROPERTY data 1/2 [use it for circular elements]",
    );
    let without = [
        "RECTANGULAR BEAM",
        "CABLE PROP",
        "RIGID LINK",
        "SPRING ELEMENT",
    ];
    without.iter().fold(text, |text, heading| {
        let start = text.find(&format!("------- {heading}")).expect("a table");
        let end = start + text[start + 7..].find("\n-------").expect("another") + 8;
        format!("{}{}", &text[..start], &text[end..])
    })
}

#[test]
fn files_of_fast_8_are_those_of_openfast_5() {
    let old = read(&of_fast_8()).unwrap_or_else(|error| panic!("{error}"));
    let new = input(&[("NCmass", "2 8e3 1e4 2e4 3e4 0 0 0 0 0 0")]);
    assert_eq!(old.description, new.description);
    assert_eq!(old.interface_joints, [2]);
    assert_eq!(old.divisions, 4);
    assert_eq!(old.title, "tubes");
}

/// The rows of a table in other layouts, or with habits of Fortran, that say the same.
#[test]
fn layouts_and_habits_of_fortran_say_the_same() {
    let plain = input(&[]);
    for [table, changed] in rows(
        r#"
        NReact       | 1
        NReact       | 1 1 1 1 1 1 1
        NReact       | 1 1 1 1 1 1 1 ""
        NReact       | 1 1 1 1 1 1 1 ! held
        NInterf      | 3
        NInterf      | 3 1
        NInterf      | 3 1 1 1 1 1 1
        NMembers     | 1 1 2 1 1 1 0\n2 2 3 1 1 1 0
        NMembers     | 1 1 2 1 1\n2 2 3 1 1
        NMembers     | 1, 1, 2, 1, 1, "1c", 0\n2, 2, 3, 1, 1, '1C', 0
        NJoints      | 1 0 0 -2.D1 1 0 0 0 0\n\n2 0 0 -1d1 1 0 0 0 0\n3.0 0 0 0 1 0 0 0 0 ! top
        NPropSetsCyl | 1 2.1D11 8.08D10 7850. 2. .03 / steel
        "#,
    ) {
        let found = input(&[(table, changed)]);
        assert_eq!(found.description, plain.description, "{changed}");
        assert_eq!(found.interface_joints, plain.interface_joints, "{changed}");
    }
    let two = deck(&[])
        .replace("4 NDiv - parts", "4 6 NDiv - parts")
        .replace('\n', "\r\n");
    let found = read(&format!("\u{feff}{two}")).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((found.description, found.divisions), (plain.description, 4));
}

#[test]
fn the_table_of_rectangles_may_have_the_name_of_the_circles() {
    let members = "1 1 2 1 1 1r 0\n2 2 3 1 1 1r 0";
    let rectangles = [
        ("NMembers", members),
        ("NPropSetsRec", "1 2.1e11 8.08e10 7850 2.0 1.2 0.03"),
    ];
    let text = deck(&rectangles).replace("NPropSetsRec", "NPropSets");
    let found = read(&text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(found.description, input(&rectangles).description);
}

#[test]
fn a_wall_of_0_is_a_solid_section() {
    let found = input(&[("NPropSetsCyl", "1 2.1e11 8.08e10 7850 2.0 0.0")]);
    let mass_kg = found.frame(Interface::Free).expect("a frame").mass_kg();
    assert!((mass_kg / (7850.0 * 20.0 * std::f64::consts::PI) - 1.0).abs() < 1e-12);
}

#[test]
fn joints_and_members_have_the_types_of_the_columns() {
    let found = input(&[
        (
            "NJoints",
            "1 0 0 -20 1 0 0 0 0\n2 0 0 -10 3 0 1 0 5e7\n3 0 0 0 1 0 0 0 0",
        ),
        ("NMembers", "1 1 2 1 1 1c 0\n2 2 3 1 1 2 -1\n3 1 3 1 1 3 -1"),
        ("NCablePropSets", "1 1e8 20 0 0"),
        ("NRigidPropSets", "1 0"),
    ]);
    let pin = JointKind::Pin {
        axis: [0.0, 1.0, 0.0],
        stiffness_n_m_per_rad: 5e7,
    };
    assert_eq!(found.description.joints[1].kind, pin);
    assert!(matches!(
        found.description.members[1].kind,
        MemberKind::Cable { .. }
    ));
    assert!(matches!(
        found.description.members[2].kind,
        MemberKind::Rigid { .. }
    ));
}

/// A frame that nothing holds has six motions without stiffness, which come first.
#[test]
fn a_substructure_without_supports_floats() {
    let found = solved(&input(&[("NReact", "")]), Interface::Free, false, 7);
    assert!(
        found[..6].iter().all(|hz| *hz < 1e-4) && found[6] > 1.0,
        "{found:?}"
    );
}

#[test]
fn what_is_not_used_has_a_note_with_its_line() {
    let of_kind = |changes: &[(&str, &str)], kind: NoteKind| {
        let notes = input(changes).notes.into_iter();
        let notes: Vec<String> = notes
            .filter(|note| note.kind == kind)
            .map(|n| n.to_string())
            .collect();
        notes.join("\n")
    };
    of_kind(&[], NoteKind::LeftOut)
        .says("SubDyn.dat:9: Nmodes (8) and the damping values are not used");
    for [table, changed, kind, said] in rows(
        r#"
        NReact         | 1 1 1 1 1 1 1 "ssi.txt" | compatibility | "ssi.txt" is not read, as in SubDyn: all six flags are 1
        NReact         | 1                       | assumption    | no flags: all its motions are held
        NReact         | 1 1 1 1 1 1 1\n2 0 0 0 0 0 0 "" | suspicious | this joint has no support
        NPropSetsCyl   | 1 2.1e11 8.08e10 7850 2.0 0.03\n8 1 1 1 1 1\n9 1 1 1 1 1 | left out | no member refers to these circular sections: 8, 9
        NJoints        | 1 0 0 -20 1 0 0 0 0\n2 0 0 -10 1 0 1 0 0\n3 0 0 0 1 0 0 0 0 | left out | JointDir of joint 2 is not used
        "#,
    ) {
        let kind = match kind {
            "compatibility" => NoteKind::Compatibility,
            "assumption" => NoteKind::Assumption,
            "suspicious" => NoteKind::Suspicious,
            _ => NoteKind::LeftOut,
        };
        of_kind(&[(table, changed)], kind).says(said);
    }
}

/// A spring whose cosine matrix is missing has the global axes if its joints are at one place, or
/// else those of its joints; both have a note.
#[test]
fn a_spring_without_its_cosine_matrix_has_a_note() {
    let axes = |z_m: &str, column: &str| {
        let joints = format!(
            "1 0 0 -20 1 0 0 0 0\n2 0 0 -10 1 0 0 0 0\n3 0 0 {z_m} 1 0 0 0 0\n4 0 0 0 1 0 0 0 0"
        );
        let text = deck(&[
            ("NJoints", &joints),
            ("NInterf", "4 1 1 1 1 1 1 1"),
            ("NMembers", "1 1 2 1 1 1 0\n2 2 3 1 1 5 7\n3 3 4 1 1 1 0"),
            (
                "NSpringPropSets",
                "1 1e8 0 0 0 0 0 2e8 0 0 0 0 3e8 0 0 0 1e9 0 0 1e9 0 1e9",
            ),
        ]);
        let input = read(&text.replace("MSpin/COSMID", column));
        let input = input.unwrap_or_else(|error| panic!("{error}"));
        let notes = input.notes.iter().map(|note| note.message.clone());
        let notes: Vec<String> = notes.filter(|note| note.contains("COSMID 7")).collect();
        match &input.description.members[1].kind {
            MemberKind::Spring(spring) => (spring.axes, notes),
            other => panic!("{other:?}"),
        }
    };
    let global = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for column in ["COSMID", "MSpin/COSMID"] {
        let (found, notes) = axes("-10", column);
        assert_eq!(found, Some(global));
        assert_eq!(
            notes,
            [
                "COSMID 7 is not used: the file has no such matrix, and the axes of the spring are the global ones"
            ]
        );
        let (found, notes) = axes("-9", column);
        assert_eq!((found, notes.len()), (None, 1));
    }
}
