//! Measured frequencies and the input values to be fitted to them, as a file describes them.
//!
//! ```toml
//! [calibrate.unknowns]
//! "foundation.rocking" = {}
//! "foundation.lateral" = { prior = [2e9, 1e9], bounds = [1e8, 1e11] }
//!
//! [[measured]]
//! mode = "fore-aft 1"
//! frequency = 0.2585
//! deviation = 0.001
//! ```

use std::ops::Range;

use towermodes::ModeName;

use crate::source::Source;
use crate::study::Placed;

/// Measurements and unknowns of a calibration.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredFile {
    /// The unknowns by name, in the order of the lines.
    pub unknowns: Vec<NamedUnknown>,
    /// The measurements, in the order of the file.
    pub measured: Vec<MeasuredMode>,
    /// The calibration file, for messages.
    pub source: Source,
}

/// An input value to be fitted.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedUnknown {
    /// The name of the change.
    pub name: Placed<String>,
    /// Mean and standard deviation, if they are known independently of the measurements.
    pub prior: Option<[f64; 2]>,
    /// The lowest and the highest value.
    pub bounds: Option<[f64; 2]>,
}

/// A measured natural frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredMode {
    /// The mode, if it is given.
    pub mode: Option<ModeName>,
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Standard deviation, Hz.
    pub deviation_hz: f64,
    /// Rows of height, m, fore-aft and side-side displacement, with any common factor; may be
    /// empty.
    pub shape: Vec<[f64; 3]>,
    /// The byte range of the table in the file.
    pub span: Range<usize>,
}
