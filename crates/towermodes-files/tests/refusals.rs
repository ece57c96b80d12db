//! Every mistake is answered with its line and column, what is wrong and what would be right.

use crate::refused;

use refused::refused_text;
use towermodes_files::tower_from_toml;
use towermodes_testing::rows;

/// A file in which each test makes one mistake.
const GOOD: &str = r#"name = "good"
[material]
density = 8500.0
youngs_modulus = 2.1e11
shear_modulus = 8.08e10
[materials.concrete]
density = 2500.0
youngs_modulus = 3.6e10
poissons_ratio = 0.2
[tower]
outfitting_factor = 1.05
shear = true
stations = [
  [ 0.0, 6.00, 0.300, "concrete"],
  [40.0, 5.50, 0.300, "concrete"],
  [40.0, 5.00, 0.027],
  [87.6, 3.87, 0.019],
]
[rna]
mass = 350e3
center = [0.0, 0.0, 2.0]
inertia = { xx = 4.0e7, yy = 2.0e7, zz = 2.5e7 }
[[point_mass]]
height = 40.0
mass = 5000.0
[foundation]
type = "clamped"
"#;

/// Replaces `from` by `to` and expects the first mistake at line:column with these words in its
/// message and hint.
#[track_caller]
fn refused(from: &str, to: &str, place: &str, message: &str, hint: &str) {
    assert!(GOOD.contains(from), "the test is wrong: {from}");
    refused_text(&GOOD.replacen(from, to, 1), place, message, hint);
}

/// Mistakes one after the other: what is replaced, by what, place, message, hint.
fn all_refused(table: &str) {
    for [from, to, place, message, hint] in rows(table) {
        refused(from, to, place, message, hint);
    }
}

#[test]
fn the_good_file_is_good() {
    let tower = tower_from_toml(GOOD).expect("a tower");
    assert_eq!(tower.name(), "good");
    assert_eq!(tower.pieces().len(), 2);
    // The point mass and the machine.
    assert_eq!(tower.attachments().len(), 2);
    assert_eq!(tower.rna().inertia_kg_m2.xx, 4.0e7);
}

#[test]
fn nan_infinite_zero_and_negative_properties() {
    all_refused(
        r#"
        8500.0 | nan | 3:11 | density is NaN
        8500.0 | inf | 3:11 | density is inf
        8500.0 | 1e999 | 3:11 | density is inf
        8500.0 | 0 | 3:11 | density is 0 kg/m3; it must be positive
        2.1e11 | -2.1e11 | 4:18 | must be positive
        5.00, 0.027 | nan, 0.027 | 16:10 | outer diameter is NaN
        5.00, 0.027 | 5.00, 0.0 | 16:16 | wall thickness is 0 m
        5.00, 0.027 | -5.00, 0.027 | 16:10 | outer diameter is -5 m
        mass = 350e3 | mass = -1 | 20:8 | must not be negative
        xx = 4.0e7 | xx = -4.0e7 | 22:11 | moments of inertia are -4e7, 2e7 and 2.5e7 kg m2
        mass = 5000.0 | mass = -5 | 25:8 | must not be negative
        = 1.05 | = 0 | 11:21 | outfitting factor is 0
        shear = true | shear = 1.5 | 12:9 | it must be greater than 0 and at most 1 | 0.53
        "#,
    );
}

#[test]
fn a_wall_thicker_than_the_radius() {
    let message = "less than twice the wall thickness 19 m at z = 87.6 m";
    refused("3.87, 0.019", "3.87, 19.0", "17:16", message, "0.027");
}

#[test]
fn heights_and_their_order() {
    all_refused(
        r#"
        [87.6, | [39.0, | 17:4 | height 39 m is below the previous station at 40 m | from the base
        [87.6, | [40.0, | 17:4 | three stations at height 40 m
        "#,
    );
    let flat = GOOD.replace("[87.6,", "[0.0,").replace("[40.0,", "[0.0,");
    refused_text(&flat, "13:12", "no height", "");
    let one = "[material]\ndensity=1\nyoungs_modulus=1\nshear_modulus=0.4\n[tower]\nstations = [[0.0, 1.0, 0.1]]\n";
    refused_text(one, "6:12", "at least two stations, but has 1", "");
    let words = "at least two stations, but has 0";
    refused_text(&one.replace("[[0.0, 1.0, 0.1]]", "[]"), "6:12", words, "");
}

#[test]
fn short_and_long_rows() {
    all_refused(
        r#"
        [87.6, 3.87, 0.019] | [87.6, 3.87] | 17:3 | station 4 has 2 values | [height, outer diameter
        [87.6, 3.87, 0.019] | [87.6, 3.87, 0.019, "concrete", 1] | 17:3 | station 4 has 5 values
        [87.6, 3.87, 0.019] | 87.6 | 17:3 | station 4 must be a list in brackets, found a number
        "#,
    );
}

#[test]
fn unknown_keys_with_the_nearest_known_one() {
    all_refused(
        r#"
        density = 8500 | densty = 8500 | 3:1 | `densty` is not a key of [material] | did you mean `density`?
        youngs_modulus | Youngs_Modulus | 4:1 | is not a key | did you mean `youngs_modulus`?
        [rna] | [rma] | 19:2 | `rma` is not a key of the file | did you mean `rna`?
        yy = 2 | iyy = 2 | 22:25 | `iyy` is not a key of inertia | did you mean `yy`?
        height = 40.0 | z = 40.0 | 24:1 | `z` is not a key of [[point_mass]] | did you mean `height`?
        height = 40.0 | jelly = 40.0 | 23:1 | [[point_mass]] has no `height` | height in m
        "#,
    );
}

#[test]
fn keys_by_the_names_of_other_programs() {
    let table = r#"
        center | cg | 21:1 | did you mean `center`?
        outfitting_factor | outfitting | 11:1 | did you mean `outfitting_factor`?
        density | rho | 3:1 | did you mean `density`?
        youngs_modulus | E | 4:1 | did you mean `youngs_modulus`?
        shear_modulus | G | 5:1 | did you mean `shear_modulus`?
        poissons_ratio | nu | 9:1 | did you mean `poissons_ratio`?
        mass = | mass_kg = | 20:1 | did you mean `mass`?
        xx | Ixx | 22:13 | did you mean `xx`?
        [rna] | [nacelle] | 19:2 | did you mean `rna`?
        stations | cans | 13:1 | did you mean `stations`?
        "clamped" | "fixed" | 27:8 | did you mean `clamped`?
        "#;
    for [key, name, place, hint] in rows(table) {
        refused(key, name, place, "", hint);
    }
}

#[test]
fn mistakes_are_in_the_order_of_the_lines() {
    let text = GOOD
        .replacen("mass = 5000.0", "z = 1", 1)
        .replacen("center", "cg", 1)
        .replacen("87.6, 3.87", "87.6, \"x\"", 1)
        .replacen("density", "rho", 1)
        .replacen("name = \"good\"", "title = \"good\"", 1);
    let mistakes = tower_from_toml(&text).expect_err("no tower");
    let lines: Vec<usize> = mistakes
        .iter()
        .map(|m| m.line_and_column(&text).0)
        .collect();
    assert_eq!(lines, [1, 3, 17, 21, 23, 25], "{mistakes:?}");
}

#[test]
fn a_misspelled_key_is_said_once() {
    let text = GOOD.replacen("density", "densty", 1);
    assert_eq!(tower_from_toml(&text).expect_err("no tower").len(), 1);
}

#[test]
fn a_misspelled_modulus_is_said_once() {
    for (right, wrong) in [
        ("shear_modulus", "shear_modulu"),
        ("poissons_ratio", "poisson_ratio"),
    ] {
        let text = GOOD.replacen(right, wrong, 1);
        let mistakes = tower_from_toml(&text).expect_err("no tower");
        assert_eq!(mistakes.len(), 1, "{mistakes:?}");
        assert_eq!(mistakes[0].hint, Some(format!("did you mean `{right}`?")));
    }
}

#[test]
fn several_mistakes_are_said_together() {
    let text = GOOD
        .replacen("8500.0", "nan", 1)
        .replacen("3.87", "\"wide\"", 1)
        .replacen("350e3", "true", 1);
    assert_eq!(tower_from_toml(&text).expect_err("no tower").len(), 3);
}

#[test]
fn missing_keys() {
    all_refused(
        r#"
        density = 8500.0\n |  | 2:1 | [material] has no `density` | steel
        shear_modulus = 8.08e10\n |  | 2:1 | no `shear_modulus` or `poissons_ratio` | 0.3
        mass = 350e3\n |  | 19:1 | [rna] has no `mass` | leave [rna] out
        height = 40.0\n |  | 23:1 | [[point_mass]] has no `height`
        type = "clamped"\n |  | 26:1 | [foundation] has no `type` | clamped
        "#,
    );
    let words = "the file has no `material`";
    refused_text("name = \"x\"\n", "2:1", words, "[material]");
}

#[test]
fn shear_modulus_and_poissons_ratio() {
    let both = |ratio: &str| format!("8.08e10\npoissons_ratio = {ratio}");
    let message = "disagree: E/(2(1+nu)) is 8.7500e10 Pa";
    refused("8.08e10", &both("0.2"), "6:18", message, "give only one");
    assert!(tower_from_toml(&GOOD.replacen("8.08e10", &both("0.3"), 1)).is_ok());
    all_refused(
        r#"
        poissons_ratio = 0.2 | poissons_ratio = 0.5 | 9:18 | 0.5, but must be between -1 and 0.5 | concrete 0.2
        poissons_ratio = 0.2 | poissons_ratio = -1.0 | 9:18 | -1, but must be between -1 and 0.5
        8.08e10 | 8.08e4 | 5:17 | outside the range -1 to 0.5 | Pa
        "#,
    );
}

#[test]
fn texts_where_numbers_belong_and_the_other_way_round() {
    all_refused(
        r#"
        8500.0 | "8500" | 3:11 | density must be a number, found a text | without quotation marks
        350e3 | "310 t" | 20:8 | mass must be a number, found a text | write 310000 (kg), without a unit
        5.00, 0.027 | 5.00, "45 mm" | 16:16 | wall thickness must be a number, found a text | write 0.045 (m), without a unit
        8500.0 | "heavy" | 3:11 | density must be a number, found a text
        8500.0 | [8500.0] | 3:11 | found a list
        8500.0 | 1979-05-27 | 3:11 | found a date
        "good" | 5 | 1:8 | name must be a text in quotation marks, found a number
        shear = true | shear = "yes" | 12:9 | true, false or a shear coefficient | write true
        shear = true | shear = "none" | 12:9 | true, false or a shear coefficient
        inertia = { | inertia = [4.2e7] #{ | 22:11 | inertia must be a table, found a list | { xx = ..., yy = ..., zz = ... }
        center = [0.0, 0.0, 2.0] | center = 2.0 | 21:10 | center must be a list
        center = [0.0, 0.0, 2.0] | center = [2.0] | 21:10 | center has 1 value instead of 3
        [[point_mass]] | [point_mass] | 23:1 | point_mass must be a list of tables | [[point_mass]]
        "#,
    );
}

#[test]
fn materials_of_stations() {
    all_refused(
        r#"
        0.300, "concrete" | 0.300, "concret" | 14:23 | no material `concret` | did you mean `concrete`?
        0.300, "concrete" | 0.300, 5 | 14:23 | must be a text
        "#,
    );
    let unnamed = GOOD.replacen("[material]", "[materials.steel]", 1);
    let words = "the material of station 3";
    refused_text(&unnamed, "16:3", words, "\"concrete\" or \"steel\"");
}

#[test]
fn machines_and_masses_that_cannot_be() {
    all_refused(
        r#"
        zz = 2.5e7 | zz = 2.5e7, xy = 6e7 | 22:11 | moments of inertia are -3.08276e7, 2.5e7 and 9.08276e7 kg m2; they must not be negative | minus the integral of x y dm
        mass = 5000.0 | mass = 5000.0\ninertia = { xx = 1.0, zz = -2.0 } | 26:11 | moments of inertia are -2, 0 and 1 kg m2
        mass = 5000.0 | mass = 5000.0\ninertia = 1.0 | 26:11 | inertia must be a table, found a number
        height = 40.0 | height = 90.0 | 24:10 | not on the tower, which reaches from 0 m to 87.6 m | datum
        mass = 350e3 | mass = 0 | 20:8 | inertia but no mass
        "#,
    );
}

#[test]
fn a_rotor_has_blades_and_speeds() {
    let with = |lines: &str, place: &str, message: &str, hint: &str| {
        let rotor = format!("[rotor]\n{lines}");
        let words = "[foundation]\ntype = \"clamped\"";
        refused(words, &rotor, place, message, hint);
    };
    with("rpm = [6.9, 12.1]", "26:1", "`blades`", "for example 3");
    with("blades = 3", "26:1", "`rpm`", "rpm = [6.9, 12.1]");
    with("blade = 3\nrpm = 12.1", "27:1", "`blade`", "`blades`");
    with("blades = 3\nrmp = 12.1", "28:1", "`rmp`", "`rpm`");
    let blades = |count: &str, message: &str, hint: &str| {
        let lines = format!("blades = {count}\nrpm = 12.1");
        with(&lines, "27:10", message, hint);
    };
    let words = "0 blades; the number must be from 1 to 10";
    blades("0", words, "omit [rotor]");
    blades("11", "11 blades; the number must be from 1 to 10", "");
    blades("2.5", "blades is 2.5, but must be a whole number", "");
    blades("-3", "blades is -3", "");
    blades("1e300", "blades is 1e300", "");
    blades("\"three\"", "blades", "");
    let rpm = |value: &str, place: &str, message: &str, hint: &str| {
        with(&format!("blades = 3\nrpm = {value}"), place, message, hint);
    };
    let table = r#"
        [12.1, 6.9] | 28:7 | 12.1 rpm, is above the highest, 6.9 rpm | [lowest, highest]
        [6.9] | 28:7 | rpm has 1 value instead of 2 | one number
        [6.9, 9.0, 12.1] | 28:7 | rpm has 3 values instead of 2 |
        [] | 28:7 | rpm has 0 values instead of 2 |
        ["a", 12.1] | 28:8 | the lowest rpm |
        { low = 1 } | 28:7 | rpm | [6.9, 12.1]
        0 | 28:7 | the rotor's highest speed |
        [-1, 12.1] | 28:7 | the rotor's lowest speed |
        nan | 28:7 | rpm |
        [6.9, inf] | 28:13 | the highest rpm is inf |
        1.1e5 | 28:7 | 110000 rpm; it must be at most 100000 rpm | revolutions per minute
        "#;
    for [value, place, message, hint] in rows(table) {
        rpm(value, place, message, hint);
    }
}

#[test]
fn files_that_are_no_tower_at_all() {
    refused_text("", "1:1", "the file is empty", "[material]");
    refused_text("  \n\t\n", "1:1", "the file is empty", "");
    refused_text("# nothing\n", "2:1", "the file has no `material`", "");
    let text = GOOD.split("5.50").next().expect("before");
    refused_text(text, "15:9", "invalid TOML", "complete");
    let text = "------- ELASTODYN TOWER INPUT FILE";
    refused_text(text, "1:9", "invalid TOML", "");
    assert!(tower_from_toml("\u{0}\u{1}\u{2}").is_err());
    assert!(tower_from_toml(&"[".repeat(100_000)).is_err());
    assert!(tower_from_toml(&format!("x = {}", "[".repeat(100_000))).is_err());
}

#[test]
fn line_ends_and_marks_of_other_systems_are_read() {
    assert!(tower_from_toml(&GOOD.replace('\n', "\r\n")).is_ok());
    assert!(tower_from_toml(&format!("\u{feff}{GOOD}")).is_ok());
}

/// A table of properties in which each test makes one mistake.
const TABLE: &str = r#"name = "table"
[tower]
outfitting_factor = 1.05
[tower.properties]
z_m = [0.0, 40.0, 40.0, 90.0]
mass_kg_per_m = [5000, 4800.0, 4200.0, 3000.0]
ei_fore_aft_n_m2 = [6.0e11, 5.0e11, 4.5e11, 1.2e11]
ei_side_side_n_m2 = [7.0e11, 5.5e11, 4.5e11, 1.1e11]
gj_n_m2 = [5.0e11, 4.0e11, 3.6e11, 0.9e11]
ea_n = [1.4e11, 1.3e11, 1.1e11, 0.6e11]
polar_inertia_kg_m = [5.0e4, 4.0e4, 3.6e4, 0.9e4]
shear_stiffness_fore_aft_n = [2.6e10, 2.4e10, 2.1e10, 1.2e10]
"#;

#[track_caller]
fn refused_table(from: &str, to: &str, place: &str, message: &str, hint: &str) {
    assert!(TABLE.contains(from), "the test is wrong: {from}");
    refused_text(&TABLE.replacen(from, to, 1), place, message, hint);
}

fn all_refused_table(table: &str) {
    for [from, to, place, message, hint] in rows(table) {
        refused_table(from, to, place, message, hint);
    }
}

#[test]
fn the_good_table_is_good() {
    let tower = tower_from_toml(TABLE).expect("a tower");
    assert_eq!(tower.pieces().len(), 2);
    assert!(tower.shears() && !tower.planes_are_equal());
    let row = tower.properties()[0].properties;
    assert_eq!(row.bending_n_m2.side_side, 7.0e11);
    // One shear column is both planes'; the polar inertia is shared out as EI, and the masses have
    // the outfitting in them.
    assert_eq!(row.shear_n.map(|shear| shear.side_side), Some(2.6e10));
    assert!((row.rotary_inertia_kg_m.fore_aft - 5.0e4 * 6.0 / 13.0).abs() < 1e-8);
    let section = tower.piece_at(0.0).section_at(0.0);
    assert!((section.masses.mass_kg_per_m - 5250.0).abs() < 1e-9);
    // Without a column of its own the other plane is the same.
    let one = TABLE.replace("ei_side_side_n_m2 = [7.0e11, 5.5e11, 4.5e11, 1.1e11]\n", "");
    assert!(tower_from_toml(&one).expect("a tower").planes_are_equal());
}

#[test]
fn tables_of_properties_with_a_mistake() {
    all_refused_table(
        r#"
        gj_n_m2 | gj_nm2 | 9:1 | `gj_nm2` is not a key | did you mean `gj_n_m2`?
        ea_n = [1.4e11, 1.3e11, 1.1e11, 0.6e11]\n |  | 4:1 | has no `ea_n` | axial stiffness
        z_m = [0.0, 40.0, 40.0, 90.0]\n |  | 4:1 | has no `z_m` | heights
        [1.4e11, 1.3e11, 1.1e11, 0.6e11] | [1.4e11, 1.3e11] | 10:8 | ea_n has 2 values instead of 4, the number of values in z_m | one value for each height
        [5000,␣ | ["x",␣ | 6:18 | mass_kg_per_m must be a number
        [5000,␣ | [nan,␣ | 6:18 | mass_kg_per_m is NaN
        5.0e11, 4.5e11, 1.2e11 | 0.0, 4.5e11, 1.2e11 | 7:29 | EI fore-aft is 0 N m2
        5.5e11 | -5.5e11 | 8:30 | EI side-side
        4.0e4 | -1 | 11:30 | polar inertia is -1 kg m
        2.4e10 | 0 | 12:39 | shear stiffness
        90.0] | 30.0] | 5:25 | height 30 m is below | base to the top
        [0.0, 40.0, 40.0, 90.0] | [40.0, 40.0, 40.0, 90.0] | 5:20 | three stations
        z_m = [0.0, 40.0, 40.0, 90.0] | z_m = 5 | 5:7 | must be a list
        shear_stiffness_fore_aft_n | shear_stiffness_side_side_n | 4:1 | has no `shear_stiffness_fore_aft_n` | other plane
        "#,
    );
}

#[test]
fn what_belongs_to_tubes_beside_a_table() {
    all_refused_table(
        r#"
        [tower]\n | [tower]\nshear = true\n | 3:9 | `shear` has no effect | shear_stiffness
        [tower]\n | [tower]\nstations = [[0.0, 6.0, 0.03], [90.0, 4.0, 0.02]]\n | 3:12 | `stations` has no effect | one of the two
        name = "table"\n | [material]\ndensity = 1.0\n | 1:1 | `material` has no effect | remove it
        "#,
    );
}
