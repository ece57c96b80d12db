//! Sections: the circular tube, and the properties of a section in a beam.

use std::f64::consts::PI;

use super::super::parts::material::Material;
use super::super::parts::surroundings::SoilStiffness;
use super::planes::Planes;
use super::shear::Shear;

/// A circular tube of outer diameter d and wall thickness t (0 < t ≤ d/2; t = d/2 is a solid rod).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tube {
    /// Outer diameter d, m.
    pub outer_diameter_m: f64,
    /// Wall thickness t, m.
    pub wall_thickness_m: f64,
}

impl Tube {
    /// Cross-section area A = π t (d − t), m²; exact, not the thin-wall formula.
    #[inline]
    pub fn area_m2(&self) -> f64 {
        PI * self.wall_thickness_m * (self.outer_diameter_m - self.wall_thickness_m)
    }

    /// Inner diameter d − 2t, m.
    #[inline]
    pub fn inner_diameter_m(&self) -> f64 {
        self.outer_diameter_m - 2.0 * self.wall_thickness_m
    }

    /// Second moment of area about a diameter, m⁴: I = A (d² + dᵢ²)/16, which is π/64 (d⁴ − dᵢ⁴)
    /// without its cancellation.
    ///
    /// The polar moment is J = 2 I.
    #[inline]
    pub fn second_moment_of_area_m4(&self) -> f64 {
        let (d, d_i) = (self.outer_diameter_m, self.inner_diameter_m());
        self.area_m2() * (d * d + d_i * d_i) / 16.0
    }

    /// Timoshenko's shear coefficient κ of a hollow circle, with m = dᵢ/d:
    /// κ = 6 (1+ν)(1+m²)² / ((7+6ν)(1+m²)² + (20+12ν) m²).
    ///
    /// Source: Cowper, *The shear coefficient in Timoshenko's beam theory*, J. Appl. Mech. 33
    /// (1966).
    #[inline]
    pub fn cowper_shear_coefficient(&self, poissons_ratio: f64) -> f64 {
        let nu = poissons_ratio;
        let m = self.inner_diameter_m() / self.outer_diameter_m;
        let m2 = m * m;
        let q = (1.0 + m2) * (1.0 + m2);
        6.0 * (1.0 + nu) * q / ((7.0 + 6.0 * nu) * q + (20.0 + 12.0 * nu) * m2)
    }

    /// The tube at the fraction `s` of the way from this one to `top`.
    #[inline]
    pub(crate) fn blend(&self, top: &Self, s: f64) -> Self {
        let blend = |a: f64, b: f64| a + s * (b - a);
        Self {
            outer_diameter_m: blend(self.outer_diameter_m, top.outer_diameter_m),
            wall_thickness_m: blend(self.wall_thickness_m, top.wall_thickness_m),
        }
    }
}

/// Masses per length of a section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionMasses {
    /// Mass ρA, kg/m.
    pub mass_kg_per_m: f64,
    /// Mass of water that moves with it transversely, kg/m.
    pub water_kg_per_m: f64,
    /// Rotary inertia that resists bending in each plane, ρI, kg m.
    pub rotary_inertia_kg_m: Planes<f64>,
    /// Inertia about the tower's axis, ρJ = 2ρI for a tube, kg m.
    pub polar_inertia_kg_m: f64,
}

impl SectionMasses {
    /// No mass.
    pub(crate) const NONE: Self = Self {
        mass_kg_per_m: 0.0,
        water_kg_per_m: 0.0,
        rotary_inertia_kg_m: Planes {
            fore_aft: 0.0,
            side_side: 0.0,
        },
        polar_inertia_kg_m: 0.0,
    };

    /// The masses of a tube.
    #[inline]
    pub fn of_tube(tube: &Tube, material: &Material) -> Self {
        let rotary = material.density_kg_per_m3 * tube.second_moment_of_area_m4();
        Self {
            mass_kg_per_m: material.density_kg_per_m3 * tube.area_m2(),
            water_kg_per_m: 0.0,
            rotary_inertia_kg_m: Planes::both(rotary),
            polar_inertia_kg_m: 2.0 * rotary,
        }
    }
}

/// The properties of a section in a beam: masses per length, stiffnesses and shear flexibilities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// Masses per length.
    pub masses: SectionMasses,
    /// Bending stiffness EI in each plane, N m².
    pub bending_n_m2: Planes<f64>,
    /// Torsional stiffness GJ, N m².
    pub torsion_n_m2: f64,
    /// Axial stiffness EA, N.
    pub axial_n: f64,
    /// Shear flexibility 1/(κGA) in each plane, 1/N; zero for a beam without shear deformation.
    pub shear_flexibility_per_n: Planes<f64>,
    /// Springs of the soil around it.
    pub soil: SoilStiffness,
}

impl Section {
    /// The section of a tube.
    #[inline]
    pub fn of_tube(tube: &Tube, material: &Material, shear: Shear) -> Self {
        let (area, second_moment) = (tube.area_m2(), tube.second_moment_of_area_m4());
        let shear_flexibility = |kappa: f64| 1.0 / (kappa * material.shear_modulus_pa * area);
        Self {
            masses: SectionMasses::of_tube(tube, material),
            bending_n_m2: Planes::both(material.youngs_modulus_pa * second_moment),
            torsion_n_m2: material.shear_modulus_pa * 2.0 * second_moment,
            axial_n: material.youngs_modulus_pa * area,
            shear_flexibility_per_n: Planes::both(match shear {
                Shear::Rigid => 0.0,
                Shear::Cowper => {
                    shear_flexibility(tube.cowper_shear_coefficient(material.poissons_ratio()))
                }
                Shear::Coefficient(kappa) => shear_flexibility(kappa),
            }),
            soil: SoilStiffness::default(),
        }
    }

    /// All its values, for the comparison of sections.
    pub(crate) fn values(&self) -> [f64; 17] {
        let (rotary, bending) = (self.masses.rotary_inertia_kg_m, self.bending_n_m2);
        let shear = self.shear_flexibility_per_n;
        let [soil_x, soil_y, soil_z, soil_torsion, soil_rx, soil_ry] = self.soil.values();
        [
            self.masses.water_kg_per_m,
            soil_x,
            soil_y,
            soil_z,
            soil_torsion,
            soil_rx,
            soil_ry,
            self.masses.mass_kg_per_m,
            rotary.fore_aft,
            rotary.side_side,
            self.masses.polar_inertia_kg_m,
            bending.fore_aft,
            bending.side_side,
            self.torsion_n_m2,
            self.axial_n,
            shear.fore_aft,
            shear.side_side,
        ]
    }

    /// The properties used by an Euler-Bernoulli beam without rotary inertia, with names for
    /// messages.
    pub(crate) fn quantities(&self) -> [(&'static str, f64); 11] {
        let (masses, bending, soil) = (&self.masses, self.bending_n_m2, &self.soil);
        [
            ("mass", masses.mass_kg_per_m),
            ("added mass", masses.water_kg_per_m),
            ("polar inertia", masses.polar_inertia_kg_m),
            ("fore-aft bending stiffness", bending.fore_aft),
            ("side-side bending stiffness", bending.side_side),
            ("torsional stiffness", self.torsion_n_m2),
            ("axial stiffness", self.axial_n),
            (
                "transverse soil stiffness",
                soil.x_n_per_m2.max(soil.y_n_per_m2),
            ),
            ("vertical soil stiffness", soil.z_n_per_m2),
            ("torsional soil stiffness", soil.torsion_n),
            (
                "rotational soil stiffness",
                soil.rotation_x_n.max(soil.rotation_y_n),
            ),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solid_rod_has_the_textbook_area_and_second_moment() {
        let rod = Tube {
            outer_diameter_m: 2.0,
            wall_thickness_m: 1.0,
        };
        assert!((rod.area_m2() - PI).abs() < 1e-15);
        assert!((rod.second_moment_of_area_m4() - PI / 4.0).abs() < 1e-15);
    }

    #[test]
    fn cowper_solid_and_thin_limits() {
        // Cowper (1966): solid circle 6(1+ν)/(7+6ν); thin tube 2(1+ν)/(4+3ν).
        let nu = 0.3;
        let solid = Tube {
            outer_diameter_m: 1.0,
            wall_thickness_m: 0.5,
        };
        let thin = Tube {
            outer_diameter_m: 1.0,
            wall_thickness_m: 1e-9,
        };
        let close = |a: f64, b: f64| (a - b).abs() < 1e-8;
        assert!(close(
            solid.cowper_shear_coefficient(nu),
            6.0 * 1.3 / (7.0 + 1.8)
        ));
        assert!(close(thin.cowper_shear_coefficient(nu), 2.0 * 1.3 / 4.9));
    }
}
