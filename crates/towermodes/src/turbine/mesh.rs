//! The elements of a turbine.

use super::error::TurbineError;

/// The highest polynomial degree of an element.
const MAX_DEGREE: usize = 60;

/// The elements of a turbine. The defaults suit frequencies up to the second bending modes of tower
/// and blades.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TurbineMesh {
    /// Least number of elements of the tower, which also end at its steps, kinks and attachments.
    pub tower_elements: usize,
    /// Polynomial degree of their deflections.
    pub tower_degree: usize,
    /// Polynomial degree of the deflections of a blade's elements.
    pub blade_degree: usize,
}

impl TurbineMesh {
    /// A finer mesh, whose frequencies tell the error of this one.
    #[must_use]
    pub fn finer(self) -> Self {
        Self {
            tower_degree: self.tower_degree + 2,
            blade_degree: self.blade_degree + 1,
            ..self
        }
    }

    pub(super) fn check(&self) -> Result<(), TurbineError> {
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
