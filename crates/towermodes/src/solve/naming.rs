//! The identity of each mode: family, order, distribution of energy, effective mass.

use std::collections::HashMap;

use super::model::{ModalForces, Model};
use super::spectrum::{Found, Spectrum};
use crate::modes::{ByMotion, Energy, Family, RigidTower, rigid_names};
use crate::space::SpatialMatrix;
use crate::tower::Tower;

/// The identity of a mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Identity {
    pub(super) family: Family,
    /// Order within the family, from 1.
    pub(super) order: usize,
    pub(super) energy: Energy,
    /// Effective modal masses, kg and kg m².
    pub(super) effective_mass: [f64; 6],
}

/// Identifies the modes found, in their order.
pub(super) fn identify(
    tower: &Tower,
    model: &mut Model,
    spectrum: &Spectrum,
    found: &[Found],
    inertia: &SpatialMatrix,
) -> Vec<Identity> {
    let forces = modal_forces(model, spectrum, found);
    let rigid = if tower.base().floats {
        names_afloat(found, &forces, model.origin, inertia)
    } else {
        vec![None; found.len()]
    };
    let mut orders: HashMap<Family, usize> = HashMap::new();
    let identified = found.iter().zip(&forces).zip(rigid);
    let identities = identified.map(|((found, forces), rigid)| {
        let mut identity = identity(model, found, forces, rigid);
        let order = orders.entry(identity.family).or_insert(0);
        *order += 1;
        identity.order = *order;
        identity
    });
    identities.collect()
}

/// The forces and energies of the modes; the second of a repeated pair has those of the first.
fn modal_forces(model: &mut Model, spectrum: &Spectrum, found: &[Found]) -> Vec<ModalForces> {
    let mut forces: Vec<ModalForces> = Vec::with_capacity(found.len());
    for (index, mode) in found.iter().enumerate() {
        let known = match forces.last() {
            Some(last) if mode.key.is_turned && found[index - 1].key.is_twin(mode.key) => *last,
            _ => model.modal_forces(mode.key.subsystem, spectrum.vector(mode.key)),
        };
        forces.push(known);
    }
    forces
}

/// The identity of one mode, with the name of a rigid-body mode if it has one; its order is not
/// known yet.
fn identity(model: &Model, found: &Found, forces: &ModalForces, rigid: Option<Family>) -> Identity {
    let kinetic = forces.kinetic.shares();
    let strain = match forces.strain {
        // A motion that nothing resists has no strain energy but rounding errors.
        _ if found.eigenvalue.is_zero() => ByMotion::default(),
        None => kinetic,
        Some(strain) => strain.shares(),
    };
    let energy = Energy { kinetic, strain };
    // The vector has uᵀ(K − σM)u = 1, and so uᵀMu = 1/(λ − σ).
    let from_origin = found.eigenvalue.lambda - model.origin;
    let identity = Identity {
        family: rigid.unwrap_or_else(|| family(model, found, &energy)),
        order: 0,
        energy,
        effective_mass: forces.force.map(|force| force * force * from_origin),
    };
    if found.key.is_turned {
        identity.turned_to_side_side()
    } else {
        identity
    }
}

/// The family of a mode of an elastic tower: that of the only motion of its subsystem, or of the
/// one with most of its energy.
fn family(model: &Model, found: &Found, energy: &Energy) -> Family {
    let mut motions = model.motions(found.key.subsystem).iter();
    match (motions.next(), motions.next()) {
        (Some(only), None) => Family::of(only),
        _ => energy.main_motion().map_or(Family::Coupled, Family::of),
    }
}

/// The names of the modes in which a floating tower moves as one body; those of the second of two
/// equal planes as in the first.
fn names_afloat(
    found: &[Found],
    forces: &[ModalForces],
    origin: f64,
    inertia: &SpatialMatrix,
) -> Vec<Option<Family>> {
    let own: Vec<usize> = (0..found.len())
        .filter(|&i| !found[i].key.is_turned)
        .collect();
    let body = RigidTower::new(inertia);
    let shares = own.iter().map(|&i| {
        let scale = (found[i].eigenvalue.lambda - origin).sqrt();
        body.shares(&forces[i].force.map(|force| force * scale))
    });
    let mut names = vec![None; found.len()];
    for (&i, name) in own.iter().zip(rigid_names(shares)) {
        let same = (0..found.len()).filter(|&j| found[j].key.is_twin(found[i].key));
        same.for_each(|j| names[j] = name);
    }
    names
}

impl Identity {
    /// The same in the side-side plane, of a mode in the fore-aft plane.
    fn turned_to_side_side(&self) -> Self {
        let [x, y, z, rx, ry, rz] = self.effective_mass;
        Self {
            family: self.family.turned_to_side_side(),
            order: self.order,
            energy: self.energy.turned_to_side_side(),
            effective_mass: [y, x, z, ry, rx, rz],
        }
    }
}
