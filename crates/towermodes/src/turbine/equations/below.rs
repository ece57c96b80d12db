//! What a tower stands on beyond a constant matrix at its base: a frame, or water whose added mass
//! depends on the frequency.

use crate::frame::{FrameBelow, FrameSolveError, ReducedFrame};
use crate::scalar::{Complex, Scalar};
use crate::space::SpatialMatrix;
use crate::tower::{InertiaByFrequency, Tower};

use super::machine_vectors::Phasors;

/// The step, relative to the frequency, from which the slope of the added mass follows.
const STEP: f64 = 1e-7;

/// What is below the base of a tower.
#[derive(Debug, Clone)]
pub(crate) enum Below {
    /// All is in the base itself.
    Nothing,
    /// A frame.
    Frame(Box<FrameBelow>),
    /// Water around a floating platform.
    Water(Box<Water>),
}

/// The added mass of a floating platform, beside that of its base, which is that at infinite
/// frequency.
#[derive(Debug, Clone)]
pub(crate) struct Water {
    by_frequency: InertiaByFrequency,
    infinite: SpatialMatrix,
    /// An inertia of the base that takes the place of that at a frequency.
    pub(crate) fixed: Option<SpatialMatrix>,
}

impl Below {
    /// What a tower stands on, with elements of a degree.
    pub(super) fn new(tower: &Tower, degree: usize) -> Result<Self, FrameSolveError> {
        if let Some(foundation) = tower.frame() {
            let at = (tower.base_m(), tower.gravity_m_per_s2());
            let carried = tower.rigid_inertia(true);
            let frame = FrameBelow::new(foundation, at, &carried, degree)?;
            return Ok(Self::Frame(Box::new(frame)));
        }
        Ok(match tower.inertia_by_frequency() {
            Some(by_frequency) => Self::Water(Box::new(Water {
                by_frequency: by_frequency.clone(),
                infinite: tower.base().inertia,
                fixed: None,
            })),
            None => Self::Nothing,
        })
    }

    /// Number of coordinates.
    pub(super) fn degrees_of_freedom(&self) -> usize {
        match self {
            Self::Frame(frame) => frame.degrees_of_freedom(),
            Self::Nothing | Self::Water(_) => 0,
        }
    }

    /// What the base feels at a frequency (rad/s) with a coefficient of the inertia, −w² in H(w).
    pub(super) fn seen(&mut self, w: f64, inertia: f64) -> Option<ReducedFrame> {
        match self {
            Self::Nothing => None,
            Self::Frame(frame) => Some(frame.seen_from_base(inertia)),
            Self::Water(water) => Some(water.seen(w, inertia)),
        }
    }

    /// The same of H(w), with its factors.
    pub(super) fn factorize(&mut self, w: f64) -> Option<ReducedFrame> {
        match self {
            Self::Nothing => None,
            Self::Frame(frame) => Some(frame.factorize(-w * w)),
            Self::Water(water) => Some(water.seen(w, -w * w)),
        }
    }

    /// Eliminates its coordinates from a right side; returns the force on the base.
    pub(super) fn reduce(&mut self, right: &mut [Complex]) -> Phasors {
        match self {
            Self::Frame(frame) => frame.reduce(right),
            Self::Nothing | Self::Water(_) => Phasors::default(),
        }
    }

    /// Finds its coordinates from the motion of the base.
    pub(super) fn substitute(&mut self, base: &Phasors, right: &mut [Complex]) {
        match self {
            Self::Frame(frame) => frame.substitute(base, right),
            Self::Nothing | Self::Water(_) => {}
        }
    }

    /// out = H′ x for the motion of the base and its coordinates x; returns the force on the base
    /// and xᴴ M x.
    pub(super) fn derivative(
        &mut self,
        w: f64,
        base: &Phasors,
        (x, out): (&[Complex], &mut [Complex]),
    ) -> (Phasors, f64) {
        match self {
            Self::Nothing => (Phasors::default(), 0.0),
            Self::Frame(frame) => {
                let (force, mass) = frame.inertia_times(base, x, out);
                let scaled = |force: Complex| force.times(-2.0 * w);
                out.iter_mut().for_each(|own| *own = scaled(*own));
                (force.map(scaled), mass)
            }
            Self::Water(water) => {
                let (added, slope) = (water.added(w), water.slope(w));
                let of = |matrix: &SpatialMatrix| {
                    matrix.map(|row| row.iter().zip(base).map(|(a, x)| x.times(*a)).sum())
                };
                let (own, change): (Phasors, Phasors) = (of(&added), of(&slope));
                let mass = base.iter().zip(&own).map(|(x, f)| (x.conj() * *f).re).sum();
                let force = |i: usize| own[i].times(-2.0 * w) - change[i].times(w * w);
                (std::array::from_fn(force), mass)
            }
        }
    }

    /// Twice the elastic energies: by component of the motion of the base, and of its own motions.
    pub(crate) fn energies(&mut self, base: &Phasors, x: &[Complex]) -> ([f64; 6], f64) {
        match self {
            Self::Frame(frame) => frame.energies(base, x),
            Self::Nothing | Self::Water(_) => Default::default(),
        }
    }

    /// Coordinates of a vector whose squares are elastic energies.
    pub(crate) fn strains(&self, x: &[Complex]) -> Vec<Complex> {
        match self {
            Self::Frame(frame) => frame.strains(x).collect(),
            Self::Nothing | Self::Water(_) => Vec::new(),
        }
    }

    /// The water, if its added mass depends on the frequency.
    pub(crate) fn water(&mut self) -> Option<&mut Water> {
        match self {
            Self::Water(water) => Some(water),
            Self::Nothing | Self::Frame(_) => None,
        }
    }
}

impl Water {
    fn seen(&self, w: f64, inertia: f64) -> ReducedFrame {
        ReducedFrame {
            stiffness: self.added(w).map(|row| row.map(|entry| inertia * entry)),
            count: 0,
        }
    }

    /// The inertia at a frequency less that at infinite frequency.
    fn added(&self, w: f64) -> SpatialMatrix {
        let all = self.fixed.unwrap_or_else(|| self.by_frequency.at(w.abs()));
        difference(&all, &self.infinite, 1.0)
    }

    fn slope(&self, w: f64) -> SpatialMatrix {
        let step = STEP * w.abs();
        let [from, to] = [w.abs(), w.abs() + step].map(|w| self.by_frequency.at(w));
        difference(&to, &from, 1.0 / step.max(f64::MIN_POSITIVE))
    }

    /// Intervals below a limit (rad/s) in which counts may fall where a mode has positive energy.
    pub(crate) fn doubtful(&self, limit: f64) -> Vec<[f64; 2]> {
        self.by_frequency.not_monotone_below(limit)
    }

    /// Inertias of the base below and above those at all frequencies of an interval.
    pub(crate) fn bounds(&self, interval: [f64; 2]) -> Option<[SpatialMatrix; 2]> {
        self.by_frequency.bounds(interval)
    }
}

/// A factor times a − b.
fn difference(a: &SpatialMatrix, b: &SpatialMatrix, factor: f64) -> SpatialMatrix {
    std::array::from_fn(|i| std::array::from_fn(|j| factor * (a[i][j] - b[i][j])))
}
