//! The aerodynamic damping of fore-aft motion by the rotating rotor.
//!
//! If the rotor moves downwind with the velocity v, the relative wind speed decreases by v: the
//! angle of attack of each blade element at the radius r decreases by v/(Ωr) and its lift by
//! ½ρ(Ωr)² c dC_L/dα v/(Ωr) per length. The thrust of B blades decreases by c_a v with
//!
//! c_a = B ½ρΩ dC_L/dα ∫ c r dr,
//!
//! which is a dashpot at the hub. The assumptions are attached flow, constant rotor speed, and tip
//! speeds much larger than the wind speed. Source: Burton, Jenkins, Bossanyi, Sharpe & Graham,
//! *Wind Energy Handbook*, 3rd ed., eq. 5.135.

use std::f64::consts::TAU;

use towermodes::{Mode, Rotor, RotorAerodynamics};

/// The damping ratio of a mode by the rotor at one speed.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct AerodynamicDamping {
    /// Rotor speed, rpm.
    pub rotor_rpm: f64,
    /// Damping ratio.
    pub damping_ratio: f64,
}

/// Computes the aerodynamic damping ratio of a mode at the lowest and at the highest rotor speed:
///
/// ζ = c_a x²/(2 M ω),
///
/// with the fore-aft displacement x of the tower top in the mode shape, the modal mass M and ω =
/// 2πf. The hub is assumed to move like the tower top; side-side motion gets no damping, because
/// the blade elements hardly resist it.
///
/// # Example
/// See [`damping`](super::damping()).
pub fn aerodynamic_damping(
    mode: &Mode,
    rotor: &Rotor,
    aerodynamics: &RotorAerodynamics,
) -> Vec<AerodynamicDamping> {
    let mut speeds_rpm = vec![rotor.lowest_rpm, rotor.highest_rpm];
    speeds_rpm.dedup();
    let omega = TAU * mode.frequency_hz;
    let of_speed = |rotor_rpm: f64| {
        let dashpot = dashpot_n_s_per_m(rotor, aerodynamics, rotor_rpm);
        let ratio = top_mass_kg(mode).map(|mass_kg| dashpot / (2.0 * mass_kg * omega));
        AerodynamicDamping {
            rotor_rpm,
            damping_ratio: ratio.unwrap_or(0.0),
        }
    };
    speeds_rpm.into_iter().map(of_speed).collect()
}

/// c_a = B ½ρΩ dC_L/dα ∫ c r dr, N s/m.
fn dashpot_n_s_per_m(rotor: &Rotor, aerodynamics: &RotorAerodynamics, rpm: f64) -> f64 {
    let speed_rad_per_s = rpm * TAU / 60.0;
    let RotorAerodynamics {
        chord_moment_m3,
        lift_slope,
        air_density_kg_per_m3,
    } = aerodynamics;
    let blades = rotor.blades as f64;
    blades * 0.5 * air_density_kg_per_m3 * speed_rad_per_s * lift_slope * chord_moment_m3
}

/// A fore-aft motion of the top that is smaller than this fraction of the largest motion is a
/// rounding error.
const AT_REST: f64 = 1e-9;

/// The modal mass of the shape scaled to a fore-aft motion of the top of 1; none if the top has no
/// fore-aft motion.
pub(super) fn top_mass_kg(mode: &Mode) -> Option<f64> {
    let x = mode.shape.last()?.translation[0];
    (x.abs() > AT_REST).then(|| mode.modal_mass / (x * x))
}
