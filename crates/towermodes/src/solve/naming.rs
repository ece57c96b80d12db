//! The identity of each mode: family, order, distribution of energy, effective mass.

use super::model::{ModalForces, Model};
use super::options::Options;
use super::spectrum::{Found, Spectrum};
use crate::modes::{ByMotion, Energy, Family, RigidNames, RigidTower};
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

/// What is wanted of identities.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Wanted {
    /// Family and order.
    Names,
    /// Energies and effective masses too.
    All,
}

/// The identities of a list of modes, and the memory to find them.
#[derive(Debug, Default)]
pub(super) struct Naming {
    pub(super) identities: Vec<Identity>,
    forces: Vec<ModalForces>,
    /// The names of modes in which a floating tower moves as one body.
    rigid: Vec<Option<Family>>,
}

/// Identifies the modes found, in their order.
pub(super) fn identify(
    tower: &Tower,
    options: &Options,
    model: &mut Model,
    spectrum: &Spectrum,
    (found, wanted): (&[Found], Wanted),
    naming: &mut Naming,
) {
    let Naming {
        identities,
        forces,
        rigid,
    } = naming;
    let floats = tower.base().floats;
    let all = floats || wanted == Wanted::All;
    set_modal_forces(model, spectrum, found, all, forces);
    rigid.clear();
    if floats {
        let inertia = &tower.rigid_inertia(options.has_rotary_inertia());
        name_afloat(found, forces, model.origin, inertia, rigid);
    } else {
        rigid.resize(found.len(), None);
    }
    let mut orders = [0; Family::ALL.len()];
    identities.clear();
    for ((found, forces), rigid) in found.iter().zip(forces).zip(rigid) {
        let mut identity = identity(model, found, forces, *rigid);
        let order = &mut orders[identity.family as usize];
        *order += 1;
        identity.order = *order;
        identities.push(identity);
    }
}

/// The forces and energies of the modes; the second of a repeated pair has those of the first.
/// Unless `all` are wanted, those of a subsystem with a single motion are left out: its family is
/// known.
fn set_modal_forces(
    model: &mut Model,
    spectrum: &Spectrum,
    found: &[Found],
    all: bool,
    forces: &mut Vec<ModalForces>,
) {
    forces.clear();
    for (index, mode) in found.iter().enumerate() {
        let subsystem = mode.key.subsystem;
        let known = match forces.last() {
            Some(last) if mode.key.is_turned && found[index - 1].key.is_twin(mode.key) => *last,
            _ if !all && model.has_single_motion(subsystem) => ModalForces::default(),
            _ => model.modal_forces(subsystem, spectrum.vector(mode.key)),
        };
        forces.push(known);
    }
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

/// Names the modes in which a floating tower moves as one body; those of the second of two equal
/// planes as in the first, which is listed before.
fn name_afloat(
    found: &[Found],
    forces: &[ModalForces],
    origin: f64,
    inertia: &SpatialMatrix,
    names: &mut Vec<Option<Family>>,
) {
    let body = RigidTower::new(inertia);
    let mut rigid_names = RigidNames::default();
    for (index, (mode, forces)) in found.iter().zip(forces).enumerate() {
        let scale = (mode.eigenvalue.lambda - origin).sqrt();
        let twin = found[..index].iter().position(|m| m.key.is_twin(mode.key));
        names.push(match twin {
            Some(twin) => names[twin],
            None => rigid_names.name(&body.shares(&forces.force.map(|force| force * scale))),
        });
    }
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
