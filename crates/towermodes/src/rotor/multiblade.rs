//! N equal blades condensed to the hub: the sum over the harmonics of multiblade coordinates.
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
use crate::scalar::{Complex, Number};
use crate::tower::MOST_BLADES;

/// A body that turns with a rotor, in the frame of the rotor.
pub trait TurningBody {
    /// The body for the motion (translation, rotation) of the apex of the rotor, in (axis of the
    /// rotor, against the rotation, radial), at a frequency in the rotating frame and a speed of
    /// the rotor, rad/s: K + Ω² (K_g − S) + 2 i s Ω C − s² M with the body's own coordinates
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

    /// The same body, for a change of its working memory.
    pub(super) fn body_mut(&mut self) -> &mut B {
        &mut self.body
    }

    /// Number of bodies.
    pub fn blades(&self) -> usize {
        self.blades
    }

    /// The rotor for the motion (translation, rotation) of its apex, in axes (shaft, left, up) that
    /// do not turn, at a frequency in this frame and a speed, rad/s; without harmonics of the
    /// blades that do not move it.
    pub fn seen_from_hub(&mut self, frequency: f64, speed: f64) -> Condensed {
        let body = &mut self.body;
        let blades = self.blades;
        sum_of_harmonics(blades, |_, shift| {
            body.seen_from_apex(frequency + shift * speed, speed)
        })
    }

    /// How many modes of the blades lie below a frequency (rad/s) that do not move the hub.
    pub fn count_reactionless(&mut self, frequency: f64, speed: f64) -> usize {
        let waves = reactionless(self.blades);
        let counts = waves.map(|waves| {
            let own = frequency + waves.shift() * speed;
            self.body.seen_from_apex(own, speed).negative
        });
        counts.sum()
    }
}

/// A harmonic of the blades that does not move the hub, by its periods around the rotor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reactionless {
    /// A wave in the direction of the rotation.
    Forward(usize),
    /// A wave against the direction of the rotation.
    Backward(usize),
    /// Adjacent blades move in opposite directions.
    Alternating(usize),
}

impl Reactionless {
    /// What the frequency in the turning frame is above that in the fixed frame, in units of the
    /// speed of the rotor.
    pub fn shift(self) -> f64 {
        match self {
            Self::Forward(waves) => -(waves as f64),
            Self::Backward(waves) => waves as f64,
            // The wave is fixed to the blades, so its frequency is that of the rotating frame.
            Self::Alternating(_) => 0.0,
        }
    }
}

/// The harmonics n = 2 … N/2 of N blades, which do not move the hub.
pub fn reactionless(blades: usize) -> impl Iterator<Item = Reactionless> {
    (2..=blades / 2).flat_map(move |waves| match 2 * waves == blades {
        true => vec![Reactionless::Alternating(waves)],
        false => vec![Reactionless::Forward(waves), Reactionless::Backward(waves)],
    })
}

/// The shift of the frequency, in rotor speeds, of the harmonics that move the hub: collective,
/// forward, backward.
pub(super) const SHIFTS: [f64; 3] = [0.0, -1.0, 1.0];

/// N Σ Vₙᴴ D Vₙ for the blade's D of each harmonic and shift.
pub(super) fn sum_of_harmonics(
    blades: usize,
    mut blade: impl FnMut(usize, f64) -> Condensed,
) -> Condensed {
    let mut sum = blade(0, SHIFTS[0]);
    sum.matrix = collective(&sum.matrix);
    for harmonic in [1, 2] {
        let whirl = blade(harmonic, SHIFTS[harmonic]);
        add_whirl(&whirl, -SHIFTS[harmonic], &mut sum);
    }
    for entry in sum.matrix.as_flattened_mut() {
        *entry = entry.times(blades as f64);
    }
    sum
}

/// The block of the motions along and about the shaft.
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
