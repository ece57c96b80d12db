//! The tower that a sweep changes.

use towermodes::{Method, Options, TowerDescription};
use towermodes_files::{Prescribed, SweepResults, TowerInput};

/// Number of segments of a sweep if it is not given. With the extrapolation from half and twice as
/// many segments the frequencies of the first modes have five to seven correct digits, as with 100
/// segments without extrapolation, in a fifth of the time.
pub const DEFAULT_SWEEP_SEGMENTS: usize = 20;

/// The tower that a sweep changes, with the options that its file prescribes.
///
/// A BModes deck prescribes the method `bmodes` and its own elements; a sweep uses them as `solve`
/// does, unless the sweep gives a method or a number of segments. The element boundaries of a deck
/// do not move with varied heights: a row in which they do not fit the tower fails with a message.
#[derive(Debug, Clone, PartialEq)]
pub struct Base {
    /// The tower description.
    pub description: TowerDescription,
    /// Options that its file prescribes.
    pub prescribed: Prescribed,
}

impl From<TowerDescription> for Base {
    fn from(description: TowerDescription) -> Self {
        Self {
            description,
            prescribed: Prescribed::default(),
        }
    }
}

impl From<&TowerInput> for Base {
    fn from(input: &TowerInput) -> Self {
        Self {
            description: input.description.clone(),
            prescribed: input.prescribed.clone(),
        }
    }
}

impl Base {
    /// The options of each solve, without shapes: those of `solve`, but with
    /// [`DEFAULT_SWEEP_SEGMENTS`].
    pub(crate) fn options(&self, results: &SweepResults) -> Options {
        let own = self.prescribed.options(results.method, results.segments);
        // The spectral method chooses its elements by itself.
        let chooses = own.method == Method::Spectral || own.borders_m.is_some();
        let default = (!chooses).then_some(DEFAULT_SWEEP_SEGMENTS);
        Options {
            segments: results.segments.or(default),
            rotary_inertia: results.rotary_inertia,
            points: 2,
            ..own
        }
    }
}
