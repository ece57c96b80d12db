//! The checks of damping.

use super::super::parts::damping::{Damping, LossFactors, RotorAerodynamics};
use super::scale::{error, positive};
use crate::tower::error::{Place, Problem, TowerError};

impl Damping {
    /// Checks the damping as [`Tower::new`](crate::Tower::new) checks it.
    ///
    /// # Errors
    /// [`TowerError`]: a loss factor is not from 0 to 1, or a value of the rotor is not positive.
    pub fn validate(&self) -> Result<(), TowerError> {
        check_damping(self)
    }
}

/// Everything that damping must satisfy.
pub(super) fn check_damping(damping: &Damping) -> Result<(), TowerError> {
    let LossFactors {
        tower,
        materials,
        foundation,
        soil,
        wires,
        water,
    } = &damping.loss_factors;
    for value in materials.iter().flatten() {
        check_loss_factor("material_loss_factors", "a material", *value)?;
    }
    let parts = [
        ("tower_loss_factor", "the tower", tower),
        ("foundation_loss_factor", "the foundation", foundation),
        ("soil_loss_factor", "the soil", soil),
        ("wires_loss_factor", "the wires", wires),
        ("water_loss_factor", "the water", water),
    ];
    for (key, part, value) in parts {
        if let Some(value) = value {
            check_loss_factor(key, part, *value)?;
        }
    }
    damping.rotor.as_ref().map_or(Ok(()), check_rotor)
}

fn check_loss_factor(key: &'static str, part: &'static str, value: f64) -> Result<(), TowerError> {
    match (0.0..=1.0).contains(&value) {
        true => Ok(()),
        false => error(Place::Damping { key }, Problem::LossFactor { part, value }),
    }
}

fn check_rotor(rotor: &RotorAerodynamics) -> Result<(), TowerError> {
    let values = [
        (
            "chord_moment",
            "the chord moment",
            rotor.chord_moment_m3,
            " m3",
        ),
        ("lift_slope", "the lift slope", rotor.lift_slope, " per rad"),
        (
            "air_density",
            "the density of air",
            rotor.air_density_kg_per_m3,
            " kg/m3",
        ),
    ];
    for (key, quantity, value, unit) in values {
        positive(Place::Damping { key }, quantity, value, unit)?;
    }
    Ok(())
}
