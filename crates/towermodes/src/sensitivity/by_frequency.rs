//! Derivatives if the added mass depends on frequency.
//!
//! With the added mass held at the frequency of a mode its eigenvalue μ has a derivative like that
//! of any tower. The mode is that of μ(λ) = λ, so dλ/dp = (∂μ/∂p)/(1 − dμ/dλ).

use super::{Derivative, Sensitivities, SensitivityError};
use crate::parameter::Change;
use crate::solve::{Solver, slopes};
use crate::tower::{Tower, TowerDescription};

/// The description with the added mass held at an angular frequency (rad/s), if it depends on
/// frequency.
pub(super) fn held(description: &TowerDescription, frequency: f64) -> Option<TowerDescription> {
    let platform = description.foundation.floating()?;
    platform.added_mass_by_frequency.as_ref()?;
    let held = platform.with_added_mass_at(frequency);
    let mut description = description.clone();
    *description.foundation.floating_mut()? = held;
    Some(description)
}

/// The derivatives of each mode with the added mass of its own frequency.
pub(super) fn sensitivities(
    description: &TowerDescription,
    changes: &[Change],
    solver: &mut Solver,
) -> Result<Sensitivities, SensitivityError> {
    let tower = Tower::new(description.clone())?;
    let modes = solver.frequencies(&tower)?.modes.clone();
    let slopes = slopes(&tower, &solver.options, &mut solver.workspace)?;
    let mut last: Option<(TowerDescription, Sensitivities)> = None;
    let mut all: Option<Sensitivities> = None;
    for (place, (frequency, slope)) in slopes.into_iter().enumerate() {
        let Some(held) = held(description, frequency) else {
            continue;
        };
        let found = match last.take() {
            // Above the last frequency of its table the added mass is constant.
            Some((same, found)) if same.foundation == held.foundation => found,
            _ => solver.of_constant(&held, changes)?,
        };
        let all = all.get_or_insert_with(|| found.clone());
        for (change, own) in all.changes.iter_mut().zip(&found.changes) {
            change.modes[place] = own.modes[place].map(|of| released(of, slope));
        }
        last = Some((held, found));
    }
    match all {
        Some(all) => Ok(Sensitivities { modes, ..all }),
        None => solver.of_constant(description, changes),
    }
}

fn released(derivative: Derivative, slope: f64) -> Derivative {
    Derivative {
        hz_per_unit: derivative.hz_per_unit / slope,
        error_hz_per_unit: derivative.error_hz_per_unit / slope.abs(),
        mesh_hz_per_unit: derivative.mesh_hz_per_unit / slope,
    }
}
