//! The circular tube: area, second moment of area, shear coefficient.

use std::f64::consts::PI;

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

    /// Second moment of area about a diameter, m⁴: I = A (d² + dᵢ²)/16, which is π/64 (d⁴ − dᵢ⁴) without its cancellation.
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
    /// Source: Cowper, *The shear coefficient in Timoshenko's beam theory*, J. Appl. Mech. 33 (1966).
    #[inline]
    pub fn cowper_shear_coefficient(&self, poissons_ratio: f64) -> f64 {
        let nu = poissons_ratio;
        let m = self.inner_diameter_m() / self.outer_diameter_m;
        let m2 = m * m;
        let q = (1.0 + m2) * (1.0 + m2);
        6.0 * (1.0 + nu) * q / ((7.0 + 6.0 * nu) * q + (20.0 + 12.0 * nu) * m2)
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
