//! How wide the terminal is.

/// Columns of what goes to a file or a pipe.
pub(crate) const WIDTH_OF_FILES: usize = 100;

/// Columns of the terminal that standard output is, or of a file if it is none.
pub(crate) fn width() -> usize {
    let size = terminal_size::terminal_size_of(std::io::stdout());
    size.map_or(WIDTH_OF_FILES, |(width, _)| usize::from(width.0))
}

/// Stands for a character that a terminal would obey instead of showing it.
pub(crate) const NOT_SHOWN: char = '\u{fffd}';
