//! Defaults of a solve, and its limits.

/// Segments used unless told; where steps and point masses make short spans, each of these has two
/// on top.
pub const DEFAULT_SEGMENTS: usize = 100;
/// Modes found unless told.
pub const DEFAULT_MODES: usize = 8;
/// Heights at which shapes are given unless told.
pub const DEFAULT_POINTS: usize = 101;
/// More segments than this are refused: they would take gigabytes, and 10⁶ already leave no error
/// but rounding.
pub const MAX_SEGMENTS: usize = 2_000_000;
/// More elements of the spectral beam than this are refused: each holds a full matrix, and a few
/// have no error but rounding.
pub const MAX_SPECTRAL_ELEMENTS: usize = 100_000;
/// A higher degree of the elements of the spectral beam than this is refused; more elements do
/// more.
pub const MAX_DEGREE: usize = 60;
/// More heights than this are refused.
pub const MAX_POINTS: usize = 1_000_000;
/// A solve that would take more memory than this, in bytes, is refused unless [`Options::limits`]
/// is off: assembly, factors, vectors, shapes and the finest mesh of the error estimate together,
/// as estimated before the first of them.
pub const MAX_BYTES: usize = 4 << 30;
/// A solve that would take longer than this, s, on a processor of 2020 is refused unless
/// [`Options::limits`] is off.
pub const MAX_SECONDS: f64 = 600.0;
