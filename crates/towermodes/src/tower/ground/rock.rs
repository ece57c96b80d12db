//! Weak rock: the initial stiffness of p-y curves.

/// The stiffness grows to this depth in diameters below the surface of the rock.
pub(super) const GROWS_DIAMETERS: f64 = 3.0;

/// k_ir E_ir, N/m², with k_ir = 100 + 400 x_r/(3 D) to a depth x_r = 3 D below the surface of the
/// rock, and 500 below. For rock with a compressive strength of 0.5 to 5 MPa.
///
/// Source: Reese, *Analysis of laterally loaded piles in weak rock*, J. Geotech. Geoenviron. Eng.
/// 123 (1997) 1010–1017.
pub(super) fn weak_rock(youngs_modulus_pa: f64, depth_m: f64, diameter_m: f64) -> f64 {
    let share = (depth_m / (GROWS_DIAMETERS * diameter_m)).clamp(0.0, 1.0);
    (100.0 + 400.0 * share) * youngs_modulus_pa
}
