//! The modes of a frame.

use std::f64::consts::TAU;

use super::assembly::{Assembled, Purpose, assemble};
use super::error::FrameSolveError;
use super::mechanism::{least_lambda, mechanism};
use super::pencil::FramePencil;
use super::recipe::FrameRecipe;
use super::shape::{FrameShape, ShapeReader};
use super::statics::{AtRest, with_tensions};
use super::tension::ForcesAtRest;
use crate::beam::MAX_DEGREE;
use crate::eigen::{EigenError, EigenWorkspace, lowest};
use crate::tower::frame::Frame;

/// The first degree of spectral elements, and the step of the degree.
const FIRST_DEGREE: usize = 4;
const STEP: usize = 2;
const LAST_DEGREE: usize = 16;
/// Relative change of all frequencies at which they have converged.
const CONVERGED: f64 = 1e-10;

/// How a frame is solved.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameOptions {
    /// Number of modes.
    pub modes: usize,
    /// How members are made into elements; none: spectral elements whose degree rises until the
    /// frequencies have converged.
    pub recipe: Option<FrameRecipe>,
    /// Gravity, m/s², for the geometric stiffness of the weight of the frame, less its buoyancy; 0
    /// for none.
    pub gravity_m_per_s2: f64,
}

impl Default for FrameOptions {
    fn default() -> Self {
        Self {
            modes: 8,
            recipe: None,
            gravity_m_per_s2: 0.0,
        }
    }
}

/// A mode of a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameMode {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Bound on the algebraic error of the frequency, Hz.
    pub error_hz: f64,
    /// Estimate of the discretization error, Hz: the difference from the degree before, of a given
    /// degree that from a higher one; 0 for SubDyn's elements, whose number is given.
    pub discretization_error_hz: f64,
    /// Its shape, m and rad, so that the modal mass is 1 kg.
    pub shape: FrameShape,
    /// The same of the reference point of the transition piece.
    pub transition: Option<[f64; 6]>,
}

/// The modes of a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameSolution {
    /// The lowest modes, rising.
    pub modes: Vec<FrameMode>,
    /// Up to this frequency, Hz, no mode is missing: a count proved it.
    pub complete_below_hz: f64,
    /// Number of unknowns.
    pub degrees_of_freedom: usize,
    /// Degree of spectral elements.
    pub degree: Option<usize>,
    /// What moves without stiffness, if the frame is a mechanism: these modes have 0 Hz. None for
    /// the six motions of a frame that nothing holds.
    pub mechanism: Option<FrameSolveError>,
}

/// Solves a frame for its lowest modes, and proves that none is missing.
///
/// # Errors
/// [`FrameSolveError`].
pub fn solve_frame(
    frame: &Frame,
    options: &FrameOptions,
) -> Result<FrameSolution, FrameSolveError> {
    let at = |degree| solve_once(frame, options, FrameRecipe::Spectral { degree });
    match options.recipe {
        Some(recipe @ FrameRecipe::Subdyn { .. }) => return solve_once(frame, options, recipe),
        Some(FrameRecipe::Spectral { degree }) => {
            let mut own = at(degree)?;
            compare(&mut own, &at(neighbour(degree))?);
            return Ok(own);
        }
        None => {}
    }
    let mut degree = FIRST_DEGREE;
    let mut coarse = loop {
        match at(degree) {
            // A higher degree has more modes.
            Err(FrameSolveError::Modes { modes, .. }) if modes > 0 && degree < LAST_DEGREE => {
                degree += STEP;
            }
            other => break other?,
        }
    };
    loop {
        degree += STEP;
        let mut fine = at(degree)?;
        compare(&mut fine, &coarse);
        let has_converged = |mode: &FrameMode| {
            mode.discretization_error_hz <= CONVERGED * mode.frequency_hz + 2.0 * mode.error_hz
        };
        if degree >= LAST_DEGREE || fine.modes.iter().all(has_converged) {
            return Ok(fine);
        }
        coarse = fine;
    }
}

/// The degree with which the error of another degree is estimated: a higher degree if possible.
fn neighbour(degree: usize) -> usize {
    match degree + STEP <= MAX_DEGREE {
        true => degree + STEP,
        false => degree - STEP,
    }
}

/// The discretization errors of modes, from elements of another degree.
fn compare(solution: &mut FrameSolution, other: &FrameSolution) {
    for (mode, other) in solution.modes.iter_mut().zip(&other.modes) {
        mode.discretization_error_hz = (mode.frequency_hz - other.frequency_hz).abs();
    }
}

/// The number of modes of a frame below a frequency, Hz, by an eigenvalue count.
///
/// # Errors
/// [`FrameSolveError`]: an impossible recipe or loops that cannot be solved.
pub fn count_frame_modes(
    frame: &Frame,
    recipe: FrameRecipe,
    below_hz: f64,
) -> Result<usize, FrameSolveError> {
    let assembled = assemble(
        frame,
        recipe,
        &ForcesAtRest::default(),
        Purpose::Frequencies,
    )?;
    let omega = TAU * below_hz;
    Ok(FramePencil::new(assembled.equations).count_below_lambda(omega * omega))
}

fn solve_once(
    frame: &Frame,
    options: &FrameOptions,
    recipe: FrameRecipe,
) -> Result<FrameSolution, FrameSolveError> {
    let wanted = options.modes;
    let at_rest = AtRest {
        gravity_m_per_s2: options.gravity_m_per_s2,
        has_buoyancy: true,
    };
    let Assembled {
        equations,
        joints,
        joint_of_node,
        transition,
        samples,
        ..
    } = with_tensions(
        frame,
        at_rest,
        |frame, forces, purpose| assemble(frame, recipe, forces, purpose),
        |_| {},
    )?;
    let available = equations.unknowns;
    if wanted == 0 || wanted > available {
        return Err(FrameSolveError::Modes {
            modes: wanted,
            available,
        });
    }
    let mut pencil = FramePencil::new(equations);
    let mut workspace = EigenWorkspace::default();
    let mechanism = match check_stiffness(frame, (&joints, &joint_of_node), &mut pencil)? {
        Some(error @ FrameSolveError::TooSoft { .. }) => return Err(error),
        mechanism => mechanism,
    };
    lowest(&mut pencil, wanted, &mut workspace).map_err(|error| match error {
        EigenError::Unresolved { wanted, resolved } => FrameSolveError::Unresolved {
            modes: wanted,
            resolved,
        },
        error => error.into(),
    })?;
    let reader = ShapeReader { joints, samples };
    let mut motions = Vec::new();
    let modes = workspace.eigenvalues()[..wanted]
        .iter()
        .enumerate()
        .map(|(index, eigenvalue)| {
            let own = eigenvalue.shifted(pencil.origin);
            // uᵀ(K − σM)u = 1, so the modal mass is 1/(λ − σ).
            let scale = eigenvalue.lambda.sqrt();
            let vector = workspace.vector(index);
            pencil.equations.set_motions(vector, &mut motions);
            let shape = reader.read(frame, &motions, vector);
            FrameMode {
                frequency_hz: own.frequency_hz(),
                error_hz: own.frequency_error_hz(),
                discretization_error_hz: 0.0,
                shape: shape.divided_by(1.0 / scale),
                transition: transition.map(|node| motions[node].map(|x| scale * x)),
            }
        });
    let modes: Vec<FrameMode> = modes.collect();
    let last = workspace
        .eigenvalues()
        .last()
        .map_or(0.0, |e| e.shifted(pencil.origin).lambda);
    Ok(FrameSolution {
        modes,
        complete_below_hz: last.max(0.0).sqrt() / TAU,
        degrees_of_freedom: available,
        degree: match recipe {
            FrameRecipe::Spectral { degree } => Some(degree),
            FrameRecipe::Subdyn { .. } => None,
        },
        mechanism,
    })
}

/// Refuses an unstable frame. Returns the motions without stiffness if the frame is a mechanism.
/// The spectrum of a mechanism is computed with an origin below zero, and also that of a free
/// frame, which has six motions without stiffness.
pub(super) fn check_stiffness(
    frame: &Frame,
    (joints, joint_of_node): (&[Option<usize>], &[usize]),
    pencil: &mut FramePencil,
) -> Result<Option<FrameSolveError>, FrameSolveError> {
    let least = least_lambda();
    match pencil.count_below_lambda(-least) {
        0 => {}
        negative => return Err(FrameSolveError::Unstable { negative }),
    }
    let still = pencil.count_below_lambda(least);
    if still == 0 {
        return Ok(None);
    }
    // Far enough below zero that the factorization keeps its digits, near enough for the digits of
    // the slow modes.
    let mut softest = least;
    while pencil.count_below_lambda(softest) <= still && softest < 1e12 {
        softest *= 2.0;
    }
    pencil.origin = -0.1 * softest;
    let is_free = frame.description().supports.is_empty() && !frame.has_soil();
    let is_free = is_free && !joints.contains(&None);
    if is_free && still <= 6 {
        return Ok(None);
    }
    let at = (&pencil.equations, &pencil.order);
    Ok(mechanism(frame, at, joint_of_node))
}
