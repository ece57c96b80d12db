//! The study of a design: what is chosen and what is to be reached, as the table `[design]` of a
//! file describes it.
//!
//! ```toml
//! [design.variables]
//! "stations[*].wall" = { between = [0.012, 0.060], each = "can", order = "falling", step = 0.001 }
//!
//! [design.frequencies]
//! "fore-aft 1" = { between = "1P-3P", margin = 0.1 }
//!
//! [design.limits]
//! diameter_to_wall = 200
//! ```
//!
//! The types are plain data; [`DesignStudy::choices`] finds their names in a tower.

use std::ops::Range;

use towermodes::{Change, Method, ModeName, Parameter};

use crate::source::Source;
use crate::study::Placed;

/// A design as a file describes it.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignStudy {
    /// The design variables.
    pub variables: Vec<DesignVariable>,
    /// The frequency targets.
    pub frequencies: Vec<DesignFrequency>,
    /// The lowest and highest ratio of diameter to wall thickness.
    pub diameter_to_wall: Option<[f64; 2]>,
    /// The largest angle between wall and axis, degrees.
    pub cone_angle_deg: Option<f64>,
    /// Number of segments or elements; `None` is the default of a solve.
    pub segments: Option<usize>,
    /// The method; `None` is that of the tower, as `solve` takes it.
    pub method: Option<Method>,
    /// Whether sections have rotary inertia in bending.
    pub rotary_inertia: bool,
    /// The study's own file, for messages.
    pub source: Source,
}

/// An entry of `[design.variables]`.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignVariable {
    /// The name of a change.
    pub name: Placed<String>,
    /// Its lowest and highest value.
    pub between: [f64; 2],
    /// Values are multiples of it.
    pub step: Option<f64>,
    /// Which of its input values are separate variables.
    pub each: DesignEach,
    /// Whether no number may exceed the one below it.
    pub is_falling: bool,
}

/// Which input values of an entry are separate variables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DesignEach {
    /// One value for all.
    #[default]
    All,
    /// Each number.
    Number,
    /// Numbers of stations at the same height have one value: diameters at flanges.
    Height,
    /// The numbers at both ends of a can have one value: wall thicknesses.
    Can,
}

/// An entry of `[design.frequencies]`.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignFrequency {
    /// The mode.
    pub mode: ModeName,
    /// Its band.
    pub band: DesignBand,
    /// The bytes of the entry in the study.
    pub span: Range<usize>,
}

/// The band of a frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DesignBand {
    /// Lowest and highest frequency, Hz; 0 and infinity for none.
    Hz([f64; 2]),
    /// Between two multiples of the rotor speed, with a distance from both as a fraction; `None`
    /// is the default of the resonance check.
    Multiples([usize; 2], Option<f64>),
}

/// The variables and limits of a study for one tower.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DesignChoices {
    /// The changes with their bounds and steps.
    pub variables: Vec<DesignChoice>,
    /// Pairs of numbers of which the second must not exceed the first.
    pub falling: Vec<[Parameter; 2]>,
}

/// One value that a study chooses.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignChoice {
    /// The change by the variable.
    pub change: Change,
    /// The entry of [`DesignStudy::variables`] that it belongs to.
    pub entry: usize,
    /// Its lowest and highest value.
    pub between: [f64; 2],
    /// Values are multiples of it.
    pub step: Option<f64>,
}
