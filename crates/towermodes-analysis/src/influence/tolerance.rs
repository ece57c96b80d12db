//! Tolerances of input values, and the combined scatter of the frequencies.

use towermodes::{Change, ParameterError, TowerDescription};

use super::Influences;

/// A tolerance of an input value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Tolerance {
    /// Percent of the value; for a height, percent of the tower height.
    Percent(f64),
    /// An amount in the unit of the input value.
    Amount(f64),
}

/// Tolerances of input values by name.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tolerances {
    /// The tolerance of input values without a tolerance of their own, except heights: a tolerance
    /// of each height would be a tolerance of each length between stations.
    pub of_others: Option<Tolerance>,
    /// Names of changes with their tolerances; if several contain the same input value, the last
    /// one applies.
    pub named: Vec<(Change, Tolerance)>,
}

impl Tolerances {
    /// Adds tolerances of input values by name.
    ///
    /// # Errors
    /// [`ParameterError`]: the tower has no such input value.
    pub fn new(
        of_others: Option<Tolerance>,
        named: &[(String, Tolerance)],
        description: &TowerDescription,
    ) -> Result<Self, ParameterError> {
        let named = named.iter().map(|(name, tolerance)| {
            let change = Change::parse(name, description)?;
            Ok((change, *tolerance))
        });
        Ok(Self {
            of_others,
            named: named.collect::<Result<_, ParameterError>>()?,
        })
    }

    /// Whether there are no tolerances.
    pub fn is_empty(&self) -> bool {
        self.of_others.is_none() && self.named.is_empty()
    }

    /// The tolerance of a change by its name; none if it has no tolerance.
    pub fn of(&self, change: &str, description: &TowerDescription) -> Option<Tolerance> {
        let own = Change::parse(change, description).ok();
        let has = |named: &&(Change, Tolerance)| {
            let own = own.as_ref().map(Change::parameters).unwrap_or_default();
            !own.is_empty() && own.iter().all(|one| named.0.parameters().contains(one))
        };
        if let Some((_, tolerance)) = self.named.iter().rev().find(has) {
            return Some(*tolerance);
        }
        let is_height = own.is_some_and(|own| own.parameters().iter().all(|one| one.is_height()));
        self.of_others.filter(|_| !is_height)
    }

    /// The combined effect of all tolerances on a mode, by its index in the list: the root sum of
    /// squares, Hz, for independent inputs.
    pub fn together_hz(
        &self,
        influences: &Influences,
        description: &TowerDescription,
        mode: usize,
    ) -> f64 {
        let effects = influences.numbers.iter().filter_map(|number| {
            let tolerance = self.of(&number.name, description)?;
            number.effect_hz(tolerance, mode)
        });
        effects.map(|effect| effect * effect).sum::<f64>().sqrt()
    }
}
