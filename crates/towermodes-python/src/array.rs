//! Numbers as NumPy arrays.

use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods};
use pyo3::prelude::*;

/// An array of one axis.
pub fn vector(py: Python<'_>, values: impl IntoIterator<Item = f64>) -> Bound<'_, PyArray1<f64>> {
    PyArray1::from_vec(py, values.into_iter().collect())
}

/// An array of rows of a fixed length.
pub fn rows<const N: usize>(
    py: Python<'_>,
    rows: impl ExactSizeIterator<Item = [f64; N]>,
) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let count = rows.len();
    PyArray1::from_vec(py, rows.flatten().collect()).reshape([count, N])
}

/// An array (sheets, rows, N) from its values in this order.
pub fn sheets<const N: usize>(
    py: Python<'_>,
    values: impl Iterator<Item = [f64; N]>,
    [sheets, rows]: [usize; 2],
) -> PyResult<Bound<'_, PyArray3<f64>>> {
    PyArray1::from_vec(py, values.flatten().collect()).reshape([sheets, rows, N])
}
