//! The curve of a mode of a beam: the polynomials of its elements themselves.

use super::sampling::SegmentCurves;
use crate::beam::{Beam, Legendre, motions};
use crate::chain::{Dim, Space};

/// Halvings that locate a turning point: 2⁻²⁶ of an interval, which changes the value there by 2⁻⁵².
const HALVINGS: usize = 26;

/// The curves of one eigenvector of a beam.
#[derive(Debug)]
pub struct BeamCurves<'a, const D: usize> {
    beam: &'a Beam<D>,
    bases: Vec<[f64; D]>,
    /// Strain coefficients, element by element.
    strains: Vec<f64>,
}

impl<'a, const D: usize> BeamCurves<'a, D>
where
    Dim<D>: Space,
{
    /// Those of an eigenvector of a beam.
    pub fn new(beam: &'a Beam<D>, vector: &[f64]) -> Self {
        let (mut bases, mut strains) = (Vec::new(), vector.to_vec());
        motions(beam, vector, &mut bases);
        let own = strains.chunks_exact_mut(beam.coordinates());
        own.enumerate()
            .for_each(|(element, own)| beam.to_strains(element, own));
        Self {
            beam,
            bases,
            strains,
        }
    }

    fn strains(&self, element: usize) -> &[f64] {
        let count = self.beam.coordinates();
        &self.strains[element * count..(element + 1) * count]
    }

    /// The value of largest magnitude of a polynomial on 0 ≤ s ≤ 1, from its value and slope at s: at an end or where the slope changes
    /// sign.
    fn extreme_of(&self, value_and_slope: impl Fn(f64) -> [f64; 2]) -> f64 {
        let intervals = self.beam.coordinates() + 2;
        let larger = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
        let [mut extreme, mut slope_below] = value_and_slope(0.0);
        for k in 1..=intervals {
            let s = |k: usize| k as f64 / intervals as f64;
            let [value, slope] = value_and_slope(s(k));
            extreme = larger(extreme, value);
            if slope * slope_below < 0.0 {
                let turning = turning_value(s(k - 1), s(k), slope_below, &value_and_slope);
                extreme = larger(extreme, turning);
            }
            slope_below = slope;
        }
        extreme
    }
}

/// The value where the slope changes sign between two places, by bisection.
fn turning_value(
    mut low: f64,
    mut high: f64,
    slope_at_low: f64,
    value_and_slope: impl Fn(f64) -> [f64; 2],
) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if value_and_slope(middle)[1] * slope_at_low > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    value_and_slope(low)[0]
}

impl BeamCurves<'_, 2> {
    /// Deflection, rotation of the section and slope at s.
    fn at(&self, element: usize, s: f64) -> [f64; 3] {
        let [deflection, rotation] = self.bases[element];
        let length_m = self.beam.length_m(element);
        let half = 0.5 * length_m;
        let (curvatures, shears) = self.strains(element).split_at(self.beam.bent());
        let (mut bent, mut turned) = (0.0, 0.0);
        for (c, term) in curvatures.iter().zip(Legendre::at(2.0 * s - 1.0)) {
            bent += c * term.second;
            turned += c * term.first;
        }
        let (mut slid, mut shear) = (0.0, 0.0);
        for (d, term) in shears.iter().zip(Legendre::at(2.0 * s - 1.0)) {
            slid += d * term.first;
            shear += d * term.value;
        }
        let turned = rotation + half * turned;
        [
            deflection + s * length_m * rotation + half * (half * bent + slid),
            turned,
            turned + shear,
        ]
    }
}

impl SegmentCurves for BeamCurves<'_, 2> {
    fn motion(&self, element: usize, s: f64) -> [f64; 2] {
        let [deflection, rotation, _] = self.at(element, s);
        [deflection, rotation]
    }

    fn extreme(&self, element: usize) -> f64 {
        self.extreme_of(|s| {
            let [deflection, _, slope] = self.at(element, s);
            [deflection, slope]
        })
    }
}

impl BeamCurves<'_, 1> {
    /// The motion and the strain at s.
    fn at(&self, element: usize, s: f64) -> [f64; 2] {
        let half = 0.5 * self.beam.length_m(element);
        let (mut moved, mut strain) = (0.0, 0.0);
        for (c, term) in self
            .strains(element)
            .iter()
            .zip(Legendre::at(2.0 * s - 1.0))
        {
            moved += c * term.first;
            strain += c * term.value;
        }
        [self.bases[element][0] + half * moved, strain]
    }
}

impl SegmentCurves for BeamCurves<'_, 1> {
    fn motion(&self, element: usize, s: f64) -> [f64; 2] {
        [self.at(element, s)[0], 0.0]
    }

    fn extreme(&self, element: usize) -> f64 {
        self.extreme_of(|s| self.at(element, s))
    }
}
