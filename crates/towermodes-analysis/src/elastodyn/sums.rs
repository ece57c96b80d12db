//! ElastoDyn's sums over the elements of a tower.

use super::model::TowerModel;
use super::polynomial::TowerPolynomial;
use towermodes::tower::Plane;

/// Sums over the elements, without the mass on top and without tuners.
#[derive(Default)]
pub(super) struct Sums {
    pub(super) mass_kg: [f64; 2],
    pub(super) stiffness: [[f64; 2]; 2],
    pub(super) gravity: [f64; 2],
    pub(super) tower_mass_kg: f64,
}

/// An element, with the values at its centre.
struct Element {
    x: f64,
    mass_kg: f64,
    /// EI h, N m³.
    stiffness: f64,
    /// g (mass above) h, N m.
    weight_n: f64,
    /// Length of the whole tower, to which the derivatives with respect to height refer.
    length_m: f64,
}

impl TowerModel {
    /// The sums over the elements, from the top down, because gravity needs the mass above each
    /// element.
    pub(super) fn sums(&self, plane: Plane, shapes: &[TowerPolynomial; 2]) -> Sums {
        let step_m = self.flexible_length_m / self.nodes as f64;
        let attached_kg = self.attached_by_element();
        let mut row = self.stations.len() - 1;
        let mut sums = Sums::default();
        let mut above_kg = self.tower_top_mass_kg;
        for element in (0..self.nodes).rev() {
            let x = (element as f64 + 0.5) / self.nodes as f64;
            while row > 1 && self.stations[row - 1].height_fraction > x {
                row -= 1;
            }
            let (density, bending_n_m2) = self.between(row, x, plane);
            let mass_kg = density * step_m + attached_kg[element];
            let centre = Element {
                x,
                mass_kg,
                stiffness: bending_n_m2 * step_m,
                weight_n: self.gravity_m_per_s2 * (above_kg + 0.5 * mass_kg) * step_m,
                length_m: self.flexible_length_m,
            };
            sums.add(&centre, shapes);
            above_kg += mass_kg;
        }
        sums.tower_mass_kg = above_kg - self.tower_top_mass_kg;
        sums
    }

    /// Mass per length (kg/m) and bending stiffness (N m²) at x, between a row and the next lower
    /// one.
    fn between(&self, row: usize, x: f64, plane: Plane) -> (f64, f64) {
        let (below, above) = (&self.stations[row - 1], &self.stations[row]);
        let rise = above.height_fraction - below.height_fraction;
        let s = ((x - below.height_fraction) / rise).clamp(0.0, 1.0);
        let blend = |a: f64, b: f64| a + s * (b - a);
        let density = blend(below.mass_kg_per_m, above.mass_kg_per_m);
        let stiffness = blend(below.bending_n_m2.of(plane), above.bending_n_m2.of(plane));
        let factor = self.stiffness_factors.of(plane);
        (self.mass_factor * density, factor * stiffness)
    }

    /// The concentrated masses in each element, kg.
    fn attached_by_element(&self) -> Vec<f64> {
        let mut attached_kg = vec![0.0; self.nodes];
        for mass in &self.concentrated_masses {
            let element = (mass.height_fraction * self.nodes as f64) as usize;
            attached_kg[element.min(self.nodes - 1)] += mass.mass_kg;
        }
        attached_kg
    }
}

impl Sums {
    fn add(&mut self, element: &Element, shapes: &[TowerPolynomial; 2]) {
        let length_m = element.length_m;
        let curvature = shapes.map(|shape| shape.curvature(element.x) / (length_m * length_m));
        for (i, shape) in shapes.iter().enumerate() {
            let slope = shape.slope(element.x) / length_m;
            self.mass_kg[i] += element.mass_kg * shape.value(element.x).powi(2);
            self.gravity[i] -= element.weight_n * slope * slope;
            for j in 0..2 {
                self.stiffness[i][j] += element.stiffness * curvature[i] * curvature[j];
            }
        }
    }
}
