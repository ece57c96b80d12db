//! Clay: resistance, secants and initial stiffness of p-y curves.

/// Lateral resistance p_u of clay per length, N/m, of two failures: the smaller one counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Resistance {
    /// Of a wedge to the surface.
    pub(super) shallow: f64,
    /// Of a flow around the pile.
    pub(super) deep: f64,
}

impl Resistance {
    /// p_u = min((3 S_u + σ′_v) D + J S_u z, 9 S_u D).
    ///
    /// Source: Matlock, *Correlations for design of laterally loaded piles in soft clay*, OTC 1204
    /// (1970); API RP 2GEO.
    pub(super) fn matlock(
        strength_pa: f64,
        effective_stress_pa: f64,
        strength_factor: f64,
        depth_m: f64,
        diameter_m: f64,
    ) -> Self {
        Self {
            shallow: (3.0 * strength_pa + effective_stress_pa) * diameter_m
                + strength_factor * strength_pa * depth_m,
            deep: 9.0 * strength_pa * diameter_m,
        }
    }

    /// p_u = min((2 c_a + σ′_v) D + 2.83 c_a z, 11 S_u D), with the mean strength c_a of the clay
    /// above.
    ///
    /// Source: Reese, Cox & Koop, *Field testing and analysis of laterally loaded piles in stiff
    /// clay*, OTC 2312 (1975), as in COSPIN.
    pub(super) fn reese(
        mean_strength_pa: f64,
        strength_pa: f64,
        effective_stress_pa: f64,
        depth_m: f64,
        diameter_m: f64,
    ) -> Self {
        Self {
            shallow: (2.0 * mean_strength_pa + effective_stress_pa) * diameter_m
                + 2.83 * mean_strength_pa * depth_m,
            deep: 11.0 * strength_pa * diameter_m,
        }
    }

    /// The smaller one. `min` would hide a value that is missing.
    pub(super) fn least(self) -> f64 {
        if self.deep < self.shallow {
            self.deep
        } else {
            self.shallow
        }
    }
}

/// The secant of Matlock's curve p = 0.5 p_u (y/y₅₀)^⅓, y₅₀ = 2.5 ε₅₀ D, to its first point in API,
/// p = 0.23 p_u at y = 0.1 y₅₀: 2.3 p_u/y₅₀, N/m². The curve itself begins vertically.
pub(super) fn api_secant(strength_n_per_m: f64, strain_50: f64, diameter_m: f64) -> f64 {
    2.3 * strength_n_per_m / (2.5 * strain_50 * diameter_m)
}

/// Initial stiffness ξ p_u/(D ε₅₀^0.25), N/m²: ξ = 10 for normally consolidated clay, 30 for
/// overconsolidated clay. With ξ = 10 it is a third to a fifth of [`api_secant`].
///
/// Source: DNV-OS-J101, as programmed in COSPIN.
pub(super) fn dnv_stiffness(
    factor: f64,
    strength_n_per_m: f64,
    strain_50: f64,
    diameter_m: f64,
) -> f64 {
    factor * strength_n_per_m / (diameter_m * strain_50.powf(0.25))
}

/// The secant 5 p_u √0.1/y_c, y_c = ε₅₀ D, N/m², of the curve p = 0.5 p_u (y/y_c)^½ for stiff clay
/// at 0.1 y_c.
///
/// The straight line k_s z y with which the curve of Reese begins is not used: it does not depend
/// on the diameter, and at some depth it is much stiffer than elastic soil.
///
/// Source: Reese, Cox & Koop, OTC 2312 (1975), with the secant that COSPIN takes.
pub(super) fn reese_stiff_clay(strength_n_per_m: f64, strain_50: f64, diameter_m: f64) -> f64 {
    5.0 * strength_n_per_m * 0.1_f64.sqrt() / (strain_50 * diameter_m)
}
