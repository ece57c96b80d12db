//! All tests of design and calibration, in one program.

mod calibration;
mod design;
