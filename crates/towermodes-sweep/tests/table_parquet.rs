//! Tables in Parquet: types, row groups, nulls, damage.

use std::fs;
use std::sync::Arc;

use parquet::basic::{Compression, LogicalType, Repetition, Type, ZstdLevel};
use parquet::column::writer::ColumnWriter;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type as SchemaType;

use towermodes_sweep::{Table, TableError};
use towermodes_testing::Says;

use crate::towers::{Folder, tower};

/// A column of a table: its name and its values, none for null.
type Column = (&'static str, Values);

enum Values {
    Double(Vec<Option<f64>>),
    Float(Vec<f32>),
    Long(Vec<i64>),
    Int(Vec<i32>),
    Text(Vec<&'static str>),
    Timestamp(Vec<i64>),
    Bool(Vec<bool>),
}

/// A file with row groups of at most `group` rows.
fn file(columns: &[Column], rows: usize, group: usize, compression: Compression) -> Vec<u8> {
    let fields = columns.iter().map(|(name, values)| {
        let (kind, logical) = match values {
            Values::Double(_) => (Type::DOUBLE, None),
            Values::Float(_) => (Type::FLOAT, None),
            Values::Long(_) => (Type::INT64, None),
            Values::Int(_) => (Type::INT32, None),
            Values::Text(_) => (Type::BYTE_ARRAY, Some(LogicalType::String)),
            Values::Timestamp(_) => (
                Type::INT64,
                Some(LogicalType::timestamp(
                    true,
                    parquet::basic::TimeUnit::MILLIS,
                )),
            ),
            Values::Bool(_) => (Type::BOOLEAN, None),
        };
        let is_optional = matches!(values, Values::Double(_));
        let repetition = match is_optional {
            true => Repetition::OPTIONAL,
            false => Repetition::REQUIRED,
        };
        let field = SchemaType::primitive_type_builder(name, kind)
            .with_repetition(repetition)
            .with_logical_type(logical);
        Arc::new(field.build().expect("a column"))
    });
    let schema = SchemaType::group_type_builder("table").with_fields(fields.collect());
    let schema = Arc::new(schema.build().expect("a schema"));
    let properties = WriterProperties::builder().set_compression(compression);
    let mut content = Vec::new();
    let mut writer = SerializedFileWriter::new(&mut content, schema, Arc::new(properties.build()))
        .expect("a writer");
    let mut first = 0;
    while first < rows {
        let range = first..rows.min(first + group);
        let mut writer = writer.next_row_group().expect("a row group");
        let mut index = 0;
        while let Some(mut column) = writer.next_column().expect("a column") {
            write(column.untyped(), &columns[index].1, range.clone());
            column.close().expect("written");
            index += 1;
        }
        writer.close().expect("written");
        first = range.end;
    }
    writer.close().expect("written");
    content
}

fn write(writer: &mut ColumnWriter<'_>, values: &Values, range: std::ops::Range<usize>) {
    let written = match (writer, values) {
        (ColumnWriter::DoubleColumnWriter(writer), Values::Double(values)) => {
            let levels: Vec<i16> = values[range.clone()]
                .iter()
                .map(|v| v.is_some().into())
                .collect();
            let values: Vec<f64> = values[range].iter().flatten().copied().collect();
            writer.write_batch(&values, Some(&levels), None)
        }
        (ColumnWriter::FloatColumnWriter(writer), Values::Float(values)) => {
            writer.write_batch(&values[range], None, None)
        }
        (
            ColumnWriter::Int64ColumnWriter(writer),
            Values::Long(values) | Values::Timestamp(values),
        ) => writer.write_batch(&values[range], None, None),
        (ColumnWriter::Int32ColumnWriter(writer), Values::Int(values)) => {
            writer.write_batch(&values[range], None, None)
        }
        (ColumnWriter::BoolColumnWriter(writer), Values::Bool(values)) => {
            writer.write_batch(&values[range], None, None)
        }
        (ColumnWriter::ByteArrayColumnWriter(writer), Values::Text(values)) => {
            let values: Vec<_> = values[range].iter().map(|text| (*text).into()).collect();
            writer.write_batch(&values, None, None)
        }
        _ => unreachable!("the column of its type"),
    };
    written.expect("written");
}

fn opened(content: &[u8], ignore: &[&str]) -> Result<(Folder, Table), TableError> {
    let folder = Folder::new();
    let path = folder.path("towers.parquet");
    fs::write(&path, content).expect("written");
    let ignore: Vec<String> = ignore.iter().map(ToString::to_string).collect();
    let table = Table::open(&path, &tower(4e7), &ignore)?;
    Ok((folder, table))
}

fn doubles(values: impl Iterator<Item = f64>) -> Values {
    Values::Double(values.map(Some).collect())
}

#[test]
fn any_range_of_rows_is_read_across_row_groups() {
    const ROWS: usize = 5000;
    let number = |row: usize| 3e5 + row as f64;
    for (group, compression) in [
        (ROWS, Compression::SNAPPY),
        (700, Compression::UNCOMPRESSED),
        (900, Compression::ZSTD(ZstdLevel::default())),
        (1, Compression::UNCOMPRESSED),
    ] {
        let rows = if group == 1 { 50 } else { ROWS };
        let columns = [
            ("rna.mass", doubles((0..rows).map(number))),
            ("name", Values::Text(vec!["a"; rows])),
            ("stations[1].wall", Values::Float(vec![0.5; rows])),
            (
                "scale(stations[0].wall)",
                Values::Long((0..rows as i64).collect()),
            ),
            (
                "add(stations[2].wall)",
                Values::Int((0..rows as i32).map(|i| -i).collect()),
            ),
        ];
        let content = file(&columns, rows, group, compression);
        let (_folder, table) = opened(&content, &["name"]).expect("a table");
        assert_eq!((table.rows(), table.changes().len()), (rows as u64, 4));
        for (first, end) in [
            (0, rows),
            (1, 2),
            (699, 702),
            (0, 0),
            (rows - 1, rows),
            (1400, 4200),
        ] {
            if end > rows {
                continue;
            }
            let values = table.read(first as u64..end as u64).expect("values");
            let expected =
                (first..end).flat_map(|row| [number(row), 0.5, row as f64, -(row as f64)]);
            let wanted = expected.collect::<Vec<f64>>();
            assert_eq!(values, wanted, "{group} {first} {end}");
        }
    }
}

#[test]
fn mistakes_are_shown_with_row_and_column() {
    let mass = |values: &[Option<f64>]| ("rna.mass", Values::Double(values.to_vec()));
    let mistake = |columns: &[Column], rows| {
        let content = file(columns, rows, 10, Compression::SNAPPY);
        opened(&content, &[]).map(|_| ()).expect_err("refused")
    };
    mistake(&[mass(&[Some(1.0), None, Some(2.0)])], 3)
        .says("row 1 (counted from 0), column `rna.mass`: the cell is null; it must be a number");
    mistake(&[mass(&[Some(1.0), Some(f64::NAN)])], 2)
        .says("row 1 (counted from 0), column `rna.mass`: the value is NaN");
    mistake(&[("rna.mass", Values::Text(vec!["1", "2"]))], 2)
        .says("column `rna.mass` has the type BYTE_ARRAY (String)");
    mistake(&[("rna.mass", Values::Bool(vec![true]))], 1)
        .says("column `rna.mass` has the type BOOLEAN");
    mistake(&[("rna.mass", Values::Timestamp(vec![1]))], 1)
        .says("column `rna.mass` has the type INT64 (Timestamp)");
    mistake(&[mass(&[Some(1.0)]), ("row", Values::Long(vec![0]))], 1)
        .says("column 2: unknown input name `row`");
    mistake(&[mass(&[])], 0).says("has no rows below the names of its columns");
}

/// 1000 files with a byte changed, or cut: an error or numbers, and never a panic.
#[test]
fn damaged_files_are_errors() {
    let columns = [
        ("rna.mass", doubles((0..200).map(f64::from))),
        ("stations[1].wall", Values::Long((0..200).collect())),
    ];
    let whole = file(&columns, 200, 90, Compression::SNAPPY);
    assert!(opened(&whole, &[]).is_ok());
    let mut state = 7_u64;
    let mut errors = 0;
    for _ in 0..1000 {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        let place = (state >> 33) as usize % whole.len();
        let mut content = whole.clone();
        match state >> 20 & 7 {
            0 => content.truncate(place),
            1 => content[place..].fill(0),
            _ => content[place] ^= 1 << (state >> 23 & 7),
        }
        errors += usize::from(opened(&content, &[]).is_err());
    }
    assert!(errors > 100, "{errors}");
}
