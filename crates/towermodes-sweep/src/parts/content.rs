//! Reads and writes the file of a part.

use std::fs::File;
use std::io::BufReader;

use super::names::key_name;
use super::part::{Part, PartFormat};
use super::write::write;
use super::{Parts, PartsError, csv};
use crate::digest::Digest;
use crate::results::Results;

impl Parts<'_> {
    /// Reads the results of a part; those of a missing mode or a failed row are NaN.
    ///
    /// # Errors
    /// [`PartsError`] if the part does not exist, is not there or is not whole.
    pub fn read(&self, part: u64) -> Result<Results, PartsError> {
        self.check_number(part)?;
        let path = self.path(part);
        let file = File::open(&path).map_err(PartsError::io(&path))?;
        let results = match self.format() {
            PartFormat::Csv => {
                let (rows, modes) = (self.rows_of(part), self.sweep().modes());
                csv::read(BufReader::new(file), &self.columns, rows, modes)
            }
            PartFormat::Parquet => self.read_parquet(part, file)?,
        };
        results.map_err(|detail| PartsError::Damaged { path, detail })
    }

    #[cfg(feature = "parquet")]
    fn read_parquet(&self, part: u64, file: File) -> Result<Result<Results, String>, PartsError> {
        let (rows, modes) = (self.rows_of(part), self.sweep().modes());
        let read = super::parquet::read(file, &self.columns, rows.start, modes);
        let expected = (rows.end - rows.start) as usize;
        Ok(match read {
            Ok(results) if results.rows() != expected => Err(format!(
                "it has {} rows in place of {expected}",
                results.rows()
            )),
            read => read.map_err(|error| error.to_string()),
        })
    }

    #[cfg(not(feature = "parquet"))]
    fn read_parquet(&self, _: u64, _: File) -> Result<Result<Results, String>, PartsError> {
        Err(PartsError::NoParquet)
    }

    /// Writes a part, unless another run has replaced the plan of the folder.
    pub(super) fn write(&self, number: u64, part: &Part) -> Result<(), PartsError> {
        self.check_claim()?;
        let name = self.name(number);
        let unwritable = |detail: String| PartsError::Unwritable {
            path: self.path(number),
            detail,
        };
        let content = match self.format() {
            PartFormat::Csv => {
                let content = csv::write(part, &self.columns);
                let content = content.map_err(|error| unwritable(error.to_string()))?;
                // Before the part, so that no part is without it.
                let text = csv::key_text(self.key(), number, &Digest::of(&content));
                write(self.folder(), &key_name(&name), text.as_bytes())?;
                content
            }
            #[cfg(feature = "parquet")]
            PartFormat::Parquet => {
                let content = super::parquet::write(part, &self.columns, (self.key(), number));
                content.map_err(|error| unwritable(error.to_string()))?
            }
            #[cfg(not(feature = "parquet"))]
            PartFormat::Parquet => return Err(PartsError::NoParquet),
        };
        write(self.folder(), &name, &content)
    }
}
