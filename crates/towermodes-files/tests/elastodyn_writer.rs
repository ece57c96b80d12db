//! Tower files of ElastoDyn written and patched, and the difference shown.

use std::ops::Range;

use towermodes::{MissingPart, Rna, Tower, TowerDescription};
use towermodes_analysis::elastodyn::MakeOptions;
use towermodes_files::elastodyn::{
    CoefficientSpans, ConcentratedMass, PatchError, TowerFile, TowerFileError, TowerRow,
    header_with_heights, make_tower_file, patched, unified_diff, write_tower_file,
};
use towermodes_testing::{Says, changed, tube};

fn row(height_fraction: f64, mass_kg_per_m: f64) -> TowerRow {
    TowerRow {
        height_fraction,
        mass_kg_per_m,
        fore_aft_n_m2: 6.5e11,
        side_side_n_m2: 4.25e11,
    }
}

fn content() -> TowerFile {
    TowerFile {
        header: header_with_heights("a small tower", 87.6, 10.0),
        fore_aft_damping_percent: [1.0, 0.75],
        side_side_damping_percent: [2.0, 1.5],
        fore_aft_tuners: [1.0, 1.1],
        side_side_tuners: [1.2, 1.3],
        mass_factor: 1.05,
        fore_aft_factor: 1.0,
        side_side_factor: 0.9,
        rows: vec![row(0.0, 5600.0), row(0.5, 4100.5), row(1.0, 2500.0)],
        coefficients: [
            [0.75, 0.25, 0.0, 0.0, 0.0],
            [-70.5, -63.75, 290.0, -176.5, 21.75],
            [1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 0.0, 0.0],
            [1.5, -0.5, 0.0, 0.125, -0.125],
        ],
        concentrated_masses: vec![ConcentratedMass {
            height_fraction: 0.324,
            mass_kg: 6700.0,
        }],
    }
}

const WRITTEN: &str = "\
------- ELASTODYN V1.00.* TOWER INPUT FILE -------------------------------------
a small tower; TowerHt = 87.6 m, TowerBsHt = 10 m
---------------------- TOWER PARAMETERS ----------------------------------------
             3   NTwInpSt    - Number of input stations to specify tower geometry
           1.0   TwrFADmp(1) - Tower 1st fore-aft mode structural damping ratio (%)
          0.75   TwrFADmp(2) - Tower 2nd fore-aft mode structural damping ratio (%)
           2.0   TwrSSDmp(1) - Tower 1st side-to-side mode structural damping ratio (%)
           1.5   TwrSSDmp(2) - Tower 2nd side-to-side mode structural damping ratio (%)
---------------------- TOWER ADJUSTMUNT FACTORS --------------------------------
           1.0   FAStTunr(1) - Tower fore-aft modal stiffness tuner, 1st mode (-)
           1.1   FAStTunr(2) - Tower fore-aft modal stiffness tuner, 2nd mode (-)
           1.2   SSStTunr(1) - Tower side-to-side stiffness tuner, 1st mode (-)
           1.3   SSStTunr(2) - Tower side-to-side stiffness tuner, 2nd mode (-)
          1.05   AdjTwMa     - Factor to adjust tower mass density (-)
           1.0   AdjFASt     - Factor to adjust tower fore-aft stiffness (-)
           0.9   AdjSSSt     - Factor to adjust tower side-to-side stiffness (-)
---------------------- DISTRIBUTED TOWER PROPERTIES ----------------------------
   HtFract         TMassDen        TwFAStif        TwSSStif
     (-)            (kg/m)          (Nm^2)          (Nm^2)
0.00000000E+00  5.60000000E+03  6.50000000E+11  4.25000000E+11
5.00000000E-01  4.10050000E+03  6.50000000E+11  4.25000000E+11
1.00000000E+00  2.50000000E+03  6.50000000E+11  4.25000000E+11
---------------------- TOWER FORE-AFT MODE SHAPES ------------------------------
    0.75000000   TwFAM1Sh(2) - Mode 1, coefficient of x^2 term
    0.25000000   TwFAM1Sh(3) -       , coefficient of x^3 term
    0.00000000   TwFAM1Sh(4) -       , coefficient of x^4 term
    0.00000000   TwFAM1Sh(5) -       , coefficient of x^5 term
    0.00000000   TwFAM1Sh(6) -       , coefficient of x^6 term
  -70.50000000   TwFAM2Sh(2) - Mode 2, coefficient of x^2 term
  -63.75000000   TwFAM2Sh(3) -       , coefficient of x^3 term
  290.00000000   TwFAM2Sh(4) -       , coefficient of x^4 term
 -176.50000000   TwFAM2Sh(5) -       , coefficient of x^5 term
   21.75000000   TwFAM2Sh(6) -       , coefficient of x^6 term
---------------------- TOWER SIDE-TO-SIDE MODE SHAPES --------------------------
    0.33333333   TwSSM1Sh(2) - Mode 1, coefficient of x^2 term
    0.33333333   TwSSM1Sh(3) -       , coefficient of x^3 term
    0.33333334   TwSSM1Sh(4) -       , coefficient of x^4 term
    0.00000000   TwSSM1Sh(5) -       , coefficient of x^5 term
    0.00000000   TwSSM1Sh(6) -       , coefficient of x^6 term
    1.50000000   TwSSM2Sh(2) - Mode 2, coefficient of x^2 term
   -0.50000000   TwSSM2Sh(3) -       , coefficient of x^3 term
    0.00000000   TwSSM2Sh(4) -       , coefficient of x^4 term
    0.12500000   TwSSM2Sh(5) -       , coefficient of x^5 term
   -0.12500000   TwSSM2Sh(6) -       , coefficient of x^6 term
---------------------- TOWER CONCENTRATED MASSES -------------------------------
             1   NTwCMass    - Number of tower concentrated masses
   HtFract         TwCMass
     (-)             (kg)
3.24000000E-01  6.70000000E+03
";

#[test]
fn a_tower_file_is_laid_out_as_openfast_s_examples_are() {
    assert_eq!(write_tower_file(&content(), true).expect("a file"), WRITTEN);
    let without = changed!(content(), concentrated_masses = Vec::new());
    let (head, _) = WRITTEN
        .split_once("---------------------- TOWER CONC")
        .expect("a section");
    assert_eq!(write_tower_file(&without, false).expect("a file"), head);
    let empty = write_tower_file(&without, true).expect("a file");
    empty.says("             0   NTwCMass ");
}

#[test]
fn masses_are_never_left_out_silently() {
    let error = write_tower_file(&content(), false).expect_err("no section");
    assert_eq!(error, TowerFileError::NoSection { masses: 1 });
}

#[test]
fn a_header_stays_one_line_and_a_missing_title_is_given() {
    let mut content = content();
    content.header = [String::new(), "two\r\nlines \t".to_owned()];
    let text = write_tower_file(&content, true).expect("a file");
    let lines: Vec<&str> = text.lines().collect();
    lines[0].begins("------- ELASTODYN V1.00.* TOWER INPUT FILE");
    assert_eq!(lines[1], "two  lines");
    assert_eq!(lines.len(), WRITTEN.lines().count());
}

#[test]
fn every_rule_of_openfast_is_kept() {
    let broken = |change: fn(&mut TowerFile)| {
        let mut content = content();
        change(&mut content);
        write_tower_file(&content, true).expect_err("a mistake")
    };
    broken(|c| c.fore_aft_damping_percent[1] = -0.1)
        .says("TwrFADmp(2) is -0.1; it must be from 0 to 100");
    broken(|c| c.side_side_damping_percent[0] = 100.5).says("TwrSSDmp(1) is 100.5");
    broken(|c| c.fore_aft_tuners[0] = 0.0).says("FAStTunr(1) is 0; it must be greater than 0");
    broken(|c| c.side_side_tuners[1] = f64::NAN).says("SSStTunr(2) is NaN");
    broken(|c| c.mass_factor = f64::INFINITY).says("AdjTwMa is inf");
    broken(|c| c.fore_aft_factor = -1.0).says("AdjFASt is -1");
    broken(|c| c.side_side_factor = 0.0).says("AdjSSSt is 0");
    broken(|c| c.rows.truncate(1)).says("at least 2 rows");
    broken(|c| c.rows[0].height_fraction = 0.1).says("HtFract of row 1 is 0.1; it must be 0");
    broken(|c| c.rows[2].height_fraction = 0.9).says("HtFract of row 3 is 0.9; it must be 1");
    broken(|c| c.rows[1].height_fraction = 0.0).says("HtFract of row 2 is 0; it must be above");
    broken(|c| c.rows[1].height_fraction = 1.0).says("HtFract of row 2 is 1");
    broken(|c| c.rows[1].height_fraction = f64::NAN).says("HtFract of row 2 is NaN");
    broken(|c| c.rows[1].mass_kg_per_m = 0.0).says("TMassDen of row 2 is 0");
    broken(|c| c.rows[0].fore_aft_n_m2 = -1.0).says("TwFAStif of row 1 is -1");
    broken(|c| c.rows[2].side_side_n_m2 = f64::NAN).says("TwSSStif of row 3 is NaN");
    broken(|c| c.coefficients[1][0] += 0.01).says("TwFAM2Sh: the coefficients sum to 1.01");
    broken(|c| c.coefficients[3][2] = f64::NAN).says("TwSSM2Sh: the coefficient of x^4 is NaN");
    broken(|c| c.concentrated_masses[0].height_fraction = 1.1)
        .says("HtFract of concentrated mass 1 is 1.1");
    broken(|c| c.concentrated_masses[0].mass_kg = -1.0)
        .says("TwCMass of concentrated mass 1 is -1");
}

#[test]
fn steps_of_the_wall_stay_steps() {
    let mut content = content();
    let above = 0.5 + 2.0 * f64::EPSILON;
    content.rows.insert(2, row(above, 4000.0));
    let text = write_tower_file(&content, true).expect("a file");
    let heights = text.lines().skip(19).take(4).map(|line| {
        let first = line.split_whitespace().next().expect("a height");
        first.parse::<f64>().expect("a number")
    });
    assert_eq!(heights.collect::<Vec<_>>(), [0.0, 0.5, above, 1.0]);
}

/// Where the first number of every line of a coefficient stands.
fn spans(text: &str) -> CoefficientSpans {
    let mut start = 0;
    let mut found: Vec<Range<usize>> = Vec::new();
    for line in text.split_inclusive('\n') {
        if line.contains("Sh(") {
            let number = line.split_whitespace().next().expect("a number");
            let at = start + line.find(number).expect("a number");
            found.push(at..at + number.len());
        }
        start += line.len();
    }
    assert_eq!(found.len(), 20);
    std::array::from_fn(|mode| std::array::from_fn(|k| found[5 * mode + k].clone()))
}

const NEW: [[f64; 5]; 4] = [
    [0.700_412_34, 0.299_587_66, 0.0, 0.0, 0.0],
    [-1234.5, 1235.5, 0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0, 0.0, 0.0],
    [1.5, -0.5, 0.0, 0.125, -0.125],
];

/// A text of twenty coefficients, each line in the same style.
fn twenty(before: &str, number: &str, after: &str) -> String {
    let line = format!("{before}{number}{after}");
    format!("head \t\r\n{}tail without an end", line.repeat(20))
}

/// The first lines of coefficients after a patch.
fn patched_lines(text: &str) -> Vec<String> {
    let result = patched(text, &spans(text), &NEW).expect("patched");
    assert!(result.starts_with("head \t\r\n") && result.ends_with("tail without an end"));
    let lines = result.split_inclusive('\n').skip(1).take(20);
    lines.map(str::to_owned).collect()
}

#[test]
fn columns_stay_where_there_is_room() {
    // Ends in one column: blanks before are taken, and given.
    let lines = patched_lines(&twenty("     ", "0.7004", "   TwFAM1Sh(2) - Mode 1  \r\n"));
    assert_eq!(lines[0], " 0.70041234   TwFAM1Sh(2) - Mode 1  \r\n");
    assert_eq!(lines[5], "-1234.50000000   TwFAM1Sh(2) - Mode 1  \r\n");
    // Begins in one column: blanks after are taken while one remains, and given.
    let lines = patched_lines(&twenty("", "0.7004", "     TwFAM1Sh(2)\n"));
    assert_eq!(lines[0], "0.70041234 TwFAM1Sh(2)\n");
    assert_eq!(lines[5], "-1234.50000000     TwFAM1Sh(2)\n");
    let lines = patched_lines(&twenty("", "0.700400000000000001", " TwFAM1Sh(2)\n"));
    assert_eq!(lines[0], "0.70041234           TwFAM1Sh(2)\n");
    let lines = patched_lines(&twenty("  ", "0.700400000000000001", "\tTwFAM1Sh(2)\n"));
    assert_eq!(lines[0], "            0.70041234\tTwFAM1Sh(2)\n");
    // No room at all: it grows.
    let lines = patched_lines(&twenty("", "0.7", "\tTwFAM1Sh(2)\n"));
    assert_eq!(lines[0], "0.70041234\tTwFAM1Sh(2)\n");
}

#[test]
fn a_number_that_is_the_same_keeps_its_bytes() {
    let lines = patched_lines(&twenty("  ", "1.0D0", " ! TwFAM1Sh(2)\n"));
    assert_eq!(lines[10], "  1.0D0 ! TwFAM1Sh(2)\n");
    assert_eq!(lines[11], "0.00000000 ! TwFAM1Sh(2)\n");
}

#[test]
fn places_that_are_none_are_refused() {
    let text = twenty("", "0.5", " é TwFAM1Sh(2)\n");
    let right = spans(&text);
    let wrong: [Range<usize>; 5] = [1_000_000..1_000_001, 13..14, 8..8, 0..9, 12..14];
    for place in wrong {
        let mut spans = right.clone();
        spans[0][0] = place.clone();
        // Outside the text, inside the two bytes of é, nothing, over a line's end, no number.
        let refused = patched(&text, &spans, &NEW);
        let (start, end) = (place.start, place.end);
        assert_eq!(refused, Err(PatchError::Place { start, end }), "{place:?}");
    }
    let mut spans = right;
    spans[0].swap(0, 1);
    assert!(patched(&text, &spans, &NEW).is_err());
    let off = [[0.5; 5]; 4];
    assert!(matches!(
        patched(&text, &spans, &off),
        Err(PatchError::Coefficients(_))
    ));
}

#[test]
fn a_difference_has_three_lines_around_each_change() {
    let line = |k: usize| format!("line {k}\n");
    let old: String = (1..=20).map(line).collect();
    let new = old
        .replace("line 2\n", "second\n")
        .replace("line 9\n", "ninth\n")
        .replace("line 17\n", "seventeenth\n")
        .replace("line 18\n", "eighteenth\n");
    let expected = "\
--- a.dat
+++ b.dat
@@ -1,12 +1,12 @@
 line 1
-line 2
+second
 line 3
 line 4
 line 5
 line 6
 line 7
 line 8
-line 9
+ninth
 line 10
 line 11
 line 12
@@ -14,7 +14,7 @@
 line 14
 line 15
 line 16
-line 17
-line 18
+seventeenth
+eighteenth
 line 19
 line 20
";
    assert_eq!(unified_diff("a.dat", "b.dat", &old, &new), expected);
    assert_eq!(unified_diff("a.dat", "b.dat", &old, &old), "");
}

#[test]
fn line_ends_and_a_missing_last_one_are_shown() {
    let diff = unified_diff("a\n", "b", "x\r\ny", "x\r\nz");
    let expected = "--- a?\n+++ b\n@@ -1,2 +1,2 @@\n x\r\n-y\n\\ No newline at end of file\n+z\n\\ No newline at end of file\n";
    assert_eq!(diff, expected);
    let diff = unified_diff("a", "b", "x\n", "x");
    let expected = "--- a\n+++ b\n@@ -1,1 +1,1 @@\n-x\n+x\n\\ No newline at end of file\n";
    assert_eq!(diff, expected);
}

#[test]
fn texts_of_different_lengths_differ_in_one_block() {
    let diff = unified_diff("a", "b", "1\n2\n3\n4\n5\n6\n", "1\n2\n3\n4\nx\ny\n5\n6\n");
    let expected = "--- a\n+++ b\n@@ -2,5 +2,7 @@\n 2\n 3\n 4\n+x\n+y\n 5\n 6\n";
    assert_eq!(diff, expected);
    unified_diff("a", "b", "", "1\n").reads("--- a\n+++ b\n@@ -0,0 +1,1 @@\n+1\n");
    unified_diff("a", "b", "1\n", "").reads("--- a\n+++ b\n@@ -1,1 +0,0 @@\n-1\n");
}

/// Tower files of other programs: of each, only the bytes of the coefficients and blanks beside
/// them change.
#[test]
fn real_files_keep_every_other_byte() {
    let Ok(folder) = std::env::var("TOWERMODES_PEER_DATA") else {
        eprintln!("skipped: TOWERMODES_PEER_DATA is not set");
        return;
    };
    for name in [
        "nrel5mw_land/NRELOffshrBsline5MW_Onshore_ElastoDyn_Tower.dat",
        "nrel5mw_land_deck/NRELOffshrBsline5MW_Tower.dat",
        "nrel5mw_oc3monopile/NRELOffshrBsline5MW_OC3Monopile_Tower.dat",
        "iea15_monopile/IEA-15-240-RWT-Monopile_ElastoDyn_tower.dat",
        "iea10/IEA-10.0-198-RWT_ElastoDyn_tower.dat",
    ] {
        let path = std::path::Path::new(&folder).join("openfast").join(name);
        let old = std::fs::read_to_string(&path).expect(name);
        let new = patched(&old, &spans(&old), &NEW).expect(name);
        let found = spans(&new);
        for (spans, coefficients) in found.iter().zip(NEW) {
            for (span, c) in spans.iter().zip(coefficients) {
                assert_eq!(new[span.clone()].parse(), Ok(c), "{name}");
            }
        }
        let changed: Vec<usize> = (0..)
            .zip(old.split('\n').zip(new.split('\n')))
            .filter(|(_, (old, new))| old != new)
            .map(|(line, _)| line)
            .collect();
        assert!(changed.len() <= 20 && old.matches('\n').count() == new.matches('\n').count());
        for (old, new) in old.split('\n').zip(new.split('\n')) {
            let rest = |line: &str| {
                let words = line.trim_start().split_once(' ');
                words.map(|(_, rest)| rest.trim_start().to_owned())
            };
            assert!(old == new || rest(old) == rest(new), "{name}: {old}");
        }
    }
}

/// The file has no place for the parts of a structure that the model lacks but its title.
#[test]
fn missing_parts_are_named_in_the_title() {
    let made = |parts: Vec<MissingPart>| {
        let description = TowerDescription {
            name: "on water".to_owned(),
            rna: Rna::point(3e5),
            missing_parts: parts,
            ..tube(&[(0.0, 6.0, 0.03), (80.0, 4.0, 0.02)])
        };
        let tower = Tower::new(description).expect("a tower");
        let made = make_tower_file(&tower, &MakeOptions::default()).expect("a tower file");
        let text = write_tower_file(&made.content, false).expect("text");
        let second = text.lines().nth(1).unwrap_or_default().to_owned();
        let notes = made.notes.iter().map(ToString::to_string);
        let is_noted = notes
            .into_iter()
            .any(|note| note.contains("in the second line"));
        (second, is_noted)
    };
    let (title, is_noted) = made(vec![MissingPart::Water]);
    let expected = "WARNING: clamped at the tower base; the file has water, which is not in this \
                    model. on water; TowerHt = 80 m, TowerBsHt = 0 m";
    assert_eq!((title.as_str(), is_noted), (expected, true));
    let (title, is_noted) = made(Vec::new());
    let expected = "on water; TowerHt = 80 m, TowerBsHt = 0 m";
    assert_eq!((title.as_str(), is_noted), (expected, false));
}
