//! The entry point for towers.

use super::by_frequency;
use super::error::SolveError;
use super::errors::estimate::{Estimates, estimate_errors, other_segments};
use super::errors::p_refinement;
use super::on_mesh::cut::Cut;
use super::on_mesh::one_mesh::{Described, describe, solve_cut};
use super::request::options::Options;
use super::results::frequencies::Estimated;
use super::results::solution::{ErrorBasis, Mode, Solution};
use super::results::warnings::{irregular, uncertain_end, warnings};
use super::solver::Solver;
use super::workspace::Workspace;
use crate::tower::Tower;

/// Computes the lowest modes of a tower, with the proof that none is missing.
///
/// # Errors
/// [`SolveError`]: impossible options, an unstable tower, or a computation that failed; never an
/// incomplete list.
///
/// # Example
/// The published element of Nikolić & Šalinić on 20 segments, compared with the exact value of a
/// clamped prismatic beam, f₁ = 1.8751²/(2π) √(EI/(ρA L⁴)), to three digits:
/// ```
/// use towermodes::{Material, Method, Options, Station, Tower, TowerDescription, solve};
///
/// let tower = Tower::new(TowerDescription {
///     materials: vec![Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 4.0, 0.03), Station::new(90.0, 4.0, 0.03)],
///     ..TowerDescription::default()
/// })?;
/// let options = Options {
///     method: Method::Rmje,
///     segments: Some(20),
///     ..Options::default()
/// };
/// let solution = solve(&tower, &options)?;
/// let first_hz = solution.modes[0].extrapolated_hz;
/// assert!((first_hz - 0.5012).abs() < 1e-3, "{first_hz}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn solve(tower: &Tower, options: &Options) -> Result<Solution, SolveError> {
    Solver::new(options.clone()).solve(tower)
}

impl Solver {
    /// Computes the lowest modes of a tower, as [`solve`].
    ///
    /// # Errors
    /// As [`solve`].
    pub fn solve(&mut self, tower: &Tower) -> Result<Solution, SolveError> {
        let Self { options, workspace } = self;
        options.check()?;
        workspace.model.monitor.restart();
        let solve = match options.method.converges_by_degree() {
            true => p_refinement::solve,
            false => solve_segments,
        };
        if !tower.has_added_mass_by_frequency() {
            return solve(tower, options, workspace);
        }
        let mut solution = match options.added_mass.fixed() {
            Some(frequency) => solve(&tower.with_added_mass_at(frequency), options, workspace),
            None => by_frequency::solve(tower, options, workspace, solve),
        }?;
        solution.added_mass = Some(options.added_mass);
        Ok(solution)
    }
}

/// The solution with elements of a fixed degree: solved once, the errors estimated from meshes of
/// half or twice as many segments.
fn solve_segments(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<Solution, SolveError> {
    let cut = Cut::new(tower, options)?;
    let found = solve_cut(tower, &cut, options, None, workspace)?;
    let statistics = workspace.spectrum.statistics;
    let mut result = describe(tower, &cut, options, &found, workspace)?;
    workspace.spectrum.recycle(found);
    let estimates = estimate_errors_of(tower, &cut, options, &mut result, workspace)?;
    let mut warnings = warnings(tower, &cut.mesh, options, &result);
    warnings.extend(irregular(&result.modes, &workspace.errors.irregular));
    let elsewhere = estimates.elsewhere;
    warnings.extend(uncertain_end(&result.modes, &result.certificate, elsewhere));
    let solution = result.into_solution(options, cut.mesh.segments(), warnings, statistics);
    Ok(Solution {
        error_basis: ErrorBasis {
            segments: other_segments(&workspace.errors.ladder),
            compared: estimates.compared,
        },
        ..solution
    })
}

/// Estimates the errors of the modes of a solution.
fn estimate_errors_of(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    result: &mut Described,
    workspace: &mut Workspace,
) -> Result<Estimates, SolveError> {
    let estimated = |mode: &Mode| Estimated::new(mode.key, mode.frequency_hz);
    workspace.errors.modes.clear();
    let modes = result.modes.iter().map(estimated);
    workspace.errors.modes.extend(modes);
    let estimates = estimate_errors(tower, cut, options, result.below, workspace)?;
    for (mode, estimated) in result.modes.iter_mut().zip(&workspace.errors.modes) {
        mode.discretization_error_hz = estimated.error_hz;
        mode.extrapolated_hz = estimated.extrapolated_hz;
    }
    Ok(estimates)
}
