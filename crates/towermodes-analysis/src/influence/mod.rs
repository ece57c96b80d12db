//! The influence of the input values of a tower on its frequencies, and the effect of their
//! tolerances.
//!
//! The influence of an input value on a mode is its elasticity: the change of the frequency in
//! percent for a 1 % change of the input value. Heights have an arbitrary datum, so for a height 1
//! % means 1 % of the tower height.

mod tolerance;

pub use tolerance::{Tolerance, Tolerances};

use towermodes::{
    Change, Derivative, NoDerivative, Operation, SensitivityError, Solver, Tower, TowerDescription,
};

/// Elasticities below this value are negligible compared with the uncertainty of input values.
pub const NEGLIGIBLE: f64 = 1e-4;

/// The reference of the percentage.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Basis {
    /// The value of the input value, or of the factor.
    Value,
    /// The height of the tower.
    TowerHeight,
    /// No percentage: the input value is zero.
    Zero,
}

/// The influence of one input value, or of a change of several, on the frequencies.
#[derive(Debug, Clone, PartialEq)]
pub struct Influence {
    /// The name of the input value or of the change.
    pub name: String,
    /// The operation of the change on its value.
    pub operation: Operation,
    /// The value on the unchanged tower: the input value, 1 for a factor, 0 for an addition.
    pub value: f64,
    /// Its unit.
    pub unit: &'static str,
    /// The reference of the percentage.
    pub basis: Basis,
    /// The change by one hundred percent, in the unit of the change: the factor from derivative to
    /// elasticity.
    whole: f64,
    /// The frequency of each mode, extrapolated, Hz.
    frequencies_hz: Vec<f64>,
    /// The derivative of each mode's frequency.
    pub derivatives: Vec<Result<Derivative, NoDerivative>>,
    /// The elasticity of each mode: percent per percent; none without a derivative.
    pub elasticities: Vec<Option<f64>>,
    /// d(mass of the tower)/d(value), kg per unit.
    pub mass_kg_per_unit: f64,
}

impl Influence {
    /// The largest absolute value of the elasticities of all modes.
    pub fn largest(&self) -> f64 {
        let known = self.elasticities.iter().flatten();
        known.fold(0.0, |most, elasticity| most.max(elasticity.abs()))
    }

    /// The derivative of a mode's frequency, by the index of the mode: percent of the frequency per
    /// unit of the value.
    pub fn percent_per_unit(&self, mode: usize) -> Option<f64> {
        let derivative = self.derivatives.get(mode)?.as_ref().ok()?;
        Some(100.0 * derivative.hz_per_unit / self.frequencies_hz[mode])
    }

    /// The effect of a tolerance on a mode, by its index in the list: percent of its frequency,
    /// without sign.
    pub fn percent(&self, tolerance: Tolerance, mode: usize) -> Option<f64> {
        Some(100.0 * self.effect_hz(tolerance, mode)? / self.frequencies_hz[mode])
    }

    /// The effect of a tolerance on a mode, by its index in the list: Hz, without sign.
    pub fn effect_hz(&self, tolerance: Tolerance, mode: usize) -> Option<f64> {
        let derivative = self.derivatives.get(mode)?.as_ref().ok()?;
        let amount = match tolerance {
            Tolerance::Percent(percent) => percent / 100.0 * self.whole,
            Tolerance::Amount(amount) => amount,
        };
        Some((derivative.hz_per_unit * amount).abs())
    }
}

/// A mode whose frequency is influenced.
#[derive(Debug, Clone, PartialEq)]
pub struct InfluencedMode {
    /// Order and family in words: "1st fore-aft bending".
    pub label: String,
    /// Its frequency, extrapolated, Hz.
    pub frequency_hz: f64,
}

/// The influence of the input values of a tower on its frequencies.
#[derive(Debug, Clone, PartialEq)]
pub struct Influences {
    /// The modes by frequency.
    pub modes: Vec<InfluencedMode>,
    /// The input values, in the order of the tower file or of the changes.
    pub numbers: Vec<Influence>,
}

impl Influences {
    /// The input values by decreasing influence on any of the modes.
    pub fn ranked(&self) -> Vec<&Influence> {
        self.ranked_by(Influence::largest)
    }

    /// The input values by decreasing effect of their tolerances on any of the modes; input values
    /// without a tolerance last.
    pub fn ranked_with(
        &self,
        tolerances: &Tolerances,
        description: &TowerDescription,
    ) -> Vec<&Influence> {
        self.ranked_by(|number| match tolerances.of(&number.name, description) {
            None => 0.0,
            Some(tolerance) => {
                let modes = 0..self.modes.len();
                let effects = modes.filter_map(|mode| number.percent(tolerance, mode));
                effects.fold(0.0, f64::max)
            }
        })
    }

    fn ranked_by(&self, size: impl Fn(&Influence) -> f64) -> Vec<&Influence> {
        let sized = self.numbers.iter();
        let sized = sized.map(|number| (without_rounding(size(number)), number));
        let mut ranked: Vec<(f64, &Influence)> = sized.collect();
        ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
        ranked.into_iter().map(|(_, number)| number).collect()
    }
}

/// A value rounded to six digits, so that rounding errors do not determine the order of equal
/// influences.
fn without_rounding(size: f64) -> f64 {
    let decade = size.log10().floor();
    match decade.is_finite() {
        true => {
            let unit = 10.0_f64.powf(decade - 5.0);
            (size / unit).round() * unit
        }
        false => size,
    }
}

/// Computes the influence of every input value of a tower, or of the given changes, on its lowest
/// frequencies.
///
/// # Errors
/// [`SensitivityError`].
///
/// # Example
/// ```
/// use towermodes::{Material, Options, Rna, Station, TowerDescription, Solver};
/// use towermodes_analysis::influences;
///
/// let description = TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     ..TowerDescription::default()
/// };
/// let result = influences(&description, None, &mut Solver::default())?;
/// // The height of the tower, from its base or from its top.
/// assert!(result.ranked()[0].name.ends_with(".height"));
/// # Ok::<(), towermodes::SensitivityError>(())
/// ```
pub fn influences(
    description: &TowerDescription,
    changes: Option<&[Change]>,
    solver: &mut Solver,
) -> Result<Influences, SensitivityError> {
    let every;
    let changes = match changes {
        Some(changes) => changes,
        None => {
            every = Change::every(description);
            &every
        }
    };
    let result = solver.sensitivities(description, changes)?;
    let height_m = Tower::new(description.clone())?.height_m();
    let modes = result.modes.iter().map(|mode| InfluencedMode {
        label: mode.label(),
        frequency_hz: mode.extrapolated_hz,
    });
    let modes: Vec<InfluencedMode> = modes.collect();
    let numbers = result.changes.into_iter().map(|of| {
        let (basis, whole) = basis(&of.change, of.value, height_m);
        let of_mode = |(mode, derivative): (&InfluencedMode, &Result<Derivative, NoDerivative>)| {
            let derivative = derivative.as_ref().ok()?;
            (basis != Basis::Zero).then(|| derivative.hz_per_unit * whole / mode.frequency_hz)
        };
        Influence {
            name: of.change.name().to_owned(),
            operation: of.change.operation(),
            value: of.value,
            unit: of.change.unit(),
            basis,
            whole,
            frequencies_hz: modes.iter().map(|mode| mode.frequency_hz).collect(),
            elasticities: modes.iter().zip(&of.modes).map(of_mode).collect(),
            derivatives: of.modes,
            mass_kg_per_unit: of.mass_kg_per_unit,
        }
    });
    Ok(Influences {
        numbers: numbers.collect(),
        modes,
    })
}

/// The reference of the percentage, and one hundred percent in the unit of the change.
fn basis(change: &Change, value: f64, height_m: f64) -> (Basis, f64) {
    let is_height = change.parameters().iter().all(|one| one.is_height());
    match change.operation() {
        Operation::Set | Operation::Add if is_height => (Basis::TowerHeight, height_m),
        _ if value == 0.0 => (Basis::Zero, 0.0),
        _ => (Basis::Value, value),
    }
}
