//! Where towers come from.

use std::path::Path;

use towermodes::Tower;
use towermodes_files::{Source, tower_from_toml};

use crate::failure::Failure;

/// Reads the tower from a file, or from standard input.
pub(crate) fn tower(file: &Path) -> Result<Tower, Failure> {
    let source = if file == Path::new("-") {
        Source::from_stdin()
    } else {
        Source::from_path(file)
    };
    let source = source.map_err(Failure::Unreadable)?;
    tower_from_toml(&source.text).map_err(|mistakes| Failure::Mistakes(source, mistakes))
}
