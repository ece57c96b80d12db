//! The mesh of a tower, and how finely each segment is represented.

use super::checks::check_segments;
use super::error::SolveError;
use super::limits::{DEFAULT_SEGMENTS, MAX_SEGMENTS};
use super::options::Options;
use crate::Method;
use crate::elements::Mesh;
use crate::tower::Tower;

/// A mesh with the degree of its elements.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cut {
    pub(super) mesh: Mesh,
    /// Polynomial degree of the spectral elements; the other methods have their own.
    pub(super) degree: usize,
}

impl Cut {
    /// The mesh of a method that has no degree.
    pub(super) fn new(tower: &Tower, options: &Options) -> Result<Self, SolveError> {
        let mesh = mesh_of(tower, options)?;
        Ok(Self { mesh, degree: 0 })
    }

    /// The degree of the elements, if the method has one to choose.
    pub(super) fn degree_of(&self, method: Method) -> Option<usize> {
        (method == Method::Spectral).then_some(self.degree)
    }
}

fn mesh_of(tower: &Tower, options: &Options) -> Result<Mesh, SolveError> {
    let (borders, most) = (options.borders(), MAX_SEGMENTS);
    if let Some(borders_m) = &options.borders_m {
        check_segments(borders_m.len().saturating_sub(1), most)?;
        return Ok(Mesh::with_borders(tower, borders_m)?);
    }
    let fewest = Mesh::fewest_segments(tower, borders);
    let Some(segments) = options.segments else {
        check_segments(fewest, most)?;
        return Ok(Mesh::at_least(tower, borders, DEFAULT_SEGMENTS));
    };
    check_segments(segments, most)?;
    check_segments(fewest, most)?;
    // BModes' own elements are equal wherever they can be.
    let equal = match options.method {
        Method::Bmodes => Mesh::equal(tower, borders, segments),
        _ => None,
    };
    Ok(equal.unwrap_or_else(|| Mesh::new(tower, borders, segments)))
}
