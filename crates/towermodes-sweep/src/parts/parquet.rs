//! Parts in Parquet; the footer has the key and the number of the part.

use std::fs::File;
use std::sync::Arc;

use parquet::basic::{Compression, Encoding, LogicalType, Repetition, Type};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::{ByteArray, DataType};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{ColumnPath, Type as SchemaType};
use towermodes::ModeName;

use super::part::{Column, Part};
use crate::results::Results;

/// The name of the key in the footer.
const KEY: &str = "towermodes.sweep";
/// The name of the number of the part in the footer.
const PART: &str = "towermodes.part";

/// The bytes of a part.
pub(super) fn write(
    part: &Part,
    columns: &[(String, Column)],
    (key, number): (&str, u64),
) -> Result<Vec<u8>> {
    let mut content = Vec::new();
    let properties = Arc::new(properties(columns, key, number));
    let schema = Arc::new(schema(columns)?);
    let mut writer = SerializedFileWriter::new(&mut content, schema, properties)?;
    let mut group = writer.next_row_group()?;
    let mut index = 0;
    while let Some(mut column) = group.next_column()? {
        write_column(column.untyped(), part, &columns[index].1)?;
        column.close()?;
        index += 1;
    }
    group.close()?;
    writer.close()?;
    Ok(content)
}

/// Frequencies of near towers have equal first bytes: the bytes of each place side by side are
/// compressed best.
fn properties(columns: &[(String, Column)], key: &str, part: u64) -> WriterProperties {
    let mut builder = WriterProperties::builder()
        .set_created_by(concat!("towermodes ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_compression(Compression::SNAPPY)
        .set_dictionary_enabled(false)
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_max_row_group_row_count(Some(super::MAX_ROWS_PER_PART as usize))
        .set_key_value_metadata(Some(vec![
            KeyValue::new(KEY.to_owned(), key.to_owned()),
            KeyValue::new(PART.to_owned(), part.to_string()),
        ]));
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

/// The numbers of a column; NaN where there is none.
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

/// What the footer of a file says.
pub(super) struct Footer {
    /// The key of its sweep and its number, if it is a part.
    pub(super) key: Option<(String, u64)>,
    pub(super) rows: i64,
}

/// Reads the footer of a file.
pub(super) fn footer(file: File) -> Result<Footer> {
    let reader = SerializedFileReader::new(file)?;
    let metadata = reader.metadata().file_metadata();
    let entries = metadata.key_value_metadata().map_or(&[][..], |list| list);
    let value = |name: &str| {
        let entry = entries.iter().find(|entry| entry.key == name)?;
        entry.value.clone()
    };
    let part = value(PART).and_then(|digits| digits.parse().ok());
    Ok(Footer {
        key: value(KEY).zip(part),
        rows: metadata.num_rows(),
    })
}

/// Reads the results of a part.
pub(super) fn read(
    file: File,
    columns: &[(String, Column)],
    first_row: u64,
    modes: &[ModeName],
) -> Result<Results> {
    let reader = SerializedFileReader::new(file)?;
    let rows = usize::try_from(reader.metadata().file_metadata().num_rows()).unwrap_or(0);
    let mut results = Results::unsolved(first_row, rows, modes)
        .map_err(|error| ParquetError::General(error.to_string()))?;
    let group = reader.get_row_group(0)?;
    if group.num_columns() != columns.len() {
        return Err(ParquetError::General("it has other columns".into()));
    }
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
                        let kept = results.failures.push(row, &sentence);
                        kept.map_err(|error| ParquetError::General(error.to_string()))?;
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
