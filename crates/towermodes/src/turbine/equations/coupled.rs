//! The parts of a turbine's equations that are solved by themselves: all that moves the tower, and
//! harmonics of the blades that do not move the hub.

use super::gyroscopic::{Gyroscopic, Raise};
use super::machine_vectors::JOINTS;
use super::model::TurbineModel;
use crate::beam::{BladeFactors, TurningBlade};
use crate::rotor::Reactionless;
use crate::scalar::Complex;
use crate::subsystem::Subsystem;

/// Tower, drivetrain and the harmonics of the blades that move the hub, at a speed (rad/s).
///
/// Vectors hold the coordinates of the tower, of the joints, and of the blades.
pub(crate) struct Coupled<'a> {
    pub(crate) model: &'a mut TurbineModel,
    pub(crate) speed: f64,
}

impl TurbineModel {
    /// The coordinates of the tower, of the joints and of the blades.
    pub(crate) fn split<'x>(&self, x: &'x [Complex]) -> [&'x [Complex]; 3] {
        let (tower, rest) = x.split_at(self.tower.members()[0].degrees_of_freedom());
        let (joints, blades) = rest.split_at(JOINTS);
        [tower, joints, blades]
    }
}

impl Gyroscopic for Coupled<'_> {
    fn degrees_of_freedom(&self) -> usize {
        let tower = self.model.tower.members()[0].degrees_of_freedom();
        tower + self.model.machine.degrees_of_freedom()
    }

    fn count_raised(&mut self, w: f64, raise: Raise) -> usize {
        let is_locked = self.model.is_locked;
        self.model.count_coupled((w, self.speed), raise, is_locked)
    }

    fn factorize(&mut self, w: f64) -> usize {
        let TurbineModel {
            tower,
            machine,
            is_locked,
            workspace,
            factors,
            ..
        } = &mut *self.model;
        let machine = machine.factorize((w, self.speed), *is_locked, factors);
        let a = TurbineModel::of_tower(-w * w);
        machine.negative + tower.members()[0].factorize_under(&a, machine.matrix, workspace)
    }

    fn solve(&mut self, x: &mut [Complex]) {
        let TurbineModel {
            tower,
            machine,
            is_locked,
            workspace,
            factors,
            ..
        } = &mut *self.model;
        let tower = &tower.members()[0];
        let (of_tower, of_machine) = x.split_at_mut(tower.degrees_of_freedom());
        let at_top = machine.reduce(*is_locked, factors, of_machine);
        let top = tower.solve_under(workspace, at_top, of_tower);
        machine.substitute(*is_locked, factors, &top, of_machine);
    }

    fn derivative(&mut self, w: f64, x: &[Complex], out: &mut [Complex]) -> f64 {
        let TurbineModel {
            tower,
            machine,
            is_locked,
            workspace,
            factors,
            ..
        } = &mut *self.model;
        let tower = &tower.members()[0];
        let (x, of_machine) = x.split_at(tower.degrees_of_freedom());
        let (out, out_of_machine) = out.split_at_mut(tower.degrees_of_freedom());
        let (top, mass) = tower.begin_derivative(w, x, workspace);
        let at = (w, self.speed, *is_locked);
        let motion = (&top, of_machine);
        let (at_top, of_machine) = machine.derivative(at, motion, factors, out_of_machine);
        tower.end_derivative(w, at_top, (x, out), workspace);
        mass + of_machine
    }
}

/// A harmonic of the blades on a hub that stands still, at a speed (rad/s).
pub(crate) struct OnStillHub<'a> {
    pub(crate) blade: &'a TurningBlade,
    pub(crate) wave: Reactionless,
    pub(crate) speed: f64,
    pub(crate) factors: BladeFactors,
}

impl Gyroscopic for OnStillHub<'_> {
    fn degrees_of_freedom(&self) -> usize {
        self.blade.degrees_of_freedom()
    }

    fn count_raised(&mut self, w: f64, raise: Raise) -> usize {
        let own = w + self.wave.shift() * self.speed;
        let added = raise.inertia_of_blade(own, self.speed);
        let at = (own, self.speed);
        let blade = self.blade;
        blade
            .factorize_with_inertia(at, added, &mut self.factors)
            .negative
    }

    fn factorize(&mut self, w: f64) -> usize {
        let own = w + self.wave.shift() * self.speed;
        self.blade
            .factorize(own, self.speed, &mut self.factors)
            .negative
    }

    fn solve(&mut self, x: &mut [Complex]) {
        self.blade.reduce(&mut self.factors, x);
        let still = [Complex::default(); 6];
        self.blade.substitute(&mut self.factors, &still, x);
    }

    fn derivative(&mut self, w: f64, x: &[Complex], out: &mut [Complex]) -> f64 {
        let own = w + self.wave.shift() * self.speed;
        let still = [Complex::default(); 6];
        let motion = (&still, x);
        let (_, mass) = self
            .blade
            .derivative((own, self.speed), motion, &mut self.factors, out);
        mass
    }
}
