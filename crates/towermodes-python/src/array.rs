//! Numbers as read-only NumPy arrays, so that results cannot be changed.

use numpy::ndarray::Dimension;
use numpy::{Element, PyArray, PyArray1, PyArray2, PyArray3, PyArrayMethods};
use pyo3::prelude::*;

/// A one-dimensional array.
pub fn vector(py: Python<'_>, values: impl IntoIterator<Item = f64>) -> Bound<'_, PyArray1<f64>> {
    constant(PyArray1::from_vec(py, values.into_iter().collect()))
}

/// An array of rows of a fixed length.
pub fn rows<const N: usize>(
    py: Python<'_>,
    rows: impl ExactSizeIterator<Item = [f64; N]>,
) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let count = rows.len();
    let array = PyArray1::from_vec(py, rows.flatten().collect());
    array.reshape([count, N]).map(constant)
}

/// An array (sheets, rows, N) from its values in this order.
pub fn sheets<const N: usize>(
    py: Python<'_>,
    values: impl Iterator<Item = [f64; N]>,
    [sheets, rows]: [usize; 2],
) -> PyResult<Bound<'_, PyArray3<f64>>> {
    let array = PyArray1::from_vec(py, values.flatten().collect());
    array.reshape([sheets, rows, N]).map(constant)
}

/// The array, made read-only.
fn constant<T: Element, D: Dimension>(array: Bound<'_, PyArray<T, D>>) -> Bound<'_, PyArray<T, D>> {
    drop(array.readwrite().make_nonwriteable());
    array
}
