//! The reader of towermodes' own files.
#![no_main]

use libfuzzer_sys::fuzz_target;
use towermodes_files::{InMemory, ReadOptions, read_source};
use towermodes_fuzz::{look_at_input, source, texts};

fuzz_target!(|bytes: &[u8]| {
    if let Some([text]) = texts(bytes) {
        let source = source("tower.toml", text);
        look_at_input(read_source(
            source,
            &InMemory::default(),
            &ReadOptions::default(),
        ));
    }
});
