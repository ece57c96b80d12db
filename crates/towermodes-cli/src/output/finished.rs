//! A finished result: a text for readers or data for programs.

use std::io::IsTerminal;
use std::path::Path;

use towermodes_files::ResultError;
use towermodes_report::wording::printable;

use super::verdicts::coloured;
use super::{deliver, write};
use crate::failure::Failure;
use crate::table::fitted;
use crate::terminal::{NOT_SHOWN, width_of};

/// A result in the format of the command.
pub(crate) enum Finished {
    /// Tables and sentences. On a terminal they are as wide as it is, with verdicts in colour.
    Text(String),
    /// Data, which are the same everywhere.
    Data(Vec<u8>),
}

impl Finished {
    /// Data that a function writes.
    pub(crate) fn data(
        write: impl FnOnce(&mut Vec<u8>) -> Result<(), ResultError>,
    ) -> Result<Self, Failure> {
        let mut data = Vec::new();
        write(&mut data)?;
        Ok(Self::Data(data))
    }

    /// Writes the result to a file or to standard output.
    pub(crate) fn deliver(&self, output: Option<&Path>) -> Result<(), Failure> {
        match self {
            Self::Text(text) if output.is_none() && std::io::stdout().is_terminal() => {
                let text = fitted(&printable(text, NOT_SHOWN), width_of(None));
                write(coloured(&text).as_bytes(), None, anstream::stdout().lock())
            }
            Self::Text(text) => deliver(text.as_bytes(), output),
            Self::Data(data) => deliver(data, output),
        }
    }
}
