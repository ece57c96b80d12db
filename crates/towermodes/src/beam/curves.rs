//! The curve of a mode of a beam: the polynomials of its elements themselves.

use super::legendre::Legendre;
use super::model::Beam;
use super::product::motions;
use super::strain::Strain;
use crate::space::transform_motion;
use crate::subsystem::{Coordinates, SegmentCurves};
use crate::tower::Motion;

/// Halvings that locate a turning point: 2⁻²⁶ of an interval, which changes the value there by
/// 2⁻⁵².
const HALVINGS: usize = 26;

/// The curves of one eigenvector of a beam.
#[derive(Debug, Clone, Default)]
pub(super) struct BeamCurves {
    /// The motion of every element's base.
    bases: Vec<[f64; 6]>,
    lengths_m: Vec<f64>,
    /// The kinds of strain and the number of coefficients of each.
    deformations: Vec<(Strain, usize)>,
    /// Strain coefficients, element by element.
    strains: Vec<f64>,
    /// Coefficients of an element.
    count: usize,
}

/// A motion and how it changes with height.
struct Rising {
    motion: [f64; 6],
    /// Per metre; of translations and the rotation about z.
    slope: [f64; 6],
}

impl BeamCurves {
    /// Those of an eigenvector of a beam.
    pub(super) fn new<const D: usize>(
        beam: &Beam<D>,
        coordinates: &Coordinates<D>,
        vector: &[f64],
    ) -> Self {
        let mut bases = Vec::new();
        motions(beam, vector, &mut bases);
        let mut strains = vector[beam.base_coordinates()..].to_vec();
        // A beam that does not deform has none.
        let own = strains.chunks_exact_mut(beam.coordinates().max(1));
        own.enumerate()
            .for_each(|(element, own)| beam.to_strains(element, own));
        let deformations = beam.deformations().iter();
        Self {
            bases: bases.iter().map(|base| coordinates.expand(base)).collect(),
            lengths_m: (0..beam.elements()).map(|e| beam.length_m(e)).collect(),
            deformations: deformations.map(|d| (d.strain, d.count)).collect(),
            strains,
            count: beam.coordinates(),
        }
    }

    fn at(&self, element: usize, s: f64) -> Rising {
        let (length_m, base) = (self.lengths_m[element], &self.bases[element]);
        let mut motion = *base;
        transform_motion(&mut motion, s * length_m);
        let mut rising = Rising {
            motion,
            slope: [base[4], -base[3], 0.0, 0.0, 0.0, 0.0],
        };
        let mut strains = &self.strains[element * self.count..(element + 1) * self.count];
        for &(strain, count) in &self.deformations {
            let (own, others) = strains.split_at(count);
            rising.deform(strain, own, s, 0.5 * length_m);
            strains = others;
        }
        rising
    }

    /// The value of largest magnitude of a polynomial on 0 ≤ s ≤ 1, from its value and slope at s:
    /// at an end or where the slope changes sign.
    fn extreme_of(&self, value_and_slope: impl Fn(f64) -> [f64; 2]) -> f64 {
        let degree = self.deformations.iter().map(|(_, count)| count).max();
        let intervals = degree.map_or(1, |degree| degree + 3);
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

impl Rising {
    /// Adds the motion by a strain with these coefficients up to s, on an element of this half
    /// length (m).
    fn deform(&mut self, strain: Strain, coefficients: &[f64], s: f64, half: f64) {
        let [mut value, mut first, mut second] = [0.0; 3];
        for (c, term) in coefficients.iter().zip(Legendre::at(2.0 * s - 1.0)) {
            value += c * term.value;
            first += c * term.first;
            second += c * term.second;
        }
        match strain {
            Strain::Curvature(plane) => {
                let components = Motion::Bending(plane).components();
                let ((w, _), (theta, sign)) = (components[0], components[1]);
                self.motion[w] += half * half * second;
                self.motion[theta] += sign * half * first;
                self.slope[w] += half * first;
            }
            Strain::Shear(plane) => {
                let (w, _) = Motion::Bending(plane).components()[0];
                self.motion[w] += half * first;
                self.slope[w] += value;
            }
            Strain::Twist => {
                self.motion[5] += half * first;
                self.slope[5] += value;
            }
            Strain::Stretch => {
                self.motion[2] += half * first;
                self.slope[2] += value;
            }
        }
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

impl SegmentCurves for BeamCurves {
    fn motion(&self, element: usize, s: f64) -> [f64; 6] {
        self.at(element, s).motion
    }

    fn extreme(&self, element: usize, component: usize) -> f64 {
        self.extreme_of(|s| {
            let rising = self.at(element, s);
            [rising.motion[component], rising.slope[component]]
        })
    }
}
