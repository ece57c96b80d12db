//! Whether a part is there, whole, and of this sweep.

use std::collections::HashMap;
use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::sync::Mutex;
use std::time::SystemTime;

use super::csv::key_text;
use super::names::key_name;
use super::part::PartFormat;
use super::{Parts, PartsError};
use crate::digest::Digest;
use crate::threads::lock;

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

/// The parts in CSV whose digest was right: the text of the key file, and length and time of the
/// part then. As long as they are the same, the part is not read again.
#[derive(Debug, Default)]
pub(super) struct Verified(Mutex<HashMap<u64, Stamp>>);

type Stamp = (String, u64, Option<SystemTime>);

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
                PartFormat::Csv => self.state_of_csv(part, file),
                PartFormat::Parquet => Ok(self.state_of_parquet(part, file)),
            },
        }
    }

    /// By the key file beside it.
    fn state_of_csv(&self, part: u64, mut file: File) -> Result<State, PartsError> {
        let Some(found) = self.key_text_of(&self.name(part))? else {
            return Ok(State::Damaged);
        };
        if let Some(foreign) = foreign(found.split(' ').next(), self.key()) {
            return Ok(foreign);
        }
        let path = self.path(part);
        let metadata = file.metadata().map_err(PartsError::io(&path))?;
        let stamp = (found, metadata.len(), metadata.modified().ok());
        if lock(&self.verified.0).get(&part) == Some(&stamp) {
            return Ok(State::Done);
        }
        let mut digest = Digest::default();
        io::copy(&mut file, &mut digest).map_err(PartsError::io(&path))?;
        if stamp.0 != key_text(self.key(), part, &digest.hexadecimal()) {
            return Ok(State::Damaged);
        }
        lock(&self.verified.0).insert(part, stamp);
        Ok(State::Done)
    }

    /// The text of the key file of a part in CSV, if there is one.
    fn key_text_of(&self, name: &str) -> Result<Option<String>, PartsError> {
        let path = self.folder().join(key_name(name));
        match fs::read(&path) {
            Ok(bytes) => Ok(Some(String::from_utf8_lossy(&bytes).into_owned())),
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
            Err(error) => Err(PartsError::Io { path, error }),
        }
    }

    /// The key of the sweep that wrote a file, if a sweep did.
    pub(super) fn key_of(&self, name: &str) -> Result<Option<String>, PartsError> {
        if !name.ends_with(".csv") {
            let path = self.folder().join(name);
            return File::open(&path)
                .map(key_of_parquet)
                .map_err(PartsError::io(path));
        }
        let text = self.key_text_of(name)?;
        Ok(text.and_then(|text| Some(text.split(' ').next()?.to_owned())))
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

/// The key in the footer of a file.
#[cfg(feature = "parquet")]
fn key_of_parquet(file: File) -> Option<String> {
    let (key, _) = super::parquet::footer(file).ok()?.key?;
    Some(key)
}

#[cfg(not(feature = "parquet"))]
fn key_of_parquet(_: File) -> Option<String> {
    None
}

/// The state of a file with another key, or without one.
fn foreign(found: Option<&str>, key: &str) -> Option<State> {
    match found {
        Some(found) if found == key => None,
        Some(_) => Some(State::Foreign("it has the key of another sweep".to_owned())),
        None => Some(State::Foreign("it has no key of a sweep".to_owned())),
    }
}
