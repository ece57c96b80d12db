//! The sums of derivatives with respect to the input values of a tower.

use super::segments::{At, FlexiblePoint, MassPoint, Segment};
use crate::tower::{NumberPlace, Places, Profile, SoilStiffness, Tower};

/// The sums, and the slopes of the quantities that are linear over a piece.
pub(super) struct Numbers<'a> {
    pub(super) places: Places,
    pub(super) sums: &'a mut [f64],
    /// The derivatives with respect to the borders of the segments.
    pub(super) borders: &'a mut [f64],
    tower: &'a Tower,
    /// The input values of the tower.
    values: &'a [f64],
}

/// Derivatives with respect to the mass, the transverse added mass, the rotary inertia in both
/// planes and about the axis, and the soil springs at a point.
pub(super) struct MassFactors {
    pub(super) mass: f64,
    pub(super) water: f64,
    pub(super) rotary: [f64; 2],
    pub(super) polar: f64,
    pub(super) soil: [f64; SoilStiffness::SPRINGS],
}

/// A quantity that is linear over a piece: its places at the lower and at the upper end.
type Line = [NumberPlace; 2];

impl<'a> Numbers<'a> {
    pub(super) fn new(
        tower: &'a Tower,
        values: &'a [f64],
        sums: &'a mut [f64],
        borders: &'a mut [f64],
    ) -> Self {
        Self {
            places: Places::of(tower),
            sums,
            borders,
            tower,
            values,
        }
    }

    pub(super) fn add(&mut self, place: NumberPlace, value: f64) {
        self.sums[place] += value;
    }

    /// Adds factor v vᵀ to the derivatives of a matrix.
    pub(super) fn add_square(&mut self, first: NumberPlace, factor: f64, motion: &[f64; 6]) {
        for (row, v) in motion.iter().enumerate() {
            for (column, w) in motion.iter().enumerate() {
                self.sums[first + 6 * row + column] += factor * v * w;
            }
        }
    }

    /// Adds the derivative with respect to a line at a point; returns that with respect to the
    /// point's height.
    fn add_line(&mut self, [base, top]: Line, at: &At, value: f64) -> f64 {
        self.sums[base] += (1.0 - at.of_piece) * value;
        self.sums[top] += at.of_piece * value;
        value * (self.values[top] - self.values[base])
    }

    /// Adds the factors of the flexibilities at a point.
    pub(super) fn add_flexible(
        &mut self,
        segment: &Segment,
        index: usize,
        point: &FlexiblePoint,
        factors: &[f64; 6],
    ) {
        let at = &point.at;
        let first = self.places.profile(segment.piece);
        let mut by_rise = 0.0;
        match self.tower.pieces()[segment.piece].profile {
            Profile::Tube { .. } => {
                let [a, b, axial, torsion, c, d] = factors;
                let four = [a + b, *axial, *torsion, c + d];
                let by = |slopes: &[f64; 4]| -> f64 {
                    four.iter().zip(slopes).map(|(f, s)| f * s).sum::<f64>() * at.weight_m
                };
                let [diameter, wall, e, g, kappa] = point.slopes.each_ref().map(by);
                by_rise += self.add_line([first, first + 2], at, diameter);
                by_rise += self.add_line([first + 1, first + 3], at, wall);
                for (place, value) in [(4, e), (5, g), (7, kappa)] {
                    self.sums[first + place] += value;
                }
            }
            Profile::Table { .. } => {
                // In the order of the table: EI, EI, GJ, EA, κGA, κGA.
                for (place, own) in [0, 1, 3, 2, 4, 5].into_iter().enumerate() {
                    let flexibility = point.flexibilities[own];
                    if flexibility == 0.0 {
                        continue;
                    }
                    let value = -factors[own] * flexibility * flexibility * at.weight_m;
                    let line = [first + 4 + place, first + 14 + place];
                    by_rise += self.add_line(line, at, value);
                }
            }
        }
        self.add_rise(segment, index, at, by_rise);
    }

    /// Adds the factors of the masses and the soil at a point.
    pub(super) fn add_masses(
        &mut self,
        segment: &Segment,
        index: usize,
        point: &MassPoint,
        factors: &MassFactors,
    ) {
        let at = &point.at;
        let first = self.places.profile(segment.piece);
        let [soil, water] = [
            self.places.soil(segment.piece),
            self.places.water(segment.piece),
        ];
        let weight = at.weight_m;
        let [fore_aft, side_side] = factors.rotary;
        let mut by_rise = 0.0;
        match self.tower.pieces()[segment.piece].profile {
            Profile::Tube { .. } => {
                let rotary = fore_aft + side_side + 2.0 * factors.polar;
                let three = [factors.mass, factors.water, rotary];
                let by = |slopes: &[f64; 3]| -> f64 {
                    three.iter().zip(slopes).map(|(f, s)| f * s).sum::<f64>() * weight
                };
                let [diameter, wall, density, outside, inside] = point.slopes.each_ref().map(by);
                by_rise += self.add_line([first, first + 2], at, diameter);
                by_rise += self.add_line([first + 1, first + 3], at, wall);
                self.sums[first + 6] += density;
                self.sums[water + 2] += outside;
                self.sums[water + 3] += inside;
            }
            Profile::Table { .. } => {
                let masses = &point.masses;
                let (mass, rotary) = (masses.mass_kg_per_m, masses.rotary_inertia_kg_m);
                let radii = [
                    rotary.fore_aft / mass,
                    rotary.side_side / mass,
                    masses.polar_inertia_kg_m / mass,
                ];
                let inertias = [fore_aft, side_side, factors.polar];
                let of_inertias = inertias.iter().zip(radii).map(|(f, r)| f * r);
                let of_mass = factors.mass + of_inertias.sum::<f64>();
                by_rise += self.add_line([first, first + 10], at, of_mass * weight);
                for (row, factor) in inertias.iter().enumerate() {
                    let line = [first + 1 + row, first + 11 + row];
                    by_rise += self.add_line(line, at, factor * mass * weight);
                }
            }
        }
        by_rise += self.add_line([water, water + 1], at, factors.water * weight);
        if self.tower.pieces()[segment.piece]
            .environment
            .soil
            .is_some()
        {
            for (spring, factor) in factors.soil.iter().enumerate() {
                let line = [soil + spring, soil + SoilStiffness::SPRINGS + spring];
                by_rise += self.add_line(line, at, factor * weight);
            }
        }
        self.add_rise(segment, index, at, by_rise);
    }

    /// Adds the effect of a point that moves within its piece, because its section changes.
    fn add_rise(&mut self, segment: &Segment, index: usize, at: &At, by_rise: f64) {
        if segment.is_in_proportion {
            return;
        }
        let by_height = by_rise / self.tower.pieces()[segment.piece].length_m();
        self.borders[index] += (1.0 - at.of_segment) * by_height;
        self.borders[index + 1] += at.of_segment * by_height;
        let [base, top] = [segment.piece, segment.piece + 1].map(|b| self.places.border(b));
        self.sums[base] -= (1.0 - at.of_piece) * by_height;
        self.sums[top] -= at.of_piece * by_height;
    }

    /// Adds the derivatives with respect to the length of a segment to those with respect to its
    /// borders.
    pub(super) fn add_length(&mut self, index: usize, by_length: f64) {
        self.borders[index] -= by_length;
        self.borders[index + 1] += by_length;
    }
}
