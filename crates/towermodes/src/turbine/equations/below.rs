//! The support of a tower, if it is not a constant matrix at its base: a frame, or water whose
//! added mass depends on the frequency.

use crate::frame::{FrameBelow, FrameSolveError, ReducedFrame};
use crate::scalar::{Complex, Number, Scalar};
use crate::space::{SpatialMatrix, add_scaled};
use crate::tower::{InertiaByFrequency, Tower};

use super::machine_vectors::Phasors;

/// Relative step of the frequency for the slope of the added mass.
const STEP: f64 = 1e-7;

/// The frame or water below the base of a tower, in addition to the constant matrix of the base.
#[derive(Debug, Clone)]
pub(crate) struct Below {
    frame: Option<Box<FrameBelow>>,
    /// Water around a floating platform, or a frame that floats.
    water: Option<Box<Water>>,
}

/// The added mass of a floating platform, relative to that at infinite frequency, which is in the
/// matrix of the base.
#[derive(Debug, Clone)]
pub(crate) struct Water {
    by_frequency: InertiaByFrequency,
    infinite: SpatialMatrix,
    /// If given, an inertia of the base that replaces that at the frequency.
    pub(crate) fixed: Option<SpatialMatrix>,
}

impl Below {
    /// The support of a tower, with elements of this degree.
    pub(super) fn new(tower: &Tower, degree: usize) -> Result<Self, FrameSolveError> {
        let frame = tower.frame().map(|foundation| {
            let at = (tower.base_m(), tower.gravity_m_per_s2());
            let carried = tower.rigid_inertia(true);
            FrameBelow::new(foundation, at, &carried, degree).map(Box::new)
        });
        let water = tower.inertia_by_frequency().map(|by_frequency| Water {
            by_frequency: by_frequency.clone(),
            infinite: tower.base().inertia,
            fixed: None,
        });
        Ok(Self {
            frame: frame.transpose()?,
            water: water.map(Box::new),
        })
    }

    /// Number of coordinates.
    pub(super) fn degrees_of_freedom(&self) -> usize {
        let frame = self.frame.as_ref();
        frame.map_or(0, |frame| frame.degrees_of_freedom())
    }

    /// The matrix at the base at a frequency (rad/s) with a coefficient of the inertia, −w² in
    /// H(w).
    pub(super) fn seen(&mut self, w: f64, inertia: f64) -> Option<ReducedFrame> {
        let frame = self.frame.as_mut();
        let of_frame = frame.map(|frame| frame.seen_from_base(inertia));
        self.with_water(of_frame, (w, inertia))
    }

    /// The matrix at the base for H(w), with its factors.
    pub(super) fn factorize(&mut self, w: f64) -> Option<ReducedFrame> {
        let frame = self.frame.as_mut();
        let of_frame = frame.map(|frame| frame.factorize(-w * w));
        self.with_water(of_frame, (w, -w * w))
    }

    /// A frame with the water around it.
    fn with_water(
        &self,
        of_frame: Option<ReducedFrame>,
        (w, inertia): (f64, f64),
    ) -> Option<ReducedFrame> {
        let Some(water) = &self.water else {
            return of_frame;
        };
        let mut seen = of_frame.unwrap_or(ReducedFrame {
            stiffness: SpatialMatrix::default(),
            count: 0,
        });
        add_scaled(&mut seen.stiffness, inertia, &water.added(w));
        Some(seen)
    }

    /// Eliminates its coordinates from a right side; returns the force on the base.
    pub(super) fn reduce(&mut self, right: &mut [Complex]) -> Phasors {
        let frame = self.frame.as_mut();
        frame.map_or_else(Phasors::default, |frame| frame.reduce(right))
    }

    /// Computes its coordinates from the motion of the base.
    pub(super) fn substitute(&mut self, base: &Phasors, right: &mut [Complex]) {
        if let Some(frame) = &mut self.frame {
            frame.substitute(base, right);
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
        let (mut force, mut mass) = (Phasors::default(), 0.0);
        if let Some(frame) = &mut self.frame {
            let scaled = |force: Complex| force.times(-2.0 * w);
            let (of_frame, own) = frame.inertia_times(base, x, out);
            out.iter_mut().for_each(|own| *own = scaled(*own));
            (force, mass) = (of_frame.map(scaled), own);
        }
        if let Some(water) = &self.water {
            let (of_water, own) = water.derivative(w, base);
            force
                .iter_mut()
                .zip(of_water)
                .for_each(|(sum, own)| *sum += own);
            mass += own;
        }
        (force, mass)
    }

    /// Twice the elastic energies: by component of the motion of the base, and of local motions.
    pub(crate) fn energies(&mut self, base: &Phasors, x: &[Complex]) -> ([f64; 6], f64) {
        let frame = self.frame.as_mut();
        frame.map_or_else(Default::default, |frame| frame.energies(base, x))
    }

    /// Coordinates of a vector whose squares are elastic energies.
    pub(crate) fn strains(&self, x: &[Complex]) -> Vec<Complex> {
        let frame = self.frame.iter();
        frame.flat_map(|frame| frame.strains(x)).collect()
    }

    /// The inertia of a frame for motions of the base that it follows as a rigid body, without the
    /// part in the matrix of the base: kg, kg m, kg m².
    pub(super) fn rigid_inertia(&mut self) -> SpatialMatrix {
        let frame = self.frame.as_mut();
        frame.map_or_else(SpatialMatrix::default, |frame| frame.rigid_inertia())
    }

    /// The water, if its added mass depends on the frequency.
    pub(crate) fn water(&mut self) -> Option<&mut Water> {
        self.water.as_deref_mut()
    }
}

impl Water {
    /// The force H′ x on the base for its motion x, and xᴴ M x.
    fn derivative(&self, w: f64, base: &Phasors) -> (Phasors, f64) {
        let (added, slope) = (self.added(w), self.slope(w));
        let of = |matrix: &SpatialMatrix| {
            matrix.map(|row| row.iter().zip(base).map(|(a, x)| x.times(*a)).sum())
        };
        let (own, change): (Phasors, Phasors) = (of(&added), of(&slope));
        let mass = base.iter().zip(&own).map(|(x, f)| (x.conj() * *f).re).sum();
        let force = |i: usize| own[i].times(-2.0 * w) - change[i].times(w * w);
        (std::array::from_fn(force), mass)
    }

    /// The inertia at a frequency minus that at infinite frequency.
    fn added(&self, w: f64) -> SpatialMatrix {
        let all = self.fixed.unwrap_or_else(|| self.by_frequency.at(w.abs()));
        difference(&all, &self.infinite, 1.0)
    }

    fn slope(&self, w: f64) -> SpatialMatrix {
        let step = STEP * w.abs();
        let [from, to] = [w.abs(), w.abs() + step].map(|w| self.by_frequency.at(w));
        difference(&to, &from, 1.0 / step.max(f64::MIN_POSITIVE))
    }

    /// Intervals below a limit (rad/s) in which counts may decrease at a mode of positive energy.
    pub(crate) fn doubtful(&self, limit: f64) -> Vec<[f64; 2]> {
        self.by_frequency.not_monotone_below(limit)
    }

    /// Lower and upper bound of the inertias of the base at all frequencies of an interval.
    pub(crate) fn bounds(&self, interval: [f64; 2]) -> Option<[SpatialMatrix; 2]> {
        self.by_frequency.bounds(interval)
    }
}

/// A factor times a − b.
fn difference(a: &SpatialMatrix, b: &SpatialMatrix, factor: f64) -> SpatialMatrix {
    std::array::from_fn(|i| std::array::from_fn(|j| factor * (a[i][j] - b[i][j])))
}
