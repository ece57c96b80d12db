//! The derivatives with respect to gravity of a tower without gravity that shears. Under gravity a
//! joint that bends and shears has an unknown more, so its gradient lacks a part.

use super::slope::Derivatives;
use super::{Derivative, NoDerivative};
use crate::parameter::{Change, Operation};
use crate::solve::{FrozenModes, ModeFrequency, Solver};
use crate::tower::Neighbours;

/// The gravity with which the tower has these unknowns, m/s²: of no other effect.
const SLIGHT: f64 = 1e-9;

/// Whether a change is one of gravity of such a tower, whose derivatives are swept.
pub(super) fn is_needed(neighbours: &Neighbours, frozen: &FrozenModes, change: &Change) -> bool {
    frozen.gradients.is_some()
        && neighbours.description().gravity_m_per_s2 == 0.0
        && neighbours.tower().shears()
        && change.operation() != Operation::Scale
        && change.parameters().iter().any(|one| one.is_gravity())
}

/// The derivatives of the same tower under slight gravity; none if it is not solved.
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
