//! The whole tower as one rigid body on its base: its stiffness and its inertia.

use super::super::model::Tower;
use super::super::pieces::integrals::{mass_integrals, soil_integrals};
use crate::space::{SpatialMatrix, add_scaled, transform_matrix};

impl Tower {
    /// Stiffness against rigid motions (x, y, z, rotation about x, y, z) of the whole tower about
    /// its base, without gravity: foundation, soil and guy wires; N/m, N, N m.
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
            add_scaled(&mut sum, 1.0, &soil.spatial());
        }
        sum
    }

    /// The inertia against rigid motions (x, y, z, rotation about x, y, z) of the whole tower about
    /// its base, with all that moves with it: foundation, water, masses, rotor-nacelle assembly;
    /// kg, kg m, kg m².
    pub fn rigid_inertia(&self, rotary_inertia: bool) -> SpatialMatrix {
        let base_m = self.base_m();
        let mut sum = self.base.inertia;
        for attachment in &self.attachments {
            add_referred(&mut sum, &attachment.inertia, attachment.height_m - base_m);
        }
        for piece in &self.pieces {
            let mass = mass_integrals(piece, piece.base_m, piece.top_m, base_m);
            add_scaled(&mut sum, 1.0, &mass.axisymmetric(rotary_inertia).spatial());
        }
        sum
    }

    /// The motion for a value of 1 of each coordinate of the base, m or rad; 0 for fixed motions.
    ///
    /// Coordinates of which the stiffness, or the inertia where nothing resists, is 1 suit the
    /// elimination.
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
    transform_matrix(&mut matrix, rise_m);
    add_scaled(sum, 1.0, &matrix);
}
