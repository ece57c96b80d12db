//! Files of other programs, if they are at hand: `TOWERMODES_PEER_DATA` is the folder with them.

use std::path::{Path, PathBuf};

use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use towermodes_files::{FileFormat, ReadOptions, SiblingFiles, Source, recognize};
use towermodes_testing::with;

use crate::damaged_files::damage::any_damages;
use crate::damaged_files::{Where, survives};

/// Files above this take long to read, and are damaged less often.
const LARGE_BYTES: usize = 50_000;
const CASES: u32 = 150;
const CASES_OF_LARGE: u32 = 12;

/// All files of a folder and the folders in it, in the order of their names.
fn files_in(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut paths: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry of the folder").path())
        .collect();
    paths.sort();
    let below = |path: PathBuf| match path.is_dir() {
        true => files_in(&path),
        false => vec![path],
    };
    paths.into_iter().flat_map(below).collect()
}

/// A file of the folder that describes a tower, and its format.
fn described(path: &Path) -> Option<(Source, FileFormat)> {
    let source = Source::from_path(path).ok()?;
    let format = recognize(&source)?;
    Some((source, format))
}

fn damage(path: &Path, source: &Source) {
    let cases = match source.text.len() > LARGE_BYTES {
        true => CASES_OF_LARGE,
        false => CASES,
    };
    let config = with!(ProptestConfig, cases, failure_persistence = None);
    let companions = SiblingFiles::of(path);
    let options = with!(ReadOptions, tower_height_m = Some(90.0));
    let place = prop::sample::select(vec![Where::Main, Where::Companions]);
    let result = TestRunner::new(config).run(&(place, any_damages()), |(place, damages)| {
        survives(source, &companions, place, &damages, &options)
    });
    if let Err(error) = result {
        panic!("{}: {error}", path.display());
    }
}

#[test]
fn damaged_peer_files_are_read_or_refused() {
    let Some(folder) = std::env::var_os("TOWERMODES_PEER_DATA") else {
        eprintln!("skipped: TOWERMODES_PEER_DATA is not set");
        return;
    };
    let mut formats = Vec::new();
    for path in files_in(Path::new(&folder)) {
        if let Some((source, format)) = described(&path) {
            damage(&path, &source);
            formats.push(format);
        }
    }
    for format in [
        FileFormat::Bmodes,
        FileFormat::ElastoDyn,
        FileFormat::ElastoDynTower,
        FileFormat::WindIo,
        FileFormat::Hawc2,
    ] {
        assert!(formats.contains(&format), "no file of {}", format.name());
    }
}
