//! Decks of BModes with random damage: refused or read, but never a panic, and what is refused is
//! refused within its file.

use crate::decks;

use decks::{ALONE, BLADE_SECTIONS, OFFSHORE, SECTIONS, WIRES, blade_file, read, tower_file, with};
use proptest::prelude::*;
use towermodes_files::{BmodesInput, ReadError};

/// What damage puts into a file.
const ODDITIES: [&str; 20] = [
    "",
    " ",
    "\n",
    ",",
    ",,",
    "/",
    "*",
    "3*",
    "-",
    "'",
    "\"",
    "nan",
    "inf",
    "1e999",
    "-1",
    "0",
    "1e308",
    "1000000000000",
    "é",
    "!",
];

/// A text with a stretch replaced.
fn damaged(text: &str, at: usize, length: usize, by: &str) -> String {
    let boundary = |mut index: usize| {
        index = index.min(text.len());
        while !text.is_char_boundary(index) {
            index -= 1;
        }
        index
    };
    let start = boundary(at % (text.len() + 1));
    let end = boundary(start + length);
    format!("{}{by}{}", &text[..start], &text[end..])
}

/// Reads a deck and looks at what is made of it.
fn survives(main: &str, sections: &str, quirks: bool) {
    let error = match read(main, sections, quirks) {
        Ok(BmodesInput::Tower(tower)) => tower.tower().err(),
        Ok(BmodesInput::Blade(_)) => None,
        Err(error) => Some(error),
    };
    if let Some(ReadError::Mistakes {
        source_file,
        mistakes,
    }) = error
    {
        assert!(!mistakes.is_empty());
        for mistake in mistakes {
            assert!(mistake.span.start <= mistake.span.end, "{mistake:?}");
            let holds = source_file.text.get(mistake.span.clone()).is_some();
            assert!(holds, "{mistake:?}");
            assert!(!mistake.message().is_empty());
        }
    }
}

fn decks_of_all_kinds() -> Vec<(String, &'static str)> {
    let hub = |support: &str, hub: &str| {
        let changed = format!("{hub} hub_conn");
        with(&tower_file(support), &[("1         hub_conn", &changed)])
    };
    let later = OFFSHORE.replace("2         tow_support", "1 tow_support");
    vec![
        (tower_file(ALONE), SECTIONS),
        (tower_file(WIRES), SECTIONS),
        (hub(OFFSHORE, "2"), SECTIONS),
        (hub(OFFSHORE, "3"), SECTIONS),
        (hub(&later, "2"), SECTIONS),
        (blade_file(), BLADE_SECTIONS),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn damage_is_survived(
        deck in 0..6_usize,
        places in prop::collection::vec((any::<usize>(), 0..12_usize, 0..ODDITIES.len()), 1..4),
        in_sections in any::<bool>(),
        quirks in any::<bool>(),
    ) {
        let (mut main, sections) = decks_of_all_kinds().swap_remove(deck);
        let mut sections = sections.to_owned();
        for (at, length, by) in places {
            let text = if in_sections { &mut sections } else { &mut main };
            *text = damaged(text, at, length, ODDITIES[by]);
        }
        survives(&main, &sections, quirks);
    }

    #[test]
    fn lost_and_repeated_lines_are_survived(deck in 0..6_usize, line in 0..100_usize, times in 0..3_usize) {
        let (main, sections) = decks_of_all_kinds().swap_remove(deck);
        let lines = main.lines().enumerate();
        let changed: String = lines
            .flat_map(|(index, text)| std::iter::repeat_n(text, if index == line { times } else { 1 }))
            .map(|text| format!("{text}\n"))
            .collect();
        survives(&changed, sections, false);
    }
}
