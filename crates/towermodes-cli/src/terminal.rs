//! The width of the terminal.

use std::path::Path;

/// Columns of text in a file or a pipe.
pub(crate) const WIDTH_OF_FILES: usize = 100;

/// Columns of the terminal, or of a file if standard output is not a terminal.
fn width() -> usize {
    let size = terminal_size::terminal_size_of(std::io::stdout());
    size.map_or(WIDTH_OF_FILES, |(width, _)| usize::from(width.0))
}

/// Stands for a character that a terminal would obey instead of showing it.
pub(crate) const NOT_SHOWN: char = '\u{fffd}';

/// Columns of a text that is written to a file, or to standard output.
pub(crate) fn width_of(output: Option<&Path>) -> usize {
    output.map_or_else(width, |_| WIDTH_OF_FILES)
}
