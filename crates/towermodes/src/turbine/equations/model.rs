//! The equations of motion of a turbine on a mesh.

use std::f64::consts::TAU;

use super::super::checked::{Turbine, rotor};
use super::super::description::rad_per_s;
use super::super::error::TurbineError;
use super::below::Below;
use super::gyroscopic::{Gyroscopic, Raise};
use super::machine::{Machine, MachineFactors};
use super::mesh::TurbineMesh;
use crate::beam::{BeamRecipe, BeamWorkspace, SpaceBeam, TopWorkspace, assemble_in_space};
use crate::elements::{Borders, Mesh};
use crate::modes::RigidTower;
use crate::rotor::reactionless;
use crate::space::add_scaled;
use crate::subsystem::{Coefficients, Subsystem};

/// A motion slower than this, rad/s (a period of a week), has no stiffness: because of rounding a
/// stiffness of zero becomes about 1e-16 of the square of the rotor speed times the inertia.
pub(crate) const UNRESISTED: f64 = 1e-5;

/// The equations of motion of a turbine on a mesh, with work arrays:
///
/// H(w) = K + i w G − w² M,
///
/// Hermitian at any speed Ω of the rotor, in axes that do not turn.
pub struct TurbineModel {
    pub(crate) tower: SpaceBeam,
    pub(crate) machine: Machine,
    pub(crate) is_locked: bool,
    /// The support of the tower.
    pub(crate) below: Below,
    pub(super) workspace: TopWorkspace,
    pub(crate) factors: MachineFactors,
    /// The turbine as a rigid body, if it floats.
    pub(crate) platform: Option<RigidTower>,
    /// Number of motions without stiffness, without the rotation of a free shaft.
    pub(crate) unresisted: usize,
    /// Relative error of frequencies because soil springs are linear between depths.
    pub(crate) soil_error: f64,
}

impl std::fmt::Debug for TurbineModel {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("TurbineModel").finish_non_exhaustive()
    }
}

impl TurbineModel {
    /// The equations of a turbine.
    ///
    /// # Errors
    /// [`TurbineError`] if the mesh is impossible, if numbers overflow, or if the tower is unstable
    /// at rest.
    pub fn new(turbine: &Turbine, mesh: &TurbineMesh) -> Result<Self, TurbineError> {
        mesh.check()?;
        let (tower, machine) = (&turbine.tower, &turbine.machine);
        let recipe = BeamRecipe::Spectral {
            degree: mesh.tower_degree,
            rotary_inertia: true,
            shear: true,
        };
        let elements = Mesh::new(tower, Borders::Gradual, mesh.tower_elements);
        let mut beam = SpaceBeam::default();
        let attachments = tower.attachments_but_inertia_of_rna();
        let mut memory = BeamWorkspace::default();
        assemble_in_space(
            tower,
            &attachments,
            (&elements, recipe),
            &mut memory,
            &mut beam,
        );
        let rotor = rotor(&turbine.blade, machine, mesh.blade_degree)?;
        let is_finite = beam.members()[0].is_finite() && rotor.body().is_finite();
        if !is_finite {
            return Err(TurbineError::Overflow);
        }
        let mut below = Below::new(tower, mesh.tower_degree)?;
        let platform = tower.base().floats.then(|| {
            let mut whole = tower.rigid_inertia(true);
            add_scaled(&mut whole, 1.0, &below.rigid_inertia());
            RigidTower::new(&whole)
        });
        let mut model = Self {
            tower: beam,
            machine: Machine::new(machine, rotor),
            is_locked: machine.generator.is_locked,
            below,
            workspace: TopWorkspace::default(),
            factors: MachineFactors::default(),
            platform,
            unresisted: 0,
            soil_error: tower.soil_error(),
        };
        let negative = model.negative_stiffness_of_tower();
        if negative > 0 {
            return Err(TurbineError::Unstable { negative });
        }
        model.unresisted = model.count_at(UNRESISTED, 0.0, true);
        Ok(model)
    }

    /// The number of negative eigenvalues of H at a frequency in Hz, which is not 0, and a speed of
    /// the rotor in rpm.
    ///
    /// If K is positive definite, this is the number of natural frequencies below the given one;
    /// the rotation of a free shaft adds 1. Proof: where an eigenvalue of H vanishes, with the
    /// vector x, its derivative by w, times w, is −xᴴ (K + w² M) x < 0, so that each crosses zero
    /// downwards. Where the stiffness K, softened by the spin, is indefinite, modes with xᴴ (K + w²
    /// M) x < 0, of negative energy, cross upwards.
    pub fn count(&mut self, frequency_hz: f64, rotor_speed_rpm: f64) -> usize {
        let speed = rad_per_s(rotor_speed_rpm);
        self.count_at(TAU * frequency_hz, speed, self.is_locked)
    }

    /// The number of negative eigenvalues of the stiffness K with the generator locked, at a speed
    /// in rpm: 0 unless the rotor turns faster than its blades vibrate.
    ///
    /// It is counted in K + w² M at 1e-5 rad/s, a period of a week: motions that nothing resists,
    /// whose stiffness is zero but for rounding, are not among them.
    pub fn negative_stiffness(&mut self, rotor_speed_rpm: f64) -> usize {
        self.negative_stiffness_at(rad_per_s(rotor_speed_rpm))
    }

    /// The negative eigenvalues of the stiffness of the tower with its support.
    fn negative_stiffness_of_tower(&mut self) -> usize {
        let inertia = UNRESISTED * UNRESISTED;
        let below = self.below.seen(0.0, inertia);
        let tower = &self.tower.members()[0];
        let own = tower.negative_stiffness(inertia, below.map(|below| below.stiffness));
        own + below.map_or(0, |below| below.count)
    }

    /// As above, at a rotor speed in rad/s.
    pub(crate) fn negative_stiffness_at(&mut self, speed: f64) -> usize {
        let raise = Raise {
            by_inertia: UNRESISTED * UNRESISTED,
            ..Raise::default()
        };
        let coupled = self.count_coupled((0.0, speed), raise, true);
        let of_waves = reactionless(self.machine.rotor.blades());
        let of_waves = of_waves.map(|wave| {
            let mut blade = self.on_still_hub(wave, speed);
            blade.count_raised(0.0, raise)
        });
        coupled + of_waves.sum::<usize>()
    }

    /// Number of motions without stiffness, apart from the rotation of a free shaft: motions of a
    /// floating platform that no mooring holds, or yaw with a negligible stiffness of the yaw
    /// drive. They are slower than 1e-5 rad/s and are not among the modes.
    pub fn unresisted_motions(&self) -> usize {
        self.unresisted
    }

    /// K + a M of the tower.
    pub(crate) fn of_tower(a: f64) -> Coefficients {
        Coefficients::STIFFNESS.minus(-a, Coefficients::MASS)
    }

    /// The negative eigenvalues of H + R at a frequency and a speed, rad/s, without harmonics of
    /// the blades that do not move the hub.
    pub(crate) fn count_coupled(
        &mut self,
        (w, speed): (f64, f64),
        raise: Raise,
        is_locked: bool,
    ) -> usize {
        let machine = self.machine.seen_from_top((w, speed), raise, is_locked);
        let inertia = raise.inertia(w) - w * w;
        let below = self.below.seen(w, inertia);
        let ends = (machine.matrix, below.map(|below| below.stiffness));
        let tower = &self.tower.members()[0];
        let workspace = &mut self.workspace;
        let negative = tower.count_negative_between(&Self::of_tower(inertia), ends, workspace);
        machine.negative + negative + below.map_or(0, |below| below.count)
    }

    fn count_at(&mut self, w: f64, speed: f64, is_locked: bool) -> usize {
        let reactionless = self.machine.rotor.count_reactionless(w, speed);
        self.count_coupled((w, speed), Raise::default(), is_locked) + reactionless
    }
}
