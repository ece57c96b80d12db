//! The derivatives with respect to gravity of a tower without gravity and with shear deformation.
//! With gravity a joint with bending and shear has one more unknown, so the gradient of the tower
//! without gravity lacks a term.

use super::slope::Derivatives;
use super::{Derivative, NoDerivative};
use crate::parameter::{Change, Operation};
use crate::solve::{FrozenModes, ModeFrequency, Solver};
use crate::tower::Neighbours;

/// A gravity so small that it has no effect but adds these unknowns, m/s².
const SLIGHT: f64 = 1e-9;

/// Whether a change is one of gravity for such a tower and the derivatives come from gradients.
pub(super) fn is_needed(neighbours: &Neighbours, frozen: &FrozenModes, change: &Change) -> bool {
    frozen.gradients.is_some()
        && neighbours.description().gravity_m_per_s2 == 0.0
        && neighbours.tower().shears()
        && change.operation() != Operation::Scale
        && change.parameters().iter().any(|one| one.is_gravity())
}

/// The derivatives of the tower with a very small gravity; none if it cannot be solved.
pub(super) fn derivatives(
    neighbours: &Neighbours,
    change: &Change,
    modes: &[ModeFrequency],
    solver: &mut Solver,
) -> Option<Derivatives> {
    let mut description = neighbours.description().clone();
    description.gravity_m_per_s2 = SLIGHT;
    let changes = std::slice::from_ref(change);
    let slight = solver.sensitivities(&description, changes).ok()?;
    let of_change = slight.changes.first()?;
    let of_mode = |mode: &ModeFrequency| -> Result<Derivative, NoDerivative> {
        let is_same = |other: &ModeFrequency| other.name() == mode.name();
        match slight.modes.iter().position(is_same) {
            Some(place) => of_change.modes[place],
            None => Err(NoDerivative::Repeated),
        }
    };
    let derivatives = modes.iter().map(of_mode).collect();
    Some((derivatives, of_change.mass_kg_per_unit))
}
