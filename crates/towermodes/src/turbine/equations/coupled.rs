//! The parts of a turbine's equations that are solved separately: the part that moves the tower,
//! and harmonics of the blades that do not move the hub.

use super::gyroscopic::{Gyroscopic, Raise};
use super::machine_vectors::JOINTS;
use super::model::TurbineModel;
use crate::beam::{BladeFactors, TurningBlade};
use crate::rotor::Reactionless;
use crate::scalar::Complex;
use crate::subsystem::Subsystem;

/// Tower, drivetrain and the harmonics of the blades that move the hub, at a speed (rad/s).
///
/// Vectors hold the coordinates of the tower, of the joints, of the blades, and of the frame.
pub(crate) struct Coupled<'a> {
    pub(crate) model: &'a mut TurbineModel,
    pub(crate) speed: f64,
}

/// The parts of a vector.
pub(crate) struct Split<'x> {
    pub(crate) tower: &'x [Complex],
    pub(crate) joints: &'x [Complex],
    pub(crate) blades: &'x [Complex],
    pub(crate) frame: &'x [Complex],
}

impl TurbineModel {
    /// Splits the coordinates into their parts.
    pub(crate) fn split<'x>(&self, x: &'x [Complex]) -> Split<'x> {
        let (tower, rest) = x.split_at(self.tower.members()[0].degrees_of_freedom());
        let (machine, frame) = rest.split_at(self.machine.degrees_of_freedom());
        let (joints, blades) = machine.split_at(JOINTS);
        Split {
            tower,
            joints,
            blades,
            frame,
        }
    }
}

/// The ranges of tower, RNA and frame in a vector.
fn split_mut((tower, machine): (usize, usize), x: &mut [Complex]) -> [&mut [Complex]; 3] {
    let (tower, rest) = x.split_at_mut(tower);
    let (machine, frame) = rest.split_at_mut(machine);
    [tower, machine, frame]
}

impl Gyroscopic for Coupled<'_> {
    fn degrees_of_freedom(&self) -> usize {
        let tower = self.model.tower.members()[0].degrees_of_freedom();
        let below = self.model.below.degrees_of_freedom();
        tower + self.model.machine.degrees_of_freedom() + below
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
            below,
            ..
        } = &mut *self.model;
        let machine = machine.factorize((w, self.speed), *is_locked, factors);
        let below = below.factorize(w);
        let ends = (machine.matrix, below.map(|below| below.stiffness));
        let a = TurbineModel::of_tower(-w * w);
        let negative = tower.members()[0].factorize_between(&a, ends, workspace);
        machine.negative + negative + below.map_or(0, |below| below.count)
    }

    fn solve(&mut self, x: &mut [Complex]) {
        let TurbineModel {
            tower,
            machine,
            is_locked,
            workspace,
            factors,
            below,
            ..
        } = &mut *self.model;
        let tower = &tower.members()[0];
        let sizes = (tower.degrees_of_freedom(), machine.degrees_of_freedom());
        let [of_tower, of_machine, of_below] = split_mut(sizes, x);
        let at_top = machine.reduce(*is_locked, factors, of_machine);
        tower.add_to_base(&below.reduce(of_below), of_tower);
        let top = tower.solve_under(workspace, at_top, of_tower);
        machine.substitute(*is_locked, factors, &top, of_machine);
        below.substitute(&tower.base_motion(of_tower), of_below);
    }

    fn derivative(&mut self, w: f64, x: &[Complex], out: &mut [Complex]) -> f64 {
        let TurbineModel {
            tower,
            machine,
            is_locked,
            workspace,
            factors,
            below,
            ..
        } = &mut *self.model;
        let tower = &tower.members()[0];
        let sizes = (tower.degrees_of_freedom(), machine.degrees_of_freedom());
        let (x, rest) = x.split_at(sizes.0);
        let (of_machine, of_below) = rest.split_at(sizes.1);
        let [out, out_of_machine, out_of_below] = split_mut(sizes, out);
        let (top, mut mass) = tower.begin_derivative(w, x, workspace);
        let at = (w, self.speed, *is_locked);
        let motion = (&top, of_machine);
        let (at_top, of_machine) = machine.derivative(at, motion, factors, out_of_machine);
        mass += of_machine;
        tower.end_derivative(w, at_top, (x, out), workspace);
        let base = tower.base_motion(x);
        let (force, of_below) = below.derivative(w, &base, (of_below, out_of_below));
        tower.add_to_base(&force, out);
        mass + of_below
    }
}

/// A harmonic of the blades on a fixed hub, at a rotor speed (rad/s).
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
