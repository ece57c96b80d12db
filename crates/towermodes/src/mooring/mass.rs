//! The masses of a mooring system: those that are fixed to the platform, and those that the modes
//! do not include.

use std::array::from_fn;

use super::carrier::{Arm, Owner};
use super::system::Mooring;
use super::vector::{Matrix3, Vector, difference, dot, length, product, skew, transposed};
use crate::space::SpatialMatrix;

impl Mooring {
    /// The rigid-body mass matrix of the points, bodies and rods that are fixed to the platform,
    /// about its reference point at the reference pose (kg, kg m, kg m²). Rods are thin.
    pub fn platform_mass(&self) -> SpatialMatrix {
        let mut sum = SpatialMatrix::default();
        for (point, arm) in self.description.points.iter().zip(&self.points) {
            add_body(&mut sum, *arm, point.mass_kg, [[0.0; 3]; 3]);
        }
        for (body, seat) in self.description.bodies.iter().zip(&self.bodies) {
            let inertia = &body.inertia_kg_m2;
            let own = from_fn(|i| from_fn(|j| if i == j { inertia[i] } else { 0.0 }));
            let turn = &seat.start.rotation;
            let inertia = product(&product(turn, &own), &transposed(turn));
            add_body(&mut sum, seat.arm(body.center_m), body.mass_kg, inertia);
        }
        for (rod, seat) in self.description.rods.iter().zip(&self.rods) {
            let along = difference(rod.ends_m[1], rod.ends_m[0]);
            let mass_kg = rod.mass_kg_per_m * length(along);
            let inertia = about_center(along).map(|row| row.map(|entry| mass_kg / 12.0 * entry));
            add_body(&mut sum, seat.arm([0.0; 3]), mass_kg, inertia);
        }
        sum
    }

    /// Mass of the free points, bodies and rods, kg, which no mode includes.
    pub fn free_mass_kg(&self) -> f64 {
        let is_free = |arm: &Arm| matches!(arm.owner, Owner::Free(_));
        let points = self.description.points.iter().zip(&self.points);
        let points = points
            .filter(|(_, arm)| is_free(arm))
            .map(|(point, _)| point.mass_kg);
        let bodies = self.description.bodies.iter().zip(&self.bodies);
        let bodies = bodies.filter(|(_, seat)| is_free(&seat.arm([0.0; 3])));
        let rods = self.description.rods.iter().zip(&self.rods);
        let rods = rods.filter(|(_, seat)| is_free(&seat.arm([0.0; 3])));
        let rods = rods
            .map(|(rod, _)| rod.mass_kg_per_m * length(difference(rod.ends_m[1], rod.ends_m[0])));
        points
            .chain(bodies.map(|(body, _)| body.mass_kg))
            .chain(rods)
            .sum()
    }

    /// Mass of the lines in air, kg, which no mode includes.
    pub fn line_mass_kg(&self) -> f64 {
        let lines = self.description.lines.iter();
        let masses = lines
            .map(|line| line.length_m * self.description.line_types[line.line_type].mass_kg_per_m);
        masses.sum()
    }
}

/// r² 1 − r rᵀ.
fn about_center(r: Vector) -> Matrix3 {
    let square = dot(r, r);
    from_fn(|i| {
        from_fn(|j| {
            if i == j {
                square - r[i] * r[j]
            } else {
                -r[i] * r[j]
            }
        })
    })
}

/// Adds the mass matrix of a body at a point, if the point is on the platform.
fn add_body(sum: &mut SpatialMatrix, arm: Arm, mass_kg: f64, inertia: Matrix3) {
    if arm.owner != Owner::Platform {
        return;
    }
    let (r, lever) = (arm.arm_m, skew(arm.arm_m));
    let steiner = about_center(r);
    for i in 0..3 {
        sum[i][i] += mass_kg;
        for j in 0..3 {
            sum[3 + i][j] += mass_kg * lever[i][j];
            sum[j][3 + i] += mass_kg * lever[i][j];
            sum[3 + i][3 + j] += inertia[i][j] + mass_kg * steiner[i][j];
        }
    }
}
