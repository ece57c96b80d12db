//! Tower files: what is read, and the rules of OpenFAST with their lines.

use towermodes_files::elastodyn::{read_elastodyn_tower, read_tower_file};
use towermodes_files::{Diagnostic, ReadOptions};
use towermodes_testing::{Says, changed, number, rows};

use crate::elastodyn::texts::{MASSES, TOWER, source};

/// The mistake in a tower file in which a text was replaced, with its line.
fn tower_mistake(from: &str, to: &str) -> (usize, Diagnostic) {
    let text = TOWER.to_owned() + MASSES;
    text.says(from);
    let source = source("tower.dat", text.replacen(from, to, 1));
    let mistake = read_tower_file(&source).expect_err(to);
    (mistake.line_and_column(&source.text).0, mistake)
}

#[test]
fn a_tower_file_is_read_by_position() {
    let (tower, spans, notes) = read_tower_file(&source("t", TOWER)).expect("a tower file");
    assert_eq!(tower.fore_aft_damping_percent, [1.0, 2.0]);
    assert_eq!(tower.side_side_damping_percent, [3.0, 4.0]);
    assert_eq!(tower.fore_aft_tuners, [1.0, 1.5]);
    assert_eq!(tower.mass_factor, 2.0);
    assert_eq!(tower.fore_aft_factor, 3.0);
    assert_eq!(tower.side_side_factor, 4.0);
    assert_eq!(tower.rows.len(), 3);
    assert_eq!(tower.rows[0].mass_kg_per_m, 1000.0);
    assert_eq!(tower.rows[1].side_side_n_m2, 1.8e10);
    assert_eq!(tower.coefficients[1], [-40.5, 41.5, 0.0, 0.0, 0.0]);
    assert_eq!(&TOWER[spans[1][0].clone()], "-40.5");
    assert_eq!(&TOWER[spans[2][1].clone()], "0.001");
    let holds = tower.concentrated_masses.is_empty() && notes.is_empty();
    assert!(holds, "a sum may be 0.001 off");
    let (tower, ..) =
        read_tower_file(&source("t", TOWER.to_owned() + "\n" + MASSES)).expect("masses");
    assert_eq!(tower.concentrated_masses[1].mass_kg, 30.0);
}

#[test]
fn a_sum_far_from_one_is_a_note() {
    let text = TOWER.replace("0.001 TwSSM1Sh(3)", "0.002 TwSSM1Sh(3)");
    let (_, _, notes) = read_tower_file(&source("t", text)).expect("a tower file");
    assert_eq!(notes.len(), 1);
    assert!(notes[0].message.contains("1st side-side") && notes[0].message.contains("1.002"));
    assert_eq!(notes[0].place, Some(("t".into(), 35)));
}

#[test]
fn the_rules_of_openfast_have_their_lines() {
    let table = r#"
        3 NTwInpSt | 1000000000000 NTwInpSt | 4 | is 1e12
        3 NTwInpSt | -1 NTwInpSt | 4 | is -1
        3 NTwInpSt | 3.5 NTwInpSt | 4 | whole number
        3 NTwInpSt | 4 NTwInpSt | 23 | row 4 of the distributed properties
        3 NTwInpSt | 2 NTwInpSt | 21 | HtFract of the last row is 0.25
        3 NTwInpSt | 1 NTwInpSt | 21 | after the rows, here
        3 NTwInpSt | 0 NTwInpSt | 4 | is 0
        1 TwrFADmp(1) | -1 TwrFADmp(1) | 5 | is -1
        4 TwrSSDmp(2) | 101 TwrSSDmp(2) | 8 | is 101
        1.5 FAStTunr(2) | 0 FAStTunr(2) | 11 | is 0
        2 AdjTwMa | -2 AdjTwMa | 14 | is -2
        ␣0.0 1.0D3 | ␣0.1 1.0D3 | 20 | first row is 0.1
        ␣0.25 900 | ␣0 900 | 21 | 0 follows 0
        ␣0.25 900 | ␣1.25 900 | 22 | 1 follows 1.25
        ␣1.0 800 | ␣0.99 800 | 22 | last row is 0.99
        ␣0.25 900 | ␣0.25 0 | 21 | TMassDen of row 2 is 0
        9e9 1.8e10 | -9e9 1.8e10 | 21 | TwFAStif of row 2 is -9000000000
        9e9 1.8e10 | 9e9 0 | 21 | TwSSStif of row 2 is 0
        9e9 1.8e10 | 9e9 | 21 | 3 numbers instead of 4
        9e9 1.8e10 | NaN 1.8e10 | 21 | not a finite number
        ␣2 AdjTwMa - (-)\n |  | 14 | expected AdjTwMa here, found AdjFASt
        ␣1 TwrFADmp(1) - %\n |  | 5 | expected TwrFADmp(1) here, found TwrFADmp(2)
        41.5 TwFAM2Sh(3) | x TwFAM2Sh(3) | 30 | a number, found `x`
        0.5 1200 | 1.5 1200 | 49 | HtFract of concentrated mass 1 is 1.5
        0.5 1200 | 0.5 -1200 | 49 | TwCMass of concentrated mass 1 is -1200
        2 NTwCMass | 3 NTwCMass | 50 | row 3 of the concentrated masses
        "#;
    for [from, to, line, says] in rows(table) {
        let line: usize = number(line);
        let (found, mistake) = tower_mistake(from, to);
        assert_eq!(found, line, "{to}: {mistake}");
        assert!(mistake.message().contains(says), "{to}: {mistake}");
    }
}

#[test]
fn a_tower_file_alone_needs_its_height() {
    let options = ReadOptions::default();
    let read = |text: &str, options: &ReadOptions| read_elastodyn_tower(source("t", text), options);
    let input = read(TOWER, &options).expect("heights in the header");
    let heights: Vec<f64> = input
        .description
        .properties
        .iter()
        .map(|row| row.height_m)
        .collect();
    assert_eq!(heights, [10.0, 17.5, 40.0]);
    assert_eq!(input.description.rna, towermodes::Rna::default());
    let silent = TOWER.replace("TowerHt =", "height");
    let error = read(&silent, &options).expect_err("no height");
    error.says("--tower-height");
    let told = ReadOptions {
        tower_height_m: Some(90.0),
        tower_base_m: Some(-10.0),
        ..options
    };
    let input = read(&silent, &told).expect("told");
    assert_eq!(input.description.properties[1].height_m, 15.0);
    // Below the sea a tower may hang from its base.
    let hanging = changed!(told, tower_height_m = Some(-20.0));
    let input = read(&silent, &hanging).expect("a hanging tower");
    assert_eq!(input.description.properties[0].height_m, 10.0);
    assert_eq!(input.description.properties[2].height_m, 20.0);
    for height in [f64::NAN, f64::INFINITY, -10.0] {
        let told = changed!(told, tower_height_m = Some(height));
        assert!(read(&silent, &told).is_err(), "{height}");
    }
}
