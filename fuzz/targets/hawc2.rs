//! The reader of HAWC2's structural files.
#![no_main]

use libfuzzer_sys::fuzz_target;
use towermodes_files::{ReadOptions, read_hawc2};
use towermodes_fuzz::{look_at_tower, source, texts};

fuzz_target!(|bytes: &[u8]| {
    if let Some([text]) = texts(bytes) {
        // Which subset is read is left to the file's length, so that each run reads once.
        let options = ReadOptions {
            hawc2_subset: (bytes.len() % 2 == 1).then_some((1, 2)),
            ..ReadOptions::default()
        };
        look_at_tower(read_hawc2(source("tower_st.dat", text), &options));
    }
});
