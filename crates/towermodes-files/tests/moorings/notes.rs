//! What is assumed and left out is noted with its line.

use towermodes_files::{MooringSite, Note};
use towermodes_testing::rows;

use super::texts::{MAP, MOORDYN_2, SITE, changed, map, moordyn};

fn lines(notes: &[Note]) -> String {
    let notes = notes
        .iter()
        .map(|note| note.to_string().replace("Mooring.dat:", "") + "\n");
    notes.collect()
}

#[test]
fn a_plain_file_has_notes_on_columns_and_options() {
    let input = moordyn(MOORDYN_2, &SITE).expect("a mooring");
    let expected = "\
3: not used by lines at rest: columns of LINE TYPES BA/-zeta, EI, Cd, Ca, CdAx, CaAx; columns of POINTS CdA, CA; columns of LINES NumSegs, Outputs; options dtM, kbot (damping, drag, added mass, segments, and settings of the simulation or iteration have no effect)
";
    assert_eq!(lines(&input.notes), expected);
    // Other programs write remarks into the names of columns.
    let remarks = changed(MOORDYN_2, "CaAx", "CaAx Cl (optional)");
    let input = moordyn(&remarks, &SITE).expect("a mooring");
    let first = lines(&input.notes);
    assert!(
        first.contains("CdAx, CaAx, Cl; columns of POINTS"),
        "{first}"
    );
    let input = map(MAP, &SITE).expect("a mooring");
    let expected = "\
1: not used by lines at rest: columns of LINE TYPES CIntDamp, Ca, Cdn, Cdt (damping, drag, added mass, segments, and settings of the simulation or iteration have no effect)
";
    assert_eq!(lines(&input.notes), expected);
}

#[test]
fn what_is_assumed_has_a_note() {
    let cases = r"
        320.0    WtrDpth | 0 WaterKin | 10: the depth of the water is not given: the seabed is at the fixed points, at z = -320 m
        1025.0   rhoW | 0 mu_kT | the density of the water (kg/m3) is not given: 1025 is assumed
        9.80665  g | 0 mu_kT | the acceleration of gravity (m/s2) is not given: 9.80665 is assumed
        0.001    dtM | 0.2 mu_kT | 23: mu_kT (0.2) is not used
        0.001    dtM | waves.txt WaterKin | 23: WaterKin (`waves.txt`) is not used
        0.001    dtM | 2e5 FricDamp | options FricDamp, kbot (
        0.001    dtM | 0 ICgenDynamic | options ICgenDynamic, kbot (
        0.001    dtM | -1 fileIC | options fileIC, kbot (
        0.001    dtM | 0.2 FrictionCoefficient | 23: FrictionCoefficient (0.2) is not used
        0.001    dtM | 1 magic | 23: the option `magic` is not known
        -0.8     0.0 | -0.8     1e4 | 6: the bending stiffness EI of the line is not used
        ------------------------ OUTPUTS | --- FAILURE ---\nID\n(-)\n1 2\n--- OUTPUTS | 28: the section FAILURE is not used
        ------------------------ OUTPUTS | --- SYROPE ---\nID\n(-)\n1 2\n--- OUTPUTS | 28: the section `SYROPE` is not known
        384.243E6 | 384.243E6|500E6 | 6: EA of the line is `384.243E6|500E6`: the first value is used";
    for [from, to, note] in rows(cases) {
        let input = moordyn(&changed(MOORDYN_2, from, to), &MooringSite::default());
        let notes = lines(&input.expect("a mooring").notes);
        let note = note.to_owned();
        assert!(notes.contains(&note), "{notes}\n{note}");
    }
}

/// The density by another name, and other names of the columns of lines.
#[test]
fn other_names_say_the_same() {
    let plain = moordyn(MOORDYN_2, &SITE).expect("a mooring");
    let fresh = changed(MOORDYN_2, "1025.0   rhoW", "1000.0   WtrDnsty");
    let fresh = moordyn(&fresh, &MooringSite::default()).expect("a mooring");
    assert_eq!(fresh.description.water_density_kg_per_m3, 1000.0);
    assert_eq!(lines(&fresh.notes), lines(&plain.notes));
    let named = changed(MOORDYN_2, "AttachA   AttachB", "AttachAnch NodeFair");
    let named = moordyn(&named, &SITE).expect("a mooring");
    assert_eq!(named.description, plain.description);
    assert_eq!(lines(&named.notes), lines(&plain.notes));
}

/// A line whose middle floats is held up on purpose; where all lines float the mass is wrong.
#[test]
fn sections_that_float_have_a_note_and_lines_that_float_a_warning() {
    let warnings = |text: &str| {
        let input = moordyn(text, &SITE).expect("a mooring");
        let mooring = input.mooring().expect("a mooring");
        let state = input.at_rest(&mooring).expect("an equilibrium");
        (
            lines(&input.notes),
            lines(&input.warnings(&mooring, &state)),
        )
    };
    let float =
        "float    0.60      77.7066   384.243E6  -0.8     0.0   1.6     1.0    0.1    0.0\n";
    let both = changed(
        MOORDYN_2,
        "---------------------- POINTS",
        &format!("{float}---------------------- POINTS"),
    );
    let (notes, found) = warnings(&both);
    let note = "7: these line types are lighter than the water that they displace, so they lift the lines of the other types: `float`";
    assert!(notes.contains(note), "{notes}");
    assert!(!found.contains("floats"), "{found}");
    let (notes, found) = warnings(&changed(MOORDYN_2, "main     0.09 ", "main     0.60 "));
    assert!(!notes.contains("lighter"), "{notes}");
    assert!(found.contains("so that it floats"), "{found}");
}

#[test]
fn a_rod_without_segments_has_a_note() {
    let rod = "\
--- ROD TYPES ---
TypeName Diam Mass/m
(name) (m) (kg/m)
can 1.2 900
--- RODS ---
ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs RodOutputs
(#) (name) (#/key) (m) (m) (m) (m) (m) (m) (-) (-)
1 can Vessel 20 -6 -5 27 -9 -17 0 -
--- POINTS";
    let text = changed(MOORDYN_2, "---------------------- POINTS", rod);
    let notes = lines(&moordyn(&text, &SITE).expect("a mooring").notes);
    assert!(
        notes
            .contains("14: NumSegs of the rod is 0, with which MoorDyn neglects length and weight"),
        "{notes}"
    );
}

#[test]
fn warnings_have_the_line_of_their_part() {
    let text = changed(MOORDYN_2, "320.0    WtrDpth", "330.0    WtrDpth");
    let text = changed(
        &text,
        "853.87     0.0    -320.0",
        "853.87     0.0    -321.0",
    );
    let input = moordyn(&text, &SITE).expect("a mooring");
    let mooring = input.mooring().expect("a mooring");
    let state = input.at_rest(&mooring).expect("an equilibrium");
    let warnings = lines(&input.warnings(&mooring, &state));
    assert!(
        warnings.starts_with("10: the anchor point 1 is at z = -321 m"),
        "{warnings}"
    );
    assert_eq!(warnings.lines().count(), 3, "{warnings}");
}
