//! Defaults of a solve, and its limits.

/// Default number of segments; each short span between steps and attachments has two more.
pub const DEFAULT_SEGMENTS: usize = 100;
/// Default number of modes.
pub const DEFAULT_MODES: usize = 8;
/// Default number of output heights of the shapes.
pub const DEFAULT_POINTS: usize = 101;
/// Largest number of segments: more would take gigabytes, and 10⁶ already leave no error but
/// rounding.
pub const MAX_SEGMENTS: usize = 2_000_000;
/// Largest number of spectral elements: each has a full matrix, and a few have no error but
/// rounding.
pub const MAX_SPECTRAL_ELEMENTS: usize = 100_000;
/// Highest degree of spectral elements.
pub const MAX_DEGREE: usize = crate::beam::MAX_DEGREE;
/// Largest number of output heights.
pub const MAX_POINTS: usize = 1_000_000;
/// A solve that would take more memory than this, bytes, is refused unless
/// [`Options::limits`](crate::Options::limits) is off. The estimate includes assembly, factors,
/// vectors, shapes and the finest mesh of the error estimate. A `usize` of 32 bits cannot hold it.
pub const MAX_BYTES: u64 = 4 << 30;
/// A solve that would take longer than this, s, on a processor of 2020 is refused unless
/// [`Options::limits`](crate::Options::limits) is off.
pub const MAX_SECONDS: f64 = 600.0;
