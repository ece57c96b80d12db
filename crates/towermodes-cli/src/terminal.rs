//! The width of the terminal.

use std::path::Path;

/// Number of columns of text in a file or a pipe.
pub(crate) const WIDTH_OF_FILES: usize = 100;

/// Number of columns of the terminal, or of a file if standard output is not a terminal.
fn width() -> usize {
    let size = terminal_size::terminal_size_of(std::io::stdout());
    size.map_or(WIDTH_OF_FILES, |(width, _)| usize::from(width.0))
}

/// Replaces a control character, which a terminal would execute instead of showing it.
pub(crate) const NOT_SHOWN: char = '\u{fffd}';

/// Number of columns of a text that is written to a file, or to standard output.
pub(crate) fn width_of(output: Option<&Path>) -> usize {
    output.map_or_else(width, |_| WIDTH_OF_FILES)
}
