//! Slices in Parquet; the header is an entry of the footer.

use std::collections::TryReserveError;
use std::fs::File;
use std::io::Write;
use std::ops::Range;
use std::sync::Arc;

use parquet::basic::{Compression, Encoding, LogicalType, Repetition, Type};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::{ByteArray, DataType};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::reader::{FileReader, RowGroupReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{ColumnPath, Type as SchemaType};
use towermodes::ModeName;

use super::column::Column;
use super::header::Header;
use super::part::Part;
use crate::rows::results::Results;

/// The key of the header in the footer.
const KEY: &str = "towermodes.sweep";

/// Number of rows in memory until they are written as a row group: about ten megabytes.
const GROUP_ROWS: usize = 65_536;

/// Writes a slice.
pub(super) struct Writer<W: Write + Send> {
    file: SerializedFileWriter<W>,
    columns: Vec<(String, Column)>,
    /// The rows that are not yet written.
    group: Option<Part>,
}

impl<W: Write + Send> Writer<W> {
    pub(super) fn new(out: W, header: &Header, columns: Vec<(String, Column)>) -> Result<Self> {
        let properties = Arc::new(properties(&columns, header));
        let schema = Arc::new(schema(&columns)?);
        Ok(Self {
            file: SerializedFileWriter::new(out, schema, properties)?,
            columns,
            group: None,
        })
    }

    /// Adds the following rows.
    pub(super) fn add(&mut self, part: Part) -> Result<()> {
        let rows = match &mut self.group {
            None => self.group.insert(part).results.rows(),
            Some(group) => {
                group.inputs.extend(part.inputs);
                let added = group.results.append(part.results);
                added.map_err(|error| ParquetError::External(error.into()))?;
                group.results.rows()
            }
        };
        match rows >= GROUP_ROWS {
            true => self.write_group(),
            false => Ok(()),
        }
    }

    fn write_group(&mut self) -> Result<()> {
        let Some(part) = self.group.take() else {
            return Ok(());
        };
        let mut group = self.file.next_row_group()?;
        let mut columns = self.columns.iter();
        while let (Some(mut writer), Some((_, column))) = (group.next_column()?, columns.next()) {
            write_column(writer.untyped(), &part, column)?;
            writer.close()?;
        }
        group.close()?;
        Ok(())
    }

    /// Writes the last rows and the footer.
    pub(super) fn finish(mut self) -> Result<()> {
        self.write_group()?;
        self.file.close()?;
        Ok(())
    }
}

/// The first bytes of the frequencies of similar towers are equal, so the encoding that stores
/// bytes of equal position together compresses best.
fn properties(columns: &[(String, Column)], header: &Header) -> WriterProperties {
    let mut builder = WriterProperties::builder()
        .set_created_by(concat!("towermodes ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_compression(Compression::SNAPPY)
        .set_dictionary_enabled(false)
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_key_value_metadata(Some(vec![KeyValue::new(
            KEY.to_owned(),
            header.to_string(),
        )]));
    for (name, column) in columns {
        let path = ColumnPath::new(vec![name.clone()]);
        builder = match column {
            Column::Row => builder.set_column_encoding(path, Encoding::DELTA_BINARY_PACKED),
            Column::Certified => builder,
            Column::Sentence => builder.set_column_dictionary_enabled(path, true),
            _ => builder.set_column_encoding(path, Encoding::BYTE_STREAM_SPLIT),
        };
    }
    builder.build()
}

fn schema(columns: &[(String, Column)]) -> Result<SchemaType> {
    let fields = columns.iter().map(|(name, column)| {
        let (kind, repetition) = match column {
            Column::Row => (Type::INT64, Repetition::REQUIRED),
            Column::Input(_) => (Type::DOUBLE, Repetition::REQUIRED),
            Column::Certified => (Type::BOOLEAN, Repetition::REQUIRED),
            Column::Sentence => (Type::BYTE_ARRAY, Repetition::OPTIONAL),
            _ => (Type::DOUBLE, Repetition::OPTIONAL),
        };
        let is_text = matches!(column, Column::Sentence);
        let field = SchemaType::primitive_type_builder(name, kind)
            .with_repetition(repetition)
            .with_logical_type(is_text.then_some(LogicalType::String));
        field.build().map(Arc::new)
    });
    SchemaType::group_type_builder("sweep")
        .with_fields(fields.collect::<Result<Vec<_>>>()?)
        .build()
}

fn write_column(writer: &mut ColumnWriter<'_>, part: &Part, column: &Column) -> Result<()> {
    let results = &part.results;
    let first = results.first_row;
    match writer {
        ColumnWriter::Int64ColumnWriter(writer) => {
            let rows = first..first + results.rows() as u64;
            let rows: Vec<i64> = rows.map(|row| row as i64).collect();
            writer.write_batch(&rows, None, None)?;
        }
        ColumnWriter::BoolColumnWriter(writer) => {
            writer.write_batch(&results.certified, None, None)?;
        }
        ColumnWriter::ByteArrayColumnWriter(writer) => {
            let sentences = results.sentences();
            let levels: Vec<i16> = sentences
                .map(|sentence| sentence.is_some().into())
                .collect();
            let sentences = results.failures.iter().map(|(_, sentence)| sentence);
            let sentences: Vec<ByteArray> = sentences.map(ByteArray::from).collect();
            writer.write_batch(&sentences, Some(&levels), None)?;
        }
        ColumnWriter::DoubleColumnWriter(writer) => {
            let numbers = numbers(part, column);
            if matches!(column, Column::Input(_)) {
                writer.write_batch(&numbers, None, None)?;
            } else {
                let levels: Vec<i16> = numbers.iter().map(|n| (!n.is_nan()).into()).collect();
                let there: Vec<f64> = numbers.into_iter().filter(|n| !n.is_nan()).collect();
                writer.write_batch(&there, Some(&levels), None)?;
            }
        }
        _ => {
            return Err(ParquetError::General(
                "a column of no type of results".into(),
            ));
        }
    }
    Ok(())
}

/// The values of a column; NaN if a value is missing.
fn numbers(part: &Part, column: &Column) -> Vec<f64> {
    let results = &part.results;
    let changes = part.inputs.len().checked_div(results.rows()).unwrap_or(0);
    match *column {
        Column::Input(input) => {
            let values = part.inputs.iter().skip(input).step_by(changes);
            values.copied().collect()
        }
        Column::Hz(mode) => results.frequencies_hz(mode).collect(),
        Column::ErrorHz(mode) => results.errors_hz(mode).collect(),
        Column::Share(mode) => results.shares(mode).collect(),
        Column::MassKg | Column::Row | Column::Certified | Column::Sentence => {
            results.mass_kg.clone()
        }
    }
}

/// The header of a file, if it has one.
pub(super) fn header(reader: &SerializedFileReader<File>) -> Option<Header> {
    let metadata = reader.metadata().file_metadata();
    let entries = metadata.key_value_metadata()?;
    let entry = entries.iter().find(|entry| entry.key == KEY)?;
    entry.value.as_deref()?.parse().ok()
}

/// Visits the results of a slice, one row group after another.
pub(super) fn each(
    reader: &SerializedFileReader<File>,
    columns: &[(String, Column)],
    rows: Range<u64>,
    modes: &[ModeName],
    visit: &mut dyn FnMut(Results),
) -> Result<()> {
    let wrong = |detail: &str| Err(ParquetError::General(detail.to_owned()));
    let mut first_row = rows.start;
    for index in 0..reader.num_row_groups() {
        let group = reader.get_row_group(index)?;
        let count = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
        let end = first_row + count as u64;
        if group.num_columns() != columns.len() {
            return wrong("it has other columns");
        }
        if end > rows.end {
            return wrong("it has more rows than stated in its footer");
        }
        visit(results_of(&*group, columns, (first_row, count), modes)?);
        first_row = end;
    }
    match first_row == rows.end {
        true => Ok(()),
        false => wrong(&format!("it ends before row {first_row}")),
    }
}

/// The results of a row group.
fn results_of(
    group: &dyn RowGroupReader,
    columns: &[(String, Column)],
    (first_row, rows): (u64, usize),
    modes: &[ModeName],
) -> Result<Results> {
    let full = |error: TryReserveError| ParquetError::External(error.into());
    let mut results = Results::unsolved(first_row, rows, modes).map_err(full)?;
    for (index, (_, column)) in columns.iter().enumerate() {
        if matches!(column, Column::Row | Column::Input(_)) {
            continue;
        }
        match group.get_column_reader(index)? {
            ColumnReader::BoolColumnReader(reader) => {
                let values = cells(reader, rows)?.into_iter();
                results.certified = values.map(|value| value == Some(true)).collect();
            }
            ColumnReader::ByteArrayColumnReader(reader) => {
                for (row, text) in (first_row..).zip(cells(reader, rows)?) {
                    if let Some(text) = text {
                        let sentence = String::from_utf8_lossy(text.data());
                        results.failures.push(row, &sentence).map_err(full)?;
                    }
                }
            }
            ColumnReader::DoubleColumnReader(reader) => {
                let numbers = cells(reader, rows)?.into_iter();
                put(&mut results, column, numbers.map(|n| n.unwrap_or(f64::NAN)));
            }
            _ => {
                return Err(ParquetError::General(
                    "it has columns of other types".into(),
                ));
            }
        }
    }
    Ok(results)
}

fn put(results: &mut Results, column: &Column, numbers: impl Iterator<Item = f64>) {
    let modes = results.modes.len();
    let (cells, first, step) = match *column {
        Column::Hz(mode) => (&mut results.frequency_hz, mode, modes),
        Column::ErrorHz(mode) => (&mut results.error_hz, mode, modes),
        Column::Share(mode) => (&mut results.share, mode, modes),
        _ => (&mut results.mass_kg, 0, 1),
    };
    let cells = cells.iter_mut().skip(first).step_by(step);
    for (cell, number) in cells.zip(numbers) {
        *cell = number;
    }
}

/// The cells of a column, none for null.
fn cells<T: DataType>(mut reader: ColumnReaderImpl<T>, rows: usize) -> Result<Vec<Option<T::T>>> {
    let (mut levels, mut values) = (Vec::new(), Vec::new());
    let (read, ..) = reader.read_records(rows, Some(&mut levels), None, &mut values)?;
    if read != rows {
        return Err(ParquetError::General("a column ends too early".into()));
    }
    if levels.is_empty() {
        return Ok(values.into_iter().map(Some).collect());
    }
    let mut values = values.into_iter();
    let cells = levels.into_iter().map(|level| match level {
        0 => None,
        _ => values.next(),
    });
    Ok(cells.collect())
}
