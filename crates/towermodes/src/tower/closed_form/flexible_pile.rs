//! Formulas for flexible piles: Randolph (1981) and EN 1998-5, Annex C.

use super::common::SoilProfile;
use super::head::HeadStiffness;
use super::pile_tube::PileTube;

/// Randolph (1981), with G* at the depth of one diameter.
pub(super) fn randolph(tube: &PileTube, g_star_pa: f64, profile: SoilProfile) -> HeadStiffness {
    let critical_m = critical_length_m(tube, g_star_pa, profile);
    let mean_pa = mean_over(critical_m, tube.diameter_m, g_star_pa, profile);
    let homogeneity = homogeneity(profile);
    let q = (tube.solid_modulus_pa() / mean_pa).powf(1.0 / 7.0) / (homogeneity * mean_pa);
    let h = 0.5 * critical_m;
    let displacement_by_force = q * 0.27 / h;
    let coupled = q * 0.30 / (h * h);
    let rotation_by_moment = q * 0.80 * homogeneity.sqrt() / h.powi(3);
    HeadStiffness::from_compliance(displacement_by_force, coupled, rotation_by_moment)
}

/// The length l_c over which a flexible pile moves, m: D (E_pe/G_c)^(2/7), solved for l_c where
/// G_c, the mean of G* over l_c, depends on it.
pub(super) fn critical_length_m(tube: &PileTube, g_star_pa: f64, profile: SoilProfile) -> f64 {
    let d = tube.diameter_m;
    let ratio = tube.solid_modulus_pa() / g_star_pa;
    let m = exponent(profile);
    // With G* = G*_D (z/D)^m the mean over l_c is G*_D (l_c/D)^m/(1 + m).
    d * ((1.0 + m) * ratio).powf(2.0 / (7.0 + 2.0 * m))
}

fn mean_over(length_m: f64, diameter_m: f64, g_star_pa: f64, profile: SoilProfile) -> f64 {
    let m = exponent(profile);
    g_star_pa * (length_m / diameter_m).powf(m) / (1.0 + m)
}

/// ρ_c, G* at a quarter of l_c over G* at its half.
fn homogeneity(profile: SoilProfile) -> f64 {
    0.5_f64.powf(exponent(profile))
}

fn exponent(profile: SoilProfile) -> f64 {
    match profile {
        SoilProfile::Homogeneous => 0.0,
        SoilProfile::Parabolic => 0.5,
        SoilProfile::Linear => 1.0,
    }
}

/// EN 1998-5:2004, Annex C, with Young's modulus of the soil at the depth of one diameter.
pub(super) fn en_1998_5(tube: &PileTube, modulus_pa: f64, profile: SoilProfile) -> HeadStiffness {
    let [lateral, coupling, rocking] = match profile {
        SoilProfile::Homogeneous => [(1.08, 0.21), (0.22, 0.50), (0.16, 0.75)],
        SoilProfile::Parabolic => [(0.79, 0.28), (0.24, 0.53), (0.15, 0.77)],
        SoilProfile::Linear => [(0.60, 0.35), (0.17, 0.60), (0.14, 0.80)],
    }
    .map(|(a, b): (f64, f64)| a * modulus_pa * (tube.solid_modulus_pa() / modulus_pa).powf(b));
    let d = tube.diameter_m;
    HeadStiffness {
        lateral_n_per_m: lateral * d,
        coupling_n: -coupling * d * d,
        rocking_n_m: rocking * d.powi(3),
    }
}
