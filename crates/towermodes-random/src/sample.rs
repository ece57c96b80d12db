//! One mode of one tower by one method: its estimated error and its true error.

use towermodes::{
    Method, Mode, Options, Shear, Solution, SolveError, Solver, Tower, TowerDescription, Warning,
};

use super::class::Class;
use super::seed::Seed;

/// The number of segments or elements of the towers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fineness {
    /// The default number of segments of the method.
    Default,
    /// A random number from 10 to 60.
    Coarse,
}

/// The estimated and the true error of a mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Number of the tower.
    pub tower: u64,
    /// Position of the mode in the list, from 1.
    pub mode: usize,
    /// Segments used.
    pub segments: usize,
    /// Its frequency, Hz.
    pub frequency_hz: f64,
    /// The estimated error, Hz.
    pub claimed_hz: f64,
    /// Its difference from the reference minus the uncertainty of the reference, Hz.
    pub true_hz: f64,
    /// Whether a warning states that the mode is not resolved.
    pub is_warned: bool,
}

/// The estimated error may be too small by this factor.
const ALLOWED: f64 = 3.0;

/// Errors below this fraction of a frequency are rounding errors.
const ROUNDING: f64 = 1e-9;

/// Number of modes.
const MODES: usize = 8;

/// Number of additional modes in the reference: errors of the method can change which modes are the
/// lowest.
const MORE: usize = 8;

/// The increase of the polynomial degree in the reference solution.
const RAISED: usize = 4;

impl Sample {
    /// Whether the error is at most three times the estimate.
    pub fn is_covered(&self) -> bool {
        self.true_hz <= ALLOWED * self.claimed_hz
    }

    /// The ratio of the estimated to the true error; none if both are rounding errors.
    pub fn ratio(&self) -> Option<f64> {
        let is_more = self.true_hz > ROUNDING * self.frequency_hz;
        is_more.then_some(self.claimed_hz / self.true_hz)
    }
}

/// The modes of a random tower by each of `methods`; an error if a method cannot solve it.
///
/// # Errors
/// The outer error: the reference cannot be solved.
pub fn samples(
    class: Class,
    number: u64,
    fineness: Fineness,
    methods: &[Method],
    solver: &mut Solver,
) -> Result<Vec<Result<Vec<Sample>, SolveError>>, SolveError> {
    let description = class.description(number);
    let of = |description| Tower::new(description).expect("classes make valid towers");
    let tower = of(description.clone());
    let mut segments = Seed::new(!number);
    let segments = match fineness {
        Fineness::Default => None,
        Fineness::Coarse => Some(segments.whole(10, 60)),
    };
    let truth = reference(&tower, true, solver)?;
    // BModes has neither shear deformation nor rotary inertia.
    let slender = match methods.contains(&Method::Bmodes) {
        true => {
            let unsheared = of(without_shear(description.clone()));
            Some(reference(&unsheared, false, solver)?)
        }
        false => None,
    };
    let sample = |&method: &Method| {
        let options = Options {
            method,
            segments: segments.filter(|_| method != Method::Spectral),
            modes: MODES,
            points: 2,
            ..Options::default()
        };
        let slender = slender.as_ref().filter(|_| method == Method::Bmodes);
        let solution = solver.with(options, |solver| solver.solve(&tower))?;
        Ok(compared(number, &solution, slender.unwrap_or(&truth)))
    };
    Ok(methods.iter().map(sample).collect())
}

/// The tower as a beam without shear deformation.
fn without_shear(mut description: TowerDescription) -> TowerDescription {
    description.shear = Shear::Rigid;
    for row in &mut description.properties {
        row.properties.shear_n = None;
    }
    description
}

/// The reference solution with a degree above the converged one.
fn reference(
    tower: &Tower,
    rotary_inertia: bool,
    solver: &mut Solver,
) -> Result<Solution, SolveError> {
    let converged = Options {
        method: Method::Spectral,
        modes: MODES + MORE,
        points: 2,
        rotary_inertia,
        ..Options::default()
    };
    let found = solver.with(converged.clone(), |solver| solver.solve(tower))?;
    let raised = Options {
        segments: Some(found.segments),
        degree: found.degree.map(|degree| degree + RAISED),
        ..converged
    };
    solver.with(raised, |solver| solver.solve(tower))
}

fn compared(tower: u64, solution: &Solution, truth: &Solution) -> Vec<Sample> {
    let sample = |mode: &Mode| {
        let same = truth.modes.iter().find(|other| other.is_same_as(mode));
        let difference_hz = same.map(|other| {
            let known_hz = other.error_hz().max(ROUNDING * other.frequency_hz);
            ((mode.frequency_hz - other.frequency_hz).abs() - known_hz).max(0.0)
        });
        // A mode that the reference does not have is wrong by its whole frequency.
        let true_hz = difference_hz.unwrap_or(mode.frequency_hz);
        Sample {
            tower,
            mode: mode.number,
            segments: solution.segments,
            frequency_hz: mode.frequency_hz,
            claimed_hz: mode.error_hz(),
            true_hz,
            is_warned: is_warned(solution),
        }
    };
    let moving = solution.modes.iter().filter(|mode| mode.frequency_hz > 0.0);
    moving.map(sample).collect()
}

fn is_warned(solution: &Solution) -> bool {
    let mut warnings = solution.warnings.iter();
    warnings.any(|warning| {
        matches!(
            warning,
            Warning::Unresolved { .. } | Warning::Irregular { .. }
        )
    })
}
