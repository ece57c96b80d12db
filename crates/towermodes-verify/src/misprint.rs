//! A printed value that differs from the result of the model of its source.

/// The value that a source should have printed, and why it printed another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Misprint {
    /// The correct value with the digits of the source, in the case's unit.
    pub correct: f64,
    /// The cause of the difference, or that it is unknown.
    pub reason: &'static str,
}
