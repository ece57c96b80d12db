//! The memory of a solve.

use super::cut::{Cut, LastCut};
use super::estimate::Estimated;
use super::frequencies::Frequencies;
use super::guesses::Guesses;
use super::model::Model;
use super::naming::Naming;
use super::progress::{Monitor, Progress};
use super::spectrum::{ModeKey, Spectrum};
use super::tracking::{Ladder, Levels};
use crate::elements::Mesh;

/// Memory that is reused from solve to solve.
///
/// # Example
/// ```
/// use towermodes::{Material, Options, Rna, Station, Tower, TowerDescription};
/// use towermodes::{Workspace, solve_with};
///
/// let mut workspace = Workspace::default();
/// for (rna_kg, expected_hz) in [(0.0, 0.892), (350e3, 0.300)] {
///     let tower = Tower::new(TowerDescription {
///         materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///         stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///         rna: Rna::point(rna_kg),
///         ..TowerDescription::default()
///     })?;
///     let solution = solve_with(&tower, &Options::default(), &mut workspace)?;
///     assert!((solution.modes[0].frequency_hz - expected_hz).abs() < 1e-3);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Default)]
pub struct Workspace {
    pub(super) model: Model,
    pub(super) spectrum: Spectrum,
    pub(super) naming: Naming,
    pub(super) errors: ErrorWorkspace,
    pub(super) frequencies: Frequencies,
    pub(super) cut: LastCut,
    /// The last cut of the spectral method.
    pub(super) spectral_cut: Option<Cut>,
}

/// The memory of error estimates.
#[derive(Debug, Default)]
pub(super) struct ErrorWorkspace {
    pub(super) guesses: Guesses,
    pub(super) ladder: Ladder<Mesh>,
    pub(super) levels: Levels,
    pub(super) keys: Vec<ModeKey>,
    pub(super) modes: Vec<Estimated>,
    pub(super) irregular: Vec<usize>,
}

impl Workspace {
    /// A workspace whose solves report their progress to an observer: each stage, and each product
    /// with the mass matrix, which can be many per second or none for seconds. The results are the
    /// same as without an observer.
    ///
    /// # Example
    /// ```
    /// use towermodes::{Material, Options, Station, Tower, TowerDescription};
    /// use towermodes::{Workspace, solve_with};
    ///
    /// let tower = Tower::new(TowerDescription {
    ///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
    ///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
    ///     ..TowerDescription::default()
    /// })?;
    /// let mut workspace = Workspace::watched(|progress| assert!(progress.fraction < 1.0));
    /// let solution = solve_with(&tower, &Options::default(), &mut workspace)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn watched(observer: impl FnMut(Progress) + Send + Sync + 'static) -> Self {
        let mut workspace = Self::default();
        workspace.model.monitor = Monitor::new(Box::new(observer));
        workspace
    }
}
