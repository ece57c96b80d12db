//! The inertia of rotor and generator that acts on the nacelle about the shaft.
//!
//! The nacelle rolls about the shaft at the rate n. The rotor rotates at the rate x relative to it,
//! and the generator q times as fast:
//!
//! ```text
//! 2 T = J_r (n + x)² + J_g (n + q x)²
//! ```
//!
//! A locked rotor has x = 0, so both inertias count once, whatever the ratio: 2 T = (J_r + J_g) n².
//! The factor q² belongs to the generator's own degree of freedom x and not to the roll of the
//! nacelle; in ElastoDyn the angular velocity of the generator is that of the nacelle for every
//! other degree of freedom (`PAngVelEG` in `ElastoDyn.f90`, OpenFAST 5.0).
//!
//! On a free rotor no torque acts, so ∂T/∂x = 0: x = −n (J_r + q J_g)/(J_r + q² J_g). With this x,
//!
//! ```text
//! 2 T = n² J_r J_g (1 − q)²/(J_r + q² J_g)
//! ```
//!
//! For a gearbox that reverses the direction of rotation q is negative.

use towermodes::RigidBody;

use super::super::main_input::main_file::MainFile;
use crate::input::RotorLock;

/// A rotor is not balanced if its centre of mass or principal axis is farther off its shaft than
/// this, as a fraction of its size.
const BALANCED: f64 = 1e-6;

/// Inertias about the shaft, kg m².
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Shaft {
    /// Inertia of hub, blades and tip masses, J_r.
    pub(crate) rotor: f64,
    /// Inertia of the generator about its own, high-speed shaft, J_g.
    pub(crate) generator: f64,
    /// Ratio of generator speed to rotor speed, q.
    pub(crate) ratio: f64,
}

impl Shaft {
    /// The shaft of a model whose rotor is this body, with the shaft along the x axis.
    pub(crate) fn of(main: &MainFile, rotor: &RigidBody) -> Self {
        Self {
            rotor: rotor.tensor_about([0.0; 3])[0][0],
            generator: main.generator_inertia_kg_m2,
            ratio: main.gearbox_ratio,
        }
    }

    /// The inertia that acts against a roll of the nacelle, kg m².
    pub(super) fn felt_by_nacelle(&self, lock: RotorLock) -> f64 {
        let Self {
            rotor,
            generator,
            ratio,
        } = *self;
        match lock {
            RotorLock::Locked => rotor + generator,
            // Nothing joins them: the generator stays with the nacelle.
            RotorLock::Free if ratio == 0.0 => generator,
            RotorLock::Free if generator == 0.0 => 0.0,
            RotorLock::Free => {
                let slip = 1.0 - ratio;
                rotor * generator * slip * slip / (rotor + generator * ratio * ratio)
            }
        }
    }
}

/// Whether a rotor can rotate about its shaft, the x axis, without moving anything else.
pub(super) fn is_balanced(rotor: &RigidBody, radius_m: f64) -> bool {
    let [_, y, z] = rotor.center_m;
    let tensor = rotor.tensor_about([0.0; 3]);
    y.hypot(z) <= BALANCED * radius_m
        && tensor[0][1].hypot(tensor[0][2]) <= BALANCED * tensor[0][0].abs()
}

#[cfg(test)]
mod tests {
    use towermodes::RigidBody;

    use super::{Shaft, is_balanced};
    use crate::input::RotorLock::{Free, Locked};

    fn shaft(rotor: f64, generator: f64, ratio: f64) -> Shaft {
        Shaft {
            rotor,
            generator,
            ratio,
        }
    }

    /// 3.8e7 + 534 kg m², and with q = 97 by hand: 3.8e7 · 534 · 96²/(3.8e7 + 534 · 9409) =
    /// 1.87011e14/4.3024406e7.
    #[test]
    fn a_locked_generator_counts_once_and_a_free_one_by_the_formula() {
        let machine = shaft(3.8e7, 534.0, 97.0);
        assert_eq!(machine.felt_by_nacelle(Locked), 38_000_534.0);
        let by_hand = 3.8e7 * 534.0 * 9216.0 / 43_024_406.0;
        assert!((machine.felt_by_nacelle(Free) / by_hand - 1.0).abs() < 1e-15);
        assert!((by_hand - 4_346_628.0).abs() < 1.0, "{by_hand}");
        // The other way round: (1 + 97)² = 9604.
        let reversed = shaft(3.8e7, 534.0, -97.0).felt_by_nacelle(Free);
        assert!((reversed / by_hand - 9604.0 / 9216.0).abs() < 1e-15);
    }

    /// The minimum of the kinetic energy over the rate x of the shaft, found by a search, equals
    /// the value of the formula.
    #[test]
    fn a_free_rotor_turns_so_that_the_energy_is_least() {
        for (rotor, generator, ratio) in [(3.8e7, 534.0, 97.0), (50.0, 2.0, 3.0), (9.0, 4.0, -2.0)]
        {
            let twice_energy =
                |x: f64| rotor * (1.0 + x).powi(2) + generator * (1.0 + ratio * x).powi(2);
            let (mut low, mut high) = (-2.0, 2.0);
            for _ in 0..200 {
                let third = (high - low) / 3.0;
                if twice_energy(low + third) < twice_energy(high - third) {
                    high -= third;
                } else {
                    low += third;
                }
            }
            let least = twice_energy(0.5 * (low + high));
            let felt = shaft(rotor, generator, ratio).felt_by_nacelle(Free);
            assert!((felt / least - 1.0).abs() < 1e-9, "{felt} {least}");
        }
    }

    #[test]
    fn without_a_gearbox_or_a_generator_nothing_holds_a_free_rotor() {
        assert_eq!(shaft(10.0, 3.0, 1.0).felt_by_nacelle(Free), 0.0);
        assert_eq!(shaft(10.0, 0.0, 97.0).felt_by_nacelle(Free), 0.0);
        assert_eq!(shaft(0.0, 0.0, 0.0).felt_by_nacelle(Free), 0.0);
        assert_eq!(shaft(10.0, 3.0, 0.0).felt_by_nacelle(Free), 3.0);
    }

    #[test]
    fn a_rotor_is_balanced_about_x_alone() {
        let blade = |y: f64, z: f64| RigidBody::point(100.0, [0.5, y, z]);
        let pair = [blade(0.0, 10.0), blade(0.0, -10.0)];
        assert!(is_balanced(&RigidBody::combined(&pair), 10.0));
        assert!(!is_balanced(&pair[0], 10.0));
        // One blade of a pair coned further than the other.
        let mut skewed = pair;
        skewed[1].center_m[0] = 0.6;
        assert!(!is_balanced(&RigidBody::combined(&skewed), 10.0));
    }
}
