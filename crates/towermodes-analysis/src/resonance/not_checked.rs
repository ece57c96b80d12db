//! What a diagram must know before it can judge: the operating speeds, and the whole structure.

use std::fmt;

use towermodes::number::four_digits;
use towermodes::tower::{FASTEST_RPM, Rotor, Rpm, Tower};
use towermodes::{Family, MissingParts, Solution};

use super::campbell::{Campbell, FrequencyLine};
use crate::verdict::Verdict;

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

/// A rotor whose operating speeds are unknown: from standstill to the speed at which 1P meets the
/// lowest bending frequency, but with blade tips of at most 120 m/s.
///
/// It gives the ends of a diagram without verdicts, see
/// [`CampbellOptions::speeds_are_known`](super::CampbellOptions::speeds_are_known).
#[must_use]
pub fn unknown_speeds(blades: usize, solution: &Solution, tip_radius_m: Option<f64>) -> Rotor {
    let bends = |family: Family| matches!(family, Family::ForeAft | Family::SideSide);
    let moving = || solution.modes.iter().filter(|mode| mode.frequency_hz > 0.0);
    let first = moving().find(|mode| bends(mode.family));
    let first_hz = first.or(moving().next()).map_or(1.0, |m| m.frequency_hz);
    let of_tips = tip_radius_m.filter(|radius_m| *radius_m > 0.0);
    let of_tips = of_tips.map(|radius_m| TIP_M_PER_S / radius_m * 60.0 / std::f64::consts::TAU);
    Rotor {
        blades,
        lowest_rpm: 0.0,
        highest_rpm: of_tips
            .unwrap_or(f64::INFINITY)
            .min(60.0 * first_hz)
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

impl Campbell {
    /// Without verdicts and classes, if there are reasons.
    pub(crate) fn unless(mut self, reasons: Vec<NotChecked>) -> Self {
        if !reasons.is_empty() {
            for margin in &mut self.margins {
                margin.verdict = Verdict::Undecided;
            }
            self.classes.clear();
        }
        self.not_checked = reasons;
        self
    }

    /// Whether the speeds of the rotor are operating speeds; otherwise they are the ends of the
    /// diagram.
    #[must_use]
    pub fn speeds_are_known(&self) -> bool {
        !self.not_checked.contains(&NotChecked::SpeedsUnknown)
    }

    /// The sentences on what is not checked: the reasons, then the rotor speeds at which the first
    /// bending frequencies are excited, where the operating speeds are what is unknown.
    pub(super) fn unchecked(&self) -> Vec<String> {
        let reasons = self.not_checked.iter();
        let reasons = reasons.map(|reason| format!("Not checked: {reason}."));
        let is_only_rotor = self.not_checked == [NotChecked::SpeedsUnknown];
        let firsts = self.first_bending.iter().filter(|_| is_only_rotor);
        let lines = firsts.filter_map(|index| self.lines.get(*index));
        reasons
            .chain(lines.filter_map(|line| self.meetings(line)))
            .collect()
    }

    /// "1st fore-aft bending, 0.3215 Hz at standstill, meets 1P at 19.29 rpm and 3P at 6.43 rpm."
    fn meetings(&self, line: &FrequencyLine) -> Option<String> {
        let [_, hz] = line.points.first()?;
        let number = self.lines.iter().position(|other| other == line)?;
        let met = |multiple: usize| {
            let mut margins = self.margins.iter();
            let own = margins.find(|m| m.line == number && m.multiple == multiple)?;
            let rpm = Rpm(own.nearest_rpm);
            Some(match own.distance {
                0.0 => format!("meets {multiple}P at {rpm} rpm"),
                _ => format!(
                    "does not meet {multiple}P up to {} rpm",
                    Rpm(self.rotor.highest_rpm)
                ),
            })
        };
        let mut multiples = vec![1, self.rotor.blades];
        multiples.dedup();
        let met: Vec<String> = multiples.into_iter().filter_map(met).collect();
        (!met.is_empty()).then(|| {
            format!(
                "{}, {} Hz at standstill, {}.",
                line.label,
                four_digits(*hz),
                met.join(" and ")
            )
        })
    }
}
