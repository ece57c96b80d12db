//! Tables in Parquet.

use std::fs::File;
use std::io;
use std::ops::Range;

use parquet::basic::{Compression, ConvertedType, LogicalType, Type};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::DataType;
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, RowGroupReader, SerializedFileReader};
use parquet::schema::types::ColumnDescriptor;
use towermodes::TowerDescription;

use super::error::{CellError, RowPlace, TableProblem};
use super::file::TableFile;
use super::header::Header;

/// Number of rows that are checked at a time.
const BLOCK: u64 = 16_384;

/// A checked table in Parquet.
pub(super) struct ParquetTable {
    reader: SerializedFileReader<File>,
}

impl std::fmt::Debug for ParquetTable {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ParquetTable").finish_non_exhaustive()
    }
}

impl From<ParquetError> for TableProblem {
    fn from(error: ParquetError) -> Self {
        let detail = error.to_string();
        Self::Damaged { detail }
    }
}

impl ParquetTable {
    /// Reads the whole file and checks every cell.
    pub(super) fn check(
        file: &mut TableFile,
        base: &TowerDescription,
        ignore: &[String],
    ) -> Result<(Header, u64, Self), TableProblem> {
        file.read_through(|reader| {
            io::copy(reader, &mut io::sink())?;
            Ok(())
        })?;
        let opened = file.lock().try_clone()?;
        let table = Self {
            reader: SerializedFileReader::new(opened)?,
        };
        let schema = table.reader.metadata().file_metadata().schema_descr();
        let fields = schema.root_schema().get_fields();
        let names = fields.iter().map(|field| field.name().to_owned());
        let names: Vec<String> = names.collect();
        let header = Header::new(names, base, ignore)?;
        let header = table.leaves(header)?;
        let rows = table.rows()?;
        let mut first = 0;
        while first < rows {
            let end = rows.min(first + BLOCK);
            table.read(file, &header, first..end)?;
            first = end;
        }
        Ok((header, rows, table))
    }

    /// Number of rows; it must equal the sum over all row groups.
    fn rows(&self) -> Result<u64, TableProblem> {
        let metadata = self.reader.metadata();
        let said = metadata.file_metadata().num_rows();
        let mut counts = metadata.row_groups().iter().map(|group| group.num_rows());
        let sum = counts.try_fold(0_u64, |sum, count| {
            sum.checked_add(u64::try_from(count).ok()?)
        });
        match sum {
            Some(rows) if i64::try_from(rows) == Ok(said) => Ok(rows),
            _ => Err(damaged(
                "the numbers of rows of its row groups do not agree with its footer",
            )),
        }
    }

    /// The header with the columns of values; refuses columns without numbers.
    fn leaves(&self, header: Header) -> Result<Header, TableProblem> {
        let schema = self.reader.metadata().file_metadata().schema_descr();
        let mut columns = Vec::new();
        for &field in &header.columns {
            let name = &header.names[field];
            let is_of = |leaf: &usize| schema.get_column_root_idx(*leaf) == field;
            let mut leaves = (0..schema.num_columns()).filter(is_of);
            let leaf = leaves.next();
            let type_of = |leaf: usize| number_type(&schema.column(leaf));
            let found = match (leaf, leaves.next()) {
                (Some(leaf), None) => match type_of(leaf) {
                    Ok(()) => {
                        self.check_codec(leaf, name)?;
                        columns.push(leaf);
                        continue;
                    }
                    Err(found) => found,
                },
                _ => "of a group of columns".to_owned(),
            };
            return Err(TableProblem::ColumnType {
                column: name.clone(),
                found,
            });
        }
        Ok(Header { columns, ..header })
    }

    fn check_codec(&self, leaf: usize, name: &str) -> Result<(), TableProblem> {
        for group in self.reader.metadata().row_groups() {
            match group.column(leaf).compression() {
                Compression::UNCOMPRESSED | Compression::SNAPPY | Compression::ZSTD(_) => {}
                other => {
                    let codec = other.to_string();
                    return Err(TableProblem::Compression {
                        column: name.to_owned(),
                        codec: codec.split('(').next().unwrap_or_default().to_owned(),
                    });
                }
            }
        }
        Ok(())
    }

    /// Reads a range of rows.
    pub(super) fn read(
        &self,
        file: &TableFile,
        header: &Header,
        rows: Range<u64>,
    ) -> Result<Vec<f64>, TableProblem> {
        // Clones of a file share their position.
        let _lock = file.lock();
        let width = header.columns.len();
        let mut values = vec![0.0; (rows.end - rows.start) as usize * width];
        let mut group_first = 0;
        for index in 0..self.reader.num_row_groups() {
            let count = self.reader.metadata().row_group(index).num_rows();
            let group_end = group_first + u64::try_from(count).unwrap_or(0);
            let from = rows.start.max(group_first);
            let to = rows.end.min(group_end);
            if from < to {
                let group = self.reader.get_row_group(index)?;
                for (place, &leaf) in header.columns.iter().enumerate() {
                    let wanted = Wanted {
                        skip: (from - group_first) as usize,
                        count: (to - from) as usize,
                    };
                    let column = wanted.numbers(&*group, leaf)?;
                    let first = (from - rows.start) as usize;
                    let cells = values.chunks_exact_mut(width).skip(first);
                    for ((cells, number), row) in cells.zip(column).zip(from..) {
                        cells[place] = number.map_err(|error| {
                            let field = self.root_of(leaf);
                            TableProblem::Cell {
                                place: RowPlace::Row(row),
                                column: header.names[field].clone(),
                                error,
                            }
                        })?;
                    }
                }
            }
            group_first = group_end;
        }
        Ok(values)
    }

    fn root_of(&self, leaf: usize) -> usize {
        let metadata = self.reader.metadata().file_metadata();
        metadata.schema_descr().get_column_root_idx(leaf)
    }
}

/// Checks that a column has numbers; the error is its type as text.
fn number_type(column: &ColumnDescriptor) -> Result<(), String> {
    if column.max_rep_level() > 0 || column.max_def_level() > 1 {
        return Err("of a list or a group".to_owned());
    }
    let physical = column.physical_type();
    let is_plain = match (column.logical_type_ref(), column.converted_type()) {
        (None, ConvertedType::NONE) => true,
        // The largest unsigned numbers would be negative ones here.
        (Some(LogicalType::Integer(integer)), _) => integer.is_signed || integer.bit_width < 32,
        (None, converted) => matches!(
            converted,
            ConvertedType::INT_8
                | ConvertedType::INT_16
                | ConvertedType::INT_32
                | ConvertedType::INT_64
                | ConvertedType::UINT_8
                | ConvertedType::UINT_16
        ),
        _ => false,
    };
    match physical {
        Type::DOUBLE | Type::FLOAT | Type::INT32 | Type::INT64 if is_plain => Ok(()),
        _ => match column.logical_type_ref() {
            Some(logical) => Err(format!("{physical} ({})", name_of(logical))),
            None => Err(physical.to_string()),
        },
    }
}

/// The name of a logical type: `UINT_64`, `Timestamp`, `String`.
fn name_of(logical: &LogicalType) -> String {
    match logical {
        LogicalType::Integer(integer) => {
            let sign = if integer.is_signed { "" } else { "U" };
            format!("{sign}INT_{}", integer.bit_width)
        }
        other => {
            let text = format!("{other:?}");
            let end = text.find(|c: char| !c.is_alphanumeric());
            text[..end.unwrap_or(text.len())].to_owned()
        }
    }
}

/// Successive rows of a row group.
struct Wanted {
    skip: usize,
    count: usize,
}

impl Wanted {
    /// The numbers of a column.
    fn numbers(
        &self,
        group: &dyn RowGroupReader,
        leaf: usize,
    ) -> Result<Vec<Result<f64, CellError>>, TableProblem> {
        match group.get_column_reader(leaf)? {
            ColumnReader::DoubleColumnReader(reader) => self.of(reader, |value| value),
            ColumnReader::FloatColumnReader(reader) => self.of(reader, f64::from),
            ColumnReader::Int32ColumnReader(reader) => self.of(reader, f64::from),
            ColumnReader::Int64ColumnReader(reader) => self.of(reader, |value| value as f64),
            _ => Err(damaged(
                "a column has another type than the schema of the file states",
            )),
        }
    }

    fn of<T: DataType>(
        &self,
        mut reader: ColumnReaderImpl<T>,
        number: impl Fn(T::T) -> f64,
    ) -> Result<Vec<Result<f64, CellError>>, TableProblem> {
        if reader.skip_records(self.skip)? != self.skip {
            return Err(damaged("a column ends too early"));
        }
        let (mut levels, mut values) = (Vec::new(), Vec::new());
        let read = reader.read_records(self.count, Some(&mut levels), None, &mut values)?;
        let mut values = values.into_iter();
        let mut next = |is_there: bool| match is_there.then(|| values.next()).flatten() {
            None => Err(CellError::Null),
            Some(value) => match number(value) {
                value if value.is_finite() => Ok(value),
                value => Err(CellError::NotFinite { value }),
            },
        };
        match (read.0 == self.count, levels.is_empty()) {
            (false, _) => Err(damaged("a column ends too early")),
            (true, true) => Ok((0..self.count).map(|_| next(true)).collect()),
            (true, false) => Ok(levels.into_iter().map(|level| next(level == 1)).collect()),
        }
    }
}

fn damaged(detail: &str) -> TableProblem {
    let detail = detail.to_owned();
    TableProblem::Damaged { detail }
}
