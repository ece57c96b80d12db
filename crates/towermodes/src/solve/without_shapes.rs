//! Frequencies without shapes, for many towers one after the other.

use super::by_frequency;
use super::error::SolveError;
use super::errors::estimate::estimate_errors;
use super::errors::p_refinement;
use super::on_mesh::cut::Cut;
use super::on_mesh::guesses::Guesses;
use super::on_mesh::listing::list;
use super::on_mesh::one_mesh::solve_cut;
use super::on_mesh::spectrum::{Found, ModeKey, SimilarModes, with_repeats};
use super::request::options::Options;
use super::results::frequencies::Frequencies;
use super::results::warnings::is_uncertain_end;
use super::solver::Solver;
use super::workspace::Workspace;
use crate::tower::Tower;

/// Number of modes of a base that are known in addition to those listed of a similar tower: the
/// order of the modes may differ.
const MORE_OF_BASE: usize = 4;

impl Solver {
    /// Computes the lowest frequencies of a tower with their names, errors and certificate, but no
    /// shapes, for many towers one after the other: the values are equal, bit for bit, to those of
    /// [`solve`](Self::solve), which takes two to three times as long. After
    /// [`start_from`](Self::start_from) they take less time, and may differ in the last digits.
    ///
    /// After a first tower nothing is allocated for others with the same heights and options,
    /// except with [`Bmodes`](crate::Method::Bmodes) and [`Spectral`](crate::Method::Spectral), and
    /// where an error needs the reference solution. A few segments suffice, because extrapolated
    /// frequencies are far more accurate than those of the mesh.
    ///
    /// [`Options::points`] and [`Options::heights_m`] have no effect.
    ///
    /// # Errors
    /// [`SolveError`], for the same towers as [`solve`](Self::solve).
    ///
    /// # Example
    /// The first frequency of a tower for three masses on top:
    /// ```
    /// use towermodes::{Family, Material, Options, Rna, Solver, Station, Tower, TowerDescription};
    ///
    /// let base = TowerDescription {
    ///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
    ///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
    ///     ..TowerDescription::default()
    /// };
    /// let options = Options { modes: 4, segments: Some(20), ..Options::default() };
    /// let mut solver = Solver::new(options);
    /// for (rna_kg, expected_hz) in [(0.0, 0.8913), (200e3, 0.3818), (350e3, 0.3002)] {
    ///     let tower = Tower::new(TowerDescription { rna: Rna::point(rna_kg), ..base.clone() })?;
    ///     let frequencies = solver.frequencies(&tower)?;
    ///     let first = frequencies.mode(Family::ForeAft, 1).expect("it is the lowest mode");
    ///     assert!((first.extrapolated_hz - expected_hz).abs() < 1e-4);
    ///     assert!(frequencies.certificate.complete);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn frequencies(&mut self, tower: &Tower) -> Result<&Frequencies, SolveError> {
        let Self { options, workspace } = self;
        solve_keeping_vectors(tower, options, workspace, &mut None)?;
        Ok(&workspace.frequencies)
    }

    /// Solves a base tower and keeps its modes. Later calls of [`frequencies`](Self::frequencies)
    /// start from these modes, which takes less time for towers similar to the base, for instance
    /// the rows of a sweep. Each frequency is proved to lie in an interval of its own, and the list
    /// is proved complete by eigenvalue counts. If a proof fails, the tower is solved without the
    /// base. The results depend only on the tower, the base and the options.
    ///
    /// Frequencies differ from those of [`solve`](Self::solve) by at most 10⁻¹³ relative, shares of
    /// the energy by at most 10⁻⁶. The base has no effect with [`Bmodes`](crate::Method::Bmodes)
    /// and [`Spectral`](crate::Method::Spectral), with an added mass that depends on frequency, if
    /// a motion has no stiffness, and if two of its frequencies in one group of coupled motions are
    /// nearly equal.
    ///
    /// # Errors
    /// [`SolveError`], if the base cannot be solved. Later towers are then solved without a base.
    ///
    /// # Example
    /// ```
    /// use towermodes::{Material, Options, Rna, Solver, Station, Tower, TowerDescription};
    ///
    /// let tower = |wall_m| Tower::new(TowerDescription {
    ///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
    ///     stations: vec![Station::new(0.0, 6.0, wall_m), Station::new(87.6, 3.87, 0.019)],
    ///     rna: Rna::point(350e3),
    ///     ..TowerDescription::default()
    /// });
    /// let options = Options { modes: 4, segments: Some(20), ..Options::default() };
    /// let mut solver = Solver::new(options.clone());
    /// solver.start_from(&tower(0.027)?)?;
    /// for wall_m in [0.025, 0.029] {
    ///     let near = solver.frequencies(&tower(wall_m)?)?.clone();
    ///     let alone = Solver::new(options.clone()).frequencies(&tower(wall_m)?)?.clone();
    ///     assert!(near.is_near_base && !alone.is_near_base);
    ///     let ratio = near.modes[0].extrapolated_hz / alone.modes[0].extrapolated_hz;
    ///     assert!((ratio - 1.0).abs() < 1e-13);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn start_from(&mut self, base: &Tower) -> Result<(), SolveError> {
        let Self { options, workspace } = self;
        workspace.base = None;
        let options = &options.without_shapes();
        options.check()?;
        if options.method.converges_by_degree() || base.has_added_mass_by_frequency() {
            return Ok(());
        }
        let cut = Cut::new(base, options)?;
        let more = Options {
            modes: options.modes + MORE_OF_BASE,
            ..options.clone()
        };
        let found = match solve_cut(base, &cut, &more, None, workspace) {
            Err(SolveError::TooManyModes { .. }) => {
                solve_cut(base, &cut, options, None, workspace)?
            }
            found => found?,
        };
        let keys: Vec<ModeKey> = found.iter().map(|found| found.key).collect();
        let Workspace {
            model, spectrum, ..
        } = workspace;
        let mut modes = Guesses::default();
        modes.take(&keys, base, model, spectrum);
        let listed = with_repeats(&found, options.modes.min(found.len()), model.origin);
        modes.set_listed(&found[..listed]);
        // If they do not lead to their own list, for example because two frequencies are nearly
        // equal, they do not lead to that of a similar tower.
        let own = solve_listed(base, &cut, options, Some(&mut modes), workspace);
        let leads = own.is_ok() && workspace.spectrum.is_guessed;
        workspace.base = leads.then_some(modes);
        Ok(())
    }
}

/// The frequencies in the workspace; also writes the vectors of the modes on their own mesh, if the
/// method has a fixed one.
pub(super) fn solve_keeping_vectors(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
    vectors: &mut Option<Vec<Vec<f64>>>,
) -> Result<(), SolveError> {
    let options = &options.without_shapes();
    options.check()?;
    workspace.model.monitor.restart();
    let mut solve = |tower: &Tower, options: &Options, workspace: &mut Workspace| match options
        .method
        .converges_by_degree()
    {
        true => p_refinement::solve_frequencies(tower, options, workspace),
        false => solve_segments(tower, options, workspace, vectors),
    };
    if !tower.has_added_mass_by_frequency() {
        return solve(tower, options, workspace);
    }
    match options.added_mass.fixed() {
        Some(frequency) => solve(&tower.with_added_mass_at(frequency), options, workspace),
        None => by_frequency::frequencies(tower, options, workspace, solve),
    }
}

/// The modes found, and where their list was proved to end. The search starts from the modes of the
/// base if there is one. If it fails for any reason, the tower is solved without the base, so that
/// errors do not depend on the base.
fn solve_near(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<(Vec<Found>, f64), SolveError> {
    let mut base = workspace.base.take();
    let near = base
        .as_mut()
        .and_then(|base| solve_listed(tower, cut, options, Some(base), workspace).ok());
    workspace.base = base;
    match near {
        Some(solved) => {
            workspace.frequencies.is_near_base = workspace.spectrum.is_guessed;
            Ok(solved)
        }
        None => solve_listed(tower, cut, options, None, workspace),
    }
}

fn solve_listed(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    base: Option<&mut dyn SimilarModes>,
    workspace: &mut Workspace,
) -> Result<(Vec<Found>, f64), SolveError> {
    let found = solve_cut(tower, cut, options, base, workspace)?;
    let below = list(tower, cut, options, &found, workspace)?;
    Ok((found, below))
}

/// The frequencies with elements of a fixed degree: solved once, the errors estimated from meshes
/// of half or twice as many segments.
fn solve_segments(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
    vectors: &mut Option<Vec<Vec<f64>>>,
) -> Result<(), SolveError> {
    let cut = workspace.cut.take(tower, options)?;
    let (found, below) = match vectors {
        None => solve_near(tower, &cut, options, workspace)?,
        Some(_) => solve_listed(tower, &cut, options, None, workspace)?,
    };
    if let Some(vectors) = vectors {
        let modes = workspace.errors.modes.iter();
        let vector = |key| workspace.spectrum.vector(key).to_vec();
        vectors.extend(modes.map(|mode| vector(mode.key)));
    }
    workspace.spectrum.recycle(found);
    let estimates = estimate_errors(tower, &cut, options, below, workspace)?;
    workspace.cut.put_back(cut, options);
    let Workspace {
        frequencies,
        errors,
        ..
    } = workspace;
    for (mode, estimated) in frequencies.modes.iter_mut().zip(&errors.modes) {
        mode.discretization_error_hz = estimated.error_hz;
        mode.extrapolated_hz = estimated.extrapolated_hz;
    }
    let extrapolated_hz = errors.modes.iter().map(|mode| mode.extrapolated_hz);
    frequencies.has_uncertain_end = is_uncertain_end(
        extrapolated_hz,
        &frequencies.certificate,
        estimates.elsewhere,
    );
    Ok(())
}
