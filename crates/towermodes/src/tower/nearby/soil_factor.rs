//! The same tower in softer or stiffer soil.

use super::super::description::TowerDescription;
use super::super::foundation::{Foundation, Support};
use super::super::parts::foundation_springs::FoundationSprings;
use super::super::parts::surroundings::SoilStiffness;
use crate::inputs::multiply_soil;

impl TowerDescription {
    /// Whether its frequencies depend on soil: it has soil springs or layers of soil, or its base
    /// is held by an elastic foundation.
    pub fn stands_in_soil(&self) -> bool {
        let springs = |soil: &SoilStiffness| *soil != SoilStiffness::default();
        let rows = self.soil.iter().flatten();
        let has_rows = rows.map(|row| &row.stiffness).any(springs);
        has_rows || self.ground.is_some() || is_elastic(&self.foundation)
    }

    /// The same tower with the stiffness of its soil multiplied by `factor`.
    ///
    /// The stiffness of soil is known within a factor of two at best. The factor applies to the
    /// springs of [`soil`](Self::soil), the modulus of the soil of a foundation that is given by
    /// its dimensions (the stiffness of the head of a flexible pile changes by less than the
    /// factor), and the springs or the stiffness matrix of the base. A clamped base and a floating
    /// platform have no soil.
    ///
    /// # Example
    /// ```
    /// use towermodes::{Foundation, HalfSpace, TowerDescription};
    ///
    /// let footing = |shear_modulus_pa| TowerDescription {
    ///     foundation: Foundation::HalfSpace(HalfSpace {
    ///         radius_m: 9.0,
    ///         embedment_m: 2.0,
    ///         shear_modulus_pa,
    ///         poissons_ratio: 0.3,
    ///     }),
    ///     ..TowerDescription::default()
    /// };
    /// assert_eq!(footing(4e7).with_soil_factor(0.5), footing(2e7));
    /// assert!(!TowerDescription::default().stands_in_soil());
    /// ```
    #[must_use]
    pub fn with_soil_factor(&self, factor: f64) -> Self {
        let mut tower = self.clone();
        for row in tower.soil.iter_mut().flatten() {
            row.stiffness = row.stiffness.times(factor);
        }
        if let Some(ground) = &mut tower.ground {
            ground.factor *= factor;
        }
        tower.foundation = on_soil(&self.foundation, factor);
        tower
    }
}

/// Whether the base can move, with springs.
fn is_elastic(foundation: &Foundation) -> bool {
    let is_spring = |spring: f64| spring.is_finite() && spring != 0.0;
    match foundation.support() {
        Support::Clamped | Support::Floating(_) => false,
        Support::Springs(springs) => springs.diagonal().into_iter().any(is_spring),
        Support::Stiffness(base) => (0..6).any(|motion| is_spring(base.stiffness[motion][motion])),
        Support::Form(_) => true,
        Support::Frame(foundation) => foundation.frame.has_soil(),
    }
}

/// The foundation on soil with `factor` times the stiffness; fixed motions stay fixed.
fn on_soil(foundation: &Foundation, factor: f64) -> Foundation {
    let mut changed = foundation.clone();
    match &mut changed {
        Foundation::Springs(springs) => *springs = times(springs, factor),
        Foundation::Stiffness(base) => {
            let entries = base.stiffness.iter_mut().flatten();
            entries.for_each(|entry| *entry *= factor);
        }
        Foundation::Frame(foundation) => foundation.frame.multiply_soil(factor),
        other => {
            if let Some(form) = other.form_mut() {
                multiply_soil(form, factor);
            }
        }
    }
    changed
}

/// Infinite springs stay infinite, and missing springs stay missing.
fn times(springs: &FoundationSprings, factor: f64) -> FoundationSprings {
    FoundationSprings {
        lateral_n_per_m: springs.lateral_n_per_m * factor,
        rocking_n_m: springs.rocking_n_m * factor,
        coupling_n: springs.coupling_n * factor,
        vertical_n_per_m: springs.vertical_n_per_m * factor,
        torsion_n_m: springs.torsion_n_m * factor,
    }
}
