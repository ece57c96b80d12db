//! The file of a table: its format, its digest, and the check that it has not changed.

use std::fs::{self, File, Metadata};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::{Mutex, MutexGuard};
use std::time::SystemTime;

use super::error::TableProblem;
use crate::digest::Digest;
use crate::rows::threads::lock;

/// The format of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Csv,
    Parquet,
}

/// An open table.
#[derive(Debug)]
pub(super) struct TableFile {
    name: String,
    kind: Kind,
    file: Mutex<File>,
    /// Length and modification time at the time of opening.
    state: State,
    digest: String,
}

type State = (u64, Option<SystemTime>);

fn state(metadata: &Metadata) -> State {
    (metadata.len(), metadata.modified().ok())
}

/// Formats that are often given instead of a table: their first bytes, their names, and what to do.
const OTHERS: [(&[u8], &str, &str); 5] = [
    (b"ARROW1", "an Arrow file", "save it as Parquet"),
    (
        b"PK\x03\x04",
        "a spreadsheet or a ZIP archive",
        "save the sheet as CSV",
    ),
    (b"\x1f\x8b", "compressed with gzip", "decompress it first"),
    (
        b"\x28\xb5\x2f\xfd",
        "compressed with Zstandard",
        "decompress it first",
    ),
    (
        b"\x89HDF",
        "an HDF5 file",
        "save the table as CSV or Parquet",
    ),
];

impl TableFile {
    /// Opens a file and recognizes its format by its first bytes.
    pub(super) fn open(path: &Path) -> Result<Self, TableProblem> {
        // To open a named pipe waits for a writer.
        if !fs::metadata(path)?.is_file() {
            return Err(TableProblem::NotAFile);
        }
        let mut file = File::open(path)?;
        let metadata = file.metadata()?;
        let mut start = Vec::new();
        file.by_ref().take(8).read_to_end(&mut start)?;
        if let Some((_, kind, remedy)) = OTHERS.iter().find(|(bytes, ..)| start.starts_with(bytes))
        {
            return Err(TableProblem::OtherFormat { kind, remedy });
        }
        Ok(Self {
            name: path.display().to_string(),
            kind: match start.starts_with(b"PAR1") {
                true => Kind::Parquet,
                false => Kind::Csv,
            },
            file: Mutex::new(file),
            state: state(&metadata),
            digest: String::new(),
        })
    }

    pub(super) fn name(&self) -> &str {
        &self.name
    }

    pub(super) fn kind(&self) -> Kind {
        self.kind
    }

    pub(super) fn digest(&self) -> &str {
        &self.digest
    }

    /// The file, for one reader at a time.
    pub(super) fn lock(&self) -> MutexGuard<'_, File> {
        lock(&self.file)
    }

    /// Reads the whole file through a reader, and keeps the digest of what was read.
    pub(super) fn read_through<T>(
        &mut self,
        read: impl FnOnce(&mut dyn Read) -> Result<T, TableProblem>,
    ) -> Result<T, TableProblem> {
        let file = self.file.get_mut().unwrap_or_else(|e| e.into_inner());
        file.seek(SeekFrom::Start(0))?;
        let mut digesting = Digesting {
            file,
            digest: Digest::default(),
        };
        let result = read(&mut digesting)?;
        io::copy(&mut digesting, &mut io::sink())?;
        self.digest = digesting.digest.hexadecimal();
        self.check_unchanged()?;
        Ok(result)
    }

    /// Refuses a file that was changed since it was opened.
    pub(super) fn check_unchanged(&self) -> Result<(), TableProblem> {
        match state(&self.lock().metadata()?) == self.state {
            true => Ok(()),
            false => Err(TableProblem::Changed),
        }
    }
}

/// A file whose bytes are digested as they are read.
struct Digesting<'a> {
    file: &'a mut File,
    digest: Digest,
}

impl Read for Digesting<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.file.read(buffer)?;
        self.digest.add(&buffer[..count]);
        Ok(count)
    }
}
