//! The reader of towermodes' own files, with a table of stations in CSV beside them.
#![no_main]

use libfuzzer_sys::fuzz_target;
use towermodes_files::{ReadOptions, read_source};
use towermodes_fuzz::{companions, look_at_input, source, texts};

fuzz_target!(|bytes: &[u8]| {
    if let Some([text, table]) = texts(bytes) {
        let source = source("tower.toml", text);
        let beside = companions([("cans.csv", table)]);
        look_at_input(read_source(source, &beside, &ReadOptions::default()));
    }
});
