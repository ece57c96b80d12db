//! The reader of the study of a sweep, and the names of its numbers in a tower.
#![no_main]

use libfuzzer_sys::fuzz_target;
use towermodes_files::{description_from_toml, read_sweep_study};
use towermodes_fuzz::{look_at_error, source, texts};

/// The tower that the studies vary.
const TOWER: &str = include_str!("../../examples/monopile.toml");

fuzz_target!(|bytes: &[u8]| {
    let Some([text]) = texts(bytes) else { return };
    match read_sweep_study(&source("study.toml", text)) {
        Ok(study) => {
            let tower = description_from_toml(TOWER).expect("the example");
            if let Err(error) = study.changes(&tower) {
                look_at_error(&error);
            }
        }
        Err(error) => look_at_error(&error),
    }
});
