//! No damaged file makes the reader or the solver panic, and what is refused has a place inside its
//! file.

use proptest::prelude::*;
use towermodes::frame::{FrameOptions, FrameRecipe, solve_frame};
use towermodes_files::{Interface, ReadError};

use super::texts::{SOIL, deck, read_with};
use crate::mutations::{any_mutation, mutated};

pub fn texts() -> [String; 3] {
    let jacket = deck(&[
        (
            "NJoints",
            "1 -5 0 -20 1 0 0 0 0\n2 0 1 -10 4 0 0 0 1e8\n3 0 0 0 1 0 0 0 0\n4 4 3 -20 1 0 0 0 0",
        ),
        ("NReact", "1 0 0 0 0 0 0 \"ssi.txt\"\n4 1 1 1 1 1 1 \"\""),
        (
            "NMembers",
            "1 1 2 1 1 1c 0\n2 2 3 1 1 1r 30\n3 4 2 1 1 2 -1\n4 1 4 1 1 3 -1\n5 1 3 1 1 5 -1",
        ),
        ("NPropSetsRec", "1 2.1e11 8.08e10 7850 2.0 1.2 0.03"),
        ("NCablePropSets", "1 1e8 20 2e6 0"),
        ("NRigidPropSets", "1 500"),
        (
            "NSpringPropSets",
            "1 3e7 0 0 0 1e7 0 4e7 0 0 0 0 5e7 0 0 0 2e8 0 0 1e8 0 3e8",
        ),
        ("NCmass", "3 8e3 1e4 2e4 3e4 0 0 0 3 1 1"),
    ]);
    let given = deck(&[
        ("NMembers", "1 1 2 1 1 4 7\n2 2 3 1 1 4 7"),
        (
            "NXPropSets",
            "1 2.1e11 8.08e10 7850 2.4 2 2 0.29 0.8 1.09 0.9",
        ),
        ("NCOSMs", "7 0 1 0 -1 0 0 0 0 1"),
    ]);
    [deck(&[]), jacket, given.replace("MSpin/", "")]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, ..ProptestConfig::default() })]

    #[test]
    fn damaged_files_are_solved_or_refused(
        file in 0..4_usize,
        mutations in prop::collection::vec(any_mutation(), 1..4),
    ) {
        let all = texts();
        let damaged = |text: &str| mutations.iter().fold(text.to_owned(), |text, m| mutated(&text, m));
        let (text, soil) = match all.get(file) {
            Some(text) => (damaged(text), SOIL.to_owned()),
            None => (all[1].clone(), damaged(SOIL)),
        };
        match read_with(&text, &soil) {
            Ok(input) => {
                let recipe = Some(FrameRecipe::Spectral { degree: 4 });
                let options = FrameOptions { modes: 4, recipe, ..FrameOptions::default() };
                let frame = input.frame(Interface::Free);
                prop_assert!(frame.is_ok());
                if let Ok(solution) = frame.map(|frame| solve_frame(&frame, &options)).expect("a frame") {
                    let is_number = |hz: f64| hz.is_finite() && hz >= 0.0;
                    prop_assert!(solution.modes.iter().all(|mode| is_number(mode.frequency_hz)));
                }
            }
            Err(ReadError::Mistakes { source_file, mistakes }) => {
                prop_assert!(!mistakes.is_empty());
                for mistake in mistakes {
                    prop_assert!(mistake.span.start <= mistake.span.end);
                    prop_assert!(mistake.span.end <= source_file.text.len());
                }
            }
            Err(ReadError::Unreadable(_)) => {}
        }
    }
}
