//! N equal blades as the hub feels them: the sum over the harmonics of multiblade coordinates.
//!
//! The hub moves by phasors of e^(i w t) in axes that do not turn: h₀ along and about the shaft,
//! h₊ = (u₂ + i u₃, θ₂ + i θ₃)/√2 and h₋, the same with −i. A blade at the azimuth ψ feels
//!
//! h(ψ) = P₀ h₀ + P₊ h₊ e^(−iψ) + P₋ h₋ e^(iψ),
//!
//! at the frequencies w, w − Ω and w + Ω of its own frame, and its coordinates follow with the same
//! factors: collective, forward (with the rotation) and backward. For N ≥ 3 the sums over the
//! blades of all other products vanish, so that the harmonics do not couple and the coefficients
//! are constant. Seen from the hub the rotor is
//!
//! H(w) = N Σₙ Vₙᴴ D(wₙ) Vₙ, V± = ½ (1, ∓i)ᵀ (1, ±i) on the axes across the shaft.
//!
//! Blades in further harmonics (n = 2 … N/2) do not move the hub, but vibrate.
//!
//! Source: Coleman & Feingold, NACA TR 1351 (1958), for two degrees of freedom of the blade.

use super::error::RotorError;
use crate::beam::{Condensed, TurningBlade};
use crate::scalar::Complex;
use crate::tower::MOST_BLADES;

/// A body that turns with a rotor, in the frame of the rotor.
pub trait TurningBody {
    /// The body for the motion (translation, rotation) of the apex of the rotor, in (axis of the
    /// rotor, against the rotation, radial), at a frequency in the turning frame and a speed of the
    /// rotor, rad/s: K + Ω² (K_g − S) + 2 i s Ω C − s² M with the body's own coordinates
    /// eliminated.
    fn seen_from_apex(&mut self, frequency: f64, speed: f64) -> Condensed;
}

impl TurningBody for TurningBlade {
    fn seen_from_apex(&mut self, frequency: f64, speed: f64) -> Condensed {
        Self::seen_from_apex(self, frequency, speed)
    }
}

/// Equal bodies at equal angles around the axis of a rotor.
#[derive(Debug, Clone)]
pub struct Multiblade<B> {
    body: B,
    blades: usize,
}

impl<B: TurningBody> Multiblade<B> {
    /// A rotor of this many equal bodies.
    ///
    /// # Errors
    /// [`RotorError`] if there are fewer than three or too many.
    pub fn new(body: B, blades: usize) -> Result<Self, RotorError> {
        match blades {
            0..3 => Err(RotorError::TooFewBlades { blades }),
            _ if blades > MOST_BLADES => Err(RotorError::TooManyBlades { blades }),
            _ => Ok(Self { body, blades }),
        }
    }

    /// One of the bodies.
    pub fn body(&self) -> &B {
        &self.body
    }

    /// Number of bodies.
    pub fn blades(&self) -> usize {
        self.blades
    }

    /// The rotor for the motion (translation, rotation) of its apex, in axes (shaft, left, up) that
    /// do not turn, at a frequency in this frame and a speed, rad/s.
    pub fn seen_from_hub(&mut self, frequency: f64, speed: f64) -> Condensed {
        let mut sum = self.body.seen_from_apex(frequency, speed);
        sum.matrix = collective(&sum.matrix);
        for (harmonic, turned) in [(-1.0, 1.0), (1.0, -1.0)] {
            let whirl = self
                .body
                .seen_from_apex(frequency + harmonic * speed, speed);
            add_whirl(&whirl, turned, &mut sum);
        }
        for entry in sum.matrix.as_flattened_mut() {
            *entry = Complex::new(self.blades as f64 * entry.re, self.blades as f64 * entry.im);
        }
        self.add_reactionless(frequency, speed, &mut sum);
        sum
    }

    /// Counts the modes of the blades that do not move the hub: harmonics n ± up to N/2; that of
    /// N/2 alone has no direction.
    fn add_reactionless(&mut self, frequency: f64, speed: f64, sum: &mut Condensed) {
        for harmonic in 2..=self.blades / 2 {
            let is_alone = 2 * harmonic == self.blades;
            let shift = harmonic as f64 * speed;
            let frequencies = [frequency - shift, frequency + shift];
            let in_own_frame = [frequency];
            let own: &[f64] = if is_alone {
                &in_own_frame
            } else {
                &frequencies
            };
            for frequency in own {
                let blade = self.body.seen_from_apex(*frequency, speed);
                sum.negative += blade.negative;
                sum.log_pivots += blade.log_pivots;
            }
        }
    }
}

/// What the motions along and about the shaft do.
fn collective(matrix: &[[Complex; 6]; 6]) -> [[Complex; 6]; 6] {
    let mut own = [[Complex::default(); 6]; 6];
    for i in [0, 3] {
        for j in [0, 3] {
            own[i][j] = matrix[i][j];
        }
    }
    own
}

/// Adds V± ᴴ D V±; `turned` is +1 for the forward and −1 for the backward whirl.
fn add_whirl(whirl: &Condensed, turned: f64, sum: &mut Condensed) {
    sum.negative += whirl.negative;
    sum.log_pivots += whirl.log_pivots;
    // a = (1, ∓i): V = ½ a āᵀ, so that Vᴴ D V = ¼ a (aᴴ D a) aᴴ.
    let a = [Complex::new(1.0, 0.0), Complex::new(0.0, -turned)];
    let conj = a.map(|a| Complex::new(a.re, -a.im));
    for block_row in [1, 4] {
        for block_column in [1, 4] {
            let mut value = Complex::default();
            for (i, left) in conj.iter().enumerate() {
                for (j, right) in a.iter().enumerate() {
                    value += *left * whirl.matrix[block_row + i][block_column + j] * *right;
                }
            }
            for (i, left) in a.iter().enumerate() {
                for (j, right) in conj.iter().enumerate() {
                    let entry = *left * value * *right;
                    let quarter = Complex::new(0.25 * entry.re, 0.25 * entry.im);
                    sum.matrix[block_row + i][block_column + j] += quarter;
                }
            }
        }
    }
}
