//! Data that a diagram needs for verdicts: the operating speeds, and the complete structure.

use std::fmt;

use towermodes::number::four_digits;
use towermodes::tower::{FASTEST_RPM, Rotor, Rpm, Tower};
use towermodes::{Family, MissingParts, Solution};

/// Why a diagram has no verdicts and no classes.
#[derive(Debug, Clone, PartialEq)]
pub enum NotChecked {
    /// The operating speeds are unknown; the speeds of the rotor are only the ends of the diagram.
    SpeedsUnknown,
    /// No turbine of this size has these operating speeds: they are probably in another unit.
    SpeedsImplausible(Rotor),
    /// The model does not contain the whole structure.
    PartsMissing(MissingParts),
    /// The platform is not in equilibrium in the described position: the sum of weight, buoyancy
    /// and mooring forces is this vertical force, as a fraction of the weight.
    OutOfBalance(f64),
}

/// The reason: "operating speeds unknown".
impl fmt::Display for NotChecked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::SpeedsUnknown => f.write_str("operating speeds unknown"),
            Self::SpeedsImplausible(rotor) => implausible(rotor, f),
            Self::PartsMissing(parts) => parts.fmt(f),
            Self::OutOfBalance(share) => write!(
                f,
                "weight, buoyancy and mooring lines leave {:.0} % of the weight, more than {:.0} %: the platform is not in equilibrium in the described position",
                100.0 * share,
                100.0 * MOST_OUT_OF_BALANCE
            ),
        }
    }
}

/// The range of the highest operating speed of turbines for which a unit is suggested, rpm.
const LIKELY_RPM: std::ops::Range<f64> = 4.0..40.0;

/// "no turbine of this size has a rotor speed of 0.09 to 0.2 rpm; if the value is in Hz, the speed
/// is 5.4 to 12 rpm".
fn implausible(rotor: &Rotor, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let speeds = [rotor.lowest_rpm, rotor.highest_rpm];
    let [lowest, highest] = speeds.map(Rpm);
    write!(
        f,
        "no turbine of this size has a rotor speed of {lowest} to {highest} rpm"
    )?;
    let units = [("Hz", 60.0), ("rad/s", 60.0 / std::f64::consts::TAU)];
    let likely = units
        .into_iter()
        .filter(|(_, in_rpm)| LIKELY_RPM.contains(&(speeds[1] * in_rpm)));
    for (unit, in_rpm) in likely {
        let [lowest, highest] = speeds.map(|speed| four_digits(in_rpm * speed));
        write!(
            f,
            "; if the value is in {unit}, the speed is {lowest} to {highest} rpm"
        )?;
    }
    Ok(())
}

/// The highest blade tip speed of a diagram whose operating speeds are unknown, m/s; large turbines
/// have 70 to 105 m/s in operation.
const TIP_M_PER_S: f64 = 120.0;

/// The diagram ends at this multiple of the speed at which 1P crosses the first bending frequencies
/// with a rigid rotor, so that it also includes the crossing with those with a flexible rotor.
const BEYOND_FIRST: f64 = 1.1;

/// A rotor whose operating speeds are unknown: from standstill to 1.1 times the speed at which 1P
/// crosses the higher of the first bending frequencies of both planes, but with blade tip speeds of
/// at most 120 m/s.
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

/// A floating platform with a larger imbalance, as a fraction of the weight, gets no verdicts.
/// Decks in use have an imbalance of up to a few percent, because their data on ballast or lines
/// are not complete; with a draft that differs by this much it is another platform.
const MOST_OUT_OF_BALANCE: f64 = 0.1;

/// The data that a diagram of this tower and rotor lacks for verdicts.
pub(crate) fn not_checked(tower: &Tower, rotor: &Rotor, speeds_are_known: bool) -> Vec<NotChecked> {
    let parts = tower.missing_parts().cloned();
    let speeds = match speeds_are_known {
        false => Some(NotChecked::SpeedsUnknown),
        true if tower.rotor_warnings(rotor).is_empty() => None,
        true => Some(NotChecked::SpeedsImplausible(*rotor)),
    };
    let parts = parts.map(NotChecked::PartsMissing);
    let balance = out_of_balance(tower).map(NotChecked::OutOfBalance);
    speeds.into_iter().chain(parts).chain(balance).collect()
}

/// The imbalance of a floating platform, if it is too large for a verdict.
fn out_of_balance(tower: &Tower) -> Option<f64> {
    let share = tower.vertical_imbalance()?;
    (share.abs() > MOST_OUT_OF_BALANCE).then_some(share)
}

#[cfg(test)]
mod tests {
    use super::{NotChecked, not_checked};
    use towermodes::{Buoyancy, Rotor, Tower, TowerDescription};
    use towermodes_verify::towers::{floater, reference};

    const ROTOR: Rotor = Rotor {
        blades: 3,
        lowest_rpm: 5.0,
        highest_rpm: 12.0,
    };

    fn tower(description: TowerDescription) -> Tower {
        Tower::new(description).expect("a tower")
    }

    /// Buoyancy of 1.09 or 1.11 times the weight.
    #[test]
    fn a_platform_that_does_not_float_is_not_judged() {
        let reasons = |factor: f64| {
            let mut description = floater();
            let weight_n = {
                let platform = description.foundation.floating_mut().expect("it floats");
                let center_m = [0.0, 0.0];
                platform.buoyancy = Some(Buoyancy {
                    force_n: 1.0,
                    center_m,
                });
                let balance = tower(description.clone()).static_balance();
                balance.expect("a balance").weight_n()
            };
            let platform = description.foundation.floating_mut().expect("it floats");
            let center_m = [0.0, 0.0];
            let force_n = factor * weight_n;
            platform.buoyancy = Some(Buoyancy { force_n, center_m });
            not_checked(&tower(description), &ROTOR, true)
        };
        assert_eq!(reasons(1.09), []);
        let found = reasons(1.11);
        assert!(
            matches!(found[..], [NotChecked::OutOfBalance(share)] if (share - 0.11).abs() < 1e-9),
            "{found:?}"
        );
        assert_eq!(
            found[0].to_string(),
            "weight, buoyancy and mooring lines leave 11 % of the weight, more than 10 %: the platform is not in equilibrium in the described position"
        );
        // Without the buoyancy nothing is known.
        assert_eq!(not_checked(&tower(floater()), &ROTOR, true), []);
    }

    #[test]
    fn speeds_in_another_unit_are_not_judged() {
        let reasons = |lowest_rpm: f64, highest_rpm: f64| {
            let rotor = Rotor {
                lowest_rpm,
                highest_rpm,
                ..ROTOR
            };
            let reasons = not_checked(&tower(reference()), &rotor, true);
            reasons.iter().map(ToString::to_string).collect::<Vec<_>>()
        };
        assert!(reasons(5.0, 12.0).is_empty());
        assert_eq!(
            reasons(0.09, 0.2),
            [
                "no turbine of this size has a rotor speed of 0.09 to 0.2 rpm; if the value is in Hz, the speed is 5.400 to 12.00 rpm"
            ]
        );
        assert_eq!(
            reasons(0.5, 1.25),
            [
                "no turbine of this size has a rotor speed of 0.5 to 1.25 rpm; if the value is in rad/s, the speed is 4.775 to 11.94 rpm"
            ]
        );
    }
}
