//! Elastic soil: springs from Young's modulus.

/// Young's modulus E = 2 (1 + ν) G, Pa.
pub(super) fn youngs_modulus_pa(shear_modulus_pa: f64, poissons_ratio: f64) -> f64 {
    2.0 * (1.0 + poissons_ratio) * shear_modulus_pa
}

/// 1.2 E, N/m².
///
/// Source: Gazetas (1991), not checked against the original.
pub(super) fn winkler(youngs_modulus_pa: f64) -> f64 {
    1.2 * youngs_modulus_pa
}

/// 0.65 (E D⁴/(E_p I))^(1/12) E/(1 − ν²), N/m², with the bending stiffness E_p I of the pile.
///
/// Derived for long beams on the surface of an elastic half-space: softer than the soil around a
/// pile.
///
/// Source: Vesić, *Bending of beams resting on isotropic elastic solid*, J. Eng. Mech. Div. ASCE 87
/// (1961).
pub(super) fn vesic(
    youngs_modulus_pa: f64,
    poissons_ratio: f64,
    diameter_m: f64,
    bending_n_m2: f64,
) -> f64 {
    let ratio = youngs_modulus_pa * diameter_m.powi(4) / bending_n_m2;
    let plane_strain = 1.0 - poissons_ratio * poissons_ratio;
    0.65 * ratio.powf(1.0 / 12.0) * youngs_modulus_pa / plane_strain
}
