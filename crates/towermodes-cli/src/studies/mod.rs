//! From the files of `design` and `calibrate` to problems, and from results to documents: what the
//! program and the Python package have in common.

pub mod calibration;
pub mod design;
pub mod first_order;
