//! The damping of fore-aft motion by the running rotor in the wind.
//!
//! A rotor that moves downwind with the velocity v sees less wind: each blade element at the radius
//! r has the angle of attack less by v/(Ωr) and the lift less by ½ρ(Ωr)² c dC_L/dα v/(Ωr) per
//! length. The thrust of B blades falls by c_a v with
//!
//! c_a = B ½ρΩ dC_L/dα ∫ c r dr,
//!
//! which is a dashpot at the hub. Attached flow, a speed of rotation that does not change, and tip
//! speeds well above the wind speed are assumed. Source: Burton, Jenkins, Bossanyi, Sharpe &
//! Graham, *Wind Energy Handbook*, 3rd ed., eq. 5.135.

use std::f64::consts::TAU;

use towermodes::{Mode, Rotor, RotorAerodynamics};

/// The damping ratio of a mode by the rotor at one speed.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct AerodynamicDamping {
    /// Speed of the rotor, rpm.
    pub rotor_rpm: f64,
    /// Damping ratio.
    pub damping_ratio: f64,
}

/// Computes the damping ratio of a mode by the rotor at its lowest and at its highest speed:
///
/// ζ = c_a x²/(2 M ω),
///
/// with x the fore-aft motion of the tower top in the shape of the mode, M its modal mass and
/// ω = 2πf. The hub is taken to move as the tower top; motion side-side, which the same elements
/// hardly resist, is not damped.
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

/// Tops that move less than this fraction of the largest motion do so by rounding.
const AT_REST: f64 = 1e-9;

/// The modal mass of a shape whose top moves fore-aft by 1; none if it does not move so.
pub(super) fn top_mass_kg(mode: &Mode) -> Option<f64> {
    let x = mode.shape.last()?.translation[0];
    (x.abs() > AT_REST).then(|| mode.modal_mass / (x * x))
}
