//! Converts the files of `design` and `calibrate` to problems, and results to documents, for the
//! program and the Python package.

pub mod calibration;
pub mod design;
pub mod first_order;
