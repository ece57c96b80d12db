//! The whole tower as one rigid body on its base: what resists its motions, and its inertia.

use super::integrals::{mass_integrals, soil_integrals};
use super::{Motion, Plane, Tower};
use crate::space::{SpatialMatrix, add_scaled, lower_matrix};

impl Tower {
    /// What resists rigid motions (x, y, z, rotation about x, y, z) of the whole tower about its base, weights left out: the foundation,
    /// soil and wires; N/m, N, N m.
    pub fn rigid_stiffness(&self) -> SpatialMatrix {
        let base_m = self.base_m();
        let mut sum = self.base.stiffness;
        for attachment in &self.attachments {
            add_referred(
                &mut sum,
                &attachment.stiffness,
                attachment.height_m - base_m,
            );
        }
        for piece in &self.pieces {
            let Some(soil) = soil_integrals(piece, piece.base_m, piece.top_m, base_m) else {
                continue;
            };
            add_bending(&mut sum, Plane::ForeAft, soil.transverse.fore_aft);
            add_bending(&mut sum, Plane::SideSide, soil.transverse.side_side);
            sum[2][2] += soil.axial_n_per_m;
            sum[5][5] += soil.torsion_n_m;
        }
        sum
    }

    /// The inertia against rigid motions (x, y, z, rotation about x, y, z) of the whole tower about its base, with all that moves with
    /// it: foundation, water, masses, rotor-nacelle assembly; kg, kg m, kg m².
    pub fn rigid_inertia(&self, rotary_inertia: bool) -> SpatialMatrix {
        let base_m = self.base_m();
        let mut sum = self.base.inertia;
        for attachment in &self.attachments {
            add_referred(&mut sum, &attachment.inertia, attachment.height_m - base_m);
        }
        for piece in &self.pieces {
            let mass = mass_integrals(piece, piece.base_m, piece.top_m, base_m);
            let mut add = |plane| {
                let rotary = mass.rotary_inertia_kg_m2.of(plane);
                let rotary = if rotary_inertia { rotary } else { 0.0 };
                let second = mass.second_moment_kg_m2 + rotary;
                add_bending(
                    &mut sum,
                    plane,
                    [mass.transverse_kg, mass.first_moment_kg_m, second],
                );
            };
            add(Plane::ForeAft);
            add(Plane::SideSide);
            sum[2][2] += mass.mass_kg;
            sum[5][5] += mass.polar_inertia_kg_m2;
        }
        sum
    }

    /// The motion that is 1 for each coordinate of the base, m or rad; 0 where it is rigidly held.
    ///
    /// Coordinates of which the stiffness, or the inertia where nothing resists, is 1 suit the elimination.
    pub(crate) fn base_units(&self) -> [f64; 6] {
        let (stiffness, inertia) = (self.rigid_stiffness(), self.rigid_inertia(true));
        std::array::from_fn(|i| {
            let resistance = match stiffness[i][i] {
                positive if positive > 0.0 => positive,
                _ => inertia[i][i],
            };
            if self.base.moves[i] && resistance > 0.0 {
                1.0 / resistance.sqrt()
            } else {
                f64::from(u8::from(self.base.moves[i]))
            }
        })
    }
}

fn add_referred(sum: &mut SpatialMatrix, matrix: &SpatialMatrix, rise_m: f64) {
    let mut matrix = *matrix;
    lower_matrix(&mut matrix, rise_m);
    add_scaled(sum, 1.0, &matrix);
}

/// Adds a matrix ww, wθ, θθ for deflection and rotation in a plane.
fn add_bending(sum: &mut SpatialMatrix, plane: Plane, [ww, wt, tt]: [f64; 3]) {
    let components = Motion::Bending(plane).components();
    for (row, (i, s)) in [[ww, wt], [wt, tt]].iter().zip(components) {
        for (entry, (j, t)) in row.iter().zip(components) {
            sum[*i][*j] += s * t * entry;
        }
    }
}
