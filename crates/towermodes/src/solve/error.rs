//! Errors of the solution of a tower or a blade.

use thiserror::Error;

use super::request::limits::{MAX_BYTES, MAX_DEGREE, MAX_POINTS, MAX_SECONDS};
use crate::eigen::EigenError;
use crate::elements::BorderError;
use crate::frame::FrameSolveError;
use crate::modes::Family;
use crate::number::Plain;

/// Buckling load factors between this and 1 are so close to 1 that small changes matter.
const ON_THE_VERGE: f64 = 0.99;

/// The consequence of such a factor.
const VERGE_OF_BUCKLING: &str = ", just below 1: the tower is close to the buckling limit";

/// A buckling load factor with six digits, or as many as distinguish it from 1.
fn factor(load_factor: f64) -> String {
    let difference = (load_factor - 1.0).abs();
    let decimals = match difference {
        d if d > 1e-5 || d == 0.0 => 6,
        d => (1.0 - d.log10().floor()).min(16.0) as usize,
    };
    format!("{:.decimals$}", Plain(load_factor))
}

/// Why a tower was not solved.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SolveError {
    /// A blade that is unstable at its rotor speed.
    #[error(
        "the blade is unstable at {} rpm: the stiffness matrix including centrifugal terms has {negative} negative eigenvalues",
        Plain(*.rotor_speed_rpm)
    )]
    UnstableBlade {
        /// Speed of the rotor, rpm.
        rotor_speed_rpm: f64,
        /// Number of negative eigenvalues of its stiffness.
        negative: usize,
    },
    /// Element borders for a method that chooses its own.
    #[error(
        "element boundaries can be given only for the method bmodes; the other methods set them at steps and changes of taper"
    )]
    BordersOfOthers,
    /// A frame under the tower that cannot be solved.
    #[error(transparent)]
    Frame(#[from] FrameSolveError),
    /// Borders that a mesh of this tower cannot have.
    #[error(transparent)]
    Borders(#[from] BorderError),
    /// No segments, or too many.
    #[error("the number of segments is {segments}; it must be from 1 to {most}")]
    Segments {
        /// The number requested, or required by the tower's steps.
        segments: usize,
        /// The largest number for the method.
        most: usize,
    },
    /// An impossible degree of spectral elements.
    #[error("the polynomial degree is {degree}; it must be from 2 to {MAX_DEGREE}")]
    Degree {
        /// The degree requested.
        degree: usize,
    },
    /// A method without shear deformation for a tower that has it.
    #[error(
        "the method bmodes has no shear deformation, so it cannot converge to the reference solution of a tower with shear; set shear = false or choose another method"
    )]
    NoShear,
    /// No modes requested.
    #[error("the number of modes is 0; it must be at least 1")]
    NoModes,
    /// More modes than degrees of freedom.
    #[error(
        "{modes} modes are requested, but the model has only {available} degrees of freedom ({segments} segment{})",
        if *.segments == 1 { "" } else { "s" }
    )]
    TooManyModes {
        /// The number requested.
        modes: usize,
        /// Number of segments.
        segments: usize,
        /// Degrees of freedom.
        available: usize,
    },
    /// Shapes that would need too much memory.
    #[error("mode shapes of {modes} modes at {points} heights need more than {} GiB of memory; reduce the number of modes or of heights", MAX_BYTES >> 30)]
    ShapesTooLarge {
        /// Modes requested.
        modes: usize,
        /// Output heights requested.
        points: usize,
    },
    /// Fewer than two output heights, or too many.
    #[error("the number of heights for mode shapes is {points}; it must be from 2 to {MAX_POINTS}")]
    Points {
        /// The number requested.
        points: usize,
    },
    /// A mode whose own frequency, with the added mass at this frequency, was not found.
    #[error(
        "the search for the frequency of mode {mode} with the added mass at its own frequency did not end; it was last at {} Hz",
        Plain(*.hz)
    )]
    OwnAddedMass {
        /// The mode, from 1.
        mode: usize,
        /// The last frequency of the search, Hz.
        hz: f64,
    },
    /// A frequency of the added mass that is negative or not finite.
    #[error("the frequency of the added mass is {hz} Hz; it must be 0 or positive")]
    AddedMassAt {
        /// The frequency requested, Hz.
        hz: f64,
    },
    /// Hinges that are not inside the halves of a segment.
    #[error(
        "the hinge position is {position}; it must be greater than 0 and less than 0.5 (the middle of the segment)"
    )]
    HingePosition {
        /// The position requested.
        position: f64,
    },
    /// A solve that would need too much memory.
    #[error(
        "{modes} modes with {degrees_of_freedom} degrees of freedom need about {:.0} GiB of memory; the limit is {} GiB",
        .bytes / f64::from(1 << 30),
        MAX_BYTES >> 30
    )]
    TooLarge {
        /// Modes requested.
        modes: usize,
        /// Degrees of freedom.
        degrees_of_freedom: usize,
        /// Estimated memory, bytes.
        bytes: f64,
    },
    /// A solve that would take too long.
    #[error(
        "{modes} modes with {degrees_of_freedom} degrees of freedom take about {:.0} minutes; the limit is {:.0} minutes",
        .seconds / 60.0,
        MAX_SECONDS / 60.0
    )]
    TooSlow {
        /// Modes requested.
        modes: usize,
        /// Degrees of freedom.
        degrees_of_freedom: usize,
        /// Estimated time, s.
        seconds: f64,
    },
    /// The tower buckles under its self-weight.
    #[error(
        "the tower buckles under gravity: the buckling load factor is {}{}",
        factor(*.load_factor), if *.load_factor > ON_THE_VERGE { VERGE_OF_BUCKLING } else { "" }
    )]
    Buckles {
        /// The factor by which self-weight must be multiplied for the tower to buckle, below 1.
        load_factor: f64,
    },
    /// The discretized tower buckles under its self-weight, but the reference beam solution does
    /// not.
    #[error(
        "with {segments} segments the tower buckles under gravity: the buckling load factor is {}; the reference solution gives {}, \
         so the tower does not buckle, but it is close to the limit; use more segments or the method spectral",
        factor(*.load_factor), factor(*.of_the_beam)
    )]
    BucklesOnSegments {
        /// Segments, or elements, used.
        segments: usize,
        /// The buckling load factor of the discretized tower, below 1.
        load_factor: f64,
        /// The buckling load factor of the reference beam solution, above 1.
        of_the_beam: f64,
    },
    /// A floating tower that is unstable, as a rigid body or by buckling.
    #[error("the floating tower is unstable in {}: the stiffness of this motion is negative", .motion.noun())]
    Unstable {
        /// The unstable motion, with negative stiffness.
        motion: Family,
    },
    /// The computation of the eigenvalues failed.
    #[error(transparent)]
    Eigen(#[from] EigenError),
}

impl SolveError {
    /// Whether the cause is an invalid option, and not the tower or the computation.
    pub fn is_usage(&self) -> bool {
        !matches!(
            self,
            Self::Eigen(_)
                | Self::Buckles { .. }
                | Self::BucklesOnSegments { .. }
                | Self::Unstable { .. }
                | Self::UnstableBlade { .. }
        )
    }
}
