//! The reader of BModes decks: the main file, then its section file.
#![no_main]

use libfuzzer_sys::fuzz_target;
use towermodes_files::{BmodesInput, Input, ReadOptions, read_bmodes};
use towermodes_fuzz::{companions, look_at_input, source, texts};

fuzz_target!(|bytes: &[u8]| {
    if let Some([main, sections]) = texts(bytes) {
        // Which of the two ways to understand a deck is left to its length, so that each run reads
        // once.
        let options = ReadOptions {
            bmodes_quirks: bytes.len() % 2 == 1,
            ..ReadOptions::default()
        };
        let companions = companions([("secs.dat", sections)]);
        let read = read_bmodes(source("tower.bmi", main), &companions, &options);
        look_at_input(read.map(|input| match input {
            BmodesInput::Tower(tower) => Input::Tower(tower),
            BmodesInput::Blade(blade) => Input::Blade(blade),
        }));
    }
});
