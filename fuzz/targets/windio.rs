//! The reader of turbines in windIO.
#![no_main]

use libfuzzer_sys::fuzz_target;
use towermodes_files::{ReadOptions, TowerPart, read_windio};
use towermodes_fuzz::{look_at_tower, source, texts};

fuzz_target!(|bytes: &[u8]| {
    if let Some([text]) = texts(bytes) {
        // Which part is read is left to the file's length, so that each run reads once.
        let options = ReadOptions {
            part: [TowerPart::All, TowerPart::Tower, TowerPart::Monopile][bytes.len() % 3],
            ..ReadOptions::default()
        };
        look_at_tower(read_windio(source("turbine.yaml", text), &options));
    }
});
