//! Getting the text of a file, or a clear reason why not.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use thiserror::Error;

/// Larger files are refused: a tower takes kilobytes, and an endless stream must not fill the memory.
pub const MAX_FILE_BYTES: u64 = 64 << 20;

/// The text of a file and what to call it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// The path as the user gave it, or `<standard input>`.
    pub name: String,
    /// The text.
    pub text: String,
}

/// Why a file has no text.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReadError {
    /// It is not there.
    #[error("{name}: no such file")]
    Missing {
        /// The path.
        name: String,
    },
    /// It is a directory.
    #[error("{name}: is a directory, not a file")]
    Directory {
        /// The path.
        name: String,
    },
    /// It is too large.
    #[error("{name}: larger than {} MiB", MAX_FILE_BYTES >> 20)]
    TooLarge {
        /// The path.
        name: String,
    },
    /// It is not text.
    #[error("{name}: not a text file (byte {byte} is not UTF-8)")]
    NotText {
        /// The path.
        name: String,
        /// Index of the first byte that is not UTF-8.
        byte: usize,
    },
    /// The system refused.
    #[error("{name}: {error}")]
    System {
        /// The path.
        name: String,
        /// What the system says.
        error: io::Error,
    },
}

impl Source {
    /// Reads a file.
    ///
    /// # Errors
    /// [`ReadError`], with the path in its message.
    pub fn from_path(path: &Path) -> Result<Self, ReadError> {
        let name = path.display().to_string();
        if path.is_dir() {
            return Err(ReadError::Directory { name });
        }
        match File::open(path) {
            Ok(file) => Self::from_reader(name, file),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                Err(ReadError::Missing { name })
            }
            Err(error) => Err(ReadError::System { name, error }),
        }
    }

    /// Reads standard input.
    ///
    /// # Errors
    /// [`ReadError`].
    pub fn from_stdin() -> Result<Self, ReadError> {
        Self::from_reader("<standard input>".into(), io::stdin().lock())
    }

    fn from_reader(name: String, reader: impl Read) -> Result<Self, ReadError> {
        let mut bytes = Vec::new();
        if let Err(error) = reader.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes) {
            return Err(ReadError::System { name, error });
        }
        if bytes.len() as u64 > MAX_FILE_BYTES {
            return Err(ReadError::TooLarge { name });
        }
        match String::from_utf8(bytes) {
            Ok(text) => Ok(Self { name, text }),
            Err(error) => {
                let byte = error.utf8_error().valid_up_to();
                Err(ReadError::NotText { name, byte })
            }
        }
    }
}
