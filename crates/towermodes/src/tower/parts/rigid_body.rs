//! Combination of rigid bodies: a rotor-nacelle assembly from its hub, blades and nacelle.

use super::inertia::Inertia;

/// Relative size below which an entry is a rounding error.
const ROUNDING: f64 = 1e-14;

/// A rigid body: mass, centre of mass, and inertia about the centre of mass.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RigidBody {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Centre of mass, m: x fore-aft (downwind), y side-side, z up, from a point that is common to
    /// all bodies.
    pub center_m: [f64; 3],
    /// Inertia about the centre of mass, kg m².
    pub inertia_kg_m2: Inertia,
}

impl RigidBody {
    /// A mass at a point.
    pub fn point(mass_kg: f64, center_m: [f64; 3]) -> Self {
        Self {
            mass_kg,
            center_m,
            inertia_kg_m2: Inertia::default(),
        }
    }

    /// A body with inertia but without mass, whose centre has no effect.
    pub fn massless(inertia_kg_m2: Inertia) -> Self {
        Self {
            inertia_kg_m2,
            ..Self::default()
        }
    }

    /// All bodies as one: masses add up, the centre is their mean by mass, and each inertia is
    /// shifted there (Steiner).
    pub fn combined(bodies: &[Self]) -> Self {
        let mass_kg: f64 = bodies.iter().map(|body| body.mass_kg).sum();
        let mean = |i: usize| {
            let moment: f64 = bodies.iter().map(|b| b.mass_kg * b.center_m[i]).sum();
            if mass_kg == 0.0 {
                0.0
            } else {
                moment / mass_kg
            }
        };
        let center_m = [mean(0), mean(1), mean(2)];
        let mut tensor = [[0.0; 3]; 3];
        for body in bodies {
            let shifted = body.tensor_about(center_m);
            for (sum, row) in tensor.iter_mut().zip(shifted) {
                for (sum, entry) in sum.iter_mut().zip(row) {
                    *sum += entry;
                }
            }
        }
        Self {
            mass_kg,
            center_m,
            inertia_kg_m2: Inertia::from_tensor(tensor),
        }
        .without_rounding()
    }

    /// The body with zeros in place of rounding errors of terms that cancel, for example of the
    /// blades of a rotor: such rounding errors would couple independent motions.
    fn without_rounding(mut self) -> Self {
        let size_m = self.center_m.iter().fold(0.0_f64, |a, x| a.max(x.abs()));
        for center_m in &mut self.center_m {
            if center_m.abs() < ROUNDING * size_m {
                *center_m = 0.0;
            }
        }
        let inertia = &mut self.inertia_kg_m2;
        let size = inertia.xx.abs().max(inertia.yy.abs()).max(inertia.zz.abs());
        for product in [&mut inertia.xy, &mut inertia.xz, &mut inertia.yz] {
            if product.abs() < ROUNDING * size {
                *product = 0.0;
            }
        }
        self
    }

    /// The inertia about a point at the distance r from the centre of mass: J + m (r² 1 − r rᵀ), kg
    /// m².
    pub fn tensor_about(&self, point_m: [f64; 3]) -> [[f64; 3]; 3] {
        let r: [f64; 3] = std::array::from_fn(|i| self.center_m[i] - point_m[i]);
        let square: f64 = r.iter().map(|r| r * r).sum();
        let own = self.inertia_kg_m2.tensor();
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let diagonal = if i == j { square } else { 0.0 };
                own[i][j] + self.mass_kg * (diagonal - r[i] * r[j])
            })
        })
    }

    /// The same body turned about y by an angle (rad) that carries z towards x, and then moved.
    #[must_use]
    pub fn turned_about_y(&self, angle_rad: f64) -> Self {
        let (sin, cos) = angle_rad.sin_cos();
        self.turned([[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]])
    }

    /// The same body turned about x by an angle (rad) that carries y towards z.
    #[must_use]
    pub fn turned_about_x(&self, angle_rad: f64) -> Self {
        let (sin, cos) = angle_rad.sin_cos();
        self.turned([[1.0, 0.0, 0.0], [0.0, cos, -sin], [0.0, sin, cos]])
    }

    /// The same body, displaced by a vector (m).
    #[must_use]
    pub fn moved(&self, by_m: [f64; 3]) -> Self {
        Self {
            center_m: std::array::from_fn(|i| self.center_m[i] + by_m[i]),
            ..*self
        }
    }

    /// The body rotated by the matrix R: centre R c, inertia R J Rᵀ.
    fn turned(&self, rotation: [[f64; 3]; 3]) -> Self {
        let own = self.inertia_kg_m2.tensor();
        let entry = |i: usize, j: usize| {
            let terms = (0..3).flat_map(|k| (0..3).map(move |l| (k, l)));
            terms
                .map(|(k, l)| rotation[i][k] * own[k][l] * rotation[j][l])
                .sum()
        };
        Self {
            mass_kg: self.mass_kg,
            center_m: rotation.map(|row| row.iter().zip(self.center_m).map(|(r, c)| r * c).sum()),
            inertia_kg_m2: Inertia::from_tensor(std::array::from_fn(|i| {
                std::array::from_fn(|j| entry(i, j))
            })),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn a_dumbbell_has_the_inertia_of_its_reduced_mass() {
        let bodies = [
            RigidBody::point(2.0, [0.0, 0.0, 1.0]),
            RigidBody::point(6.0, [0.0, 0.0, 5.0]),
        ];
        let whole = RigidBody::combined(&bodies);
        assert_eq!(whole.center_m, [0.0, 0.0, 4.0]);
        // m1 m2/(m1 + m2) d² = 12/8 · 16.
        assert_eq!(whole.inertia_kg_m2.xx, 24.0);
        assert_eq!(whole.inertia_kg_m2.zz, 0.0);
    }

    #[test]
    fn a_quarter_turn_swaps_axes() {
        let body = RigidBody {
            mass_kg: 1.0,
            center_m: [0.0, 0.0, 2.0],
            inertia_kg_m2: Inertia {
                xx: 1.0,
                yy: 2.0,
                zz: 3.0,
                ..Inertia::default()
            },
        };
        let turned = body.turned_about_y(FRAC_PI_2);
        assert!((turned.center_m[0] - 2.0).abs() < 1e-15);
        assert!((turned.inertia_kg_m2.xx - 3.0).abs() < 1e-15);
        let turned = body.turned_about_x(FRAC_PI_2);
        assert!((turned.center_m[1] + 2.0).abs() < 1e-15);
        assert!((turned.inertia_kg_m2.yy - 3.0).abs() < 1e-15);
    }
}
