//! A line in space: the forces on its ends and their stiffness.

use std::array::from_fn;

use super::cable::{Cable, Profile};
use super::description::{LineType, MooringDescription, MooringLine};
use super::vector::{Matrix3, Vector, difference};

/// Heights above the seabed below this fraction of the depth are treated as on the seabed.
const ON_SEABED: f64 = 1e-9;

/// A line with its weight in water.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rope {
    cable: Cable,
    /// +1, or −1 for a line lighter than water: the mirror image of a heavy one, without seabed.
    up: f64,
    depth_m: f64,
}

/// The forces and the stiffness of a line between two points.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hung {
    /// The force of the line on each end, N.
    pub(super) forces_n: [Vector; 2],
    /// The stiffness −∂F_i/∂u_j of the ends, N/m.
    pub(super) stiffness: [[Matrix3; 2]; 2],
    /// Its shape.
    pub(super) profile: Profile,
}

impl Rope {
    pub(super) fn new(line: &MooringLine, kind: &LineType, mooring: &MooringDescription) -> Self {
        let displaced_kg_per_m = mooring.water_density_kg_per_m3 * kind.area_m2();
        let w = (kind.mass_kg_per_m - displaced_kg_per_m) * mooring.gravity_m_per_s2;
        Self {
            cable: Cable {
                weight_n_per_m: w.abs(),
                axial_stiffness_n: kind.axial_stiffness_n,
                length_m: line.length_m,
                seabed_friction: kind.seabed_friction,
            },
            up: if w < 0.0 { -1.0 } else { 1.0 },
            depth_m: mooring.depth_m,
        }
    }

    /// The line between two positions; none if there is no tension in double precision.
    pub(super) fn between(&self, ends_m: [Vector; 2]) -> Option<Hung> {
        let [z_0, z_1] = ends_m.map(|end| self.up * end[2]);
        let (lower, upper) = if z_0 <= z_1 { (0, 1) } else { (1, 0) };
        let chord = difference(ends_m[upper], ends_m[lower]);
        let span_m = chord[0].hypot(chord[1]);
        let profile = self.cable.profile(
            span_m,
            (z_1 - z_0).abs(),
            self.clearance_m(ends_m[lower][2]),
        )?;
        let along = if span_m > 0.0 {
            [chord[0] / span_m, chord[1] / span_m]
        } else {
            [1.0, 0.0]
        };
        let mut hung = Hung {
            forces_n: [[0.0; 3]; 2],
            stiffness: [[[[0.0; 3]; 3]; 2]; 2],
            profile,
        };
        // The ends in the order of the profile: the index of the end of the line, and the sign of
        // the span.
        let ends = [(lower, -1.0), (upper, 1.0)];
        let pulls = [
            (profile.lower_horizontal_n, profile.lower_n),
            (-profile.horizontal_n, profile.upper_n),
        ];
        for (row, &(i, sign_i)) in ends.iter().enumerate() {
            let (horizontal_n, down_n) = pulls[row];
            hung.forces_n[i] = [
                horizontal_n * along[0],
                horizontal_n * along[1],
                0.0 - self.up * down_n,
            ];
            for (column, &(j, sign_j)) in ends.iter().enumerate() {
                let signs = [sign_i, sign_j];
                hung.stiffness[i][j] = self.block(&profile, along, [row, column], signs);
            }
        }
        Some(hung)
    }

    /// At least `count` places along the line between two positions, from the first to the second;
    /// these two where no number is its tension.
    pub(super) fn places(&self, ends_m: [Vector; 2], count: usize) -> Vec<Vector> {
        let Some(hung) = self.between(ends_m) else {
            return ends_m.to_vec();
        };
        let is_rising = self.up * ends_m[0][2] <= self.up * ends_m[1][2];
        let [lower, upper] = if is_rising {
            ends_m
        } else {
            [ends_m[1], ends_m[0]]
        };
        let chord = difference(upper, lower);
        let span_m = chord[0].hypot(chord[1]);
        let share = |beside: f64| if span_m > 0.0 { beside / span_m } else { 0.0 };
        let curve = self
            .cable
            .curve(&hung.profile, (span_m, self.up * chord[2]), count);
        let place = |&(beside, above): &(f64, f64)| {
            let [x, y, z] = lower;
            let s = share(beside);
            [x + s * chord[0], y + s * chord[1], z + self.up * above]
        };
        let mut places: Vec<Vector> = curve.iter().map(place).collect();
        if !is_rising {
            places.reverse();
        }
        places
    }

    /// −∂F_i/∂u_j for two ends of the profile, 0 the lower and 1 the upper one.
    fn block(
        &self,
        profile: &Profile,
        along: [f64; 2],
        ends: [usize; 2],
        signs: [f64; 2],
    ) -> Matrix3 {
        let [row, column] = ends.map(|end| end + 1);
        let k = &profile.stiffness;
        let across = [-along[1], along[0]];
        let (in_plane, out_of_plane) = (k[0][0], profile.transverse_n_per_m);
        let sign = signs[0] * signs[1];
        from_fn(|i| {
            from_fn(|j| match (i, j) {
                (2, 2) => k[row][column],
                (2, j) => self.up * signs[1] * k[row][0] * along[j],
                (i, 2) => self.up * signs[0] * k[0][column] * along[i],
                (i, j) => {
                    sign * (in_plane * along[i] * along[j] + out_of_plane * across[i] * across[j])
                }
            })
        })
    }

    /// The lowest height of the line, m; for a line lighter than water the highest.
    pub(super) fn extreme_z_m(&self, ends_m: [Vector; 2], sag_m: f64) -> f64 {
        let lower = ends_m.map(|end| self.up * end[2]);
        self.up * (lower[0].min(lower[1]) - sag_m)
    }

    /// Height of an end above the seabed, m; infinite for a line lighter than water, which does not
    /// reach the seabed.
    fn clearance_m(&self, z_m: f64) -> f64 {
        let height_m = z_m + self.depth_m;
        match self.up < 0.0 {
            true => f64::INFINITY,
            false if height_m <= ON_SEABED * self.depth_m => 0.0,
            false => height_m,
        }
    }
}
