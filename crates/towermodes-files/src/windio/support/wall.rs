//! A stretch of a wall of several layers, and its sections.

use std::f64::consts::PI;
use std::ops::Range;

use towermodes::{Material, Planes, Properties};

use crate::diagnostic::DiagnosticKind;

/// Largest relative error of mass and stiffness between rows that represent walls.
const ROW_ERROR: f64 = 1e-5;

/// A stretch of wall: diameter and thicknesses at its base and top, linear between them.
pub(super) struct Wall {
    pub(crate) diameter_m: [f64; 2],
    /// Thicknesses from outside in, m, and the index of the material of each layer.
    pub(crate) layers: Vec<([f64; 2], usize)>,
    /// Its place in the file.
    pub(crate) span: Range<usize>,
}

impl Wall {
    /// Checks that there is a tube at the base (0) or the top (1); `at` is the position in
    /// messages.
    pub(super) fn check(&self, end: usize, at: &str) -> Result<(), DiagnosticKind> {
        let d = self.diameter_m[end];
        let t: f64 = self.layers.iter().map(|(t, _)| t[end]).sum();
        let wall = format!("the wall thickness {at}");
        Err(if d <= 0.0 || d.is_nan() {
            let what = format!("the outer diameter {at}");
            DiagnosticKind::out_of_range_in(what, d, "m", "positive")
        } else if t <= 0.0 || t.is_nan() {
            DiagnosticKind::out_of_range_in(wall, t, "m", "positive")
        } else if 2.0 * t > d {
            let rule = format!("at most half the outer diameter, {d} m");
            DiagnosticKind::out_of_range_in(wall, t, "m", rule)
        } else {
            return Ok(());
        })
    }

    /// The section at a fraction of the height: the sums of its concentric tubes.
    pub(crate) fn properties(
        &self,
        height: f64,
        materials: &[Material],
        outfitting: f64,
    ) -> Properties {
        let blend = |[a, b]: [f64; 2]| a + height * (b - a);
        let mut outer = 0.5 * blend(self.diameter_m);
        let (mut mass, mut inertia, mut ei, mut gj, mut ea) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for &(thickness, material) in &self.layers {
            let inner = (outer - blend(thickness)).max(0.0);
            let material = &materials[material];
            let rings = (outer - inner) * (outer + inner);
            let area = PI * rings;
            let second_moment = 0.25 * area * (outer * outer + inner * inner);
            mass += material.density_kg_per_m3 * area;
            inertia += material.density_kg_per_m3 * second_moment;
            ei += material.youngs_modulus_pa * second_moment;
            gj += 2.0 * material.shear_modulus_pa * second_moment;
            ea += material.youngs_modulus_pa * area;
            outer = inner;
        }
        Properties {
            mass_kg_per_m: outfitting * mass,
            rotary_inertia_kg_m: Planes::both(outfitting * inertia),
            polar_inertia_kg_m: 2.0 * outfitting * inertia,
            bending_n_m2: Planes::both(ei),
            torsion_n_m2: gj,
            axial_n: ea,
            shear_n: None,
        }
    }

    /// The number of rows that the stretch needs for an accurate linear interpolation: the error is
    /// inversely proportional to its square.
    pub(super) fn rows_between(
        &self,
        materials: &[Material],
        outfitting: f64,
        most: usize,
    ) -> usize {
        let values = |height: f64| {
            let p = self.properties(height, materials, outfitting);
            let gyration = p.polar_inertia_kg_m / p.mass_kg_per_m;
            [
                p.mass_kg_per_m,
                p.bending_n_m2.fore_aft,
                p.torsion_n_m2,
                p.axial_n,
                gyration,
            ]
        };
        let (base, top) = (values(0.0), values(1.0));
        let mut error = 0.0_f64;
        for height in [0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875] {
            for ((value, a), b) in values(height).into_iter().zip(base).zip(top) {
                error = error.max(((a + height * (b - a)) / value - 1.0).abs());
            }
        }
        // Wider where the section is small: the error is relative.
        let rows = (1.5 * error / ROW_ERROR).sqrt().ceil();
        if rows.is_finite() {
            (rows as usize).clamp(1, most)
        } else {
            most
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wall(top_m: f64) -> Wall {
        Wall {
            diameter_m: [6.0, top_m],
            layers: vec![([0.03, 0.03], 0), ([0.2, 0.2], 1)],
            span: 0..0,
        }
    }

    #[test]
    fn straight_walls_need_no_rows_between_and_tapers_many() {
        let steel = Material::from_poissons_ratio(7850.0, 2.1e11, 0.3);
        let concrete = Material::from_poissons_ratio(2500.0, 4e10, 0.2);
        let rows = |top_m| wall(top_m).rows_between(&[steel, concrete], 1.0, 200);
        assert_eq!(rows(6.0), 1);
        // EI ~ D^3: the largest error is about 3/4 of the square of the relative change, 1/36 from
        // row to row.
        assert!((20..=200).contains(&rows(5.0)), "{}", rows(5.0));
        assert!(rows(5.9) < rows(5.0));
    }
}
