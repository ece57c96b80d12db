//! Motions of the blades of a rotor, harmonic by harmonic: solutions and products at a frequency.
//!
//! Coordinates are those of a blade times √N, so that sums of squares are those of all blades:
//! collective, forward, backward.

use super::multiblade::{Multiblade, SHIFTS, sum_of_harmonics};
use crate::beam::{BladeFactors, Condensed, TurningBlade};
use crate::scalar::{Complex, Number, Scalar};

/// The factors of a blade in each harmonic.
#[derive(Debug, Clone, Default)]
pub struct RotorFactors {
    harmonics: [BladeFactors; 3],
}

/// A motion or a force of the apex in phasors, in the fixed axes (shaft, left, up).
type Phasors = [Complex; 6];

impl Multiblade<TurningBlade> {
    /// Number of coordinates of the blades in the harmonics that move the hub.
    pub fn degrees_of_freedom(&self) -> usize {
        3 * self.body().degrees_of_freedom()
    }

    /// The rotor as [`seen_from_hub`](Self::seen_from_hub) with a M added to the D of each
    /// harmonic, where `added` gives a, rad²/s², for the frequency in the rotating frame.
    pub fn seen_with_inertia(
        &mut self,
        frequency: f64,
        speed: f64,
        added: impl Fn(f64) -> f64,
    ) -> Condensed {
        let blades = self.blades();
        let body = self.body_mut();
        sum_of_harmonics(blades, |_, shift| {
            let own = frequency + shift * speed;
            body.seen_with_inertia(own, speed, added(own))
        })
    }

    /// The rotor as [`seen_from_hub`](Self::seen_from_hub), with its factors.
    pub fn factorize(&self, frequency: f64, speed: f64, factors: &mut RotorFactors) -> Condensed {
        sum_of_harmonics(self.blades(), |harmonic, shift| {
            let work = &mut factors.harmonics[harmonic];
            self.body()
                .factorize(frequency + shift * speed, speed, work)
        })
    }

    /// Eliminates the coordinates from a right side; returns the force on the apex.
    pub fn reduce(&self, factors: &mut RotorFactors, right: &mut [Complex]) -> Phasors {
        let count = self.body().degrees_of_freedom();
        let mut sum = Phasors::default();
        for (harmonic, right) in right.chunks_exact_mut(count).enumerate() {
            let force = self.body().reduce(&mut factors.harmonics[harmonic], right);
            self.add_force(harmonic, &force, &mut sum);
        }
        sum
    }

    /// Computes the coordinates from the motion of the apex, and overwrites a reduced right side
    /// with them.
    pub fn substitute(&self, factors: &mut RotorFactors, apex: &Phasors, own: &mut [Complex]) {
        let count = self.body().degrees_of_freedom();
        for (harmonic, own) in own.chunks_exact_mut(count).enumerate() {
            let felt = self.felt(harmonic, apex);
            self.body()
                .substitute(&mut factors.harmonics[harmonic], &felt, own);
        }
    }

    /// The product of dH/dw with a motion x of the apex and the coordinates, in `out`; returns the
    /// force on the apex and xᴴ M x.
    pub fn derivative(
        &self,
        (frequency, speed): (f64, f64),
        (apex, own): (&Phasors, &[Complex]),
        factors: &mut RotorFactors,
        out: &mut [Complex],
    ) -> (Phasors, f64) {
        let count = self.body().degrees_of_freedom();
        let (mut sum, mut inertia) = (Phasors::default(), 0.0);
        let parts = own.chunks_exact(count).zip(out.chunks_exact_mut(count));
        for (harmonic, (own, out)) in parts.enumerate() {
            let at = (frequency + SHIFTS[harmonic] * speed, speed);
            let felt = self.felt(harmonic, apex);
            let work = &mut factors.harmonics[harmonic];
            let (force, own) = self.body().derivative(at, (&felt, own), work, out);
            self.add_force(harmonic, &force, &mut sum);
            inertia += own;
        }
        (sum, inertia)
    }

    /// √N Vₙ h: the motion of the blade roots in a harmonic due to the motion of the apex, in (axis
    /// of the rotor, against the rotation, radial).
    pub fn felt(&self, harmonic: usize, apex: &Phasors) -> Phasors {
        let root = (self.blades() as f64).sqrt();
        let mut felt = Phasors::default();
        for first in [0, 3] {
            let [along, left, up] = [apex[first], apex[first + 1], apex[first + 2]];
            if harmonic == 0 {
                felt[first] = along.times(root);
            } else {
                // a = (1, ∓i): V = ½ a āᵀ.
                let turned = Complex::new(0.0, SHIFTS[harmonic]);
                let whirl = (left + turned.conj() * up).times(0.5 * root);
                felt[first + 1] = whirl;
                felt[first + 2] = turned * whirl;
            }
        }
        felt
    }

    /// Adds √N Vₙᴴ f.
    fn add_force(&self, harmonic: usize, force: &Phasors, sum: &mut Phasors) {
        let root = (self.blades() as f64).sqrt();
        for first in [0, 3] {
            if harmonic == 0 {
                sum[first] += force[first].times(root);
            } else {
                let turned = Complex::new(0.0, SHIFTS[harmonic]);
                let whirl = force[first + 1] + turned.conj() * force[first + 2];
                let whirl = whirl.times(0.5 * root);
                sum[first + 1] += whirl;
                sum[first + 2] += turned * whirl;
            }
        }
    }
}
