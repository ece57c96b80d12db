//! Distances in percent, with enough digits to distinguish them from the margin.

use towermodes::tower::Rpm;

use super::campbell::{Campbell, Margin};
use crate::verdict::Verdict;

/// The largest number of decimals.
const MOST_DIGITS: usize = 6;

impl Campbell {
    /// A distance in percent with its sign and one decimal: "+12.3"; with more decimals where
    /// rounding would move it to or across the margin or twice the margin: "+4.96" for a margin of
    /// 5 %.
    #[must_use]
    pub fn distance_percent(&self, margin: &Margin) -> String {
        signed_percent(margin.distance, self.margin)
    }

    /// The distance in the form that tables show: "+12.3 %", "crossing", or the rotor speed from
    /// which the mode is missing, if this is the only reason for the warning.
    #[must_use]
    pub fn distance_text(&self, margin: &Margin) -> String {
        match (self.missing_from_rpm(margin), margin.distance) {
            (Some(rpm), _) => format!("no mode from {} rpm", Rpm(rpm)),
            (None, 0.0) => "crossing".to_owned(),
            (None, _) => self.short_percent(margin) + " %",
        }
    }

    /// A distance in percent with its sign: without decimals if it is ten times the frequency.
    pub(super) fn short_percent(&self, margin: &Margin) -> String {
        match margin.distance {
            share if share.abs() < 9.995 => self.distance_percent(margin),
            share => format!("{:+.0}", 100.0 * share),
        }
    }

    /// The rotor speed (rpm) from which the mode of a pair is missing, if this is the only reason
    /// for the warning: up to the end of its line the distance is large enough.
    #[must_use]
    pub fn missing_from_rpm(&self, margin: &Margin) -> Option<f64> {
        let line = self.lines.get(margin.line)?;
        let end = line.lost?;
        let towards = line.error_hz / margin.natural_hz;
        let is_apart = margin.distance.abs() - towards >= self.margin;
        (margin.verdict == Verdict::Warn && is_apart).then_some(end.rotor_speed_rpm)
    }
}

fn signed_percent(distance: f64, margin: f64) -> String {
    let percent = 100.0 * distance;
    let text = |digits: usize| format!("{percent:+.digits$}");
    let limits = [1.0, 2.0].map(|times| times * 100.0 * margin);
    let is_telling = |text: &String| {
        let shown = text.parse::<f64>().unwrap_or(percent).abs();
        // A distance exactly at the limit needs no more digits.
        let tells = |limit: &f64| {
            let (seen, real) = (shown - limit, percent.abs() - limit);
            real.abs() < 1e-9 || (seen.abs() > 1e-9 && seen.signum() == real.signum())
        };
        limits.iter().all(tells)
    };
    let mut texts = (1..MOST_DIGITS).map(text);
    texts.find(is_telling).unwrap_or_else(|| text(MOST_DIGITS))
}

#[cfg(test)]
mod tests {
    use super::signed_percent;

    #[test]
    fn a_distance_is_on_its_side_of_the_margin() {
        let said = |percent: f64| signed_percent(percent / 100.0, 0.05);
        assert_eq!(said(12.34), "+12.3");
        assert_eq!(said(-4.9), "-4.9");
        assert_eq!(said(4.96), "+4.96");
        assert_eq!(said(-4.9996), "-4.9996");
        assert_eq!(said(5.04), "+5.04");
        assert_eq!(said(9.97), "+9.97");
        assert_eq!(said(-10.04), "-10.04");
        assert_eq!(said(5.0), "+5.0");
        // 5.000 000 01: six digits are the most.
        assert_eq!(said(5.000_000_01), "+5.000000");
    }

    /// The margin may have more digits: 7.24 is less than 7.25 and must not be shown as larger.
    #[test]
    fn a_margin_between_tenths_is_kept_apart() {
        assert_eq!(signed_percent(0.0724, 0.0725), "+7.2");
        assert_eq!(signed_percent(0.0728, 0.0725), "+7.3");
        assert_eq!(signed_percent(0.0722, 0.0721), "+7.22");
    }
}
