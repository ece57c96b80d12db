//! The embedded part of a pile.

use std::f64::consts::PI;

/// A tubular pile from the surface of the soil down to its tip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PileTube {
    /// Outer diameter D, m.
    pub diameter_m: f64,
    /// Wall thickness t, m; half the diameter for a solid pile.
    pub wall_thickness_m: f64,
    /// Embedded length L, m.
    pub embedded_length_m: f64,
    /// Young's modulus of the pile, Pa.
    pub youngs_modulus_pa: f64,
}

impl PileTube {
    /// Length over diameter, L/D.
    pub fn slenderness(&self) -> f64 {
        self.embedded_length_m / self.diameter_m
    }

    /// Bending stiffness EI = E π (D⁴ − (D − 2t)⁴)/64, N m².
    pub fn bending_n_m2(&self) -> f64 {
        let (d, t) = (self.diameter_m, self.wall_thickness_m);
        // D⁴ − d⁴ = (D² + d²)(D + d)(D − d), without cancellation for thin walls.
        let inner = d - 2.0 * t;
        let difference = (d * d + inner * inner) * (d + inner) * (2.0 * t);
        self.youngs_modulus_pa * PI / 64.0 * difference
    }

    /// Young's modulus of the solid pile with the same diameter and bending stiffness,
    /// E_pe = EI/(π D⁴/64), Pa.
    pub fn solid_modulus_pa(&self) -> f64 {
        self.bending_n_m2() / (PI / 64.0 * self.diameter_m.powi(4))
    }
}
