//! The static balance of a floating tower as text.

use towermodes::number::digits;
use towermodes::{EquilibriumPose, StaticBalance};

/// Displacements (m) and rotations (degrees) smaller than this are omitted.
const NAMED: f64 = 5e-3;

/// "static balance: " with weights, buoyancy, forces of the lines, their sum, and the position of
/// equilibrium.
pub fn static_balance(balance: &StaticBalance) -> String {
    format!("static balance: {}", forces_and_place(balance))
}

/// Weights, buoyancy, lines, what they leave, and where they are in balance.
pub(crate) fn forces_and_place(balance: &StaticBalance) -> String {
    let force = |value_n: f64| format!("{} MN", digits(value_n / 1e6, 5));
    let equilibrium = match &balance.equilibrium {
        Ok(pose) => format!("equilibrium {}", place(pose)),
        Err(error) => error.to_string(),
    };
    let stiffness = match balance.linearized_at_equilibrium {
        true => ", where the mooring lines have their stiffness",
        false => "",
    };
    format!(
        "weight {}, buoyancy {} and mooring lines {} leave {} kN ({} % of the weight); {equilibrium}{stiffness}",
        force(balance.weight_n()),
        force(balance.buoyancy_n),
        force(balance.lines_n),
        digits(balance.residual_force_n[2] / 1e3, 4),
        digits(100.0 * balance.residual_share(), 2),
    )
}

/// A pose, as its motions that are not nearly zero.
fn place(pose: &EquilibriumPose) -> String {
    let motions = [
        ("surge", pose.surge_m, "m"),
        ("sway", pose.sway_m, "m"),
        ("heave", pose.heave_m, "m"),
        ("roll", pose.roll_deg, "degrees"),
        ("pitch", pose.pitch_deg, "degrees"),
        ("yaw", pose.yaw_deg, "degrees"),
    ];
    let named = motions.iter().filter(|(_, size, _)| size.abs() >= NAMED);
    let named: Vec<String> = named
        .map(|(motion, size, unit)| format!("{motion} {size:.2} {unit}"))
        .collect();
    match named.is_empty() {
        true => "at the reference position".to_owned(),
        false => format!("at {}", named.join(", ")),
    }
}
