//! How to solve a tower.

use super::checks::check_modes;
use super::error::SolveError;
use super::limits::{DEFAULT_MODES, DEFAULT_POINTS, MAX_BYTES, MAX_DEGREE, MAX_POINTS};
use crate::Method;
use crate::beam::BeamRecipe;
use crate::elements::{Borders, Element, GAUSS_HINGE_POSITION, Recipe};
use crate::modes::ShapePoint;

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
        check_modes(self.modes)?;
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
