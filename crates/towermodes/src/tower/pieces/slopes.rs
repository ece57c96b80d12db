//! Derivatives of the section of a tube with respect to the numbers that it is made of.

use super::super::parts::material::Material;
use super::environment::Environment;
use super::section::Tube;
use super::shear::Shear;

/// Derivatives of the flexibilities (1/EI, 1/EA, 1/GJ, 1/κGA) of a tube with respect to (diameter,
/// wall, E, G, κ).
pub(crate) type FlexibilitySlopes = [[f64; 4]; 5];

/// Derivatives of the masses (ρA, transverse water, ρI) of a tube with respect to (diameter, wall,
/// density, water outside, water inside).
pub(crate) type MassSlopes = [[f64; 3]; 5];

/// A value with its derivatives with respect to diameter and wall.
#[derive(Clone, Copy)]
struct Sloped {
    value: f64,
    slopes: [f64; 2],
}

impl Tube {
    fn area(&self) -> Sloped {
        let (pi, d_i) = (std::f64::consts::PI, self.inner_diameter_m());
        Sloped {
            value: self.area_m2(),
            slopes: [pi * self.wall_thickness_m, pi * d_i],
        }
    }

    /// I = A (d² + dᵢ²)/16.
    fn second_moment_of_area(&self) -> Sloped {
        let (area, d, d_i) = (self.area(), self.outer_diameter_m, self.inner_diameter_m());
        let squares = (d * d + d_i * d_i) / 16.0;
        let of_squares = [(d + d_i) / 8.0, -d_i / 4.0];
        let slope = |i: usize| area.slopes[i] * squares + area.value * of_squares[i];
        Sloped {
            value: area.value * squares,
            slopes: [slope(0), slope(1)],
        }
    }

    /// d(ln κ) of Cowper's coefficient with respect to diameter, wall and Poisson's ratio.
    fn cowper_slopes(&self, nu: f64) -> [f64; 3] {
        let d = self.outer_diameter_m;
        let m = self.inner_diameter_m() / d;
        let m2 = m * m;
        let (q, of_q) = ((1.0 + m2) * (1.0 + m2), 2.0 * (1.0 + m2));
        let below = (7.0 + 6.0 * nu) * q + (20.0 + 12.0 * nu) * m2;
        let by_m2 = of_q / q - ((7.0 + 6.0 * nu) * of_q + 20.0 + 12.0 * nu) / below;
        let by_m = 2.0 * m * by_m2;
        let by_nu = 1.0 / (1.0 + nu) - (6.0 * q + 12.0 * m2) / below;
        [by_m * (1.0 - m) / d, -2.0 * by_m / d, by_nu]
    }

    /// See [`FlexibilitySlopes`].
    pub(crate) fn flexibility_slopes(
        &self,
        material: &Material,
        shear: Shear,
    ) -> FlexibilitySlopes {
        let (e, g) = (material.youngs_modulus_pa, material.shear_modulus_pa);
        let (area, inertia) = (self.area(), self.second_moment_of_area());
        let bending = 1.0 / (e * inertia.value);
        let axial = 1.0 / (e * area.value);
        let torsion = 1.0 / (2.0 * g * inertia.value);
        let nu = material.poissons_ratio();
        let (kappa, of_kappa) = match shear {
            Shear::Rigid => (f64::INFINITY, [0.0; 3]),
            Shear::Cowper => (self.cowper_shear_coefficient(nu), self.cowper_slopes(nu)),
            Shear::Coefficient(kappa) => (kappa, [0.0; 3]),
        };
        let sheared = 1.0 / (kappa * g * area.value);
        let by_size = |i: usize| {
            let (a, b) = (
                area.slopes[i] / area.value,
                inertia.slopes[i] / inertia.value,
            );
            [
                -bending * b,
                -axial * a,
                -torsion * b,
                -sheared * (a + of_kappa[i]),
            ]
        };
        // ν = E/2G − 1.
        let (nu_by_e, nu_by_g) = (0.5 / g, -0.5 * e / (g * g));
        [
            by_size(0),
            by_size(1),
            [
                -bending / e,
                -axial / e,
                0.0,
                -sheared * of_kappa[2] * nu_by_e,
            ],
            [
                0.0,
                0.0,
                -torsion / g,
                -sheared * (1.0 / g + of_kappa[2] * nu_by_g),
            ],
            [0.0, 0.0, 0.0, -sheared / kappa],
        ]
    }

    /// See [`MassSlopes`].
    pub(crate) fn mass_slopes(&self, material: &Material, around: &Environment) -> MassSlopes {
        let density = material.density_kg_per_m3;
        let (area, inertia) = (self.area(), self.second_moment_of_area());
        let (d, d_i) = (self.outer_diameter_m, self.inner_diameter_m());
        let (outside, inside) = (around.outside_kg_per_m3, around.inside_kg_per_m3);
        [
            [
                density * area.slopes[0],
                2.0 * (outside * d + inside * d_i),
                density * inertia.slopes[0],
            ],
            [
                density * area.slopes[1],
                -4.0 * inside * d_i,
                density * inertia.slopes[1],
            ],
            [area.value, 0.0, inertia.value],
            [0.0, d * d, 0.0],
            [0.0, d_i * d_i, 0.0],
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tower::{Section, SectionMasses};

    /// The four flexibilities and three masses of a tube of (diameter, wall, E, G, κ, density,
    /// outside, inside).
    fn values(n: &[f64; 8], is_cowper: bool) -> [f64; 7] {
        let tube = Tube {
            outer_diameter_m: n[0],
            wall_thickness_m: n[1],
        };
        let material = Material::from_shear_modulus(n[5], n[2], n[3]);
        let shear = match is_cowper {
            true => Shear::Cowper,
            false => Shear::Coefficient(n[4]),
        };
        let section = Section::of_tube(&tube, &material, shear);
        let masses = SectionMasses::of_tube(&tube, &material);
        let around = Environment {
            outside_kg_per_m3: n[6],
            inside_kg_per_m3: n[7],
            ..Environment::default()
        };
        [
            1.0 / section.bending_n_m2.fore_aft,
            1.0 / section.axial_n,
            1.0 / section.torsion_n_m2,
            section.shear_flexibility_per_n.fore_aft,
            masses.mass_kg_per_m,
            around.water_kg_per_m(&tube),
            masses.rotary_inertia_kg_m.fore_aft,
        ]
    }

    #[test]
    fn slopes_are_those_of_small_differences() {
        let at = [5.0, 0.04, 2.1e11, 8.08e10, 0.6, 7850.0, 800.0, 750.0];
        let tube = Tube {
            outer_diameter_m: at[0],
            wall_thickness_m: at[1],
        };
        let material = Material::from_shear_modulus(at[5], at[2], at[3]);
        let around = Environment {
            outside_kg_per_m3: at[6],
            inside_kg_per_m3: at[7],
            ..Environment::default()
        };
        for is_cowper in [false, true] {
            let shear = match is_cowper {
                true => Shear::Cowper,
                false => Shear::Coefficient(at[4]),
            };
            let flexibilities = tube.flexibility_slopes(&material, shear);
            let masses = tube.mass_slopes(&material, &around);
            for number in 0..8 {
                let slope = |h: f64| {
                    let moved = |h: f64| {
                        let mut moved = at;
                        moved[number] *= 1.0 + h;
                        values(&moved, is_cowper)
                    };
                    let (above, below) = (moved(h), moved(-h));
                    let slope = |i: usize| (above[i] - below[i]) / (2.0 * h * at[number]);
                    std::array::from_fn::<f64, 7, _>(slope)
                };
                let (whole, half) = (slope(2e-3), slope(1e-3));
                let of_flexibility = [
                    Some(0),
                    Some(1),
                    Some(2),
                    Some(3),
                    Some(4),
                    None,
                    None,
                    None,
                ];
                let of_mass = [
                    Some(0),
                    Some(1),
                    None,
                    None,
                    None,
                    Some(2),
                    Some(3),
                    Some(4),
                ];
                for value in 0..7 {
                    let expected = half[value] + (half[value] - whole[value]) / 3.0;
                    let got = match value {
                        0..4 => of_flexibility[number].map(|n: usize| flexibilities[n][value]),
                        _ => of_mass[number].map(|n: usize| masses[n][value - 4]),
                    };
                    let got = got.unwrap_or(0.0);
                    let is_near = (got - expected).abs() <= 1e-9 * expected.abs();
                    let is_zero = got == 0.0 && !is_cowper && number == 4;
                    let both_none = got == 0.0 && expected == 0.0;
                    let unused = is_cowper && number == 4;
                    assert!(
                        is_near || both_none || unused || (is_zero && expected == 0.0),
                        "number {number}, value {value}: {got} {expected}"
                    );
                }
            }
        }
    }
}
