//! The text of a file, or the reason why it cannot be read.

use std::fs::{File, FileType, Metadata};
use std::io::{self, Read};
use std::path::Path;

use thiserror::Error;

/// Larger files are refused: a tower takes kilobytes, and an endless stream must not fill the
/// memory.
pub const MAX_FILE_BYTES: u64 = 64 << 20;

/// The beginning of a pointer to a file that is stored elsewhere, what stores the file, and how to
/// get it.
const POINTERS: [(&str, &str, &str); 2] = [
    (
        "version https://git-lfs.github.com/spec/",
        "Git LFS",
        "run `git lfs pull` in the repository it is from",
    ),
    ("/annex/objects/", "git-annex", "run `git annex get` for it"),
];

/// The first bytes of workbooks of spreadsheets: of `xlsx` and `ods`, which are archives in ZIP,
/// and of `xls`.
const WORKBOOKS: [&[u8]; 2] = [b"PK\x03\x04", b"\xd0\xcf\x11\xe0"];

/// The text of a file and its name.
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
pub enum FileError {
    /// It does not exist.
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
    /// It is a pipe, a socket or a device, whose reading might never end.
    #[error("{name}: is {kind}, not a regular file")]
    Special {
        /// The path.
        name: String,
        /// Its kind: `a named pipe`, `a socket` or `a device`.
        kind: &'static str,
    },
    /// It is too large.
    #[error("{name}: larger than {} MiB, more than any tower needs", MAX_FILE_BYTES >> 20)]
    TooLarge {
        /// The path.
        name: String,
    },
    /// It is a pointer to a file that is stored elsewhere.
    #[error("{name}: this is a {system} pointer, not the file itself; {remedy}")]
    Pointer {
        /// The path.
        name: String,
        /// The system that stores the file: `Git LFS` or `git-annex`.
        system: &'static str,
        /// How the user can get the file.
        remedy: &'static str,
    },
    /// It is a workbook of a spreadsheet.
    #[error(
        "{name}: this is an Excel workbook or an archive, not a text file; save the sheet as CSV"
    )]
    Workbook {
        /// The path.
        name: String,
    },
    /// It is a web page, as saved from a repository viewer.
    #[error("{name}: this is a web page (HTML), not the file itself; download the raw file")]
    WebPage {
        /// The path.
        name: String,
    },
    /// It is not text.
    #[error(
        "{name}: not a text file (the byte at offset {byte} is not a character in UTF-8 or Latin-1); save it as UTF-8"
    )]
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
        /// The error of the system.
        error: io::Error,
    },
}

impl Source {
    /// File and line of a byte, for messages: `design.toml:7`.
    pub fn place(&self, byte: usize) -> String {
        let before = self.text.get(..byte).unwrap_or(&self.text);
        let line = 1 + before.matches('\n').count();
        format!("{}:{line}", self.name)
    }

    /// Reads the file that a user named: a regular file, or a descriptor that is already open, such
    /// as `/dev/stdin` or the `/dev/fd/63` of a shell.
    ///
    /// # Errors
    /// [`FileError`], with the path in its message.
    pub fn from_path(path: &Path) -> Result<Self, FileError> {
        match is_open_descriptor(path) {
            true => Self::open(path),
            false => Self::from_regular_file(path),
        }
    }

    /// Reads a file that another file names: only a regular file, because reading from a pipe might
    /// never end.
    ///
    /// # Errors
    /// [`FileError`], with the path in its message.
    pub fn from_regular_file(path: &Path) -> Result<Self, FileError> {
        if let Ok(metadata) = path.metadata() {
            check_kind(path, &metadata)?;
        }
        Self::open(path)
    }

    fn open(path: &Path) -> Result<Self, FileError> {
        let name = path.display().to_string();
        match File::open(path) {
            Ok(file) => Self::from_reader(name, file),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                Err(FileError::Missing { name })
            }
            Err(error) => Err(FileError::System { name, error }),
        }
    }

    /// Reads standard input.
    ///
    /// # Errors
    /// [`FileError`].
    pub fn from_stdin() -> Result<Self, FileError> {
        Self::from_reader("<standard input>".into(), io::stdin().lock())
    }

    fn from_reader(name: String, reader: impl Read) -> Result<Self, FileError> {
        let mut bytes = Vec::new();
        if let Err(error) = reader.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes) {
            return Err(FileError::System { name, error });
        }
        Self::from_bytes(name, bytes)
    }

    /// The text of a file whose bytes are known, in UTF-8, Latin-1, or UTF-16 with a mark.
    ///
    /// # Errors
    /// [`FileError`].
    pub fn from_bytes(name: String, bytes: Vec<u8>) -> Result<Self, FileError> {
        if bytes.len() as u64 > MAX_FILE_BYTES {
            return Err(FileError::TooLarge { name });
        }
        if WORKBOOKS.iter().any(|mark| bytes.starts_with(mark)) {
            return Err(FileError::Workbook { name });
        }
        let text = match String::from_utf8(bytes) {
            Ok(text) => text,
            Err(error) => {
                let byte = error.utf8_error().valid_up_to();
                let bytes = error.as_bytes();
                match utf16(bytes).or_else(|| latin1(bytes)) {
                    Some(text) => text,
                    None => return Err(FileError::NotText { name, byte }),
                }
            }
        };
        let text = with_line_feeds(text);
        let source = Self { name, text };
        source.check_is_itself()?;
        Ok(source)
    }

    /// Refuses pointers of Git LFS and git-annex, and web pages.
    ///
    /// # Errors
    /// [`FileError::Pointer`], [`FileError::WebPage`].
    pub(crate) fn check_is_itself(&self) -> Result<(), FileError> {
        let name = self.name.clone();
        let start = self.text.trim_start_matches('\u{feff}').trim_start();
        let mut pointers = POINTERS.into_iter();
        if let Some((_, system, remedy)) = pointers.find(|(mark, ..)| start.starts_with(mark)) {
            return Err(FileError::Pointer {
                name,
                system,
                remedy,
            });
        }
        let is_page = |mark: &str| {
            let head = start.get(..mark.len());
            head.is_some_and(|head| head.eq_ignore_ascii_case(mark))
        };
        if is_page("<!doctype html") || is_page("<html") {
            return Err(FileError::WebPage { name });
        }
        Ok(())
    }
}

/// Whether a path names a descriptor that the program has open already, so that opening it does not
/// wait.
fn is_open_descriptor(path: &Path) -> bool {
    let folders = ["/dev/fd", "/proc/self/fd"];
    path == Path::new("/dev/stdin") || folders.iter().any(|folder| path.starts_with(folder))
}

/// Refuses a file that is not regular or too large, before it is opened.
fn check_kind(path: &Path, metadata: &Metadata) -> Result<(), FileError> {
    let name = path.display().to_string();
    if metadata.is_dir() {
        return Err(FileError::Directory { name });
    }
    if let Some(kind) = special(metadata.file_type()) {
        return Err(FileError::Special { name, kind });
    }
    if metadata.len() > MAX_FILE_BYTES {
        return Err(FileError::TooLarge { name });
    }
    Ok(())
}

/// The kind of a file that is neither regular nor a directory.
#[cfg(unix)]
fn special(kind: FileType) -> Option<&'static str> {
    use std::os::unix::fs::FileTypeExt;
    let is_device = kind.is_block_device() || kind.is_char_device();
    match (kind.is_fifo(), kind.is_socket(), is_device) {
        (true, ..) => Some("a named pipe"),
        (_, true, _) => Some("a socket"),
        (.., true) => Some("a device"),
        _ => None,
    }
}

/// The kind of a file that is neither regular nor a directory.
#[cfg(not(unix))]
fn special(kind: FileType) -> Option<&'static str> {
    (!kind.is_file()).then_some("a device")
}

/// The text of bytes in Latin-1, which older programs write; none if some bytes are not text.
fn latin1(bytes: &[u8]) -> Option<String> {
    let is_text = |byte: &u8| matches!(byte, b'\t' | b'\n' | b'\r' | 0x20..=0x7e | 0xa0..=0xfe);
    let text = || bytes.iter().map(|&byte| char::from(byte)).collect();
    bytes.iter().all(is_text).then(text)
}

/// The text of bytes in UTF-16, which some shells of Windows write, with a byte order mark.
fn utf16(bytes: &[u8]) -> Option<String> {
    let (mark, rest) = bytes.split_first_chunk::<2>()?;
    let unit: fn([u8; 2]) -> u16 = match mark {
        [0xff, 0xfe] => u16::from_le_bytes,
        [0xfe, 0xff] => u16::from_be_bytes,
        _ => return None,
    };
    let (pairs, odd) = rest.as_chunks::<2>();
    let units: Vec<u16> = pairs.iter().map(|pair| unit(*pair)).collect();
    let text = String::from_utf16(&units).ok();
    text.filter(|text| odd.is_empty() && !text.contains('\0'))
}

/// A text whose lines end in a carriage return alone, with line feeds in their place.
fn with_line_feeds(text: String) -> String {
    match text.contains('\r') && !text.contains('\n') {
        true => text.replace('\r', "\n"),
        false => text,
    }
}

/// The bytes of a text that was made of a file with these bytes, in the encoding of that file.
pub fn encoded_as(text: &str, original: &[u8]) -> Vec<u8> {
    if std::str::from_utf8(original).is_ok() {
        return text.as_bytes().to_vec();
    }
    if utf16(original).is_some() {
        let is_little = original.starts_with(&[0xff, 0xfe]);
        let units = std::iter::once(0xfeff).chain(text.encode_utf16());
        let pairs = units.map(|unit: u16| match is_little {
            true => unit.to_le_bytes(),
            false => unit.to_be_bytes(),
        });
        return pairs.flatten().collect();
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
        for binary in [
            &b"\xff\xfe1\0x"[..],
            b"\xff\xfe\0\0",
            b"\0\xff",
            b"\x7f\x80",
        ] {
            assert!(Source::from_reader("deck".into(), binary).is_err());
        }
    }

    #[test]
    fn other_encodings_and_line_ends_are_read() {
        let text = |bytes: &[u8]| {
            Source::from_reader("deck".into(), bytes)
                .expect("text")
                .text
        };
        assert_eq!(text(b"\xff\xfe1\0\r\0\n\0\xb0\0"), "1\r\n\u{b0}");
        assert_eq!(text(b"\xfe\xff\0\x31\0\n"), "1\n");
        for bytes in [&b"\xff\xfe1\0\xb0\0"[..], b"\xfe\xff\0\x31\0\n"] {
            assert_eq!(encoded_as(&text(bytes), bytes), bytes);
        }
        assert_eq!(text(b"1 NumBl\r2 x\r"), "1 NumBl\n2 x\n");
        assert_eq!(text(b"1\r\n2\r3\n"), "1\r\n2\r3\n");
    }

    #[test]
    fn pointers_and_web_pages_are_refused() {
        let refusal = |text: &str| {
            let source = Source::from_reader("Tower.dat".into(), text.as_bytes());
            source
                .err()
                .map(|error| error.to_string())
                .unwrap_or_default()
        };
        let pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";
        assert!(refusal(pointer).contains("Tower.dat: this is a Git LFS pointer"));
        assert!(refusal(pointer).contains("`git lfs pull`"));
        assert!(refusal("/annex/objects/SHA256E-s100--ab.dat\n").contains("git-annex pointer"));
        assert!(refusal("PK\u{3}\u{4}\u{14}\0").contains("Tower.dat: this is an Excel workbook"));
        assert!(refusal("PK 1\n").is_empty());
        assert!(refusal("\n<!DOCTYPE HTML>\n<html lang=\"en\">").contains("a web page"));
        for file in [
            "version 1\n",
            "# https://git-lfs.github.com/spec/\n",
            "<h\n",
        ] {
            assert_eq!(refusal(file), "", "{file}");
        }
    }
}
