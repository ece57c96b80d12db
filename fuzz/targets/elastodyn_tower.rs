//! The reader of ElastoDyn's tower files alone.
#![no_main]

use libfuzzer_sys::fuzz_target;
use towermodes_files::ReadOptions;
use towermodes_files::elastodyn::read_elastodyn_tower;
use towermodes_fuzz::{look_at_tower, source, texts};

fuzz_target!(|bytes: &[u8]| {
    if let Some([text]) = texts(bytes) {
        // Whether the height is given or must stand in the file is left to its length, so that each
        // run reads once.
        let options = ReadOptions {
            tower_height_m: (bytes.len() % 2 == 1).then_some(90.0),
            ..ReadOptions::default()
        };
        look_at_tower(read_elastodyn_tower(source("tower.dat", text), &options));
    }
});
