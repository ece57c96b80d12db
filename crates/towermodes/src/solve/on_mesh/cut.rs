//! The mesh of a tower, and the degree of its elements.

use super::super::error::SolveError;
use super::super::request::checks::check_segments;
use super::super::request::limits::{DEFAULT_SEGMENTS, MAX_SEGMENTS};
use super::super::request::options::Options;
use crate::Method;
use crate::elements::{Borders, Mesh};
use crate::tower::Tower;

/// A mesh with the degree of its elements.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Cut {
    pub(crate) mesh: Mesh,
    /// Polynomial degree of the spectral elements; the other methods have their own.
    pub(crate) degree: usize,
}

impl Cut {
    /// The mesh of a method that has no degree.
    pub(crate) fn new(tower: &Tower, options: &Options) -> Result<Self, SolveError> {
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

/// The last mesh, for the next tower with the same heights.
#[derive(Debug, Default)]
pub(crate) struct LastCut {
    cut: Cut,
    /// The options with which it was made; none if they are not known.
    made_with: Option<(Method, Option<usize>)>,
}

impl LastCut {
    /// The mesh of a method that has no degree: the last one if it is the same. It must be
    /// [put back](Self::put_back).
    pub(crate) fn take(&mut self, tower: &Tower, options: &Options) -> Result<Cut, SolveError> {
        let wanted = key(options);
        let is_same = wanted.is_some() && self.made_with == wanted;
        self.made_with = None;
        match is_same && self.cut.mesh.has_spans_of(tower) {
            true => Ok(std::mem::take(&mut self.cut)),
            false => Cut::new(tower, options),
        }
    }

    /// Stores a cut that was made with these options.
    pub(crate) fn put_back(&mut self, cut: Cut, options: &Options) {
        (self.cut, self.made_with) = (cut, key(options));
    }
}

/// The options on which a mesh depends besides the spans of the tower; none if it depends on more.
fn key(options: &Options) -> Option<(Method, Option<usize>)> {
    let depends_on_spans = options.borders() == Borders::Pieces && options.borders_m.is_none();
    // The elements of BModes have equal lengths over the height of the tower.
    let is_alike = depends_on_spans && options.method != Method::Bmodes;
    is_alike.then_some((options.method, options.segments))
}
