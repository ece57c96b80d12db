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
    #[error("{name}: not a text file (byte {byte} is neither UTF-8 nor Latin-1); save it as UTF-8")]
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
                match latin1(error.as_bytes()) {
                    Some(text) => Ok(Self { name, text }),
                    None => Err(ReadError::NotText { name, byte }),
                }
            }
        }
    }
}

/// The text of bytes in Latin-1, as older programs write degrees and umlauts; none if there are bytes that no text has.
fn latin1(bytes: &[u8]) -> Option<String> {
    let is_text = |byte: &u8| matches!(byte, b'\t' | b'\n' | b'\r' | 0x20..=0x7e | 0xa0..=0xfe);
    let text = || bytes.iter().map(|&byte| char::from(byte)).collect();
    bytes.iter().all(is_text).then(text)
}

/// The bytes of a text that was made of a file with these bytes, in the encoding of that file.
pub fn encoded_as(text: &str, original: &[u8]) -> Vec<u8> {
    if std::str::from_utf8(original).is_ok() {
        return text.as_bytes().to_vec();
    }
    let latin1 = text.chars().map(|c| u8::try_from(u32::from(c)));
    let latin1: Result<Vec<u8>, _> = latin1.collect();
    latin1.unwrap_or_else(|_| text.as_bytes().to_vec())
}

#[cfg(test)]
mod tests {
    use super::{Source, encoded_as};

    #[test]
    fn latin1_comes_back_as_it_was() {
        let bytes = b"87.6 TowerHt - 5\xb0, f\xfcr den Turm\r\n";
        let source = Source::from_reader("deck".into(), &bytes[..]).expect("text");
        assert_eq!(source.text, "87.6 TowerHt - 5\u{b0}, f\u{fc}r den Turm\r\n");
        assert_eq!(encoded_as(&source.text, bytes), bytes);
        assert_eq!(
            encoded_as("\u{fc}", "\u{fc}".as_bytes()),
            "\u{fc}".as_bytes()
        );
        for binary in [&b"\xff\xfe1\0"[..], b"\0\xff", b"\x7f\x80"] {
            assert!(Source::from_reader("deck".into(), binary).is_err());
        }
    }
}
