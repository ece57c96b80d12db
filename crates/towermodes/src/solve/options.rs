//! What a user can ask for, and why it may be refused.

use thiserror::Error;

use crate::Method;
use crate::beam::BeamRecipe;
use crate::eigen::EigenError;
use crate::elements::{BorderError, Borders, Element, GAUSS_HINGE_POSITION, Recipe};
use crate::modes::{Family, ShapePoint};
use crate::number::Plain;

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

/// How to solve a tower.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The element.
    pub method: Method,
    /// Number of segments; `None` is [`DEFAULT_SEGMENTS`] and two more for each short span between
    /// steps, kinks and what is attached.
    pub segments: Option<usize>,
    /// Where the elements of the method `bmodes` begin and end, m, from the base to the top, in
    /// place of `segments`: whatever is attached must be at one of these heights; rows of the tower
    /// need not be, and what the elements miss of them is in the errors.
    pub borders_m: Option<Vec<f64>>,
    /// Polynomial degree of the elements of the spectral beam, 2 to [`MAX_DEGREE`]; `None` raises
    /// it until the modes stand still.
    pub degree: Option<usize>,
    /// How many modes, from the lowest.
    pub modes: usize,
    /// At how many equal heights, base and top included, shapes are given.
    pub points: usize,
    /// Other heights at which shapes are given, m: [`Mode::shape_there`](crate::Mode::shape_there).
    pub heights_m: Vec<f64>,
    /// Whether sections have rotary inertia in bending (false: an Euler-Bernoulli beam).
    pub rotary_inertia: bool,
    /// Where the hinges of the cardanic element sit, as a share k of the segment from each end; (1
    /// − 1/√3)/2 unless told.
    pub hinge_position: f64,
    /// Whether what would take more than [`MAX_BYTES`] or [`MAX_SECONDS`] is refused before it
    /// begins.
    pub limits: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            method: Method::default(),
            segments: None,
            borders_m: None,
            degree: None,
            modes: DEFAULT_MODES,
            points: DEFAULT_POINTS,
            heights_m: Vec::new(),
            rotary_inertia: true,
            hinge_position: GAUSS_HINGE_POSITION,
            limits: true,
        }
    }
}

impl Options {
    /// Refuses what no tower can be asked.
    pub(super) fn check(&self) -> Result<(), SolveError> {
        if self.modes == 0 {
            return Err(SolveError::NoModes);
        }
        if let Some(degree) = self
            .degree
            .filter(|degree| !(2..=MAX_DEGREE).contains(degree))
        {
            return Err(SolveError::Degree { degree });
        }
        if self.borders_m.is_some() && self.method != Method::Bmodes {
            return Err(SolveError::BordersOfOthers);
        }
        if !(2..=MAX_POINTS).contains(&self.points) {
            return Err(SolveError::Points {
                points: self.points,
            });
        }
        if !(self.hinge_position > 0.0 && self.hinge_position < 0.5) {
            return Err(SolveError::HingePosition {
                position: self.hinge_position,
            });
        }
        Ok(())
    }

    /// Refuses more modes than a model of so many degrees of freedom has.
    pub(super) fn check_size(&self, segments: usize, available: usize) -> Result<(), SolveError> {
        let modes = self.modes;
        if modes > available {
            return Err(SolveError::TooManyModes {
                modes,
                segments,
                available,
            });
        }
        Ok(())
    }

    /// Refuses shapes that no memory holds, whatever the tower.
    pub(super) fn check_shapes(&self) -> Result<(), SolveError> {
        let (modes, points) = (self.modes, self.points + self.heights_m.len());
        if modes > MAX_BYTES / (points * size_of::<ShapePoint>()) {
            return Err(SolveError::ShapesTooLarge { modes, points });
        }
        Ok(())
    }

    /// Whether sections have rotary inertia in bending: if told so, and never with BModes.
    pub fn has_rotary_inertia(&self) -> bool {
        self.rotary_inertia && self.method != Method::Bmodes
    }

    /// What the elements of a chain need to know of it.
    pub(super) fn recipe(&self, element: Element) -> Recipe {
        Recipe {
            element,
            rotary_inertia: self.rotary_inertia,
            hinge_position: self.hinge_position,
        }
    }

    /// What the elements of a beam need to know of it, and their degree if they are spectral.
    pub(super) fn beam_recipe(&self, degree: usize) -> BeamRecipe {
        match self.method {
            Method::Bmodes => BeamRecipe::Bmodes,
            _ => BeamRecipe::Spectral {
                degree,
                rotary_inertia: self.rotary_inertia,
                shear: true,
            },
        }
    }

    /// Where segments must end.
    pub(super) fn borders(&self) -> Borders {
        match self.method {
            Method::Spectral => Borders::Gradual,
            _ => Borders::Pieces,
        }
    }
}

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
