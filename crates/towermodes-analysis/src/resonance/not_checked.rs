//! What a diagram must know before it can judge: the operating speeds, and the whole structure.

use std::fmt;

use towermodes::tower::{FASTEST_RPM, Rotor, Tower};
use towermodes::{Family, MissingParts, Solution};

/// Why a diagram has no verdicts and no classes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NotChecked {
    /// The operating speeds are unknown; those of the rotor are only the ends of the diagram.
    SpeedsUnknown,
    /// The frequencies are not those of the whole structure.
    PartsMissing(MissingParts),
}

/// The reason: "operating speeds unknown".
impl fmt::Display for NotChecked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::SpeedsUnknown => f.write_str("operating speeds unknown"),
            Self::PartsMissing(parts) => parts.fmt(f),
        }
    }
}

/// The fastest blade tips of a diagram whose operating speeds are unknown, m/s; those of large
/// turbines in operation move at 70 to 105 m/s.
const TIP_M_PER_S: f64 = 120.0;

/// The diagram ends at this multiple of the speed at which 1P meets the first bending frequencies
/// with a rigid rotor, so that it meets those with a flexible rotor too.
const BEYOND_FIRST: f64 = 1.1;

/// A rotor whose operating speeds are unknown: from standstill to 1.1 times the speed at which 1P
/// meets the higher of the first bending frequencies of both planes, but with blade tips of at most
/// 120 m/s.
///
/// It gives the ends of a diagram without verdicts, see
/// [`CampbellOptions::speeds_are_known`](super::CampbellOptions::speeds_are_known).
#[must_use]
pub fn unknown_speeds(blades: usize, solution: &Solution, tip_radius_m: Option<f64>) -> Rotor {
    let moving = || solution.modes.iter().filter(|mode| mode.frequency_hz > 0.0);
    let first_of = |family: Family| moving().find(|mode| mode.family == family);
    let planes = [Family::ForeAft, Family::SideSide].into_iter();
    let first_hz = planes.filter_map(first_of).map(|mode| mode.frequency_hz);
    let first_hz = first_hz.reduce(f64::max);
    let lowest_hz = || moving().next().map_or(1.0, |mode| mode.frequency_hz);
    let first_hz = first_hz.unwrap_or_else(lowest_hz);
    let of_tips = tip_radius_m.filter(|radius_m| *radius_m > 0.0);
    let of_tips = of_tips.map(|radius_m| TIP_M_PER_S / radius_m * 60.0 / std::f64::consts::TAU);
    Rotor {
        blades,
        lowest_rpm: 0.0,
        highest_rpm: of_tips
            .unwrap_or(f64::INFINITY)
            .min(BEYOND_FIRST * 60.0 * first_hz)
            .min(FASTEST_RPM),
    }
}

/// What is unknown about a tower and its rotor.
pub(crate) fn not_checked(tower: &Tower, speeds_are_known: bool) -> Vec<NotChecked> {
    let parts = tower.missing_parts().cloned();
    let speeds = (!speeds_are_known).then_some(NotChecked::SpeedsUnknown);
    let parts = parts.map(NotChecked::PartsMissing);
    speeds.into_iter().chain(parts).collect()
}
