//! The identity of each mode: family, order, distribution of energy, effective mass.

use super::super::request::options::Options;
use super::model::{ModalForces, Model};
use super::spectrum::{Found, ModeKey, Spectrum};
use crate::modes::{Arrears, ByMotion, Energy, Family, RigidTower, Shares};
use crate::tower::{Motion, Motions, Plane, Tower};

/// Families whose sums in the rule of names differ by no more than this get modes in their order:
/// more than the rounding of shares, which tells equal motions in two planes apart.
const TIE: f64 = 1e-6;
const FAMILIES: usize = Family::ALL.len();

/// The identity of a mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Identity {
    pub(crate) family: Family,
    /// Order within the family, from 1.
    pub(crate) order: usize,
    pub(crate) shares: Shares,
    pub(crate) energy: Energy,
    /// Effective modal masses, kg and kg m².
    pub(crate) effective_mass: [f64; 6],
}

/// The data that are needed of identities.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wanted {
    /// Family, order and shares.
    Names,
    /// Energies and effective masses too.
    All,
}

/// The identities of a list of modes, and the memory to find them.
#[derive(Debug, Default)]
pub(crate) struct Naming {
    pub(crate) identities: Vec<Identity>,
    /// The shares of the first modes, if they are known already.
    pub(crate) known: Vec<Shares>,
    forces: Vec<ModalForces>,
}

/// Identifies the modes found, in their order.
pub(crate) fn identify(
    tower: &Tower,
    options: &Options,
    model: &mut Model,
    spectrum: &Spectrum,
    (found, wanted): (&[Found], Wanted),
    naming: &mut Naming,
) {
    let Naming {
        identities,
        known,
        forces,
    } = naming;
    let floats = tower.base().floats;
    let all = floats || wanted == Wanted::All;
    set_modal_forces(model, spectrum, found, all, forces);
    let rotary = options.has_rotary_inertia();
    let body = floats.then(|| RigidTower::new(&model.rigid_inertia(tower, rotary)));
    let mut arrears = Arrears::new(Family::ALL.map(Family::is_rigid), TIE);
    identities.clear();
    for (index, (found, forces)) in found.iter().zip(forces).enumerate() {
        let body = (body.as_ref(), known.get(index));
        identities.push(identity(model, found, forces, body, &mut arrears));
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

/// The motions that the structure couples in a mode.
fn motions_of(model: &Model, key: ModeKey) -> Motions {
    match key.is_turned {
        true => Motions::only(Motion::Bending(Plane::SideSide)),
        false => model.motions(key.subsystem),
    }
}

/// The identity of the next mode of a list, whose shares may be known.
fn identity(
    model: &Model,
    found: &Found,
    forces: &ModalForces,
    (body, known): (Option<&RigidTower>, Option<&Shares>),
    arrears: &mut Arrears<FAMILIES>,
) -> Identity {
    let kinetic = forces.kinetic.shares();
    let strain = match forces.strain {
        // The strain energy of a motion without stiffness is only rounding error.
        _ if found.eigenvalue.is_zero() => ByMotion::default(),
        None => kinetic,
        Some(strain) => strain.shares(),
    };
    let energy = Energy { kinetic, strain };
    // The vector has uᵀ(K − σM)u = 1, and so uᵀMu = 1/(λ − σ).
    let from_origin = found.eigenvalue.lambda - model.origin;
    let motions = motions_of(model, found.key);
    let shares = match body {
        Some(body) => {
            let force = forces.force.map(|force| force * from_origin.sqrt());
            let own = Shares::afloat(&kinetic, &body.shares(&force));
            if found.key.is_turned {
                own.turned_to_side_side()
            } else {
                own
            }
        }
        None => match motions.only_one() {
            Some(only) => Shares::only(Family::of(only)),
            None => Shares::of_motions(&energy.mean()),
        },
    };
    let shares = match forces.local {
        // Half of the sum of the shares in kinetic and strain energy, as of the motions.
        Some([kinetic, _]) if body.is_some() => shares.with_local(kinetic),
        Some([kinetic, strain]) => shares.with_local(0.5 * (kinetic + strain)),
        None => shares,
    };
    let is_on_frame = forces.local.is_some();
    // Known shares name the mode, but do not describe its vector: modes of other added masses may
    // have another order, and a motion that this vector has not cannot scale its shape.
    let by = known.unwrap_or(&shares);
    let (family, order) = name((motions, is_on_frame), by, body.is_some(), arrears);
    let effective_mass = forces.force.map(|force| force * force * from_origin);
    let [x, y, z, rx, ry, rz] = effective_mass;
    let (energy, effective_mass) = match found.key.is_turned {
        true => (energy.turned_to_side_side(), [y, x, z, ry, rx, rz]),
        false => (energy, effective_mass),
    };
    Identity {
        family,
        order,
        shares,
        energy,
        effective_mass,
    }
}

/// Names the next mode of a list, whose subsystem couples these motions and may have local modes of
/// a frame: by its motions, and afloat by those of the tower as one rigid body too.
fn name(
    (motions, is_on_frame): (Motions, bool),
    shares: &Shares,
    floats: bool,
    arrears: &mut Arrears<FAMILIES>,
) -> (Family, usize) {
    if let Some(only) = motions.only_one()
        && !floats
    {
        let family = Family::of(only);
        return (family, arrears.name_alone(family as usize));
    }
    let may = |place: usize| {
        let family = Family::ALL[place];
        let couples = |motion| motions.contains(motion);
        (floats || !family.is_rigid()) && family.motion().map_or(is_on_frame, couples)
    };
    let (place, order) = arrears.name(shares.values(), may);
    (Family::ALL[place], order)
}
