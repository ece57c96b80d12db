//! Tolerances of numbers, and the scatter of the frequencies that they make together.

use towermodes::{Change, ParameterError, TowerDescription};

use super::Influences;

/// A tolerance of a number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Tolerance {
    /// Percent of the value; of a height, percent of the height of the tower.
    Percent(f64),
    /// An amount in the unit of the number.
    Amount(f64),
}

/// Tolerances of numbers by name.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tolerances {
    /// The tolerance of the numbers that have none of their own, heights excepted: a tolerance of
    /// each height would be one of each length.
    pub of_others: Option<Tolerance>,
    /// Names of changes with their tolerances; the last one that has a number counts.
    pub named: Vec<(Change, Tolerance)>,
}

impl Tolerances {
    /// With tolerances of numbers by name.
    ///
    /// # Errors
    /// [`ParameterError`]: the tower has no such number.
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

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.of_others.is_none() && self.named.is_empty()
    }

    /// The tolerance of a change with a name; none if it has none.
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
