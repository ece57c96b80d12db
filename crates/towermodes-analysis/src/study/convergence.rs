//! The convergence of one method as its number of segments, or its degree, increases.

use super::follow::{FollowedMode, compared, followed, not_found, solve_for};
use towermodes::Method;
use towermodes::Warning;
use towermodes::tower::Tower;
use towermodes::{MAX_SEGMENTS, Options, SolveError, Solver};

/// The refinement of a method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fineness {
    /// A number of segments or elements.
    Segments(usize),
    /// A polynomial degree of the method spectral.
    Degree(usize),
}

impl Fineness {
    /// The value of the refinement.
    pub fn number(self) -> usize {
        match self {
            Self::Segments(number) | Self::Degree(number) => number,
        }
    }

    /// The polynomial degree, if the refinement is a degree.
    pub fn degree(self) -> Option<usize> {
        match self {
            Self::Segments(_) => None,
            Self::Degree(degree) => Some(degree),
        }
    }

    /// The options with this refinement.
    fn applied_to(self, options: &Options) -> Options {
        let mut options = options.clone();
        match self {
            Self::Segments(segments) => options.segments = Some(segments),
            Self::Degree(degree) => options.degree = Some(degree),
        }
        options
    }
}

#[cfg(feature = "serde")]
fn serialize_degree<S: serde::Serializer>(
    asked: &Fineness,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serde::Serialize::serialize(&asked.degree(), serializer)
}

/// The errors at one refinement.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Level {
    /// Number of segments or elements used.
    pub segments: usize,
    /// The requested refinement. In JSON `degree`: the polynomial degree of the elements of the
    /// method spectral; null for other methods.
    #[cfg_attr(
        feature = "serde",
        serde(rename = "degree", serialize_with = "serialize_degree")
    )]
    #[cfg_attr(feature = "schema", schemars(with = "Option<usize>"))]
    pub asked: Fineness,
    /// Degrees of freedom of the whole tower.
    pub degrees_of_freedom: usize,
    /// The frequency of each mode, Hz; none if the mesh does not have this mode.
    pub frequencies_hz: Vec<Option<f64>>,
    /// The relative error f/f_limit − 1 of each mode.
    #[cfg_attr(feature = "serde", serde(rename = "relative_errors"))]
    pub errors: Vec<Option<f64>>,
    /// The observed order p of the error n⁻ᵖ relative to the previous level; for the method
    /// spectral the number of decimal digits gained per degree. None if the error is only rounding.
    #[cfg_attr(feature = "serde", serde(rename = "observed_orders"))]
    pub orders: Vec<Option<f64>>,
}

/// The convergence of one method as its number of segments, or its degree, increases.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Convergence {
    /// The method.
    pub method: Method,
    /// Whether the reference beam has rotary inertia in bending.
    #[cfg_attr(feature = "serde", serde(rename = "limit_has_rotary_inertia"))]
    pub rotary_inertia: bool,
    /// The modes with their limit frequencies: the frequencies of the reference beam solution of
    /// the same beam theory.
    pub modes: Vec<FollowedMode>,
    /// The levels in the requested order.
    pub levels: Vec<Level>,
    /// Warnings of the reference solution: differences from a mode that it does not resolve are not
    /// errors of the method.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub warnings: Vec<Warning>,
}

/// Default numbers of segments of a study.
pub const STUDY_SEGMENTS: [usize; 6] = [10, 20, 40, 80, 160, 320];
/// Default polynomial degrees of a study of the method spectral.
pub const STUDY_DEGREES: [usize; 6] = [4, 6, 8, 10, 12, 14];
/// The smallest number of levels that is sufficient to show an order.
const FEWEST_LEVELS: usize = 4;

/// Smaller errors are rounding errors or errors of the reference, and have no order.
const ROUNDING: f64 = 1e-11;

/// The options of the reference solution that a method converges to: spectral, without rotary
/// inertia if the method has none.
///
/// # Errors
/// [`SolveError::NoShear`] for BModes and a tower with shear deformation: BModes has none and
/// converges to another beam theory.
fn limit_options(tower: &Tower, options: &Options) -> Result<Options, SolveError> {
    if options.method == Method::Bmodes && tower.shears() {
        return Err(SolveError::NoShear);
    }
    Ok(Options {
        method: Method::Spectral,
        segments: None,
        degree: None,
        rotary_inertia: options.has_rotary_inertia(),
        points: 2,
        ..options.clone()
    })
}

/// Solves a tower by one method at each refinement and compares the frequencies with those of the
/// reference beam that the method converges to. `done` is called with each level.
///
/// # Errors
/// [`SolveError`] of any of the solves, or [`SolveError::NoShear`].
///
/// # Example
/// See the [crate's front page](crate).
pub fn converge(
    tower: &Tower,
    fineness: &[Fineness],
    solver: &mut Solver,
    mut done: impl FnMut(&Level),
) -> Result<Convergence, SolveError> {
    let options = solver.options.clone();
    let limit = limit_options(tower, &options)?;
    let beam = solver.with(limit.clone(), |solver| solver.solve(tower))?;
    let mut warnings = beam.warnings.clone();
    let modes = followed(tower, &beam);
    let mut levels: Vec<Level> = Vec::with_capacity(fineness.len());
    for &asked in fineness {
        let solution = solve_for(tower, &asked.applied_to(&options), &modes, solver)?;
        warnings.extend(not_found(&modes, &solution));
        let (frequencies_hz, errors) = compared(&modes, &solution);
        let mut level = Level {
            asked,
            segments: solution.segments,
            degrees_of_freedom: solution.degrees_of_freedom,
            frequencies_hz,
            errors,
            orders: Vec::new(),
        };
        level.orders = orders(levels.last(), &level);
        done(&level);
        levels.push(level);
    }
    Ok(Convergence {
        method: options.method,
        modes,
        rotary_inertia: limit.rotary_inertia,
        levels,
        warnings,
    })
}

impl Convergence {
    /// Removes levels with equal meshes: a tower with many parts has a minimum number of segments.
    pub fn remove_equal_meshes(&mut self) {
        for level in &mut self.levels {
            level.asked = Fineness::Segments(level.segments);
        }
        self.levels.dedup_by_key(|level| level.segments);
    }
}

/// A study with [`STUDY_SEGMENTS`], each mesh once; if these are fewer than four meshes, with the
/// minimum number of segments of the tower and its multiples by powers of two.
///
/// The study is an argument, so that a program can report its progress.
///
/// # Errors
/// Those of `converge`.
pub fn converge_by_default<E>(
    mut converge: impl FnMut(&[Fineness]) -> Result<Convergence, E>,
) -> Result<Convergence, E> {
    let mut convergence = converge(&STUDY_SEGMENTS.map(Fineness::Segments))?;
    convergence.remove_equal_meshes();
    if convergence.levels.len() >= FEWEST_LEVELS {
        return Ok(convergence);
    }
    let fewest = convergence.levels.first().map_or(1, |level| level.segments);
    let doubled = std::iter::successors(Some(fewest), |segments| Some(2 * segments));
    let doubled = doubled
        .take(FEWEST_LEVELS)
        .take_while(|segments| *segments <= MAX_SEGMENTS)
        .map(Fineness::Segments);
    let mut convergence = converge(&doubled.collect::<Vec<_>>())?;
    convergence.remove_equal_meshes();
    Ok(convergence)
}

/// The observed order of each mode between two levels.
fn orders(before: Option<&Level>, level: &Level) -> Vec<Option<f64>> {
    let Some(before) = before else {
        return vec![None; level.errors.len()];
    };
    let order = |(coarse, fine): (&Option<f64>, &Option<f64>)| {
        let (coarse, fine) = (coarse.as_ref()?.abs(), fine.as_ref()?.abs());
        let gain = match (before.asked, level.asked) {
            (Fineness::Degree(coarse), Fineness::Degree(fine)) => fine as f64 - coarse as f64,
            _ => (level.segments as f64 / before.segments as f64).log10(),
        };
        let order = (coarse / fine).log10() / gain;
        (coarse > ROUNDING && fine > ROUNDING && order.is_finite()).then_some(order)
    };
    before.errors.iter().zip(&level.errors).map(order).collect()
}
