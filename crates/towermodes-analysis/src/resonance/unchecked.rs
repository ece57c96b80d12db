//! A diagram without verdicts: its content, and the sentences about it.

use towermodes::number::four_digits;
use towermodes::tower::Rpm;

use super::campbell::{Campbell, FrequencyLine, Margin};
use super::not_checked::NotChecked;
use crate::verdict::Verdict;

impl Campbell {
    /// The diagram without verdicts and classes, if there are reasons.
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

    /// The sentences on what is not checked: the reasons, then, if the operating speeds are
    /// unknown, the rotor speeds at which the first bending frequencies are excited.
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

    /// "1st fore-aft bending, 0.3215 Hz at standstill, meets 3P at 6.43 rpm, but not 1P, which is
    /// 0.3032 Hz at 18.19 rpm, the end of the diagram."
    fn meetings(&self, line: &FrequencyLine) -> Option<String> {
        let [_, hz] = line.points.first()?;
        let number = self.lines.iter().position(|other| other == line)?;
        let margin = |multiple: usize| {
            let mut margins = self.margins.iter();
            margins.find(|m| m.line == number && m.multiple == multiple)
        };
        let mut multiples = vec![1, self.rotor.blades];
        multiples.dedup();
        let margins: Vec<&Margin> = multiples.into_iter().filter_map(margin).collect();
        let (met, missed): (Vec<&Margin>, Vec<&Margin>) = margins
            .into_iter()
            .partition(|margin| margin.distance == 0.0);
        let met: Vec<String> = met.iter().map(|margin| at(margin)).collect();
        let met = met.join(" and ");
        let missed = self.not_met(&missed);
        let verb = match (met.is_empty(), missed.is_empty()) {
            (true, true) => return None,
            (false, true) => format!("crosses {met}"),
            (true, false) => format!("does not cross {missed}"),
            (false, false) => format!("crosses {met}, but not {missed}"),
        };
        let hz = four_digits(*hz);
        Some(format!("{}, {hz} Hz at standstill, {verb}.", line.label))
    }

    /// "1P, which is 0.3032 Hz at 18.19 rpm, the end of the diagram".
    fn not_met(&self, margins: &[&Margin]) -> String {
        let end_rpm = self.rotor.highest_rpm;
        let names = margins.iter().map(|margin| format!("{}P", margin.multiple));
        let hz = |margin: &&Margin| four_digits(margin.multiple as f64 * end_rpm / 60.0);
        let hz: Vec<String> = margins.iter().map(hz).collect();
        let names: Vec<String> = names.collect();
        let verb = match names.len() {
            0 => return String::new(),
            1 => "is",
            _ => "are",
        };
        format!(
            "{}, which {verb} {} Hz at {} rpm, the end of the diagram",
            names.join(" and "),
            hz.join(" and "),
            Rpm(end_rpm)
        )
    }
}

/// "3P at 6.43 rpm".
fn at(margin: &Margin) -> String {
    format!("{}P at {} rpm", margin.multiple, Rpm(margin.nearest_rpm))
}
