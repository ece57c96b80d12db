//! Truncated and damaged files.

use towermodes_files::elastodyn::{
    read_blade_file, read_elastodyn, read_main_file, read_tower_file,
};
use towermodes_files::{InMemory, ReadOptions};

use crate::elastodyn::texts::{BLADE, MASSES, TOWER, main_text, source};

#[test]
fn a_file_that_ends_early_says_where() {
    let whole = TOWER.to_owned() + MASSES;
    for length in 0..whole.len() {
        let result = read_tower_file(&source("t", &whole[..length]));
        assert!(result.is_err() || length > TOWER.len() - 25, "{length}");
    }
    let main = main_text(5, &[]);
    let end = main.find("------- OUTPUT").expect("a heading");
    for length in (0..end - 30).step_by(7) {
        let holds = read_main_file(&source("m", &main[..length])).is_err();
        assert!(holds, "{length}");
    }
}

/// Pseudo-random numbers (Knuth's linear congruential generator), the same in every run.
fn next(state: &mut u64) -> usize {
    *state = state
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    (*state >> 33) as usize
}

/// A text with a few pieces left out, doubled or replaced.
fn damaged(text: &str, state: &mut u64) -> String {
    const PIECES: &[&str] = &[
        "",
        " ",
        "\n",
        "\r\n",
        "-",
        "1e999",
        "NaN",
        "inf",
        "1000000000000",
        "\"",
        "'",
        "/",
        ",",
        "\u{fc}",
        "\u{0}",
        "-1",
        "NTwInpSt",
        "---- x ----\n",
        "1e308",
        "999999999999999999999",
    ];
    let mut characters: Vec<char> = text.chars().collect();
    for _ in 0..1 + next(state) % 4 {
        let at = next(state) % characters.len();
        let end = (at + next(state) % 12).min(characters.len());
        let piece = PIECES[next(state) % PIECES.len()];
        characters.splice(at..end, piece.chars());
    }
    characters.into_iter().collect()
}

#[test]
fn damaged_files_give_a_tower_or_a_mistake_in_the_text() {
    let mut state = 20_261_121;
    let (tower, main) = (TOWER.to_owned() + MASSES, main_text(5, &[]));
    for round in 0..2000 {
        let (which, mut companions) = (round % 3, InMemory::default());
        let mut text = |index: usize, text: &str| match index == which {
            true => damaged(text, &mut state),
            false => text.to_owned(),
        };
        let (main, tower, blade) = (text(0, &main), text(1, &tower), text(2, BLADE));
        let mistakes = [
            read_main_file(&source("m", main.as_str()))
                .err()
                .map(|m| (m, &main)),
            read_tower_file(&source("t", tower.as_str()))
                .err()
                .map(|m| (m, &tower)),
            read_blade_file(&source("b", blade.as_str()))
                .err()
                .map(|m| (m, &blade)),
        ];
        for (mistake, text) in mistakes.into_iter().flatten() {
            let holds = text.get(mistake.span.clone()).is_some();
            assert!(holds, "{mistake} in {text}");
        }
        companions.files.insert("tower.dat".into(), tower.clone());
        companions
            .files
            .insert("parts\\blade.dat".into(), blade.clone());
        let deck = read_elastodyn(source("m", main), &companions, &ReadOptions::default());
        if let Ok(deck) = deck {
            // The library may refuse what is left, at a place in one of the files.
            let _ = deck.input.tower();
        }
    }
}
