//! Meshes and degrees of the spectral method.

use super::super::error::SolveError;
use super::super::request::checks::check_segments;
use super::super::request::limits::MAX_SPECTRAL_ELEMENTS;
use super::super::request::options::Options;
use super::cut::Cut;
use crate::elements::Mesh;
use crate::tower::Tower;

/// Frequencies that change by no more than this, relatively, from one degree to the next have
/// converged.
pub(crate) const CONVERGED: f64 = 1e-10;
/// The step of the degree.
pub(crate) const STEP: usize = 2;
/// Above this degree the elements are halved instead, because their matrices are full.
const HIGHEST_DEGREE: usize = 30;
/// With more modes per element the number of elements increases, not the degree.
const MODES_AN_ELEMENT: usize = 20;

/// The first mesh and degree: one element per linear piece, more where it is steep, or the number
/// requested.
pub(crate) fn first_cut(tower: &Tower, options: &Options) -> Result<Cut, SolveError> {
    let borders = options.borders();
    let mut mesh = match options.segments {
        None => Mesh::coarsest(tower, borders),
        Some(segments) => {
            check_segments(segments, MAX_SPECTRAL_ELEMENTS)?;
            Mesh::new(tower, borders, segments)
        }
    };
    while options.modes / MODES_AN_ELEMENT > mesh.segments()
        && 2 * mesh.segments() <= MAX_SPECTRAL_ELEMENTS
    {
        mesh = mesh.doubled();
    }
    check_segments(mesh.segments(), MAX_SPECTRAL_ELEMENTS)?;
    Ok(Cut {
        degree: first_degree(options.modes, mesh.segments()),
        mesh,
    })
}

/// A degree at which `modes` modes of `elements` elements are nearly converged.
fn first_degree(modes: usize, elements: usize) -> usize {
    // Half of the modes are in each bending plane, and a half wave needs a degree of about one and
    // a half; an element with only part of a half wave needs less.
    if modes >= elements {
        7 + modes.div_ceil(elements)
    } else {
        4 + (4 * modes).div_ceil(elements)
    }
}

/// The next finer cut: a higher degree, or elements of half the length.
pub(crate) fn finer(cut: Cut, options: &Options) -> Cut {
    if cut.degree + STEP <= HIGHEST_DEGREE {
        return Cut {
            degree: cut.degree + STEP,
            ..cut
        };
    }
    let mesh = cut.mesh.doubled();
    Cut {
        degree: first_degree(options.modes, mesh.segments()),
        mesh,
    }
}

pub(crate) fn can_be_finer(cut: &Cut, options: &Options) -> bool {
    let elements = cut.mesh.segments();
    cut.degree + STEP <= HIGHEST_DEGREE
        || 2 * elements <= MAX_SPECTRAL_ELEMENTS.min(64 * options.modes)
}
