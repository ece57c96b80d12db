//! Clay: secants and initial stiffness of p-y curves.

/// Strength p_u per length, N/m: min((3 S_u + σ′_v) D + J S_u z, 9 S_u D).
///
/// Source: Matlock, *Correlations for design of laterally loaded piles in soft clay*, OTC 1204
/// (1970); API RP 2GEO.
pub(super) fn matlock_strength(
    undrained_strength_pa: f64,
    effective_stress_pa: f64,
    strength_factor: f64,
    depth_m: f64,
    diameter_m: f64,
) -> f64 {
    let shallow = (3.0 * undrained_strength_pa + effective_stress_pa) * diameter_m
        + strength_factor * undrained_strength_pa * depth_m;
    let deep = 9.0 * undrained_strength_pa * diameter_m;
    // `min` would hide a value that is missing.
    if deep < shallow { deep } else { shallow }
}

/// The secant of Matlock's curve p = 0.5 p_u (y/y₅₀)^⅓, y₅₀ = 2.5 ε₅₀ D, to its first point in API,
/// p = 0.23 p_u at y = 0.1 y₅₀: 2.3 p_u/y₅₀, N/m². The curve itself begins vertically.
pub(super) fn api_secant(strength_n_per_m: f64, strain_50: f64, diameter_m: f64) -> f64 {
    2.3 * strength_n_per_m / (2.5 * strain_50 * diameter_m)
}

/// Initial stiffness ξ p_u/(D ε₅₀^0.25), N/m²: ξ = 10 for normally consolidated clay, 30 for
/// overconsolidated clay.
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

/// The secant 5 p_u √0.1/y_c, y_c = ε₅₀ D, N/m², of the curve for stiff clay.
///
/// Source: Reese, Cox & Koop, OTC 2312 (1975), with the secant that COSPIN takes.
pub(super) fn reese_stiff_clay(strength_n_per_m: f64, strain_50: f64, diameter_m: f64) -> f64 {
    5.0 * strength_n_per_m * 0.1_f64.sqrt() / (strain_50 * diameter_m)
}
