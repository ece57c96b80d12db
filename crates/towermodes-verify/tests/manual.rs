//! The manual comes out, and would notice if it did not. That the book has it as it comes out is a
//! test of the program.

use towermodes_verify::{CHAPTERS, Row, Subject, Verdict, manual};

fn rows() -> Vec<Row> {
    manual().iter().flat_map(|case| case.run()).collect()
}

#[test]
fn every_value_comes_out() {
    let rows = rows();
    let failed: Vec<String> = rows
        .iter()
        .filter(|row| row.verdict() == Verdict::Fail)
        .map(|row| {
            format!(
                "{}, {}, {} by {}: expected {}, got {}, difference {} > {:.1e}",
                row.chapter.name,
                row.case,
                row.what,
                row.method,
                row.expected.value,
                row.shown(),
                row.shown_difference(),
                row.tolerance
            )
        })
        .collect();
    assert!(
        failed.is_empty(),
        "{} of {}:\n{}",
        failed.len(),
        rows.len(),
        failed.join("\n")
    );
    assert!(rows.len() > 400, "{} rows: cases are missing", rows.len());
    for chapter in CHAPTERS {
        let holds = rows.iter().any(|row| row.chapter == chapter);
        assert!(holds, "{}", chapter.name);
    }
}

#[test]
fn a_value_off_by_little_more_than_its_tolerance_fails() {
    for case in manual() {
        for run in &case.runs {
            let mut wrong = case.clone();
            wrong.runs = vec![run.clone()];
            for (expected, row) in wrong.clone().run().iter().enumerate() {
                let off = 1.0 + 2.5 * row.tolerance;
                wrong.expected[expected].value *= off;
                if let Some(misprint) = &mut wrong.expected[expected].misprint {
                    misprint.correct *= off;
                }
            }
            for row in wrong.run() {
                assert_eq!(
                    row.verdict(),
                    Verdict::Fail,
                    "{}, {}, {}",
                    row.case,
                    row.what,
                    row.method
                );
            }
        }
    }
}

#[test]
fn a_wrong_tower_fails() {
    let mut case = manual().remove(0);
    let mut tower = case.subject.as_tower().expect("a tower").clone();
    tower.stations[0].wall_thickness_m *= 1.001;
    case.subject = Subject::tower(tower.clone());
    assert!(case.run().iter().any(|row| !row.passes()));
    tower.stations[0].wall_thickness_m = 4.0;
    case.subject = Subject::tower(tower);
    let rows = case.run();
    assert!(rows.iter().all(|row| !row.passes()));
    assert!(rows[0].shown().contains("less than twice the wall"));
}

/// Their reference is what the paper prints, so they must not pass.
#[test]
fn the_misprints_of_the_paper_are_marked() {
    let rows = rows();
    let misprints = rows.iter().filter(|row| row.verdict() == Verdict::Misprint);
    let found: Vec<_> = misprints
        .map(|row| {
            (
                row.source,
                row.method.as_str(),
                row.what.as_str(),
                row.expected.value,
            )
        })
        .collect();
    let (table_1, table_2) = ("Nikolić & Šalinić, Table 1", "Nikolić & Šalinić, Table 2");
    let expected = [
        (table_1, "rmje 60", "torsion 1", 11.8834),
        (table_2, "rmje 40", "axial 1", 7.1018),
        (table_2, "rmje 60", "axial 1", 7.1060),
    ];
    assert_eq!(found, expected);
    let paper = rows.iter().filter(|row| row.chapter.name == "paper");
    assert_eq!(paper.filter(|row| row.passes()).count(), 40);
}
