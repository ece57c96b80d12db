//! The proof of a coupled Campbell diagram and the effects that it does not include, as text.

use towermodes::number::four_digits;
use towermodes::tower::Rpm;
use towermodes_analysis::whirl::CoupledCampbell;

use super::text::{counted, listed};

/// Each sentence names at most this many rotor speeds.
const NAMED: usize = 4;

/// The effects that the coupled modes of a turbine do not include.
pub const STRUCTURE_ONLY: &str =
    "Structure only: no aerodynamics, no controller, constant rotor speed.";

/// The certificate of a coupled diagram in a sentence: "At each of 31 rotor speeds (0 to 14.52 rpm)
/// an eigenvalue count proves that no mode below 2.880 Hz is missing and that no mode is unstable."
/// Otherwise the speeds without such a proof.
pub fn proved(coupled: &CoupledCampbell) -> String {
    let limit = four_digits(coupled.limit_hz);
    let rpm = |speed: Option<f64>| Rpm(speed.unwrap_or_default()).to_string();
    let speeds: Vec<f64> = coupled.speeds.iter().map(|s| s.rotor_speed_rpm).collect();
    let open = coupled.uncertified_rpm();
    if open.is_empty() {
        return format!(
            "At each of {} ({} to {} rpm) an eigenvalue count proves that no mode below {limit} Hz is missing and that no mode is unstable.",
            counted(speeds.len(), "rotor speed"),
            rpm(speeds.first().copied()),
            rpm(speeds.last().copied())
        );
    }
    let mut named: Vec<String> = open.iter().map(|rpm| Rpm(*rpm).to_string()).collect();
    let more = named.len().saturating_sub(NAMED);
    named.truncate(NAMED);
    if more > 0 {
        named.push(format!("{more} more"));
    }
    format!(
        "Unstable or not certified at {} rpm: the rotor turns so fast that the stiffness is not positive definite, and not all modes of negative energy were found. At each of the other {} an eigenvalue count proves that no mode below {limit} Hz is missing and that no mode is unstable.",
        listed(&named),
        counted(speeds.len() - open.len(), "rotor speed")
    )
}
