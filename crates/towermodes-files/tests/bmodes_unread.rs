//! Decks of BModes whose lines are not quite those of the samples: a blank line left out, and
//! counts that drop what follows.

use crate::decks;

use decks::{ALONE, OFFSHORE, SECTIONS, WIRES, mistakes, tower, tower_file, with};
use towermodes::{Options, solve};

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
    assert!(
        notes.iter().find(is_meant).is_some(),
        "{line} {words:?}: {notes:?}"
    );
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
    assert!(said.contains("tow_support"), "{said}");
}

#[test]
fn wires_that_a_count_of_zero_drops_are_noted() {
    let dropped = with(
        &tower_file(WIRES),
        &[("2         n_attachments", "0         n_attachments")],
    );
    let words = [
        "n_attachments is 0",
        "no guy wires",
        "wire_stfness is 1e8 N/m",
    ];
    has_note(&dropped, 53, &words);
    assert!(first_hz(&tower_file(WIRES)) > 1.1 * first_hz(&dropped));
    let without = with(
        &dropped,
        &[("1.e8 2.e8 wire_stfness", "0.   0.   wire_stfness")],
    );
    has_note(&without, 53, &["n_attachments is 0", "tow_support = 0"]);
    let is_on_count =
        |(line, message): &(usize, String)| *line == 53 && message.contains("n_attachments");
    assert!(!notes(&tower_file(WIRES)).iter().any(is_on_count));
}

#[test]
fn sets_of_wires_beyond_the_count_are_noted() {
    let one = with(
        &tower_file(WIRES),
        &[("2         n_attachments", "1         n_attachments")],
    );
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
    let main = with(
        &tower_file(OFFSHORE),
        &[("3         n_secs_m", "0         n_secs_m")],
    );
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
    let soil = with(
        &tower_file(OFFSHORE),
        &[("2         n_secs_k", "0         n_secs_k")],
    );
    has_note(
        &soil,
        88,
        &["n_secs_k_distr is 0", "the 2 values of distr_k"],
    );
    let floating = with(&soil, &[("1         hub_conn", "2         hub_conn")]);
    assert!(!notes(&floating).iter().any(|(line, _)| *line == 88));
    let zeros = with(&main, &[("7000. 6000. 0. :", "0. 0. 0. :")]);
    assert!(!notes(&zeros).iter().any(|(line, _)| *line == 83));
}
