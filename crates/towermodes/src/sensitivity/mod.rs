//! Derivatives of the frequencies of a tower with respect to the numbers of its description.
//!
//! With the vector x of a mode held, d(λ)/dp = d/dp xᵀKx/xᵀMx (Hellmann 1937, Feynman 1939; Fox &
//! Kapoor 1968), no solve. With the default method `swept` has the derivatives with respect to all
//! numbers of a tower from one sweep along each mode, and differences what is left: how these
//! numbers follow from those of the description. With other methods `held` differences the
//! quotients, each of an assembly of a neighbour of the tower and two products. `step` chooses the
//! steps, `slope` extrapolates from steps and meshes, `solved` solves again where the neighbour has
//! another structure, `weightless` where gravity would give it one, `finer` on a finer mesh where
//! that of the frequencies is too coarse for the derivatives.

mod by_frequency;
mod error;
mod finer;
mod held;
mod slope;
mod solved;
mod step;
mod swept;
mod weightless;

pub use error::SensitivityError;

use crate::parameter::{Change, Operation};
use crate::solve::{FrozenModes, ModeFrequency, Solver};
use crate::tower::{Neighbours, TowerDescription};

/// The derivatives of the lowest frequencies of a tower.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensitivities {
    /// The modes by frequency, without shapes. Every row of the tower is a segment border, so
    /// frequencies may differ from those of a [`Solution`](crate::Solution) within their errors; if
    /// both bending planes are equal, the list contains the modes of both planes.
    pub modes: Vec<ModeFrequency>,
    /// The derivatives with respect to each change, in the order of the changes.
    pub changes: Vec<ChangeSensitivity>,
}

/// The derivatives of the frequencies with respect to one change of the tower.
#[derive(Debug, Clone, PartialEq)]
pub struct ChangeSensitivity {
    /// The change.
    pub change: Change,
    /// The value of the change that leaves the tower unchanged: the present input value, 1 for a
    /// factor (`scale`), 0 for an addition (`add`).
    pub value: f64,
    /// d([`Tower::structure_mass_kg`](crate::Tower::structure_mass_kg))/d(value), kg per unit.
    pub mass_kg_per_unit: f64,
    /// The derivative of each mode's frequency, in the order of the modes.
    pub modes: Vec<Result<Derivative, NoDerivative>>,
}

/// The derivative of a frequency with respect to the value of a change.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Derivative {
    /// d(extrapolated frequency)/d(value), Hz per unit of the value.
    pub hz_per_unit: f64,
    /// Estimate of its error, Hz per unit: from the step, from rounding and from the mesh.
    pub error_hz_per_unit: f64,
    /// The derivative of the frequency on the mode's own mesh, Hz per unit.
    pub mesh_hz_per_unit: f64,
}

/// Why a frequency has no derivative.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum NoDerivative {
    /// The frequency is zero.
    #[error("the frequency is zero")]
    AtRest,
    /// The change couples the mode with another mode of the same frequency, so the two frequencies
    /// separate in proportion to the magnitude of the change, whatever its sign: each has a kink.
    #[error("the input value couples the mode with another mode of the same frequency")]
    Repeated,
    /// The input value can be changed in one direction only, or the frequency has a kink: its
    /// slopes in the two directions differ.
    #[error(
        "the derivatives for an increase and a decrease of the input value differ, or one of them does not exist"
    )]
    OneSided,
}

impl ChangeSensitivity {
    /// The elasticity d(ln f)/d(ln value) of a mode, by its place in the list: percent of frequency
    /// per percent of the value. None without a derivative, and for an addition, whose value is 0.
    pub fn elasticity(&self, modes: &[ModeFrequency], mode: usize) -> Option<f64> {
        let derivative = self.modes.get(mode)?.as_ref().ok()?;
        let relative = derivative.hz_per_unit / modes.get(mode)?.extrapolated_hz;
        (self.change.operation() != Operation::Add).then_some(relative * self.value)
    }
}

impl Solver {
    /// Computes the derivatives of the lowest frequencies of a tower with respect to changes of it.
    ///
    /// The derivative of each frequency is exact up to the error that is given with it. It exists
    /// for every method, every number of the description and every kind of tower; heights move the
    /// mesh with them. Where fewer than 60 segments leave a derivative an error above 0.1 %, as in
    /// soil, all derivatives are computed on a finer mesh; the frequencies are computed on the
    /// requested mesh.
    ///
    /// [`points`](crate::Options::points) and [`heights_m`](crate::Options::heights_m) have no
    /// effect.
    ///
    /// # Errors
    /// [`SensitivityError`]: the description is invalid, its modes cannot be computed, or a change
    /// sets input values that are not equal.
    ///
    /// # Example
    /// How the first frequency changes with the wall thickness and with the mass on top:
    /// ```
    /// use towermodes::{Change, Material, Rna, Solver, Station, TowerDescription};
    ///
    /// let description = TowerDescription {
    ///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
    ///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
    ///     rna: Rna::point(350e3),
    ///     ..TowerDescription::default()
    /// };
    /// let changes = Change::parse_all(["scale(stations[*].wall)", "rna.mass"], &description)?;
    /// let result = Solver::default().sensitivities(&description, &changes)?;
    /// let elasticity = |change: usize| result.changes[change].elasticity(&result.modes, 0);
    /// let first = |change: usize| elasticity(change).expect("it has a derivative");
    /// assert!((first(0) - 0.4391).abs() < 1e-4);
    /// assert!((first(1) + 0.4457).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn sensitivities(
        &mut self,
        description: &TowerDescription,
        changes: &[Change],
    ) -> Result<Sensitivities, SensitivityError> {
        let fixed = self.options.added_mass.fixed();
        match by_frequency::held(description, fixed.unwrap_or_default()) {
            None => self.of_constant(description, changes),
            Some(held) if fixed.is_some() => self.of_constant(&held, changes),
            Some(_) => by_frequency::sensitivities(description, changes, self),
        }
    }

    /// The same where the added mass is constant.
    fn of_constant(
        &mut self,
        description: &TowerDescription,
        changes: &[Change],
    ) -> Result<Sensitivities, SensitivityError> {
        let values = changes.iter();
        let values = values.map(|change| step::present_value(change, description));
        let values: Vec<f64> = values.collect::<Result<_, _>>()?;
        let neighbours = Neighbours::of(description)?;
        let numbers = (changes, &values[..]);
        let (mut found, segments) = self.on_mesh(&neighbours, numbers)?;
        let finer = finer::options(&found, &neighbours, (&self.options, segments));
        if let Some(options) = finer {
            // Without the finer mesh the errors tell how coarse this one is.
            let finer = self.with(options, |finer| finer.on_mesh(&neighbours, numbers));
            if let Ok((finer, _)) = finer {
                found.take_finer(&finer);
            }
        }
        Ok(found)
    }

    /// The derivatives on the mesh of the options, and its number of segments.
    fn on_mesh(
        &mut self,
        neighbours: &Neighbours,
        (changes, values): (&[Change], &[f64]),
    ) -> Result<(Sensitivities, usize), SensitivityError> {
        let mut frozen = FrozenModes::of(neighbours, &self.options, &mut self.workspace)?;
        let mut swept = swept::Swept::new(neighbours);
        let mut held = held::Held::new(neighbours, &mut frozen);
        let mut results = Vec::with_capacity(changes.len());
        for (change, &value) in changes.iter().zip(values) {
            let of_swept = match weightless::is_needed(neighbours, held.frozen(), change) {
                true => {
                    let modes = &held.frozen().modes;
                    weightless::derivatives(neighbours, change, modes, self)
                }
                false => swept.derivatives(held.frozen(), change, value),
            };
            let of_held = of_swept.or_else(|| held.derivatives(change, value));
            let (modes, mass_kg_per_unit) = match of_held {
                Some(derivatives) => derivatives,
                None => {
                    solved::derivatives(neighbours, (change, value), &held.frozen().modes, self)
                }
            };
            results.push(ChangeSensitivity {
                change: change.clone(),
                value,
                mass_kg_per_unit,
                modes,
            });
        }
        let segments = frozen.segments();
        let found = Sensitivities {
            modes: frozen.modes,
            changes: results,
        };
        Ok((found, segments))
    }
}
