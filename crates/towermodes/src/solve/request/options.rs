//! Options of the solution of a tower.

use super::super::error::SolveError;
use super::added_mass::AddedMassAt;
use super::checks::check_modes;
use super::limits::{DEFAULT_MODES, DEFAULT_POINTS, MAX_BYTES, MAX_DEGREE, MAX_POINTS};
use crate::Method;
use crate::beam::BeamRecipe;
use crate::elements::{Borders, Element, GAUSS_HINGE_POSITION, Recipe};
use crate::modes::ShapePoint;

/// How to solve a tower.
///
/// # Example
/// Twelve modes by the element of BModes, which has no rotary inertia in bending.
/// ```
/// use towermodes::{Method, Options};
///
/// let options = Options {
///     method: Method::Bmodes,
///     modes: 12,
///     ..Options::default()
/// };
/// assert!(options.rotary_inertia && !options.has_rotary_inertia());
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The method of discretization.
    pub method: Method,
    /// Number of segments; `None` is [`DEFAULT_SEGMENTS`](crate::DEFAULT_SEGMENTS) and two more for
    /// each short span between steps, kinks and attachments.
    pub segments: Option<usize>,
    /// Heights at which the elements of [`Method::Bmodes`] begin and end, m, from the base to the
    /// top, instead of `segments`. Every attachment must be at one of these heights. Rows of the
    /// tower need not be; the error estimate includes the effect of rows inside an element.
    pub borders_m: Option<Vec<f64>>,
    /// Polynomial degree of the elements of [`Method::Spectral`], 2 to [`MAX_DEGREE`]; `None`
    /// increases it until the modes converge.
    pub degree: Option<usize>,
    /// Number of modes, from the lowest.
    pub modes: usize,
    /// Number of equally spaced output heights of the shapes, base and top included.
    pub points: usize,
    /// Additional output heights of the shapes, m: [`Mode::shape_there`](crate::Mode::shape_there).
    pub heights_m: Vec<f64>,
    /// Whether sections have rotary inertia in bending (false: an Euler-Bernoulli beam).
    pub rotary_inertia: bool,
    /// Position of the hinges of [`Method::Cardanic`], as a fraction k of the segment from each
    /// end, 0 < k < 1/2; (1 − 1/√3)/2 by default.
    pub hinge_position: f64,
    /// The frequency at which the frequency-dependent added mass of a floating platform is taken.
    pub added_mass: AddedMassAt,
    /// Whether the energy of each mode by parts of the tower is computed:
    /// [`Mode::energy_parts`](crate::Mode::energy_parts).
    pub energy_parts: bool,
    /// Whether a solve whose estimated cost is above [`MAX_BYTES`] or
    /// [`MAX_SECONDS`](crate::MAX_SECONDS) is refused before it begins.
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
            added_mass: AddedMassAt::default(),
            energy_parts: false,
            limits: true,
        }
    }
}

impl Options {
    /// The same options without output heights.
    pub(crate) fn without_shapes(&self) -> Self {
        Self {
            points: 2,
            heights_m: Vec::new(),
            energy_parts: false,
            ..self.clone()
        }
    }

    /// Refuses options that are impossible for any tower.
    pub(crate) fn check(&self) -> Result<(), SolveError> {
        check_modes(self.modes)?;
        self.added_mass.check()?;
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

    /// Refuses shapes that need too much memory, whatever the tower is.
    pub(crate) fn check_shapes(&self) -> Result<(), SolveError> {
        let (modes, points) = (self.modes, self.points + self.heights_m.len());
        let bytes_per_mode = points as u64 * size_of::<ShapePoint>() as u64;
        if modes as u64 > MAX_BYTES / bytes_per_mode {
            return Err(SolveError::ShapesTooLarge { modes, points });
        }
        Ok(())
    }

    /// Whether sections have rotary inertia in bending: as [set](Self::rotary_inertia), but never
    /// with BModes.
    pub fn has_rotary_inertia(&self) -> bool {
        self.rotary_inertia && self.method != Method::Bmodes
    }

    /// The recipe of the elements of a chain.
    pub(crate) fn recipe(&self, element: Element) -> Recipe {
        Recipe {
            element,
            rotary_inertia: self.rotary_inertia,
            hinge_position: self.hinge_position,
        }
    }

    /// The recipe of the elements of a method of beams, with their degree if they are spectral.
    pub(crate) fn beam_recipe(&self, degree: usize) -> BeamRecipe {
        match self.method.converges_by_degree() {
            false => BeamRecipe::Bmodes,
            true => BeamRecipe::Spectral {
                degree,
                rotary_inertia: self.rotary_inertia,
                shear: true,
            },
        }
    }

    /// Heights at which segments must end.
    pub(crate) fn borders(&self) -> Borders {
        match self.method.converges_by_degree() {
            true => Borders::Gradual,
            false => Borders::Pieces,
        }
    }
}
