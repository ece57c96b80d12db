//! Whether a part is there, whole, and of this sweep.

use std::fs::{self, File};
use std::io::ErrorKind;
use std::path::Path;

use super::csv::{key_name, key_text};
use super::part::PartFormat;
use super::{Parts, PartsError};

/// What a folder has of a part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum State {
    /// No file.
    Missing,
    /// The whole part.
    Done,
    /// A file that is not whole; it is written anew.
    Damaged,
    /// A file of another sweep.
    Foreign(String),
}

impl Parts<'_> {
    /// What the folder has of a part.
    ///
    /// # Errors
    /// [`PartsError::Io`] for a file that cannot be read.
    pub(super) fn state(&self, part: u64) -> Result<State, PartsError> {
        let path = self.path(part);
        match File::open(&path) {
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(State::Missing),
            Err(error) => Err(PartsError::Io { path, error }),
            Ok(file) => match self.format() {
                PartFormat::Csv => self.state_of_csv(part, &path),
                PartFormat::Parquet => Ok(self.state_of_parquet(part, file)),
            },
        }
    }

    /// By the hidden file beside it.
    fn state_of_csv(&self, part: u64, path: &Path) -> Result<State, PartsError> {
        let hidden = self.folder().join(key_name(&self.name(part)));
        let Ok(found) = fs::read_to_string(&hidden) else {
            return Ok(State::Damaged);
        };
        if let Some(foreign) = foreign(found.split(' ').next(), self.key()) {
            return Ok(foreign);
        }
        let content = fs::read(path).map_err(PartsError::io(path))?;
        match found == key_text(self.key(), part, &content) {
            true => Ok(State::Done),
            false => Ok(State::Damaged),
        }
    }

    /// By its footer.
    #[cfg(feature = "parquet")]
    fn state_of_parquet(&self, part: u64, file: File) -> State {
        let Ok(footer) = super::parquet::footer(file) else {
            return State::Damaged;
        };
        let key = footer.key.as_ref().map(|(key, _)| key.as_str());
        if let Some(foreign) = foreign(key, self.key()) {
            return foreign;
        }
        let rows = self.rows_of(part);
        let is_this = footer.key.is_some_and(|(_, number)| number == part);
        match is_this && u64::try_from(footer.rows) == Ok(rows.end - rows.start) {
            true => State::Done,
            false => State::Damaged,
        }
    }

    #[cfg(not(feature = "parquet"))]
    fn state_of_parquet(&self, _: u64, _: File) -> State {
        State::Damaged
    }
}

/// The state of a file with another key, or without one.
fn foreign(found: Option<&str>, key: &str) -> Option<State> {
    match found {
        Some(found) if found == key => None,
        Some(_) => Some(State::Foreign("it has the key of another sweep".to_owned())),
        None => Some(State::Foreign("it has no key of a sweep".to_owned())),
    }
}
