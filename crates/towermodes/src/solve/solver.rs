//! The solver: its options, and memory that is reused from solve to solve.

use super::progress::{Monitor, Progress};
use super::request::options::Options;
use super::workspace::Workspace;

/// Options, and memory that is reused from solve to solve: after the first tower, solves of most
/// other towers with the same options allocate little or no memory.
///
/// # Example
/// ```
/// use towermodes::{Material, Rna, Solver, Station, Tower, TowerDescription};
///
/// let mut solver = Solver::default();
/// for (rna_kg, expected_hz) in [(0.0, 0.892), (350e3, 0.300)] {
///     let tower = Tower::new(TowerDescription {
///         materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///         stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///         rna: Rna::point(rna_kg),
///         ..TowerDescription::default()
///     })?;
///     let solution = solver.solve(&tower)?;
///     assert!((solution.modes[0].frequency_hz - expected_hz).abs() < 1e-3);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Default)]
pub struct Solver {
    /// Method, mesh and number of modes.
    pub options: Options,
    pub(crate) workspace: Workspace,
}

impl Solver {
    /// A solver with new memory.
    pub fn new(options: Options) -> Self {
        Self {
            options,
            workspace: Workspace::default(),
        }
    }

    /// This solver with an observer, to which each solve of a tower reports its progress: each
    /// stage, and each product with the mass matrix, which can be many per second or none for
    /// seconds. The results are the same as without an observer.
    ///
    /// # Example
    /// ```
    /// use towermodes::{Material, Options, Solver, Station, Tower, TowerDescription};
    ///
    /// let tower = Tower::new(TowerDescription {
    ///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
    ///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
    ///     ..TowerDescription::default()
    /// })?;
    /// let solver = Solver::new(Options { modes: 12, ..Options::default() });
    /// let mut solver = solver.watched(|progress| assert!(progress.fraction < 1.0));
    /// assert_eq!(solver.solve(&tower)?.modes.len(), 12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn watched(mut self, observer: impl FnMut(Progress) + Send + Sync + 'static) -> Self {
        self.workspace.model.monitor = Monitor::new(Box::new(observer));
        self
    }

    /// Calls `work` with other options and the same memory, and restores the options of the solver
    /// afterwards.
    ///
    /// # Example
    /// ```
    /// use towermodes::{Method, Options, Solver};
    ///
    /// let mut solver = Solver::default();
    /// let published = Options { method: Method::Rmje, ..Options::default() };
    /// assert_eq!(solver.with(published, |solver| solver.options.method), Method::Rmje);
    /// assert_eq!(solver.options, Options::default());
    /// ```
    pub fn with<T>(&mut self, options: Options, work: impl FnOnce(&mut Self) -> T) -> T {
        let own = std::mem::replace(&mut self.options, options);
        let result = work(self);
        self.options = own;
        result
    }
}
