//! Bad decks of BModes: each is refused at its line. BModes 3.00 takes half of them, and hangs on
//! some.

use crate::decks;
use towermodes_testing::{Says, number, rows, words};

use decks::{
    ALONE, BLADE_SECTIONS, OFFSHORE, SECTIONS, TOWER, WIRES, blade_file, mistakes, read, refused,
    tower_file, with,
};
use towermodes_files::{BmodesInput, ReadError};

/// The main file with a change is refused on a line.
#[track_caller]
fn main_refused(old: &str, new: &str, line: usize, words: &[&str]) {
    let main = with(&tower_file(ALONE), &[(old, new)]);
    refused(&main, SECTIONS, &format!("tower.bmi:{line}"), words);
}

fn main_all_refused(table: &str) {
    for [old, new, line, said] in rows(table) {
        main_refused(old, new, line.parse().expect("a line"), &words(said));
    }
}

#[track_caller]
fn sections_refused(old: &str, new: &str, line: usize, words: &[&str]) {
    let sections = with(SECTIONS, &[(old, new)]);
    let place = format!("secs.dat:{line}");
    refused(&tower_file(ALONE), &sections, &place, words);
}

fn sections_all_refused(table: &str) {
    for [old, new, line, said] in rows(table) {
        sections_refused(old, new, line.parse().expect("a line"), &words(said));
    }
}

#[track_caller]
fn support_refused(support: &str, old: &str, new: &str, line: usize, words: &[&str]) {
    let main = with(&tower_file(support), &[(old, new)]);
    refused(&main, SECTIONS, &format!("tower.bmi:{line}"), words);
}

const ROW_6: &str = "0.0 0. 0. 4000. 20000. 20000. 500.0E9 500.0E9 400.0E9 110.0E9 0. 0. 0.\n";
const ROW_7: &str = "0.5 0. 0. 4000. 20000. 20000. 500.0E9 500.0E9 400.0E9 110.0E9 0. 0. 0.\n";
const ROW_9: &str = "1.0 0. 0. 2000.  4000.  4000. 100.0E9 100.0E9  80.0E9  50.0E9 0. 0. 0.\n";

#[test]
fn the_deck_itself_is_fine() {
    for support in [ALONE, WIRES, OFFSHORE] {
        let tower = decks::tower(&tower_file(support), SECTIONS, false);
        assert!(tower.tower().is_ok(), "{support}");
    }
    assert!(read(&blade_file(), BLADE_SECTIONS, false).is_ok());
}

#[test]
fn a_missing_section_file_is_named() {
    let words = ["section file", "other.dat", "no such file"];
    main_refused("'secs.dat'", "'other.dat'", 31, &words);
}

#[test]
fn a_path_cut_at_a_slash_is_refused() {
    let words = ["sec_props_file", "quotes"];
    main_refused("'secs.dat' sec", "data/secs.dat sec", 31, &words);
    main_refused("'secs.dat' sec", "/secs.dat sec", 31, &words);
}

#[test]
fn masses_are_positive() {
    let words = ["mass_den", "positive"];
    sections_refused("2000.  4000.", "-2000. 4000.", 9, &words);
    sections_refused("2000.  4000.", "0. 4000.", 9, &words);
    main_all_refused(
        r#"
        2.0e5     tip | -1. tip | 19 | tip_mass & negative
        1.0       sec_mass | 0. sec_mass | 34 | sec_mass_mult & positive
        "#,
    );
}

#[test]
fn all_wrong_values_of_the_sections_are_said_at_once() {
    let sections = with(
        SECTIONS,
        &[(
            "4000. 20000. 20000. 500.0E9 500.0E9 400.0E9 110.0E9 0. 0. 0.\n0.5 0. 0. 4000.",
            "0. 20000. 20000. -5. 500.0E9 400.0E9 110.0E9 0. 0. 0.\n0.5 0. 0. 0.",
        )],
    );
    let (_, mistakes) = mistakes(&tower_file(ALONE), &sections, false);
    assert_eq!(mistakes.len(), 3);
}

#[test]
fn what_is_not_finite_is_refused() {
    sections_all_refused(
        r#"
        3000. | NaN | 8 | mass_den & not a finite number
        240.0E9 | Infinity | 8 | tor_stff & not a finite number
        "#,
    );
    main_all_refused(
        r#"
        2.0e5     tip | nan tip | 19 | tip_mass & not a finite number
        80.0␣␣ | 1e999␣ | 9 | radius & not a finite number
        "#,
    );
}

#[test]
fn stiffnesses_are_positive() {
    sections_all_refused(
        r#"
        300.0E9 300 | -300.0E9 300 | 8 | flp_stff & positive
        240.0E9 | 0. | 8 | tor_stff & positive
        ␣80.0E9 0 | ␣0. 0 | 8 | axial_stff & positive
        "#,
    );
    let words = ["tor_stff_mult", "positive"];
    main_refused("1.0       tor_", "0.0 tor_", 39, &words);
}

#[test]
fn a_section_without_inertia_is_refused() {
    sections_all_refused(
        r#"
        12000. 12000. | 0. 12000. | 8 | flp_iner is 0 & torsion
        12000. 12000. | -1. 12000. | 8 | flp_iner & negative
        "#,
    );
    let none = [
        ("1.0       flp_i", "0. flp_i"),
        ("1.0       lag_i", "0. lag_i"),
    ];
    let main = with(&tower_file(ALONE), &none);
    let words = ["flp_iner_mult", "both 0"];
    refused(&main, SECTIONS, "tower.bmi:36", &words);
}

/// BModes multiplies both inertias with the twist alone, so that they are about the blade's axis.
#[test]
fn a_centre_of_mass_beside_the_axis_of_a_blade_needs_inertia() {
    let far = with(BLADE_SECTIONS, &[("12.0E9 0.15", "12.0E9 0.75")]);
    let words = [
        "the edgewise inertia of the row with its factor",
        "mass_den cg_offst^2 = 112.5 kg m",
        "about the axis of the blade",
        "add mass_den cg_offst^2",
    ];
    refused(&blade_file(), &far, "secs.dat:7", &words);
}

#[test]
fn rows_are_counted() {
    let old = "4        n_secs";
    let new = "5        n_secs";
    sections_refused(old, new, 11, &["row 5 of n_secs = 5", "write n_secs = 4"]);
    let parameter = [(ROW_9, ""), ("\n**Note: text may follow.\n", "")];
    let cut = with(SECTIONS, &parameter);
    let words = ["row 4 of n_secs = 4", "file ends"];
    refused(&tower_file(ALONE), &cut, "secs.dat:8", &words);
    sections_all_refused(
        r#"
        4        n_secs | 3        n_secs | 2 | 4 rows instead of 3 & n_secs = 4
        4        n_secs | 1        n_secs | 2 | n_secs & at least 2
        4        n_secs | 1000000000000 n_secs | 2 | n_secs & at most
        "#,
    );
}

#[test]
fn a_short_row_does_not_swallow_the_next() {
    let short = ROW_7.replace(" 0. 0. 0.\n", " 0. 0.\n");
    sections_refused(ROW_7, &short, 7, &["12 numbers instead of 13", "tc_offst"]);
    let last = ROW_9.replace(" 0. 0. 0.\n", "\n");
    sections_refused(ROW_9, &last, 9, &["10 numbers instead of 13", "cg_offst"]);
}

#[test]
fn text_in_a_number_is_refused() {
    sections_all_refused(
        r#"
        3000. | 3000kg | 8 | mass_den & `3000kg` & unit
        3000. | heavy | 8 | mass_den & `heavy`
        "#,
    );
    main_all_refused(
        r#"
        2.0e5     tip | 350000kg tip | 19 | tip_mass & `350000kg` & blank
        80.0␣␣ | tall␣ | 9 | radius & a number & `tall`
        "#,
    );
}

#[test]
fn locations_rise_from_0_to_1() {
    let old = "0.5 0. 0. 3000.";
    sections_refused(old, "0.4 0. 0. 3000.", 8, &["sec_loc", "0.4 follows 0.5"]);
    let third = format!("{ROW_7}{ROW_7}");
    let sections = with(
        SECTIONS,
        &[(ROW_7, &third), ("4        n_secs", "5        n_secs")],
    );
    let words = ["sec_loc 0.5 occurs 3 times", "step"];
    refused(&tower_file(ALONE), &sections, "secs.dat:9", &words);
    let turned = with(SECTIONS, &[(ROW_6, "@"), (ROW_9, ROW_6), ("@", ROW_9)]);
    refused(
        &tower_file(ALONE),
        &turned,
        "secs.dat:6",
        &["sec_loc", "must be 0"],
    );
    let old = "1.0 0. 0. 2000.";
    sections_refused(old, "0.9 0. 0. 2000.", 9, &["sec_loc", "0.9", "must be 1"]);
    sections_refused(
        ROW_6,
        &ROW_6.replacen("0.0", "0.1", 1),
        6,
        &["sec_loc", "0.1", "must be 0"],
    );
    let old = "1.0 0. 0. 2000.";
    let new = "80. 0. 0. 2000.";
    sections_refused(old, new, 9, &["sec_loc", "metres", "divide by 80"]);
}

#[test]
fn borders_rise_from_0_to_1() {
    main_all_refused(
        r#"
        0.75  1.0 | 0.75  0.9 | 48 | last & el_loc & 0.9
        0.  0.25 | 0.1  0.25 | 48 | first & el_loc & 0.1
        0.5  0.75 | 0.75  0.5 | 48 | el_loc & 0.5 follows 0.75
        0.5  0.75 | 0.5  0.5 | 48 | el_loc & 0.5 follows 0.5 & length
        "#,
    );
}

#[test]
fn borders_are_counted() {
    main_all_refused(
        r#"
        4         nselt | 5 nselt | 50 | value 6 of the 6 & nselt is 5
        4         nselt | 3 nselt | 48 | el_loc & 5 values instead of 4
        0.75  1.0 | 0.75  1.0\n0.9 1.0 | 49 | el_loc has 7 values instead of 5
        4         nselt | 0 nselt | 46 | nselt & at least 1
        4         nselt | 1000000000000 nselt | 46 | nselt & at most
        "#,
    );
}

#[test]
fn a_root_is_held_in_one_of_three_ways() {
    main_all_refused(
        r#"
        1         hub_conn | 0 hub_conn | 13 | hub_conn is 0 & 1, 2 or 3
        1         hub_conn | 4 hub_conn | 13 | hub_conn is 4 & BModes has no 4
        "#,
    );
    for hub in ["2", "3"] {
        let changed = format!("{hub} hub_conn");
        let main = with(&tower_file(ALONE), &[("1         hub_conn", &changed)]);
        let input = decks::tower(&main, SECTIONS, false);
        let error = input.tower().expect_err("nothing holds it").to_string();
        if hub == "2" {
            error.says("there is no stiffness against");
        }
        let blade = with(&blade_file(), &[("1         hub_conn", &changed)]);
        let words = ["hub_conn is", "must be 1 for a blade"];
        refused(&blade, BLADE_SECTIONS, "tower.bmi:13", &words);
    }
}

#[test]
fn choices_are_those_of_bmodes() {
    main_all_refused(
        r#"
        1         id_mat | 2 id_mat | 30 | id_mat is 2 & must be 1
        10        modepr | 0 modepr | 14 | modepr & at least 1
        0         tow_ | 3 tow_ | 51 | tow_support is 3 & 0, 1 or 2
        0         tow_ | -1 tow_ | 51 | tow_support is -1
        2         beam | 3 beam | 6 | beam_type is 3 & blade & tower
        false     Echo | 9 Echo | 5 | Echo & true or false
        "#,
    );
}

#[test]
fn lengths_make_sense() {
    main_all_refused(
        r#"
        80.0␣␣ | -80.0␣ | 9 | radius & positive
        80.0␣␣ | 0.0␣ | 9 | radius & positive
        0.        hub_rad | 80. hub_rad | 10 | hub_rad is 80 m & below radius
        0.        hub_rad | -1. hub_rad | 10 | hub_rad & negative
        0.        romg: | -1. romg: | 7 | rot_rpm & negative
        "#,
    );
    let words = ["80 m", "below the top"];
    support_refused(OFFSHORE, "10.0      draft", "-80. draft", 52, &words);
}

#[test]
fn wires_are_within_their_ranges() {
    let refused = |old, new, line, words: &[&str]| support_refused(WIRES, old, new, line, words);
    let table = r#"
        3 4       n_w | 3 2 n_w | 54 | n_wires is 2 & three
        3 5       node | 1 5 node | 55 | node_attach is 1 & base
        3 5       node | 3 6 node | 55 | node_attach is 6 & nselt + 1
        60. 30. | 60. 91. | 57 | th_wire is 91 & 0 to 90
        60. 30. | -1. 30. | 57 | th_wire is -1
        1.e8 2.e8 | 0. 2.e8 | 56 | wire_stfness is 0 & positive
        2         n_att | -1 n_att | 53 | n_attachments & at least 0
        1.e8 2.e8 | 1.e8 | 56 | wire_stfness
        "#;
    for [old, new, line, said] in rows(table) {
        refused(old, new, number(line), &words(said));
    }
}

#[test]
fn whole_numbers_have_no_point() {
    main_all_refused(
        r#"
        4         nselt | 4.0 nselt | 46 | nselt & whole number & write 4
        10        modepr | 10.0 modepr | 14 | modepr & write 10
        "#,
    );
}

#[test]
fn decimal_commas_are_no_separators() {
    let words = ["tip_mass", "decimal point"];
    main_refused("2.0e5     tip", "3,5e5 tip", 19, &words);
    sections_refused(
        ROW_7,
        &ROW_7.replace('.', ","),
        7,
        &["18 numbers", "decimal points"],
    );
    let matrix = "4.0e4 0. 0. 0. -2.8e6 0.";
    support_refused(
        OFFSHORE,
        matrix,
        "4,0e4 0. 0. 0. -2.8e6 0.",
        75,
        &["mooring_K", "7 values instead of 6"],
    );
    let all = [(
        "4.0e4 0. 0. 0. -2.8e6 0.\n0. 4.0e4",
        "4,0 0,0 0,0 0,0 -2,8 0,0\n0. 4.0e4",
    )];
    let main = with(&tower_file(OFFSHORE), &all);
    let line = "tower.bmi:75";
    refused(&main, SECTIONS, line, &["mooring_K", "values instead of 6"]);
}

#[test]
fn a_missing_line_is_noticed_where_it_is_missing() {
    main_all_refused(
        r#"
        --- General parameters ---\n |  | 4 | heading & Echo & missing
        80.0      radius:     height\n |  | 9 | `radius` & found `hub_rad`
        --- Tip mass ---\n |  | 18 | heading & tip_mass
        -1.5      cm_loc      m\n |  | 20 | `cm_loc` & found `cm_axial`
        2.5       cm_axial    m\n |  | 21 | `cm_axial` & found `ixx_tip`
        3.0e4     iyz_tip     kg m2\n |  | 28 | iyz_tip & missing
        el_loc()\n |  | 47 | announces el_loc & numbers
        "#,
    );
    let words = ["announces hydro_K", "numbers"];
    support_refused(OFFSHORE, "hydro_K:\n", "", 67, &words);
    main_refused("--- Support ---\n", "", 50, &["heading", "tow_support"]);
}

#[test]
fn a_line_too_many_is_noticed() {
    main_all_refused(
        r#"
        A small tower\n | A small tower\nof steel\n | 5 | Echo & `---` & extra line
        80.0      radius | # height\n80.0      radius | 9 | radius & extra line
        --- Tip mass ---\n | --- Tip\nmass ---\n | 19 | tip_mass & `mass`
        "#,
    );
    let words = ["hydro_M", "`rows`"];
    support_refused(OFFSHORE, "hydro_M:\n", "hydro_M:\nrows\n", 61, &words);
}

#[test]
fn missing_rows_of_a_matrix_are_noticed() {
    let row = "0. 0. 1.2e4 0. 0. 0.\n";
    support_refused(OFFSHORE, row, "", 81, &["mooring_K", "`Distributed`"]);
    let changes = [
        ("1         hub_conn", "2 hub_conn"),
        ("4.0e4 0. 0. 0. -2.8e6", "4.0e4 0. 0. 0. 2.8e6"),
    ];
    let main = with(&tower_file(OFFSHORE), &changes);
    let words = ["row 1, column 5", "symmetric"];
    refused(&main, SECTIONS, "tower.bmi:79", &words);
}

#[test]
fn tables_over_the_height_are_checked() {
    let table = r#"
        0. 5. 10. : | 0. 10. 5. : | 84 | height & 5 m follows 10 m
        0. 5. 10. : | 0. 5. 8. 9. : | 84 | z_distr_m & 4 values instead of 3
        7000. 6000. | -7. 6000. | 85 | distr_m & negative
        "#;
    for [old, new, line, said] in rows(table) {
        support_refused(OFFSHORE, old, new, number(line), &words(said));
    }
    let huge = "1000000000000 n_secs_m_distr";
    support_refused(OFFSHORE, "3         n_secs_m_distr", huge, 83, &["at most"]);
}

/// As in BModes, what lies beyond the tower has no effect, and so have tables of zeros.
#[test]
fn tables_end_at_the_top() {
    let read = |from: &str, to: &str| {
        let main = with(&tower_file(OFFSHORE), &[(from, to)]);
        decks::tower(&main, SECTIONS, false)
    };
    // 6000 kg/m at 5 m above the base falls to 0 at 95 m; the top is 90 m above it.
    let long = read("0. 5. 10. :", "0. 5. 95. :");
    let rows = &long.description.added_mass[0];
    assert_eq!(rows.len(), 3);
    assert_eq!(rows[2].height_m, 80.0);
    assert!((rows[2].mass_kg_per_m - 6000.0 * 5.0 / 90.0).abs() < 1e-9);
    let said = |input: &towermodes_files::TowerInput, words: &str| {
        input.notes.iter().any(|note| note.message.contains(words))
    };
    assert!(said(&long, "5 m above the tower top"));
    assert!(long.tower().is_ok());
    let below = read("0. 5. 10. :", "-30. -20. -10. :");
    assert!(below.description.added_mass.is_empty());
    assert!(said(&below, "it has no effect"));
    let zeros = read("7000. 6000. 0.", "0. 0. 0.");
    assert!(zeros.description.added_mass.is_empty());
}

#[test]
fn values_left_out_are_refused() {
    main_all_refused(
        r#"
        0.5  0.75 | 0.5,,0.75 | 48 | value 4 of the 5 & no value
        0.5  0.75 | 0.5 / 0.75 | 48 | value 4 of the 5 & `/`
        0.25  0.5  0.75 | 3* | 48 | no value & `3*`
        80.0␣␣ | , 80.0␣ | 9 | radius & no value
        "#,
    );
    let words = ["flp_iner", "no value"];
    sections_refused("3000. 12000.", "3000.,, 12000.", 8, &words);
}

#[test]
fn what_the_tower_itself_cannot_be_is_said_at_its_line() {
    let main = with(&tower_file(ALONE), &[("2.0e5     tip_mass", "0. tip_mass")]);
    let ReadError::Mistakes {
        source_file,
        mistakes,
    } = decks::tower(&main, SECTIONS, false)
        .tower()
        .expect_err("inertia without mass")
    else {
        panic!("mistakes")
    };
    assert_eq!(source_file.name, "tower.bmi");
    assert_eq!(mistakes[0].line_and_column(&source_file.text).0, 19);
}

#[test]
fn products_that_overflow_are_refused() {
    let changes = [("1.0       tor_stff_mult", "1e300 tor_stff_mult")];
    let main = with(&tower_file(ALONE), &changes);
    let words = ["too large or too small"];
    refused(&main, SECTIONS, "secs.dat:6", &words);
}

#[test]
fn no_beginning_of_a_deck_is_a_deck() {
    let whole = tower_file(OFFSHORE);
    let end = whole.find("2*5.0e7").expect("the last values");
    for length in 0..end {
        assert!(read(&whole[..length], SECTIONS, false).is_err(), "{length}");
    }
    let end = SECTIONS.find("  50.0E9 0. 0. 0.").expect("the last row");
    for length in 0..end {
        let holds = read(&tower_file(ALONE), &SECTIONS[..length], false).is_err();
        assert!(holds, "{length}");
    }
    assert!(matches!(
        read(TOWER, SECTIONS, false),
        Err(ReadError::Mistakes { .. })
    ));
    assert!(matches!(
        read(&blade_file(), BLADE_SECTIONS, true),
        Ok(BmodesInput::Blade(_))
    ));
}

#[test]
fn pitch_that_would_turn_a_towers_axes_is_refused_with_quirks_only() {
    let changes = [
        ("0.        bl_thp", "5. bl_thp"),
        ("1.0       edge_stff", "2.0 edge_stff"),
    ];
    let main = with(&tower_file(ALONE), &changes);
    let (source, mistakes) = mistakes(&main, SECTIONS, true);
    assert_eq!(mistakes[0].line_and_column(&source.text).0, 12);
    let input = decks::tower(&main, SECTIONS, false);
    assert!(
        input
            .notes
            .iter()
            .any(|note| note.message.contains("bl_thp is 5"))
    );
}
