//! Input values of a tower fitted to measured frequencies.
//!
//! Weighted least squares: the sum of ((f − measured)/σ)² over all measurements and of ((x −
//! mean)/σ)² over all priors is minimized by the method of Levenberg (1944) and Marquardt (1963),
//! with the exact derivatives of [`towermodes::Solver::sensitivities`]. For positive input values
//! the logarithm is fitted. Standard deviations and correlations are those of the linearized
//! problem (Tarantola 2005, ch. 3).
//!
//! A good fit does not show that the model is valid.
//!
//! `problem` contains the problem, `variable` the unknowns as coordinates, `pairing` the assignment
//! of measurements to modes, `fit` the iteration, `beside` its start where the derivatives vanish,
//! `singular` its linear algebra, `determined` the check whether the unknowns are determined,
//! `result` the result, `remark` the remarks on the result, `words` their texts.

mod beside;
mod determined;
mod error;
mod fit;
mod pairing;
mod point;
mod problem;
mod remark;
mod result;
mod singular;
mod variable;
mod words;

pub use error::CalibrationError;
pub use pairing::Ambiguity;
pub use point::AtBound;
pub use problem::{Measured, MeasuredShape, Prior, Problem, Unknown};
pub use remark::{Remark, UnknownChange};
pub use result::{Calibration, Direction, Explained, Fitted};

use towermodes::Solver;

/// Largest number of times that the measurements are paired again with the modes of the fitted
/// tower.
const MOST_PAIRINGS: usize = 4;

/// Fits input values of a tower to measured frequencies.
///
/// [`towermodes::Options::modes`] is the initial number of modes; more modes are computed if a
/// measurement needs them.
///
/// # Errors
/// [`CalibrationError`]: the problem is contradictory or not determined, a tower of the iteration
/// cannot be solved, or a measured mode does not exist.
///
/// # Example
/// The rocking stiffness that explains a first frequency of 0.28094 ± 0.002 Hz:
/// ```
/// use towermodes::{Change, Foundation, FoundationSprings, Material, Options, Rna, Station};
/// use towermodes::{TowerDescription, Solver};
/// use towermodes_design::calibration::{Measured, Problem, Unknown, calibrate};
///
/// let base = TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     foundation: Foundation::Springs(FoundationSprings {
///         lateral_n_per_m: f64::INFINITY,
///         rocking_n_m: 1e11,
///         coupling_n: 0.0,
///         vertical_n_per_m: f64::INFINITY,
///         torsion_n_m: f64::INFINITY,
///     }),
///     ..TowerDescription::default()
/// };
/// let problem = Problem {
///     unknowns: vec![Unknown::new(Change::parse("foundation.rocking", &base)?)],
///     measured: vec![Measured::of("fore-aft 1".parse()?, 0.28094, 0.002)],
///     base,
/// };
/// let fitted = calibrate(&problem, &mut Solver::default())?;
/// let rocking = &fitted.unknowns[0];
/// assert!((rocking.value / 8e10 - 1.0).abs() < 1e-3);
/// assert!((rocking.deviation.expect("free") / 9.2e9 - 1.0).abs() < 0.03);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn calibrate(problem: &Problem, solver: &mut Solver) -> Result<Calibration, CalibrationError> {
    problem.check()?;
    let options = &solver.options.clone();
    let variables = variable::variables(problem)?;
    let mut description = problem.base.clone();
    let start: Vec<f64> = variables.iter().map(|variable| variable.start).collect();
    variable::apply(&variables, &start, &mut description);
    let mut pairing = pairing::pair(problem, &description, options, solver)?;
    for round in 1.. {
        let mut options = options.clone();
        options.modes = pairing.modes;
        let mut towers = point::Towers::new(problem, &variables, &pairing.names, options, solver);
        let before = towers.evaluate(&start)?;
        let found = beside::fit_beside(&mut towers, &before)?;
        let options = towers.options.clone();
        description.clone_from(&problem.base);
        variable::apply_rounded(&variables, &found.point.x, &mut description);
        let again = pairing::pair(problem, &description, &options, solver)?;
        if again.names == pairing.names || round == MOST_PAIRINGS {
            let is_stable = again.names == pairing.names;
            pairing.ambiguities = again.ambiguities;
            pairing.shares = again.shares;
            pairing.shared = again.shared;
            pairing.is_stable = is_stable;
            pairing.is_certified = again.is_certified;
            return Ok(result::result(
                problem,
                &variables,
                &pairing,
                &before,
                &found,
                description,
            ));
        }
        pairing = again;
    }
    unreachable!("the last round returns")
}
