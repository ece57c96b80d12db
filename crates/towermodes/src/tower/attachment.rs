//! Bodies and springs at a height of a tower: point masses, guy wires, rotor-nacelle assembly.

use super::description::{PointMass, Rna};
use super::parts::inertia::Inertia;
use super::parts::surroundings::Wires;
use crate::space::SpatialMatrix;

/// A body or spring at a height of the tower, for the motion (x, y, z, rotation about x, y, z) of
/// the tower there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attachment {
    /// Height, m.
    pub height_m: f64,
    /// Mass whose weight compresses the tower below, kg.
    pub mass_kg: f64,
    /// Inertia: kg, kg m, kg m².
    pub inertia: SpatialMatrix,
    /// Stiffness to the ground: N/m, N, N m.
    pub stiffness: SpatialMatrix,
    /// Mass times the height of its centre above this height, kg m: times g the geometric stiffness
    /// against rotation about x and y, with negative sign.
    pub overturning_kg_m: f64,
}

const NONE: SpatialMatrix = [[0.0; 6]; 6];

impl Attachment {
    pub(super) fn of_point_mass(mass: &PointMass) -> Self {
        Self {
            height_m: mass.height_m,
            mass_kg: mass.mass_kg,
            inertia: spatial_inertia(mass.mass_kg, [0.0; 3], &mass.inertia_kg_m2),
            stiffness: NONE,
            overturning_kg_m: 0.0,
        }
    }

    pub(super) fn of_wires(wires: &Wires) -> Self {
        let mut stiffness = NONE;
        stiffness[0][0] = wires.horizontal_n_per_m();
        stiffness[1][1] = wires.horizontal_n_per_m();
        stiffness[2][2] = wires.vertical_n_per_m();
        Self {
            height_m: wires.height_m,
            mass_kg: 0.0,
            inertia: NONE,
            stiffness,
            overturning_kg_m: 0.0,
        }
    }

    /// The assembly on the tower's top: its weight at the height c_z of its centre gives the
    /// geometric stiffness −m g c_z; the effect of its lateral offset is neglected.
    pub(super) fn of_rna(rna: &Rna, top_m: f64) -> Self {
        Self {
            height_m: top_m,
            mass_kg: rna.mass_kg,
            inertia: spatial_inertia(rna.mass_kg, rna.center_m, &rna.inertia_kg_m2),
            stiffness: NONE,
            overturning_kg_m: rna.mass_kg * rna.center_m[2],
        }
    }

    /// Its mass and stiffness matrices.
    pub(super) fn matrices(&self) -> [&SpatialMatrix; 2] {
        [&self.inertia, &self.stiffness]
    }
}

/// `[[m 1, −m [c]×], [m [c]×, J − m [c]×[c]×]]`: the spatial inertia of a body about a point from
/// which its centre of mass is at c.
///
/// Source: Featherstone, *Rigid Body Dynamics Algorithms* (2008), eq. 2.63, translation first.
pub(crate) fn spatial_inertia(mass_kg: f64, c: [f64; 3], inertia: &Inertia) -> SpatialMatrix {
    let m = mass_kg;
    let [x, y, z] = c;
    let cross = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    let own = inertia.tensor();
    let squares = x * x + y * y + z * z;
    let mut matrix = NONE;
    for i in 0..3 {
        matrix[i][i] = m;
        for j in 0..3 {
            matrix[i][3 + j] = 0.0 - m * cross[i][j];
            matrix[3 + j][i] = matrix[i][3 + j];
            let steiner = if i == j { squares } else { 0.0 } - c[i] * c[j];
            matrix[3 + i][3 + j] = own[i][j] + m * steiner;
        }
    }
    matrix
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinetic_energy_is_that_of_the_centre_and_of_the_rotation() {
        let (m, c) = (3.0, [0.4, -0.7, 2.0]);
        let inertia = Inertia {
            xx: 5.0,
            yy: 6.0,
            zz: 7.0,
            xy: -0.3,
            xz: 0.2,
            yz: 0.1,
        };
        let (v, w) = ([0.1, 0.5, -0.2], [0.7, -0.3, 0.9]);
        let centre = [
            v[0] + w[1] * c[2] - w[2] * c[1],
            v[1] + w[2] * c[0] - w[0] * c[2],
            v[2] + w[0] * c[1] - w[1] * c[0],
        ];
        let tensor = inertia.tensor();
        let spin: f64 = (0..3)
            .map(|i| (0..3).map(|j| w[i] * tensor[i][j] * w[j]).sum::<f64>())
            .sum();
        let energy = m * centre.iter().map(|x| x * x).sum::<f64>() + spin;
        let matrix = spatial_inertia(m, c, &inertia);
        let motion = [v[0], v[1], v[2], w[0], w[1], w[2]];
        let spatial: f64 = (0..6)
            .map(|i| {
                (0..6)
                    .map(|j| motion[i] * matrix[i][j] * motion[j])
                    .sum::<f64>()
            })
            .sum();
        assert!((spatial - energy).abs() < 1e-13);
    }
}
