//! Towers designed to frequencies, and calibrated to measured ones.
//!
//! [`design`] finds a light tower whose frequencies are in given bands; [`calibration`] finds
//! the numbers of a tower that explain measured frequencies. Both use the exact derivatives of
//! [`towermodes::Solver::sensitivities`].

pub mod calibration;
pub mod design;
