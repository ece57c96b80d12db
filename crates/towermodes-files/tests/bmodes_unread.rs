//! Decks of BModes whose lines are not quite those of the samples: a blank line left out, and
//! counts that drop what follows.

use crate::decks;

use decks::{ALONE, OFFSHORE, SECTIONS, WIRES, mistakes, tower, tower_file, with};
use towermodes::{Options, solve};
use towermodes_testing::Says;

/// The notes of a deck, each with the line it is on.
fn notes(main: &str) -> Vec<(usize, String)> {
    let notes = tower(main, SECTIONS, false).notes.into_iter();
    let placed = notes.filter_map(|note| Some((note.place?.1, note.message)));
    placed.collect()
}

#[track_caller]
fn has_note(main: &str, line: usize, words: &[&str]) {
    let notes = notes(main);
    let is_meant = |(at, message): &&(usize, String)| {
        *at == line && words.iter().all(|word| message.contains(word))
    };
    let holds = notes.iter().find(is_meant).is_some();
    assert!(holds, "{line} {words:?}: {notes:?}");
}

fn first_hz(main: &str) -> f64 {
    let tower = tower(main, SECTIONS, false).tower().expect("a tower");
    solve(&tower, &Options::default()).expect("solved").modes[0].frequency_hz
}

#[test]
fn headings_without_the_blank_line_before_them_are_read() {
    for support in [ALONE, WIRES, OFFSHORE] {
        let main = tower_file(support);
        let expected = tower(&main, SECTIONS, false).description;
        for heading in [
            "--- Support ---",
            "--- General parameters ---",
            "--- Tip mass ---",
            "Factors",
        ] {
            let without = with(
                &main,
                &[(&format!("\n\n{heading}"), &format!("\n{heading}"))],
            );
            let found = tower(&without, SECTIONS, false).description;
            assert_eq!(found, expected, "{heading}");
        }
        let all = main.replace("\n\n", "\n");
        assert_eq!(tower(&all, SECTIONS, false).description, expected);
    }
    let bare = with(
        &tower_file(ALONE),
        &[(
            "\n\n--- Support ---\n0         tow_support: none",
            "\nSupport\n0",
        )],
    );
    assert!(tower(&bare, SECTIONS, false).tower().is_ok());
}

#[test]
fn a_heading_that_is_missing_is_still_noticed() {
    let main = with(&tower_file(ALONE), &[("\n--- Support ---", "")]);
    let (source, mistakes) = mistakes(&main, SECTIONS, false);
    let said = mistakes[0].to_string();
    assert_eq!(mistakes[0].line_and_column(&source.text).0, 50, "{said}");
    said.says("tow_support");
}

#[test]
fn wires_that_a_count_of_zero_drops_are_noted() {
    let parameter = [("2         n_attachments", "0         n_attachments")];
    let dropped = with(&tower_file(WIRES), &parameter);
    let words = [
        "n_attachments is 0",
        "no guy wires",
        "wire_stfness is 1e8 N/m",
    ];
    has_note(&dropped, 53, &words);
    assert!(first_hz(&tower_file(WIRES)) > 1.1 * first_hz(&dropped));
    let parameter = [("1.e8 2.e8 wire_stfness", "0.   0.   wire_stfness")];
    let without = with(&dropped, &parameter);
    has_note(&without, 53, &["n_attachments is 0", "tow_support = 0"]);
    let is_on_count =
        |(line, message): &(usize, String)| *line == 53 && message.contains("n_attachments");
    assert!(!notes(&tower_file(WIRES)).iter().any(is_on_count));
}

#[test]
fn sets_of_wires_beyond_the_count_are_noted() {
    let parameter = [("2         n_attachments", "1         n_attachments")];
    let one = with(&tower_file(WIRES), &parameter);
    has_note(
        &one,
        53,
        &[
            "n_attachments is 1",
            "2 sets of guy wires",
            "only the first 1",
        ],
    );
    // A template that leaves a second number on one line gives no second set.
    let template = with(
        &one,
        &[
            ("3 4       n_wires", "3         n_wires"),
            ("60. 30.   th_wire", "60.       th_wire"),
        ],
    );
    assert!(!notes(&template).iter().any(|(line, _)| *line == 53));
}

#[test]
fn what_follows_no_support_is_noted() {
    for (support, name) in [
        (WIRES, "n_attachments is 2"),
        (OFFSHORE, "mass_pform is 8000000"),
    ] {
        let kind = if support == WIRES {
            "1         tow"
        } else {
            "2         tow"
        };
        let main = with(&tower_file(support), &[(kind, "0         tow")]);
        has_note(&main, 51, &["tow_support is 0", name]);
    }
    let none = with(
        &tower_file(WIRES),
        &[
            ("1         tow", "0         tow"),
            ("2         n_attachments", "0         n_attachments"),
        ],
    );
    assert!(!notes(&none).iter().any(|(line, _)| *line == 51));
}

#[test]
fn tables_that_a_count_of_zero_drops_are_noted() {
    let parameter = [("3         n_secs_m", "0         n_secs_m")];
    let main = with(&tower_file(OFFSHORE), &parameter);
    has_note(
        &main,
        83,
        &[
            "n_secs_m_distr is 0",
            "the 3 values of distr_m",
            "n_secs_m_distr = 3",
        ],
    );
    // A floating tower stands in no soil, and decks keep the table of another tower.
    let parameter = [("2         n_secs_k", "0         n_secs_k")];
    let soil = with(&tower_file(OFFSHORE), &parameter);
    let words = ["n_secs_k_distr is 0", "the 2 values of distr_k"];
    has_note(&soil, 88, &words);
    let floating = with(&soil, &[("1         hub_conn", "2         hub_conn")]);
    assert!(!notes(&floating).iter().any(|(line, _)| *line == 88));
    let zeros = with(&main, &[("7000. 6000. 0. :", "0. 0. 0. :")]);
    assert!(!notes(&zeros).iter().any(|(line, _)| *line == 83));
}

/// The deck of a monopile as later versions have it: guy wires after the offshore block. Both
/// tables have no rows, and `added_mass` and `stiffness` are the lines after their counts.
fn without_rows(added_mass: &str, stiffness: &str) -> String {
    with(
        &tower_file(OFFSHORE),
        &[
            ("2         tow_support", "1         tow_support"),
            (
                "3         n_secs_m_distr: rows\n0. 5. 10. : z_distr_m [m]\n7000. 6000. 0. : distr_m [kg/m]\n",
                &format!("0         n_secs_m_distr: rows\n{added_mass}"),
            ),
            (
                "2         n_secs_k_distr: rows\n0. 6.\n2*5.0e7   : distr_k [N/m2]\nEND\n",
                &format!("0         n_secs_k_distr: rows\n{stiffness}{WIRES_AFTER}"),
            ),
        ],
    )
}

const WIRES_AFTER: &str = "
Tension wires
2         n_attachments: places
3 4       n_wires: wires
3 5       node_attach: nodes
1.e8 2.e8 wire_stfness: N/m
60. 30.   th_wire: degrees
";

#[test]
fn tables_of_no_rows_may_leave_out_their_empty_lines() {
    let full = [
        "0. 0. : z_distr_m [m]\n0. 0. : distr_m [kg/m]\n",
        "0. 0. : z_distr_k [m]\n0. 0. : distr_k [N/m2]\n",
    ];
    let of = |main: &str| tower(main, SECTIONS, false).description;
    let expected = of(&without_rows(full[0], full[1]));
    assert_eq!(expected.wires.len(), 2);
    for left in ["", "\n", "\n\n", "0. 0.\n"] {
        for [added_mass, stiffness] in [[left, left], [left, full[1]], [full[0], left]] {
            let main = without_rows(added_mass, stiffness);
            assert_eq!(of(&main), expected, "{added_mass:?} {stiffness:?}");
            // Without the names that show which line is which.
            let bare = main.replace("n_secs_k_distr: rows", "");
            assert_eq!(of(&bare), expected, "{added_mass:?} {stiffness:?}");
            // Version 3.00 reads nothing after the tables.
            let old = main.replace("1         tow_support", "2         tow_support");
            let ended = old.split(WIRES_AFTER).collect::<String>();
            assert_eq!(of(&old), of(&ended), "{added_mass:?} {stiffness:?}");
            assert_eq!(of(&ended).wires, []);
        }
    }
}

#[test]
fn a_table_of_rows_after_one_without_lines_keeps_them() {
    let rows = "2         n_secs_k_distr: rows\n0. 6.\n2*5.0e7   : distr_k [N/m2]\n";
    let table = "3         n_secs_m_distr: rows\n0. 5. 10. : z_distr_m [m]\n7000. 6000. 0. : distr_m [kg/m]\n";
    let of = |lines: &str, rows_of_stiffness: &str| {
        let changes = [(table, lines), (rows, rows_of_stiffness)];
        tower(&with(&tower_file(OFFSHORE), &changes), SECTIONS, false).description
    };
    let expected = of("0 n_secs_m_distr\n0.\n0.\n", rows);
    assert_eq!(of("0 n_secs_m_distr\n", rows), expected);
    // Bare numbers: the number of rows must not be taken for a heading.
    assert_eq!(of("0\n", "2\n0. 6.\n2*5.0e7\n"), expected);
}

#[test]
fn tables_of_no_rows_before_something_else_are_refused() {
    let said = |main: &str| mistakes(main, SECTIONS, false).1[0].to_string();
    let main = without_rows("", "");
    let torn = main
        .split("\nDistributed stiffness")
        .next()
        .expect("a part");
    said(torn).says("ends");
    let without_count = with(&main, &[("0         n_secs_k_distr: rows\n", "")]);
    said(&without_count).says("n_");
    let without_places = with(&main, &[("2         n_attachments: places\n", "")]);
    said(&without_places).says("the heading of the wires");
}
