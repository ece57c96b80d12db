//! Solves with more and more modes until a condition holds.

use super::error::SolveError;
use super::solver::Solver;

/// An error that can mean that more modes were requested than exist.
pub trait TooManyModes {
    /// Number of available modes, if more were requested.
    fn available_modes(&self) -> Option<usize>;
}

impl TooManyModes for SolveError {
    fn available_modes(&self) -> Option<usize> {
        match self {
            Self::TooManyModes { available, .. } => Some(*available),
            _ => None,
        }
    }
}

impl Solver {
    /// Calls the solve function for the number of modes in the options, then for twice as many, up
    /// to `most`, until `has_all` is true or there are no more modes. Afterwards the options
    /// contain the number of modes of the last solve.
    ///
    /// # Errors
    /// The errors of the function, except the error that fewer modes exist than were requested.
    ///
    /// # Example
    /// All modes below 5 Hz:
    /// ```
    /// use towermodes::{Material, Options, Solution, Solver, Station, Tower, TowerDescription};
    ///
    /// let tower = Tower::new(TowerDescription {
    ///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
    ///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
    ///     ..TowerDescription::default()
    /// })?;
    /// let mut solver = Solver::new(Options { modes: 2, ..Options::default() });
    /// let reaches = |solution: &Solution| solution.certificate.below_hz > 5.0;
    /// let solution = solver.until(100, |solver| solver.solve(&tower), reaches)?;
    /// assert_eq!((solution.modes.len(), solver.options.modes), (8, 8));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn until<T, E: TooManyModes>(
        &mut self,
        most: usize,
        mut solve: impl FnMut(&mut Self) -> Result<T, E>,
        mut has_all: impl FnMut(&T) -> bool,
    ) -> Result<T, E> {
        let mut most = most;
        loop {
            let modes = self.options.modes;
            match solve(self) {
                Ok(found) if modes >= most || has_all(&found) => return Ok(found),
                Ok(_) => self.options.modes = modes.saturating_mul(2).min(most),
                // Another mesh or degree of the same solve may have fewer modes still.
                Err(error) => match error.available_modes() {
                    Some(available) if (1..modes).contains(&available) => {
                        (self.options.modes, most) = (available, available);
                    }
                    _ => return Err(error),
                },
            }
        }
    }
}
