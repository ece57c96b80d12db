//! Tower files of each released version are read by every later one, with the frequencies that
//! they had then. Files and lines of a version are never changed; a new version adds a folder.

use std::path::Path;
use towermodes::{Options, solve};
use towermodes_files::read_tower;

/// The largest relative difference of a frequency: rounding differs between processors, and
/// frequencies of platform motions are small differences of large numbers.
const TOLERANCE: f64 = 1e-8;

#[test]
fn files_of_version_1_0_have_their_frequencies() {
    check("1.0", include_str!("1.0/frequencies.txt"));
}

/// Lines of file, label and frequency; four for each file.
#[track_caller]
fn check(version: &str, expected: &str) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/compatibility");
    let lines: Vec<Vec<&str>> = expected.lines().map(|l| l.split(" | ").collect()).collect();
    for of_file in lines.chunk_by(|a, b| a[0] == b[0]) {
        let file = folder.join(version).join(of_file[0][0]);
        let reading = read_tower(&file).unwrap_or_else(|error| panic!("{error}"));
        let solution = solve(&reading.tower, &Options::default()).expect("a solution");
        for (mode, line) in solution.modes.iter().zip(of_file) {
            let [file, label, frequency_hz] = line[..] else {
                panic!("{line:?}");
            };
            let frequency_hz: f64 = frequency_hz.parse().expect("a number");
            let change = mode.frequency_hz / frequency_hz - 1.0;
            assert_eq!(mode.label().to_string(), label, "{file}");
            assert!(change.abs() < TOLERANCE, "{file}, {label}: {change:e}");
        }
    }
}
