//! Motions of nacelle, drivetrain and rotor: solutions and products at a frequency.

use super::machine::{ABOUT_SHAFT, ABOUT_TOWER, Machine, MachineFactors};
use crate::scalar::{Complex, Number, Scalar};
use crate::space::SpatialMatrix;

/// A motion or a force in phasors.
pub(crate) type Phasors = [Complex; 6];

/// Number of coordinates of the joints: yaw of the nacelle, rotation of the generator relative to
/// it at the low-speed shaft, and twist of the shaft; zero for missing ones.
pub(crate) const JOINTS: usize = 3;
const YAW: usize = 0;
const GENERATOR: usize = 1;
const TWIST: usize = 2;
/// Index of the first coordinate of a joint in its matrix.
const FIRST: usize = 6;

impl Machine {
    /// Number of its coordinates: those of the joints, then those of the blades.
    pub(crate) fn degrees_of_freedom(&self) -> usize {
        JOINTS + self.rotor.degrees_of_freedom()
    }

    /// The joints of the shaft in the order of their indices.
    fn of_shaft(&self, is_locked: bool) -> impl Iterator<Item = usize> {
        let joints = [(GENERATOR, !is_locked), (TWIST, self.twists())].into_iter();
        joints
            .filter(|(_, is_there)| *is_there)
            .map(|(joint, _)| joint)
    }

    /// Eliminates the coordinates from a right side; returns the force on the tower top.
    pub(crate) fn reduce(
        &self,
        is_locked: bool,
        factors: &mut MachineFactors,
        right: &mut [Complex],
    ) -> Phasors {
        let (joints, blades) = right.split_at_mut(JOINTS);
        let at_apex = self.rotor.reduce(&mut factors.rotor, blades);
        let mut of_shaft = bordered(&at_apex);
        for (place, joint) in (FIRST..).zip(self.of_shaft(is_locked)) {
            of_shaft[place] = joints[joint] + at_apex[ABOUT_SHAFT];
        }
        factors.joints[0].reduce(&mut of_shaft);
        for (place, joint) in (FIRST..).zip(self.of_shaft(is_locked)) {
            joints[joint] = of_shaft[place];
        }
        let at_nacelle = transposed_times(&self.to_apex, &of_shaft);
        let mut of_yaw = bordered(&at_nacelle);
        of_yaw[FIRST] = joints[YAW] + at_nacelle[ABOUT_TOWER];
        factors.joints[1].reduce(&mut of_yaw);
        joints[YAW] = of_yaw[FIRST];
        std::array::from_fn(|i| of_yaw[i])
    }

    /// Computes the coordinates from the motion of the tower top; they replace a reduced right
    /// side.
    pub(super) fn substitute(
        &self,
        is_locked: bool,
        factors: &mut MachineFactors,
        top: &Phasors,
        own: &mut [Complex],
    ) {
        let (joints, blades) = own.split_at_mut(JOINTS);
        let reduced = [joints[YAW], joints[GENERATOR], joints[TWIST]];
        joints.fill(Complex::default());
        if self.yaws() {
            let mut of_yaw = bordered(top);
            of_yaw[FIRST] = reduced[YAW];
            factors.joints[1].substitute(&mut of_yaw);
            joints[YAW] = of_yaw[FIRST];
        }
        let mut of_shaft = bordered(&self.shaft_motion(top, joints[YAW]));
        for (place, joint) in (FIRST..).zip(self.of_shaft(is_locked)) {
            of_shaft[place] = reduced[joint];
        }
        factors.joints[0].substitute(&mut of_shaft);
        for (place, joint) in (FIRST..).zip(self.of_shaft(is_locked)) {
            joints[joint] = of_shaft[place];
        }
        let apex = self.apex_motion(top, joints);
        self.rotor.substitute(&mut factors.rotor, &apex, blades);
    }

    /// The product of dH/dw with a motion x of the tower top and the coordinates, in `out`; returns
    /// the force on the top and xᴴ M x.
    pub(crate) fn derivative(
        &self,
        (w, speed, is_locked): (f64, f64, bool),
        (top, own): (&Phasors, &[Complex]),
        factors: &mut MachineFactors,
        out: &mut [Complex],
    ) -> (Phasors, f64) {
        let (joints, blades) = own.split_at(JOINTS);
        let (out, of_blades) = out.split_at_mut(JOINTS);
        out.fill(Complex::default());
        let apex = self.apex_motion(top, joints);
        let at = (w, speed);
        let rotor = (&apex, blades);
        let (mut force, mut mass) = self
            .rotor
            .derivative(at, rotor, &mut factors.rotor, of_blades);
        let mut add = |inertia: &SpatialMatrix, motion: &Phasors, force: &mut Phasors| {
            let own = times(inertia, motion);
            mass += dot(motion, &own);
            add_to(force, &own.map(|f| f.times(-2.0 * w)));
        };
        add(&self.hub, &apex, &mut force);
        let spin = self.spin(speed);
        force[4] += Complex::new(-spin * apex[5].im, spin * apex[5].re);
        force[5] -= Complex::new(-spin * apex[4].im, spin * apex[4].re);
        for joint in self.of_shaft(is_locked) {
            out[joint] = force[ABOUT_SHAFT];
        }
        // The generator turns by θ + q g.
        let mut at_shaft = force;
        let nacelle = self.nacelle_motion(top, joints[YAW]);
        let about_shaft = self.shaft_motion(top, joints[YAW])[ABOUT_SHAFT];
        let turned = about_shaft + joints[GENERATOR].times(self.gear_ratio);
        let momentum = turned.times(self.generator_inertia);
        let of_generator = (turned.conj() * momentum).re;
        at_shaft[ABOUT_SHAFT] += momentum.times(-2.0 * w);
        if !is_locked {
            out[GENERATOR] += momentum.times(-2.0 * w * self.gear_ratio);
        }
        let mut force = transposed_times(&self.to_apex, &at_shaft);
        add(&self.nacelle, &nacelle, &mut force);
        if self.yaws() {
            out[YAW] = force[ABOUT_TOWER];
        }
        add(&self.bearing, top, &mut force);
        (force, mass + of_generator)
    }

    /// The motion of the nacelle at the tower top.
    fn nacelle_motion(&self, top: &Phasors, yaw: Complex) -> Phasors {
        let mut nacelle = *top;
        nacelle[ABOUT_TOWER] += yaw;
        nacelle
    }

    /// The motion of the nacelle at the apex, in the axes of the shaft.
    pub(super) fn shaft_motion(&self, top: &Phasors, yaw: Complex) -> Phasors {
        times(&self.to_apex, &self.nacelle_motion(top, yaw))
    }

    /// The motion of the apex of the rotor, in the axes of the shaft.
    pub(crate) fn apex_motion(&self, top: &Phasors, joints: &[Complex]) -> Phasors {
        let mut apex = self.shaft_motion(top, joints[YAW]);
        apex[ABOUT_SHAFT] += joints[GENERATOR] + joints[TWIST];
        apex
    }

    /// The motion of the nacelle at the apex, in the axes of the tower.
    pub(crate) fn nacelle_at_apex(&self, top: &Phasors, joints: &[Complex]) -> Phasors {
        let of_shaft = self.shaft_motion(top, joints[YAW]);
        // The axes of the shaft are the rotations in `to_apex`.
        std::array::from_fn(|i| {
            let of = &of_shaft[i / 3 * 3..];
            (0..3).map(|k| of[k].times(self.to_apex[k][i % 3])).sum()
        })
    }

    /// Square roots of twice the elastic energies of yaw drive and shaft.
    pub(crate) fn springs(&self, joints: &[Complex]) -> [Complex; 2] {
        let scaled = |stiffness: f64, x: Complex| match stiffness.is_infinite() {
            true => Complex::default(),
            false => x.times(stiffness.sqrt()),
        };
        [
            scaled(self.yaw, joints[YAW]),
            scaled(self.shaft, joints[TWIST]),
        ]
    }
}

fn bordered(own: &Phasors) -> [Complex; 8] {
    std::array::from_fn(|i| own.get(i).copied().unwrap_or_default())
}

fn times(matrix: &SpatialMatrix, x: &Phasors) -> Phasors {
    matrix.map(|row| row.iter().zip(x).map(|(a, x)| x.times(*a)).sum())
}

fn transposed_times(matrix: &SpatialMatrix, x: &[Complex]) -> Phasors {
    std::array::from_fn(|i| (0..6).map(|k| x[k].times(matrix[k][i])).sum())
}

fn add_to(sum: &mut Phasors, addend: &Phasors) {
    for (sum, addend) in sum.iter_mut().zip(addend) {
        *sum += *addend;
    }
}

fn dot(a: &Phasors, b: &Phasors) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a.conj() * *b).re).sum()
}
