//! The checks of damping.

use super::super::parts::damping::{Damping, loss_factor};
use super::inputs::{check_input, check_inputs};
use crate::inputs::Input;
use crate::tower::error::{Place, TowerError};

/// The loss factors of materials, each by its name.
static OF_MATERIAL: Input = loss_factor("material_loss_factors", "the loss factor of a material");
const AT_MATERIALS: Place = Place::Damping {
    key: "material_loss_factors",
};

impl Damping {
    /// Checks the damping as [`Tower::new`](crate::Tower::new) checks it.
    ///
    /// # Errors
    /// [`TowerError`]: a loss factor is not from 0 to 1, or a value of the rotor is not positive.
    pub fn validate(&self) -> Result<(), TowerError> {
        check_damping(self)
    }
}

/// Checks the values of the damping.
pub(super) fn check_damping(damping: &Damping) -> Result<(), TowerError> {
    check_inputs(damping, |key| Place::Damping { key })?;
    let mut materials = damping.loss_factors.materials.iter().flatten();
    materials.try_for_each(|value| check_input(&OF_MATERIAL, *value, AT_MATERIALS))
}
