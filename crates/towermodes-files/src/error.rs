//! Why a file describes no tower.

use std::fmt;

use thiserror::Error;

use crate::diagnostic::Diagnostic;
use crate::source::{FileError, Source};

/// Why a file describes no tower or blade.
///
/// `Display` shows every mistake on its own line, as `file:line:column: problem (suggestion)`. A
/// program with its own format takes the mistakes from [`ReadError::Mistakes`].
#[derive(Debug, Error)]
pub enum ReadError {
    /// The file, or a file that it names, cannot be read.
    #[error(transparent)]
    Unreadable(#[from] FileError),
    /// The file has mistakes.
    #[error("{}", Listed { source_file, mistakes })]
    Mistakes {
        /// The file with the mistakes.
        source_file: Box<Source>,
        /// All mistakes that were found; never empty.
        mistakes: Vec<Diagnostic>,
    },
}

impl ReadError {
    /// The error for one mistake in a file.
    pub fn mistake(source: &Source, mistake: Diagnostic) -> Self {
        Self::mistakes(source, vec![mistake])
    }

    /// Mistakes in a file.
    pub fn mistakes(source: &Source, mistakes: Vec<Diagnostic>) -> Self {
        let source_file = Box::new(source.clone());
        Self::Mistakes {
            source_file,
            mistakes,
        }
    }
}

/// Mistakes with their places, one per line.
struct Listed<'a> {
    source_file: &'a Source,
    mistakes: &'a [Diagnostic],
}

impl fmt::Display for Listed<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Source { name, text } = self.source_file;
        for (index, mistake) in self.mistakes.iter().enumerate() {
            let (line, column) = mistake.line_and_column(text);
            let end = if index == 0 { "" } else { "\n" };
            write!(f, "{end}{name}:{line}:{column}: {mistake}")?;
        }
        Ok(())
    }
}
