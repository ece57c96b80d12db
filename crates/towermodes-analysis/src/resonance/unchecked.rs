//! A diagram without verdicts: what it has instead, and the sentences that say so.

use towermodes::number::four_digits;
use towermodes::tower::Rpm;

use super::campbell::{Campbell, FrequencyLine};
use super::not_checked::NotChecked;
use crate::verdict::Verdict;

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
