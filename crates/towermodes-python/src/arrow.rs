//! Tables that are read and written by the Arrow PyCapsule interface.
//!
//! The capsules contain the structures of the Arrow C stream interface, which all usual table
//! libraries support; the code here depends on none of them.

#![allow(unsafe_code)]

use std::ffi::CStr;
use std::ops::Range;
use std::sync::Arc;

use arrow_array::builder::StringBuilder;
use arrow_array::cast::AsArray;
use arrow_array::ffi_stream::{FFI_ArrowArrayStream, RecordBatchStreamReader};
use arrow_array::types::{
    ArrowPrimitiveType, Float32Type, Float64Type, Int8Type, Int16Type, Int32Type, Int64Type,
    UInt8Type, UInt16Type, UInt32Type, UInt64Type,
};
use arrow_array::{
    Array, ArrayRef, BooleanArray, Float64Array, RecordBatch, RecordBatchIterator,
    RecordBatchReader, StringArray, UInt64Array,
};
use arrow_schema::{ArrowError, DataType, Field, Schema};
use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyCapsule;

use crate::error::usage;
use crate::lock::released;

/// The name of a capsule with a stream of arrays.
const STREAM: &CStr = c"arrow_array_stream";

/// A column of numbers with its name.
type NamedColumn<'py> = (String, Bound<'py, PyArray1<f64>>);

/// The columns of a table as numbers; a missing value is NaN. The given function receives all names
/// and returns the positions of the columns to read.
#[pyfunction]
#[pyo3(signature = (capsule: "object", choose: "object") -> "list[tuple[str, Incomplete]]")]
pub fn columns_of_stream<'py>(
    py: Python<'py>,
    capsule: &Bound<'py, PyCapsule>,
    choose: &Bound<'py, PyAny>,
) -> PyResult<Vec<NamedColumn<'py>>> {
    let reader = reader(capsule)?;
    let names = reader.schema();
    let names = names.fields().iter().map(|field| field.name().clone());
    let names: Vec<String> = names.collect();
    let chosen: Vec<usize> = choose.call1((&names,))?.extract()?;
    let names: Vec<String> = chosen.iter().map(|&place| names[place].clone()).collect();
    let columns = released(py, || numbers(reader, &chosen, &names))?;
    let columns = columns
        .into_iter()
        .map(|column| PyArray1::from_vec(py, column));
    Ok(names.into_iter().zip(columns).collect())
}

fn reader(capsule: &Bound<'_, PyCapsule>) -> PyResult<RecordBatchStreamReader> {
    let pointer = capsule.pointer_checked(Some(STREAM))?;
    // SAFETY: a capsule of this name holds this structure. It is taken out, which leaves an empty
    // one behind, so that the destructor of the capsule releases nothing.
    let stream = unsafe { FFI_ArrowArrayStream::from_raw(pointer.as_ptr().cast()) };
    RecordBatchStreamReader::try_new(stream).map_err(|error| unreadable(&error))
}

fn unreadable(error: &ArrowError) -> PyErr {
    usage(format!("the table cannot be read: {error}"))
}

fn numbers(
    reader: impl Iterator<Item = Result<RecordBatch, ArrowError>>,
    chosen: &[usize],
    names: &[String],
) -> PyResult<Vec<Vec<f64>>> {
    let mut columns = vec![Vec::new(); names.len()];
    for batch in reader {
        let batch = batch.map_err(|error| unreadable(&error))?;
        let arrays = chosen.iter().map(|&place| batch.column(place));
        for ((column, array), name) in columns.iter_mut().zip(arrays).zip(names) {
            extend(column, array).ok_or_else(|| {
                PyTypeError::new_err(format!(
                    "column {name} holds {}, but must hold numbers; cast it to 64-bit floats",
                    array.data_type()
                ))
            })?;
        }
    }
    Ok(columns)
}

/// Adds the numbers of an array to a column; none if the array does not contain numbers.
fn extend(column: &mut Vec<f64>, array: &dyn Array) -> Option<()> {
    match array.data_type() {
        DataType::Float64 => of_type::<Float64Type>(column, array, |value| value),
        DataType::Float32 => of_type::<Float32Type>(column, array, f64::from),
        DataType::Int8 => of_type::<Int8Type>(column, array, f64::from),
        DataType::Int16 => of_type::<Int16Type>(column, array, f64::from),
        DataType::Int32 => of_type::<Int32Type>(column, array, f64::from),
        DataType::Int64 => of_type::<Int64Type>(column, array, |value| value as f64),
        DataType::UInt8 => of_type::<UInt8Type>(column, array, f64::from),
        DataType::UInt16 => of_type::<UInt16Type>(column, array, f64::from),
        DataType::UInt32 => of_type::<UInt32Type>(column, array, f64::from),
        DataType::UInt64 => of_type::<UInt64Type>(column, array, |value| value as f64),
        DataType::Null => {
            column.extend(std::iter::repeat_n(f64::NAN, array.len()));
            Some(())
        }
        _ => None,
    }
}

fn of_type<T: ArrowPrimitiveType>(
    column: &mut Vec<f64>,
    array: &dyn Array,
    number: impl Fn(T::Native) -> f64,
) -> Option<()> {
    let array = array.as_primitive_opt::<T>()?;
    column.extend(array.iter().map(|value| value.map_or(f64::NAN, &number)));
    Some(())
}

/// A table of results as a stream: the number of each row, the inputs, the mass, whether the row is
/// certified, frequency, error and share of each mode, and the reason why a row failed. NaN is
/// written as a missing value.
#[pyfunction]
#[pyo3(signature = (first_row, inputs: "list[tuple[str, Incomplete]]", modes: "list[str]", mass_kg: "object", certified: "object", frequency_hz: "object", error_hz: "object", share: "object", failures: "tuple[object, object, object]") -> "object")]
#[allow(clippy::too_many_arguments)]
pub fn stream_of_results<'py>(
    py: Python<'py>,
    first_row: u64,
    inputs: Vec<(String, PyReadonlyArray1<'py, f64>)>,
    modes: Vec<String>,
    mass_kg: PyReadonlyArray1<'py, f64>,
    certified: PyReadonlyArray1<'py, bool>,
    frequency_hz: PyReadonlyArray2<'py, f64>,
    error_hz: PyReadonlyArray2<'py, f64>,
    share: PyReadonlyArray2<'py, f64>,
    failures: Failures<'py>,
) -> PyResult<Bound<'py, PyCapsule>> {
    let rows = first_row..first_row + certified.as_array().len() as u64;
    let mut table = Table::default();
    table.add("row", Arc::new(UInt64Array::from_iter_values(rows.clone())));
    for (name, column) in &inputs {
        table.add(name, present(column.as_array().iter().copied()));
    }
    table.add("mass_kg", present(mass_kg.as_array().iter().copied()));
    table.add(
        "certified",
        Arc::new(BooleanArray::from_iter(
            certified.as_array().iter().map(|c| Some(*c)),
        )),
    );
    let [frequency_hz, error_hz, share] =
        [&frequency_hz, &error_hz, &share].map(|of| of.as_array());
    for (place, mode) in modes.iter().enumerate() {
        let column =
            |of: &numpy::ndarray::ArrayView2<'_, f64>| present(of.column(place).iter().copied());
        table.add(&format!("{mode}_hz"), column(&frequency_hz));
        table.add(&format!("{mode}_error_hz"), column(&error_hz));
        table.add(&format!("{mode}_share"), column(&share));
    }
    table.add("error", Arc::new(sentences(rows, &failures)?));
    PyCapsule::new_with_value(py, table.stream()?, STREAM)
}

/// The rows that failed; the end of the message of each row in the text of all messages; this text
/// in UTF-8.
type Failures<'py> = (
    PyReadonlyArray1<'py, u64>,
    PyReadonlyArray1<'py, u64>,
    PyReadonlyArray1<'py, u8>,
);

/// The message of each row; none if a row is complete.
fn sentences(rows: Range<u64>, (failed, ends, text): &Failures<'_>) -> PyResult<StringArray> {
    let text = text.as_slice()?;
    if i32::try_from(text.len()).is_err() {
        return Err(usage(format!(
            "the messages of {} failed rows are too long for a column of a table (2 GiB); \
             take the numbers from `frequency_hz` and the messages from `failures`",
            failed.as_array().len()
        )));
    }
    let mut column = StringBuilder::with_capacity((rows.end - rows.start) as usize, text.len());
    let mut begin = 0;
    let (failed, ends) = (failed.as_array(), ends.as_array());
    let mut failures = failed.iter().zip(ends).peekable();
    for row in rows {
        let failure = failures.next_if(|(failed, _)| **failed == row);
        let message = failure.and_then(|(_, end)| {
            let message = text.get(begin..*end as usize);
            begin = *end as usize;
            message.map(String::from_utf8_lossy)
        });
        column.append_option(message);
    }
    Ok(column.finish())
}

/// A table of texts and numbers as a stream, with the columns of texts first. NaN is written as a
/// missing value.
#[pyfunction]
#[pyo3(signature = (texts: "list[tuple[str, list[str]]]", numbers: "list[tuple[str, Incomplete]]") -> "object")]
pub fn stream_of_columns<'py>(
    py: Python<'py>,
    texts: Vec<(String, Vec<String>)>,
    numbers: Vec<(String, PyReadonlyArray1<'py, f64>)>,
) -> PyResult<Bound<'py, PyCapsule>> {
    let mut table = Table::default();
    for (name, column) in texts {
        table.add(&name, Arc::new(StringArray::from(column)));
    }
    for (name, column) in &numbers {
        table.add(name, present(column.as_array().iter().copied()));
    }
    PyCapsule::new_with_value(py, table.stream()?, STREAM)
}

/// Numbers in which NaN is a missing value.
fn present(numbers: impl Iterator<Item = f64>) -> ArrayRef {
    let numbers = numbers.map(|number| (!number.is_nan()).then_some(number));
    Arc::new(Float64Array::from_iter(numbers))
}

/// Columns of a table in the order in which they are added.
#[derive(Default)]
struct Table {
    fields: Vec<Field>,
    columns: Vec<ArrayRef>,
}

impl Table {
    fn add(&mut self, name: &str, column: ArrayRef) {
        let is_nullable = !matches!(name, "row" | "certified");
        self.fields
            .push(Field::new(name, column.data_type().clone(), is_nullable));
        self.columns.push(column);
    }

    fn stream(self) -> PyResult<FFI_ArrowArrayStream> {
        let schema = Arc::new(Schema::new(self.fields));
        let batch = RecordBatch::try_new(Arc::clone(&schema), self.columns);
        let batch = batch.map_err(|error| unreadable(&error))?;
        let batches = RecordBatchIterator::new([Ok(batch)], schema);
        Ok(FFI_ArrowArrayStream::new(Box::new(batches)))
    }
}
