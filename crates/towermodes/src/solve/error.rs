//! Why a tower or a blade was not solved.

use thiserror::Error;

use super::limits::{MAX_BYTES, MAX_DEGREE, MAX_POINTS, MAX_SECONDS};
use crate::eigen::EigenError;
use crate::elements::BorderError;
use crate::modes::Family;
use crate::number::Plain;

/// Buckling load factors above this and below 1 are so near to 1 that small changes decide.
const ON_THE_VERGE: f64 = 0.99;

/// What such a factor means.
const VERGE_OF_BUCKLING: &str = ", so it is on the verge of buckling: weights that are smaller by the difference from 1 let it stand";

/// A buckling load factor with six digits, or as many as tell it from 1.
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
    /// A blade that its rotation turns over.
    #[error("at {} rpm the blade is unstable: centrifugal forces are larger than {negative} of its stiffnesses", Plain(*.rotor_speed_rpm))]
    UnstableBlade {
        /// Speed of the rotor, rpm.
        rotor_speed_rpm: f64,
        /// Number of negative eigenvalues of its stiffness.
        negative: usize,
    },
    /// Borders for a method that has its own.
    #[error(
        "borders of elements are for the method bmodes; the others have theirs at the tower's steps and kinks"
    )]
    BordersOfOthers,
    /// Borders at which a tower cannot be cut.
    #[error(transparent)]
    Borders(#[from] BorderError),
    /// No segments, or too many.
    #[error("{segments} segments cannot be used; the number must be from 1 to {most}")]
    Segments {
        /// The number asked for, or that the tower's steps make.
        segments: usize,
        /// The most that the method takes.
        most: usize,
    },
    /// A degree of the spectral beam that cannot be.
    #[error(
        "elements of degree {degree} cannot be used; the degree must be from 2 to {MAX_DEGREE}"
    )]
    Degree {
        /// The degree asked for.
        degree: usize,
    },
    /// A method without shear deformation where only one that has it makes sense.
    #[error("BModes has no shear deformation, so it converges to no beam of a tower that shears")]
    NoShear,
    /// No modes asked for.
    #[error("no modes were asked for; the least is 1")]
    NoModes,
    /// More modes than degrees of freedom.
    #[error(
        "{modes} modes were asked for, but there are only {available} degrees of freedom (segments: {segments})"
    )]
    TooManyModes {
        /// The number asked for.
        modes: usize,
        /// Number of segments.
        segments: usize,
        /// Degrees of freedom.
        available: usize,
    },
    /// Shapes that would need more memory than a workstation has to spare.
    #[error("shapes of {modes} modes at {points} heights would need more than {} GiB; ask for fewer of either", MAX_BYTES >> 30)]
    ShapesTooLarge {
        /// Modes asked for.
        modes: usize,
        /// Heights asked for.
        points: usize,
    },
    /// Fewer heights than base and top, or too many.
    #[error(
        "shapes cannot be given at {points} heights; the number must be from 2 to {MAX_POINTS}"
    )]
    Points {
        /// The number asked for.
        points: usize,
    },
    /// Hinges that are not inside the halves of a segment.
    #[error("the hinge position {position} is not between 0 and 0.5, the middle of a segment")]
    HingePosition {
        /// The position asked for.
        position: f64,
    },
    /// More memory than a workstation has to spare.
    #[error(
        "{modes} modes of {degrees_of_freedom} degrees of freedom would need about {:.0} GiB of memory; the limit is {} GiB",
        .bytes / f64::from(1 << 30),
        MAX_BYTES >> 30
    )]
    TooLarge {
        /// Modes asked for.
        modes: usize,
        /// Degrees of freedom.
        degrees_of_freedom: usize,
        /// What it would need, bytes.
        bytes: f64,
    },
    /// More time than anybody waits without having asked for it.
    #[error(
        "{modes} modes of {degrees_of_freedom} degrees of freedom would take about {:.0} minutes; the limit is {:.0}",
        .seconds / 60.0,
        MAX_SECONDS / 60.0
    )]
    TooSlow {
        /// Modes asked for.
        modes: usize,
        /// Degrees of freedom.
        degrees_of_freedom: usize,
        /// What it would take, s.
        seconds: f64,
    },
    /// The weights are more than the tower bears.
    #[error(
        "the tower buckles under its own weight: it would bear {} times the weights it carries{}",
        factor(*.load_factor), if *.load_factor > ON_THE_VERGE { VERGE_OF_BUCKLING } else { "" }
    )]
    Buckles {
        /// The factor by which the weights must be multiplied for the tower to be just stable,
        /// below 1.
        load_factor: f64,
    },
    /// The weights are more than the tower bears on its segments, though not more than the beam
    /// bears.
    #[error(
        "on {segments} segments the tower buckles under its own weight: it would bear {} times the weights it carries; the beam itself bears {} \
         times these, so the tower stands, but is on the verge of buckling; use more segments, or the method spectral",
        factor(*.load_factor), factor(*.of_the_beam)
    )]
    BucklesOnSegments {
        /// Segments, or elements, used.
        segments: usize,
        /// The factor by which the weights must be multiplied for the tower on its segments to be
        /// just stable, below 1.
        load_factor: f64,
        /// The same of the beam itself, above 1.
        of_the_beam: f64,
    },
    /// A floating tower that does not stay as it is, as one body or by buckling.
    #[error("the floating tower is unstable in {}: its stiffness there is negative", .motion.noun())]
    Unstable {
        /// The motion that grows.
        motion: Family,
    },
    /// The eigenvalues were not found.
    #[error(transparent)]
    Eigen(#[from] EigenError),
}

impl SolveError {
    /// Whether the request is at fault, not the tower or the computation.
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
