//! The elements of a turbine.

use super::super::error::TurbineError;
use crate::beam::MAX_DEGREE;

/// Number of coordinates of each curvature over the length of a blade, if its longest element …
const CURVATURES: f64 = 24.0;
/// … but no higher degree than this.
const MOST_DEGREE_OF_BLADE: usize = 9;

/// The elements of a turbine. The defaults suit frequencies up to the second bending modes of tower
/// and blades, for blades whose elements are no longer than a twelfth of the span.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TurbineMesh {
    /// Least number of elements of the tower, which also end at its steps, kinks and attachments.
    pub tower_elements: usize,
    /// Polynomial degree of the deflections of the elements of the tower.
    pub tower_degree: usize,
    /// Polynomial degree of the deflections of a blade's elements.
    pub blade_degree: usize,
}

impl TurbineMesh {
    /// A finer mesh, from whose frequencies the error of this mesh is estimated: its higher degrees
    /// reduce the error by a factor of several.
    #[must_use]
    pub fn finer(self) -> Self {
        Self {
            tower_degree: self.tower_degree + 2,
            blade_degree: self.blade_degree + 1 + self.blade_degree / 5,
            ..self
        }
    }

    /// The default for blades whose longest element has this length as a fraction of the span: the
    /// longer, the higher the degree.
    pub(crate) fn of_blade(longest: f64) -> Self {
        let usual = Self::default();
        let degree = 1 + (CURVATURES * longest - 1e-9).ceil() as usize;
        Self {
            blade_degree: degree.clamp(usual.blade_degree, MOST_DEGREE_OF_BLADE),
            ..usual
        }
    }

    pub(crate) fn check(&self) -> Result<(), TurbineError> {
        check_mesh("the tower", self.tower_elements, self.tower_degree)?;
        check_mesh("a blade", 1, self.blade_degree)
    }
}

impl Default for TurbineMesh {
    fn default() -> Self {
        Self {
            tower_elements: 2,
            tower_degree: 6,
            blade_degree: 3,
        }
    }
}

fn check_mesh(part: &'static str, elements: usize, degree: usize) -> Result<(), TurbineError> {
    match elements > 0 && (2..=MAX_DEGREE).contains(&degree) {
        true => Ok(()),
        false => Err(TurbineError::Mesh {
            part,
            elements,
            degree,
            most: MAX_DEGREE,
        }),
    }
}
