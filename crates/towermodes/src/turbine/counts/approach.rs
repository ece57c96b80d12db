//! The approach to one frequency between two counts.
//!
//! A frequency is approached by Rayleigh's quotient: with H(σ) y = H′ x the next estimate is the
//! root nearest to σ of yᴴ H(w) y, which is known without a product, because yᴴ H(σ) y = yᴴ r. Both
//! mode and frequency converge cubically. Each factorization counts, and so tells on which side of
//! σ the frequency lies.
//!
//! Sources: Parlett, *The Symmetric Eigenvalue Problem* (1980), ch. 4, for H linear in w; Wittrick
//! & Williams (1982) for counts in spinning structures.

use super::super::equations::gyroscopic::Gyroscopic;
use super::search::{Found, Guess, POINT, Sample, Search};
use crate::scalar::{Complex, Number, Scalar};

/// Half the width of the final bracket of a frequency, relative to the frequency.
const CLOSE: f64 = 1e-10;
/// A step smaller than this, relative to the frequency, is the last one except for rounding.
const SETTLED: f64 = 1e-6;
/// Number of steps after which bisection has reached any tolerance.
const STEPS: usize = 200;
/// Iterations for modes that share a frequency.
const SHARED_STEPS: usize = 3;

/// The state of the search for one frequency.
#[derive(Clone, Copy)]
struct Approach {
    low: Sample,
    high: Sample,
    /// The estimate, if there is one.
    w: Option<f64>,
    is_settled: bool,
}

impl<G: Gyroscopic + ?Sized> Search<'_, G> {
    /// Finds the mode in a bracket, or all modes with the same frequency; `is_low` decides whether
    /// a count belongs to the lower side.
    pub(super) fn find(
        &mut self,
        low: Sample,
        high: Sample,
        is_low: impl Fn(usize) -> bool,
        guess: Option<&Guess<'_>>,
    ) -> Vec<Found> {
        let mut state = Approach {
            low,
            high,
            w: None,
            is_settled: false,
        };
        let mut sigma = self.begin(&state, guess);
        for _ in 0..STEPS {
            let negative = if state.is_settled {
                self.system.count(sigma)
            } else {
                let (negative, w) = self.step(sigma);
                state.is_settled = (w - sigma).abs() <= SETTLED * sigma;
                state.w = Some(w);
                negative
            };
            let sample = self.record(Sample { w: sigma, negative });
            match is_low(negative) {
                true => state.low = sample,
                false => state.high = sample,
            }
            match state.next() {
                Next::Done => break,
                Next::At(w) => sigma = w,
                Next::Halve => {
                    (state.w, state.is_settled) = (None, false);
                    sigma = 0.5 * (state.low.w + state.high.w);
                    start(&mut self.right);
                }
            }
        }
        self.result(&state)
    }

    /// The first shift; it also prepares the right side.
    fn begin(&mut self, state: &Approach, guess: Option<&Guess<'_>>) -> f64 {
        let middle = 0.5 * (state.low.w + state.high.w);
        let inside = guess.filter(|guess| state.low.w < guess.w && guess.w < state.high.w);
        let sigma = inside.map_or(middle, |guess| guess.w);
        match guess.filter(|guess| guess.vector.len() == self.right.len()) {
            Some(guess) => {
                self.system.derivative(sigma, guess.vector, &mut self.right);
            }
            None => start(&mut self.right),
        }
        sigma
    }

    /// One step of the iteration: the count at the shift, and the next estimate.
    fn step(&mut self, sigma: f64) -> (usize, f64) {
        let negative = self.system.factorize(sigma);
        self.vector.copy_from_slice(&self.right);
        self.system.solve(&mut self.vector);
        let of_h = dot(&self.vector, &self.right);
        let Self {
            system,
            vector,
            right,
            ..
        } = self;
        let mass = system.derivative(sigma, vector, right);
        let slope = dot(vector, right);
        let step = nearest_root(of_h, slope, mass);
        let size = dot(vector, vector).sqrt();
        let scale = if size > 0.0 && size.is_finite() {
            1.0 / size
        } else {
            1.0
        };
        let all = vector.iter_mut().chain(right.iter_mut());
        all.for_each(|entry| *entry = entry.times(scale));
        (negative, sigma + step)
    }

    fn result(&mut self, state: &Approach) -> Vec<Found> {
        let bounds = [state.low, state.high];
        let together = state.high.negative.abs_diff(state.low.negative);
        if together > 1 {
            return self.shared(bounds, together);
        }
        let w = state.w.unwrap_or(0.5 * (state.low.w + state.high.w));
        let vector = self.vector.clone();
        vec![Found { w, bounds, vector }]
    }

    /// Finds modes with the same frequency, by inverse iteration with all of them.
    fn shared(&mut self, bounds: [Sample; 2], count: usize) -> Vec<Found> {
        let w = 0.5 * (bounds[0].w + bounds[1].w);
        self.system.factorize(bounds[0].w.max(0.5 * bounds[1].w));
        let mut vectors: Vec<Vec<Complex>> = Vec::new();
        for place in 0..count {
            start(&mut self.right);
            // Different starting vectors.
            self.right.rotate_left(place * 7 % self.vector.len().max(1));
            for _ in 0..SHARED_STEPS {
                self.vector.copy_from_slice(&self.right);
                self.system.solve(&mut self.vector);
                self.make_orthogonal(w, &vectors);
                self.system.derivative(w, &self.vector, &mut self.right);
            }
            vectors.push(self.vector.clone());
        }
        let all = vectors.into_iter();
        all.map(|vector| Found { w, bounds, vector }).collect()
    }

    /// Removes the components along other vectors, with −H′ as metric, and scales the vector.
    fn make_orthogonal(&mut self, w: f64, others: &[Vec<Complex>]) {
        for other in others {
            self.system.derivative(w, other, &mut self.right);
            let size = dot(other, &self.right);
            let pairs = self.right.iter().zip(&self.vector);
            let along: Complex = pairs.map(|(a, b)| a.conj() * *b).sum();
            let along = along.over(size);
            for (entry, other) in self.vector.iter_mut().zip(other) {
                *entry -= along * *other;
            }
        }
        let scale = 1.0 / dot(&self.vector, &self.vector).sqrt();
        self.vector
            .iter_mut()
            .for_each(|entry| *entry = entry.times(scale));
    }
}

/// The action after a step.
enum Next {
    Done,
    At(f64),
    Halve,
}

impl Approach {
    fn next(&self) -> Next {
        let (low, high) = (self.low.w, self.high.w);
        if high - low <= POINT * high {
            return Next::Done;
        }
        let Some(w) = self.w.filter(|w| low < *w && *w < high) else {
            return Next::Halve;
        };
        let margin = CLOSE * w;
        if w - low > 2.0 * margin {
            Next::At(w - margin)
        } else if high - w > 2.0 * margin {
            Next::At(w + margin)
        } else if self.is_settled {
            Next::Done
        } else {
            Next::At(w)
        }
    }
}

/// The root of yᴴ H(σ + x) y = h + s x − m x² that is nearest to 0.
fn nearest_root(h: f64, slope: f64, mass: f64) -> f64 {
    let square = slope * slope + 4.0 * mass * h;
    if square >= 0.0 {
        -2.0 * h / (slope + slope.signum() * square.sqrt())
    } else {
        -h / slope
    }
}

/// A right side that contains every mode: pseudo-random numbers.
fn start(right: &mut [Complex]) {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    right.fill_with(|| Complex::new(next(), next()));
}

/// The real part of aᴴ b.
fn dot(a: &[Complex], b: &[Complex]) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| a.re * b.re + a.im * b.im)
        .sum()
}
