//! The part of a tower that is in the ground.

use super::super::pieces::section::Tube;
use super::description::Ground;
use super::layer::{GroundLayer, LayerSoil};
use crate::tower::description::TowerDescription;

/// From this depth, in diameters below the surface around a hole of local scour, the effective
/// stress is not reduced.
const OVERBURDEN_DIAMETERS: f64 = 6.0;

/// A tower in the ground: heights, depths, the sections of the pile, the weight of the soil.
#[derive(Debug)]
pub(in crate::tower) struct Pile<'a> {
    description: &'a TowerDescription,
    pub(super) ground: &'a Ground,
    /// Height of the tip, m.
    pub(super) tip_m: f64,
    /// Height of the surface after general scour, m.
    pub(super) bed_m: f64,
    /// Height of the bottom of the hole of local scour, m: the upper end of the soil at the pile.
    pub(super) hole_m: f64,
    /// Weight of the soil above the top of each layer before scour, Pa.
    weights_to_top_pa: Vec<f64>,
}

impl<'a> Pile<'a> {
    /// The pile of a tower with ground.
    pub(super) fn of(description: &'a TowerDescription) -> Option<Self> {
        let ground = description.ground.as_ref()?;
        let bed_m = ground.surface_m - ground.scour.general_m;
        let lowest_station = description.stations.first().map(|row| row.height_m);
        let lowest_row = description.properties.first().map(|row| row.height_m);
        Some(Self {
            description,
            ground,
            tip_m: lowest_station.or(lowest_row)?,
            bed_m,
            hole_m: bed_m - ground.scour.local_m,
            weights_to_top_pa: weights_to_top_pa(ground),
        })
    }

    /// Embedded length L, m.
    pub(super) fn length_m(&self) -> f64 {
        self.hole_m - self.tip_m
    }

    /// Depth below the bottom of the hole, m.
    pub(super) fn depth_m(&self, height_m: f64) -> f64 {
        self.hole_m - height_m
    }

    /// The factor on the springs of a layer.
    pub(super) fn factor(&self, index: usize) -> f64 {
        self.ground.factor * self.ground.layers[index].factor
    }

    /// The depth at which undisturbed soil has the same effective stress, m: below a hole of
    /// depth S min(z, (z − S) 6D/(6D − S)), with z below the surface around the hole.
    ///
    /// Source: API RP 2A and RP 2GEO, commentary on scour, as programmed in COSPIN: no stress at
    /// the bottom of the hole, the full one six diameters below the surface around it.
    pub(super) fn overburden_depth_m(&self, height_m: f64) -> f64 {
        let (depth_m, full_m) = (self.bed_m - height_m, self.full_overburden_m());
        if self.ground.scour.local_m == 0.0 || height_m <= full_m {
            return depth_m;
        }
        self.depth_m(height_m) * (self.bed_m - full_m) / (self.hole_m - full_m)
    }

    /// Height below which the hole does not reduce the effective stress, m: its bottom, if it is
    /// deeper than six diameters.
    pub(super) fn full_overburden_m(&self) -> f64 {
        let full_m = self.bed_m - OVERBURDEN_DIAMETERS * self.diameter_m(self.hole_m);
        if full_m > self.hole_m {
            self.hole_m
        } else {
            full_m
        }
    }

    /// Vertical effective stress in the undisturbed soil before scour, Pa.
    pub(super) fn stress_before_scour_pa(&self, height_m: f64) -> f64 {
        self.weight_above_pa(height_m, self.ground.surface_m)
    }

    /// Vertical effective stress with scour, Pa.
    pub(super) fn effective_stress_pa(&self, height_m: f64) -> f64 {
        let unreduced_pa = self.weight_above_pa(height_m, self.bed_m);
        match self.overburden_excess_pa(height_m) {
            Some(excess_pa) if excess_pa < 0.0 => unreduced_pa + excess_pa,
            _ => unreduced_pa,
        }
    }

    /// The difference between the stress with local scour, on a line from zero to the unreduced
    /// stress, and the stress without scour, Pa; none where local scour does not reduce the stress.
    /// It can be positive under heavy layers above light ones; then the line is not used.
    pub(super) fn overburden_excess_pa(&self, height_m: f64) -> Option<f64> {
        let full_m = self.full_overburden_m();
        if self.ground.scour.local_m == 0.0 || height_m <= full_m {
            return None;
        }
        let share = self.depth_m(height_m) / (self.hole_m - full_m);
        let reduced_pa = share * self.weight_above_pa(full_m, self.bed_m);
        Some(reduced_pa - self.weight_above_pa(height_m, self.bed_m))
    }

    /// The mean undrained strength of the clay from the top of the soil down to a height in a layer
    /// of clay, Pa.
    pub(super) fn mean_strength_pa(&self, index: usize, height_m: f64) -> f64 {
        let (mut sum, mut length_m) = (0.0, 0.0);
        for (above, layer) in self.ground.layers[..=index].iter().enumerate() {
            let LayerSoil::Clay(clay) = &layer.soil else {
                continue;
            };
            let Some([top_pa, bottom_pa]) = clay.undrained_strength_pa else {
                continue;
            };
            let upper_m = layer.top_m.min(self.hole_m);
            let lower_m = if above == index {
                height_m
            } else {
                layer.bottom_m
            };
            let at_pa = |at_m: f64| top_pa + self.layer(above, at_m).1 * (bottom_pa - top_pa);
            let part_m = upper_m - lower_m;
            if part_m > 0.0 {
                sum += 0.5 * (at_pa(upper_m) + at_pa(lower_m)) * part_m;
                length_m += part_m;
            }
        }
        match length_m > 0.0 {
            true => sum / length_m,
            false => f64::NAN,
        }
    }

    /// Weight of the soil between a height and the surface with or without scour, Pa.
    fn weight_above_pa(&self, height_m: f64, surface_m: f64) -> f64 {
        self.weight_to_pa(height_m) - self.weight_to_pa(surface_m)
    }

    /// Weight of the soil between a height and the surface before scour, Pa: the first and the last
    /// layer are extended beyond their ends.
    fn weight_to_pa(&self, height_m: f64) -> f64 {
        let layers = &self.ground.layers;
        let below = layers.partition_point(|layer| layer.bottom_m > height_m);
        let index = below.min(layers.len().saturating_sub(1));
        let Some(layer) = layers.get(index) else {
            return f64::NAN;
        };
        let weight = layer.effective_unit_weight_n_per_m3.unwrap_or(f64::NAN);
        self.weights_to_top_pa[index] + weight * (layer.top_m - height_m)
    }

    /// Outer diameter D, m; at a step the diameter of the tube above it.
    pub(super) fn diameter_m(&self, height_m: f64) -> f64 {
        let given = self.ground.pile_diameter_m;
        let own = || self.tube(height_m).map(|(tube, _)| tube.outer_diameter_m);
        given.or_else(own).unwrap_or(f64::NAN)
    }

    /// Bending stiffness E I, N m²; of a table with different planes the smaller one.
    pub(super) fn bending_n_m2(&self, height_m: f64) -> f64 {
        if let Some((tube, youngs_modulus_pa)) = self.tube(height_m) {
            return youngs_modulus_pa * tube.second_moment_of_area_m4();
        }
        let rows = &self.description.properties;
        let around = around(rows, height_m, |row| row.height_m);
        around.map_or(f64::NAN, |(below, share)| {
            let planes = |index: usize| rows[index].properties.bending_n_m2;
            let (low, high) = (planes(below), planes(below + 1));
            let blend = |a: f64, b: f64| a + share * (b - a);
            let fore_aft = blend(low.fore_aft, high.fore_aft);
            fore_aft.min(blend(low.side_side, high.side_side))
        })
    }

    /// The tube at a height with its Young's modulus, Pa; none for a table of properties.
    fn tube(&self, height_m: f64) -> Option<(Tube, f64)> {
        let stations = &self.description.stations;
        let (below, share) = around(stations, height_m, |row| row.height_m)?;
        let tube = |index: usize| Tube {
            outer_diameter_m: stations[index].outer_diameter_m,
            wall_thickness_m: stations[index].wall_thickness_m,
        };
        let material = self
            .description
            .materials
            .get(stations[below].material)
            .map(|material| material.youngs_modulus_pa);
        let tube = tube(below).blend(&tube(below + 1), share);
        Some((tube, material.unwrap_or(f64::NAN)))
    }

    /// The layer, and the position of a height in it: 0 at its top, 1 at its bottom.
    pub(super) fn layer(&self, index: usize, height_m: f64) -> (&'a GroundLayer, f64) {
        let layer = &self.ground.layers[index];
        let share = (layer.top_m - height_m) / (layer.top_m - layer.bottom_m);
        (layer, share)
    }

    /// Height of the surface of the rock to which a layer of rock belongs, m.
    pub(super) fn rock_surface_m(&self, index: usize) -> f64 {
        let above = self.ground.layers[..=index].iter().rev();
        let rock = above.take_while(|layer| matches!(layer.soil, LayerSoil::Rock(_)));
        let top_m = rock.map(|layer| layer.top_m).fold(f64::MIN, f64::max);
        top_m.min(self.hole_m)
    }
}

fn weights_to_top_pa(ground: &Ground) -> Vec<f64> {
    let weights = ground.layers.iter().scan(0.0, |above_pa, layer| {
        let to_top_pa = *above_pa;
        let weight = layer.effective_unit_weight_n_per_m3.unwrap_or(f64::NAN);
        *above_pa += weight * (layer.top_m - layer.bottom_m);
        Some(to_top_pa)
    });
    weights.collect()
}

/// The index of the row below a height, of rows in increasing height, and the position of the
/// height between this row and the next one as a fraction; at the ends the nearest pair of rows.
fn around<R>(rows: &[R], height_m: f64, row_m: impl Fn(&R) -> f64) -> Option<(usize, f64)> {
    let above = rows.partition_point(|row| row_m(row) <= height_m);
    let upper = above.min(rows.len().checked_sub(1)?).max(1);
    let below = upper - 1;
    let (low_m, high_m) = (row_m(rows.get(below)?), row_m(rows.get(upper)?));
    let share = match high_m > low_m {
        true => (height_m - low_m) / (high_m - low_m),
        false => 0.0,
    };
    Some((below, share.clamp(0.0, 1.0)))
}
