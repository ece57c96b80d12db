//! The solutions of several files as one JSON list and one CSV table.

use std::io::Write;

use serde::Serialize;
use towermodes::{Solution, Tower};

use super::solution::SolutionDocument;
use super::solution_csv::{header, records};
use super::{ResultError, write_result_json};
use crate::input::Note;

/// The solution of the tower of one of several files.
#[derive(Debug, Clone, Copy)]
pub struct SolvedFile<'a> {
    /// The path of the file.
    pub file: &'a str,
    /// Its tower.
    pub tower: &'a Tower,
    /// The solution of this tower.
    pub solution: &'a Solution,
    /// The notes of the reader.
    pub notes: &'a [Note],
}

/// The result of `towermodes solve` for several files: their solutions in the order of the command
/// line. Files that failed are not in the list.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct SeveralDocument<'a>(Vec<FileDocument<'a>>);

/// The solution of one file: the keys of the result of `solve` for this file, and `file`.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct FileDocument<'a> {
    /// The path of the file.
    file: &'a str,
    #[serde(flatten)]
    solution: SolutionDocument<'a>,
}

impl<'a> FileDocument<'a> {
    fn of(solved: &SolvedFile<'a>) -> Self {
        Self {
            file: solved.file,
            solution: SolutionDocument::of(solved.tower, solved.solution, solved.notes),
        }
    }
}

/// Writes the solutions of several files as one indented JSON list with a newline at the end.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_several_json(files: &[SolvedFile<'_>], writer: impl Write) -> Result<(), ResultError> {
    let documents = files.iter().map(FileDocument::of).collect();
    write_result_json(&SeveralDocument(documents), writer)
}

/// Writes the modes of several files as one CSV table: the columns of the result of one file after
/// the column `file`.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_several_csv(files: &[SolvedFile<'_>], writer: impl Write) -> Result<(), ResultError> {
    let mut csv = ::csv::Writer::from_writer(writer);
    csv.write_record(std::iter::once("file").chain(header()))?;
    for solved in files {
        for record in records(solved.solution) {
            csv.write_field(solved.file)?;
            csv.write_record(record)?;
        }
    }
    csv.flush()?;
    Ok(())
}
