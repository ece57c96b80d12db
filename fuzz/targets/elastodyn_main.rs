//! The reader of ElastoDyn models: the main file, then the tower file, then the blade file.
#![no_main]

use libfuzzer_sys::fuzz_target;
use towermodes_files::ReadOptions;
use towermodes_files::elastodyn::read_elastodyn;
use towermodes_fuzz::{companions, look_at_tower, source, texts};

fuzz_target!(|bytes: &[u8]| {
    if let Some([main, tower, blade]) = texts(bytes) {
        let companions = companions([("tower.dat", tower), ("blade.dat", blade)]);
        let read = read_elastodyn(
            source("main.dat", main),
            &companions,
            &ReadOptions::default(),
        );
        look_at_tower(read.map(|deck| deck.input));
    }
});
