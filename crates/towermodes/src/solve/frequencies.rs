//! Frequencies without shapes, for many towers one after the other.

use super::cut::Cut;
use super::error::SolveError;
use super::estimate::{Estimated, estimate_errors};
use super::naming::{Wanted, identify};
use super::one_mesh::solve_cut;
use super::options::Options;
use super::p_refinement;
use super::progress::Stage;
use super::solution::Certificate;
use super::solver::Solver;
use super::spectrum::Found;
use super::stability::check_buckling;
use super::warnings::is_uncertain_end;
use super::workspace::Workspace;
use crate::eigen::EigenError;
use crate::modes::{Family, ModeName, SecondFamily, Shares};
use crate::tower::Tower;

/// The name and the frequency of a natural mode of a tower, one of [`Frequencies::modes`]: the same
/// values as those of the [`Mode`](crate::Mode) of a [`Solution`](crate::Solution), bit by bit.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ModeFrequency {
    /// The kind of motion: the one whose energy in the modes so far exceeds its names by most
    /// ([`Arrears`](crate::modes::Arrears)).
    pub family: Family,
    /// Order within the family, from 1.
    pub order: usize,
    /// The share of each kind of motion in its energy.
    pub shares: Shares,
    /// Natural frequency of the discretized tower, Hz; 0 for a rigid-body motion that nothing
    /// resists.
    pub frequency_hz: f64,
    /// Bound on the error of the eigenvalue computation, Hz.
    pub algebraic_error_hz: f64,
    /// Estimate of the discretization error: the difference from the frequency of the beam, Hz.
    pub discretization_error_hz: f64,
    /// The frequency of the beam, extrapolated from meshes with half or twice the segments, Hz.
    pub extrapolated_hz: f64,
}

impl ModeFrequency {
    /// The total error, discretization and eigenvalue computation together, Hz.
    pub fn error_hz(&self) -> f64 {
        self.discretization_error_hz + self.algebraic_error_hz
    }

    /// Its name: family and order.
    pub fn name(&self) -> ModeName {
        ModeName {
            family: self.family,
            order: self.order,
        }
    }

    /// The share of its own family in its energy.
    pub fn share(&self) -> f64 {
        self.shares.of(self.family)
    }

    /// The family with the largest share of its energy beside its own; none if there is none.
    pub fn second(&self) -> Option<SecondFamily> {
        self.shares.second_to(self.family)
    }

    /// Order and family in words: "1st fore-aft bending".
    pub fn label(&self) -> String {
        self.family.label(self.order)
    }
}

/// The lowest frequencies of a tower, with their errors and the proof that none is missing.
///
/// There are no warnings: what makes a frequency doubtful is part of its error.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Frequencies {
    /// The modes by frequency; of a repeated pair the fore-aft one first.
    pub modes: Vec<ModeFrequency>,
    /// The proof that none is missing.
    pub certificate: Certificate,
    /// Whether the list ends within the error of the segments, so that another mesh may have
    /// another mode below its end; see [`Warning::UncertainEnd`](crate::Warning::UncertainEnd).
    pub has_uncertain_end: bool,
    /// Number of segments or elements used.
    pub segments: usize,
}

impl Frequencies {
    /// The mode of a family and an order in it, from 1, if it is in the list.
    pub fn mode(&self, family: Family, order: usize) -> Option<&ModeFrequency> {
        let mut modes = self.modes.iter();
        modes.find(|mode| mode.family == family && mode.order == order)
    }
}

impl Solver {
    /// Computes the lowest frequencies of a tower with their names, errors and certificate, but no
    /// shapes, for many towers one after the other: [`solve`](Self::solve) gives the same values
    /// bit by bit, and takes two to three times as long.
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
    match options.method.converges_by_degree() {
        true => p_refinement::solve_frequencies(tower, options, workspace),
        false => solve_segments(tower, options, workspace, vectors),
    }
}

/// With elements of a fixed kind: solved once, the errors estimated from meshes of half or twice as
/// many segments.
fn solve_segments(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
    vectors: &mut Option<Vec<Vec<f64>>>,
) -> Result<(), SolveError> {
    let cut = workspace.cut.take(tower, options)?;
    let found = solve_cut(tower, &cut, options, workspace)?;
    let below = list(tower, &cut, options, &found, workspace)?;
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

/// Proves that no mode is missing below those found and lists the modes requested, their
/// discretization errors still unknown; returns where the list ends, λ, rad²/s².
pub(super) fn list(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    found: &[Found],
    workspace: &mut Workspace,
) -> Result<f64, SolveError> {
    let Workspace {
        model,
        spectrum,
        naming,
        errors,
        frequencies,
        ..
    } = workspace;
    model.monitor.enter(Stage::Certificate);
    let proof = spectrum.prove(model, found, options.modes)?;
    model.monitor.enter(Stage::Buckling);
    check_buckling(tower, model, spectrum)?;
    let listed = &found[..options.modes];
    identify(
        tower,
        options,
        model,
        spectrum,
        (listed, Wanted::Names),
        naming,
    );
    frequencies.modes.clear();
    errors.modes.clear();
    for (found, identity) in listed.iter().zip(&naming.identities) {
        let frequency_hz = found.eigenvalue.frequency_hz();
        if !frequency_hz.is_finite() {
            return Err(EigenError::NotFinite.into());
        }
        frequencies.modes.push(ModeFrequency {
            family: identity.family,
            order: identity.order,
            shares: identity.shares,
            frequency_hz,
            algebraic_error_hz: found.eigenvalue.frequency_error_hz(),
            discretization_error_hz: 0.0,
            extrapolated_hz: frequency_hz,
        });
        errors.modes.push(Estimated::new(found.key, frequency_hz));
    }
    frequencies.certificate = Certificate::of(&proof);
    frequencies.has_uncertain_end = false;
    frequencies.segments = cut.mesh.segments();
    Ok(proof.below)
}
