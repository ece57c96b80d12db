//! Design of towers for given frequencies, and calibration with measured frequencies.
//!
//! [`design`] finds a light tower whose frequencies are in given bands; [`calibration`] fits input
//! values of a tower to measured frequencies. Both use the exact derivatives of
//! [`towermodes::Solver::sensitivities`].

pub mod calibration;
pub mod design;
