//! The embedded part of a pile.

use std::f64::consts::PI;

use super::common::{against_diameter, error, unusual};
use crate::inputs::{Input, Inputs, Limit, Quantity};
use crate::tower::error::{Problem, TowerError};
use crate::tower::warning::Warning;

/// A tubular pile from the surface of the soil down to its tip.
#[derive(Debug, Clone, Copy, PartialEq, Inputs)]
pub struct PileTube {
    /// Outer diameter D, m.
    #[input(Input::length("diameter", "the outer diameter of the pile").note("of the pile"))]
    pub diameter_m: f64,
    /// Wall thickness t, m; half the diameter for a solid pile.
    #[input(Input::length("wall_thickness", "the wall thickness of the pile"))]
    pub wall_thickness_m: f64,
    /// Embedded length L, m.
    #[input(Input::length("embedded_length", "the embedded length of the pile")
        .hint("from the surface of the soil to the tip, in m"))]
    pub embedded_length_m: f64,
    /// Young's modulus of the pile, Pa.
    #[input(Input::new("youngs_modulus", " Pa", Limit::Positive, "Young's modulus of the pile")
        .note("of the pile")
        .hint("of the pile in Pa; steel has 2.1e11")
        .usual_of(Quantity::YoungsModulus, [1e9, 1e12]))]
    pub youngs_modulus_pa: f64,
}

impl PileTube {
    /// Checks that the wall is at most half as thick as the pile.
    pub(super) fn check(&self) -> Result<(), TowerError> {
        let (value, most) = (self.wall_thickness_m, 0.5 * self.diameter_m);
        if value <= most {
            return Ok(());
        }
        let problem = Problem::TooLarge {
            quantity: "the wall thickness of the pile",
            value,
            unit: " m",
            most,
        };
        error("wall_thickness", problem)
    }

    /// Warns about dimensions outside the usual range of piles.
    pub(super) fn doubt(&self, base_diameter_m: Option<f64>, warnings: &mut Vec<Warning>) {
        warnings.extend(against_diameter(self.diameter_m, base_diameter_m));
        let wall = self.diameter_m / self.wall_thickness_m;
        warnings.extend(unusual(
            Quantity::PileWall,
            "wall_thickness",
            wall,
            [2.0, 500.0],
        ));
        let (quantity, ratio) = (Quantity::PileSlenderness, self.slenderness());
        warnings.extend(unusual(quantity, "embedded_length", ratio, [1.0, 100.0]));
    }

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
