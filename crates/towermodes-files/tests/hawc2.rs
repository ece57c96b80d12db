//! Structural files of HAWC2: sections, choices, notes, and every mistake with its place.

use towermodes_testing::{Says, line_and_column, rows, with};

use std::path::{Path, PathBuf};

use towermodes::{Family, Method, Options, TowerDescription, solve};
use towermodes_files::{ReadError, ReadOptions, Source, TowerInput, read_hawc2};

/// Two subsets of a tower that is not round, with a step, so that no two columns can be mistaken
/// for each other.
const GOOD: &str = "\
1 number of sets
-----
#1 Test tower
r m x_cg y_cg ri_x ri_y x_sh y_sh E G I_x I_y K k_x k_y A pitch x_e y_e
$1 4 Flexible
0.0  5000 0 0 2.0 1.5 0 0 2.0e11 8.0e10 4.0 3.0 7.0 0.5 0.6 1.0 0 0 0
30.0 4500 0 0 2.0 1.5 0 0 2.0e11 8.0e10 3.5 2.5 6.0 0.5 0.6 0.9 0 0 0
30.0 4000 0 0 2.0 1.5 0 0 2.0e11 8.0e10 3.0 2.0 5.0 0.5 0.6 0.8 0 0 0
80.0 3000 0 0 2.0 1.5 0 0 2.0e11 8.0e10 2.0 1.0 3.0 0.5 0.6 0.6 0 0 0
r m x_cg
$2 2 Stiff
0.0  5000 0 0 2.0 2.0 0 0 2.0e17 8.0e17 4.0 4.0 8.0 0.5 0.5 1.0 0 0 0
80.0 3000 0 0 2.0 2.0 0 0 2.0e17 8.0e17 2.0 2.0 4.0 0.5 0.5 0.6 0 0 0
";

fn source(text: &str) -> Source {
    Source {
        name: "tower_st.dat".to_owned(),
        text: text.to_owned(),
    }
}

#[track_caller]
fn read(text: &str, options: &ReadOptions) -> TowerInput {
    read_hawc2(source(text), options).expect("a tower")
}

/// Replaces `from` by `to` and expects the first mistake at line:column with these words in its
/// message and hint.
#[track_caller]
fn refused(from: &str, to: &str, place: (usize, usize), words: &str, hint: &str) {
    assert!(GOOD.contains(from), "the test is wrong: {from}");
    refused_text(&GOOD.replacen(from, to, 1), place, words, hint);
}

/// Mistakes one after the other: what is replaced, by what, place, message, hint.
fn all_refused(table: &str) {
    for [from, to, place, message, hint] in rows(table) {
        refused(from, to, line_and_column(place), message, hint);
    }
}

#[track_caller]
fn refused_text(text: &str, place: (usize, usize), words: &str, hint: &str) {
    let result = read_hawc2(source(text), &ReadOptions::default());
    let Err(ReadError::Mistakes { mistakes, .. }) = result else {
        panic!("not refused: {words}");
    };
    let first = &mistakes[0];
    first.message().says(words);
    first.says(hint);
    assert_eq!(first.line_and_column(text), place, "{first}");
}

fn has_note(input: &TowerInput, words: &str) -> bool {
    let mut notes = input.notes.iter();
    notes.any(|note| note.to_string().contains(words))
}

#[test]
fn columns_become_the_sections_of_both_planes() {
    let options = with!(ReadOptions, tower_base_m = Some(15.0));
    let input = read(GOOD, &options);
    let TowerDescription {
        name, properties, ..
    } = &input.description;
    assert_eq!(name, "Test tower");
    let heights_m: Vec<f64> = properties.iter().map(|row| row.height_m).collect();
    assert_eq!(heights_m, [15.0, 45.0, 45.0, 95.0]);
    let base = &properties[0].properties;
    assert_eq!(base.mass_kg_per_m, 5000.0);
    // E I_x resists fore-aft bending, k_y G A fore-aft shear, m ri_x² fore-aft rotation.
    assert_eq!(base.bending_n_m2.fore_aft, 8.0e11);
    assert!((base.bending_n_m2.side_side / 6.0e11 - 1.0).abs() < 1e-15);
    assert_eq!(base.torsion_n_m2, 5.6e11);
    assert_eq!(base.axial_n, 2.0e11);
    let shear = base.shear_n.expect("shear");
    assert!((shear.fore_aft / 4.8e10 - 1.0).abs() < 1e-15);
    assert!((shear.side_side / 4.0e10 - 1.0).abs() < 1e-15);
    assert_eq!(base.rotary_inertia_kg_m.fore_aft, 20_000.0);
    assert_eq!(base.rotary_inertia_kg_m.side_side, 11_250.0);
    assert_eq!(base.polar_inertia_kg_m, 31_250.0);
    // 30 m × 4750 kg/m + 50 m × 3500 kg/m.
    let tower = input.tower().expect("valid");
    assert!((tower.mass_kg() - 317_500.0).abs() < 1e-6);
    assert_eq!(tower.pieces().len(), 2);
}

#[test]
fn what_was_chosen_and_left_out_is_said() {
    let input = read(GOOD, &ReadOptions::default());
    let chosen = "tower_st.dat:5: set 1, subset 1 (Flexible; E 2e11 Pa, G 8e10 Pa) is read; \
                  not read: set 1, subset 2 (Stiff; E 2e17 Pa, G 8e17 Pa)";
    assert!(has_note(&input, chosen), "{:?}", input.notes);
    assert!(has_note(&input, "deform in shear"));
    assert!(has_note(&input, "from 0 m, where it is clamped, to 80 m"));
    assert!(!has_note(&input, "intended to be rigid"));
    assert_eq!(input.notes.len(), 3);

    let stiff = ReadOptions {
        hawc2_subset: Some((1, 2)),
        tower_height_m: Some(100.0),
        ..ReadOptions::default()
    };
    let input = read(GOOD, &stiff);
    assert_eq!(input.description.properties.len(), 2);
    assert!(has_note(&input, "set 1, subset 2 (Stiff"));
    assert!(has_note(&input, "intended to be rigid"));
    assert!(has_note(&input, "needs a base at 20 m"));

    let cut = GOOD.replacen("$2 2", "$2 3", 1);
    let error = read_hawc2(source(&cut), &stiff).expect_err("cut off");
    let words =
        "set 1, subset 2 has 2 rows instead of 3 (the file ends after them: is it complete?)";
    assert_eq!(error.to_string(), format!("tower_st.dat:11:1: {words}"));
}

#[test]
fn a_subset_that_is_not_there_is_answered_with_those_that_are() {
    let options = with!(ReadOptions, hawc2_subset = Some((2, 1)));
    let error = read_hawc2(source(GOOD), &options).expect_err("no such set");
    let words = "tower_st.dat:3:1: set 2, subset 1 is missing (the file has set 1, subset 1; set 1, subset 2)";
    assert_eq!(error.to_string(), words);
}

#[test]
fn zero_shear_factors_and_radii_are_a_beam_without() {
    let text = GOOD.replace("0.5 0.6", "0 0").replace("2.0 1.5", "0 0");
    let input = read(&text, &ReadOptions::default());
    let section = &input.description.properties[0].properties;
    assert_eq!(section.shear_n, None);
    assert_eq!(section.rotary_inertia_kg_m.fore_aft, 0.0);
    assert_eq!(section.torsion_n_m2, f64::INFINITY);
    assert!(has_note(&input, "k_x and k_y are 0"));
    assert!(has_note(&input, "rigid in torsion"));
}

#[test]
fn offsets_turns_and_directions_are_noted() {
    // The radius of a tube with I/A = 4 is √8 = 2.83 m: 0.05 m are 1.77 % of it.
    let text = GOOD.replacen("5000 0 0 ", "5000 0.05 0 ", 1);
    let input = read(&text, &ReadOptions::default());
    assert!(has_note(&input, "tower_st.dat:6: "));
    assert!(has_note(
        &input,
        "x_cg = 0.05 m, 1.77 % of the tube's radius"
    ));

    // ½ (4 − 3)/4 sin 1° = 0.2 %.
    let text = GOOD.replacen("1.0 0 0 0", "1.0 0.5 0 0", 1);
    let input = read(&text, &ReadOptions::default());
    assert!(has_note(&input, "rotation of the principal axes"));

    let text = GOOD.replacen("2.0 1.0 3.0", "5.0 4.0 9.0", 1);
    let input = read(&text, &ReadOptions::default());
    assert!(has_note(&input, "run upwards"));
}

#[test]
fn rows_that_hawc2_does_not_read_are_noted() {
    let text = GOOD.replacen("$1 4", "$1 2", 1);
    let input = read(&text, &ReadOptions::default());
    assert_eq!(input.description.properties.len(), 2);
    assert!(has_note(&input, "tower_st.dat:8: 2 rows after the 2 rows"));
}

#[test]
fn free_text_windows_line_ends_and_fortran_numbers_are_read() {
    let text = GOOD.replacen("2.0e11", "2.0D+11", 1);
    let text = text.replacen("0.6 1.0 0 0 0", "0.6 1.0 0 0 0 ; the base", 1);
    let text = format!("\u{feff}{}", text.replace('\n', "\r\n"));
    let input = read(&text, &ReadOptions::default());
    assert_eq!(input.description.properties.len(), 4);
    assert_eq!(input.description.properties[0].properties.axial_n, 2.0e11);
}

#[test]
fn counts_are_bounded_by_the_rows_that_are_there() {
    all_refused(
        r#"
        $1 4 | $1 1000000000000 | 10:1 | expected row 5 of the 1000000000000 of set 1, subset 1 here, found `r`
        $1 4 | $1 99999999999999999999 | 5:4 | a whole number
        $1 4 | $1 5 | 10:1 | row 5 of the 5 of set 1, subset 1
        $1 4 | $1 0 | 5:4 | must be at least 1 | `$1 20 name`
        $1 4 | $1 -4 | 5:4 | must be at least 1
        $1 4 | $1 | 5:4 | a whole number, found `Flexible`
        $1 4 Flexible | $1 | 5:3 | the number of rows of the subset is missing
        $1 4 | $1 1 | 5:1 | the subset has 1 row instead of at least 2
        $2 2 | $1 2 | 11:1 | set 1, subset 1 occurs 2 times
        #1 Test | # Test | 1:1 | not a structural file of HAWC2 | `#1 name`
        "#,
    );
}

#[test]
fn mistakes_in_rows_have_their_place() {
    all_refused(
        r#"
        5000 0 0 2.0 | -5 0 0 2.0 | 6:6 | column 2, m, mass per length, is -5 kg/m, but must be positive
        5000 0 0 2.0 | nan 0 0 2.0 | 6:6 | not a finite number
        5000 0 0 2.0 | 5000 0 0 -2 | 6:15 | non-negative
        4500 0 0 | 4500 x 0 | 7:11 | column 3, x_cg, must be a number, found `x`
        0.9 0 0 0 | 0.9 0 0 | 7:68 | 18 columns instead of 19 | r m x_cg
        0.9 0 0 0 | 0.9 0 0 0 7 | 7:71 | 20 columns instead of 19
        "#,
    );
    let full = format!("0.9 0 0 0{}", " 1".repeat(11));
    let words = "the rows have 30 columns: full 6x6 stiffness matrices";
    refused("0.9 0 0 0", &full, (7, 71), words, "classic 19");
    all_refused(
        r#"
        80.0 3000 | 20.0 3000 | 9:1 | r is not in increasing order: 20 m follows 30 m | distance from the first node
        0.5 0.6 0.9 | 0.5 0 0.9 | 7:57 | k_y, shear factor is 0, but must be positive as the other shear factors | all 0
        2.0e11 | 1.0e308 | 6:1 | E I_x, the bending stiffness, in this row is too large
        5000 0 0 | 5000 0.9 0 | 6:11 | x_cg (column 3) is 0.9 m, 32 % of the radius | blade
        1.0 0 0 0 | 1.0 30 0 0 | 6:65 | pitch (column 17) rotates the principal axes by 30 degrees
        1.0 0 0 0 | 1.0 90 0 0 | 6:65 | rotates the principal axes by 90 degrees
        "#,
    );
}

#[test]
fn full_matrices_are_refused_once() {
    // The columns of that layout after y_cg: pitch, x_e, y_e and the 21 entries of the matrix, many
    // of them 0.
    let row = |r: &str| format!("{r} 5000 0 0 2 2 0 0 0{}\n", " 0 1e10 0".repeat(7));
    let text = format!("#1 Tower\n$1 3\n{}{}{}", row("0"), row("40"), row("80"));
    let Err(ReadError::Mistakes { mistakes, .. }) =
        read_hawc2(source(&text), &ReadOptions::default())
    else {
        panic!("full matrices are read");
    };
    assert_eq!(mistakes.len(), 1, "{mistakes:?}");
    mistakes[0].message().says("30 columns");
    assert_eq!(mistakes[0].line_and_column(&text).0, 3);
}

#[test]
fn notes_have_no_more_digits_than_a_reader_needs() {
    let text = GOOD.replacen("80.0 3000", "80.00139662865123 3000", 1);
    let input = read(&text, &ReadOptions::default());
    assert!(has_note(&input, "to 80.0014 m"), "{:?}", input.notes);
}

#[test]
fn what_only_the_tower_shows_has_its_place() {
    let text = GOOD.replacen("0.0  5000", "30.0 5000", 1);
    let error = read(&text, &ReadOptions::default())
        .tower()
        .expect_err("thrice");
    let ReadError::Mistakes { mistakes, .. } = error else {
        panic!("a mistake");
    };
    assert_eq!(mistakes[0].line_and_column(&text), (8, 1));
    mistakes[0].message().says("three stations at height 30 m");
}

#[test]
fn cut_and_changed_files_never_panic() {
    for end in 0..GOOD.len() {
        let result = read_hawc2(source(&GOOD[..end]), &ReadOptions::default());
        let _ = result.map(|input| input.tower().is_ok());
    }
    for (at, _) in GOOD.char_indices() {
        for change in ["#", "$", "\n", "-", "9e307 ", "/", "'", "\u{feff}", "ü"] {
            let text = format!("{}{change}{}", &GOOD[..at], &GOOD[at + 1..]);
            let result = read_hawc2(source(&text), &ReadOptions::default());
            let _ = result.map(|input| input.tower().is_ok());
        }
    }
    let many = format!("#1\n{}", "$1 1\n".repeat(3000));
    assert!(read_hawc2(source(&many), &ReadOptions::default()).is_err());
}

/// A file of the folder of real files, if the tests are given one.
fn real(path: &str) -> Option<PathBuf> {
    let Some(folder) = std::env::var_os("TOWERMODES_PEER_DATA") else {
        eprintln!("skipped: TOWERMODES_PEER_DATA is not set");
        return None;
    };
    Some(Path::new(&folder).join(path))
}

/// What is known of a real file, computed from its columns apart from this program: trapezoids for
/// the mass; frequencies by shooting with Runge-Kutta of an Euler-Bernoulli beam whose m and EI are
/// linear between the rows.
struct Known {
    path: &'static str,
    rows: usize,
    mass_kg: f64,
    top_m: f64,
    frequencies_hz: [f64; 2],
    shear_n: f64,
}

const KNOWN: [Known; 4] = [
    Known {
        path: "openfast/iea15_monopile/IEA_15MW_RWT_Tower_st.dat",
        rows: 20,
        mass_kg: 853_465.135_8,
        top_m: 129.386,
        frequencies_hz: [0.774_648_015_6, 3.255_776_856],
        shear_n: 4.958_363_567_04e10,
    },
    Known {
        path: "openfast/iea15_monopile/IEA_15MW_RWT_Monopile_st.dat",
        rows: 19,
        mass_kg: 560_601.854_5,
        top_m: 45.0,
        frequencies_hz: [5.276_781_684, 30.702_680_679],
        shear_n: 6.969_286_051_0e10,
    },
    Known {
        path: "openfast/iea15_monopile/IEA_15MW_RWT_Embeddedmonopile_st.dat",
        rows: 2,
        mass_kg: 649_350.0,
        top_m: 45.0,
        frequencies_hz: [4.756_314_803, 29.807_316_069],
        shear_n: 6.969_286_051_0e10,
    },
    Known {
        path: "openfast/iea10/iea10mw_rc1_hawc2_tower_st.dat",
        rows: 20,
        mass_kg: 628_443.431_75,
        top_m: 115.63,
        frequencies_hz: [0.780_846_394_7, 3.616_144_407],
        shear_n: 3.983_204_004_0e10,
    },
];

#[test]
fn real_files_have_the_masses_and_frequencies_of_their_columns() {
    for known in &KNOWN {
        let Some(path) = real(known.path) else { return };
        let source = Source::from_path(&path).expect("the real file");
        let mut input = read_hawc2(source, &ReadOptions::default()).expect("a tower");
        let found = input.description.properties.len();
        assert_eq!(found, known.rows, "{}", known.path);
        let base = &input.description.properties[0].properties;
        let shear_n = base.shear_n.expect("shear").fore_aft;
        assert!((shear_n / known.shear_n - 1.0).abs() < 1e-12);
        assert!(has_note(&input, "not read: set 1, subset 2"));
        assert!(!has_note(&input, "run upwards"));
        for row in &mut input.description.properties {
            row.properties.shear_n = None;
        }
        let tower = input.tower().expect("valid");
        let holds = (tower.mass_kg() / known.mass_kg - 1.0).abs() < 1e-12;
        assert!(holds, "{}", known.path);
        assert_eq!(tower.top_m(), known.top_m);
        let options = Options {
            method: Method::Spectral,
            rotary_inertia: false,
            modes: 12,
            ..Options::default()
        };
        let solution = solve(&tower, &options).expect("solved");
        for (order, expected) in known.frequencies_hz.into_iter().enumerate() {
            let mode = solution.mode(Family::ForeAft, order + 1).expect("there");
            let error = mode.frequency_hz / expected - 1.0;
            assert!(error.abs() < 1e-7, "{}: {}", known.path, mode.frequency_hz);
        }
    }
}
