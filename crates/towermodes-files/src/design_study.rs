//! The design file: design variables, frequency targets and limits, as the table `[design]`
//! describes them.
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
    /// Number of segments or elements; `None` for the default of `solve`.
    pub segments: Option<usize>,
    /// The method; `None` for the default of `solve` for this tower.
    pub method: Option<Method>,
    /// Whether sections have rotary inertia in bending.
    pub rotary_inertia: bool,
    /// The design file, for messages.
    pub source: Source,
}

/// An entry of `[design.variables]`.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignVariable {
    /// The name of a change.
    pub name: Placed<String>,
    /// Its lowest and highest value.
    pub between: [f64; 2],
    /// The step; values are multiples of it.
    pub step: Option<f64>,
    /// Which of its input values are separate variables.
    pub each: DesignEach,
    /// Whether no input value may exceed the one below it.
    pub is_falling: bool,
}

/// Which input values of an entry are separate variables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DesignEach {
    /// One value for all.
    #[default]
    All,
    /// Each input value is a variable.
    Number,
    /// Input values of stations at the same height have one value, for example diameters at
    /// flanges.
    Height,
    /// The input values at both ends of a can have one value, for example wall thicknesses.
    Can,
}

/// An entry of `[design.frequencies]`.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignFrequency {
    /// The mode.
    pub mode: ModeName,
    /// Its band.
    pub band: DesignBand,
    /// The byte range of the entry in the file.
    pub span: Range<usize>,
}

/// The band of a frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DesignBand {
    /// Lowest and highest frequency, Hz; 0 and infinity for no limit.
    Hz([f64; 2]),
    /// Between two multiples of the rotor speed, with a distance from both as a fraction; `None`
    /// for the default of the resonance check.
    Multiples([usize; 2], Option<f64>),
}

/// The variables and limits of a design file for one tower.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DesignChoices {
    /// The changes with their bounds and steps.
    pub variables: Vec<DesignChoice>,
    /// Pairs of input values of which the second must not exceed the first.
    pub falling: Vec<[Parameter; 2]>,
}

/// One design variable of a tower.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignChoice {
    /// The change that the variable makes.
    pub change: Change,
    /// The entry of [`DesignStudy::variables`] that it belongs to.
    pub entry: usize,
    /// Its lowest and highest value.
    pub between: [f64; 2],
    /// The step; values are multiples of it.
    pub step: Option<f64>,
}
