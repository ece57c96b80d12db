//! Reads the file of a slice.

use std::fs::File;
use std::io::{BufRead, BufReader, Read, Seek};
use std::ops::Range;
use std::path::Path;

use super::SliceError;
use super::column::Column;
use super::csv;
use super::header::Header;
use crate::rows::results::Results;
use crate::sweep::Sweep;

/// Number of rows of a CSV that are read at a time.
const BLOCK_ROWS: u64 = 16_384;
/// Largest length of the first line of a slice.
const MOST_BYTES: u64 = 1000;

/// An open slice.
pub(super) enum Open {
    Csv(BufReader<File>),
    #[cfg(feature = "parquet")]
    Parquet(::parquet::file::reader::SerializedFileReader<File>),
}

/// Opens a slice and reads its header.
///
/// # Errors
/// [`SliceError::Io`], [`SliceError::NoSlice`].
pub(super) fn open(path: &Path) -> Result<(Header, Open), SliceError> {
    let mut file = File::open(path).map_err(SliceError::io(path))?;
    let mut start = Vec::new();
    let read = file.by_ref().take(4).read_to_end(&mut start);
    let read = read.and_then(|_| file.rewind());
    read.map_err(SliceError::io(path))?;
    let (header, open) = match start.as_slice() {
        b"PAR1" => open_parquet(path, file)?,
        _ => open_csv(path, file)?,
    };
    match header {
        Some(header) => Ok((header, open)),
        None => Err(SliceError::NoSlice {
            path: path.to_path_buf(),
        }),
    }
}

fn open_csv(path: &Path, file: File) -> Result<(Option<Header>, Open), SliceError> {
    let mut reader = BufReader::new(file);
    let mut line = Vec::new();
    let read = reader
        .by_ref()
        .take(MOST_BYTES)
        .read_until(b'\n', &mut line);
    read.map_err(SliceError::io(path))?;
    let text = String::from_utf8_lossy(&line);
    let header = text.strip_prefix("# ").and_then(|text| text.parse().ok());
    Ok((header, Open::Csv(reader)))
}

#[cfg(feature = "parquet")]
fn open_parquet(path: &Path, file: File) -> Result<(Option<Header>, Open), SliceError> {
    let reader = ::parquet::file::reader::SerializedFileReader::new(file);
    let reader = reader.map_err(|error| SliceError::io(path)(std::io::Error::other(error)))?;
    Ok((super::parquet::header(&reader), Open::Parquet(reader)))
}

#[cfg(not(feature = "parquet"))]
fn open_parquet(_: &Path, _: File) -> Result<(Option<Header>, Open), SliceError> {
    Err(SliceError::NoParquet)
}

impl Open {
    /// Visits the results of the slice in blocks of rows.
    ///
    /// # Errors
    /// The error in the file.
    pub(super) fn each(
        self,
        sweep: &Sweep,
        columns: &[(String, Column)],
        rows: Range<u64>,
        visit: &mut dyn FnMut(Results),
    ) -> Result<(), String> {
        let modes = sweep.modes();
        match self {
            Self::Csv(file) => {
                let mut lines = csv::Rows::new(file, columns)?;
                let mut first = rows.start;
                while first < rows.end {
                    let count = (rows.end - first).min(BLOCK_ROWS);
                    let results = Results::unsolved(first, count as usize, modes);
                    let mut results = results.map_err(|error| error.to_string())?;
                    lines.fill(&mut results, columns)?;
                    visit(results);
                    first += count;
                }
                lines.end()
            }
            #[cfg(feature = "parquet")]
            Self::Parquet(reader) => {
                let read = super::parquet::each(&reader, columns, rows, modes, visit);
                read.map_err(|error| error.to_string())
            }
        }
    }
}
