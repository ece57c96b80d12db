//! Numbers as a report writes them.

use crate::svg::superscript;

/// Frequencies are shown with at least this many decimals, and at most with those a number holds.
const DECIMALS: std::ops::RangeInclusive<i32> = 4..=11;

/// What stands in a cell where there is nothing.
pub(super) const NOTHING: &str = "\u{2013}";

/// A value as it was given, to ten digits: plainly where that is short, else as `2.1·10¹¹`; `rigid` of an infinite one.
pub(super) fn given(value: f64) -> String {
    if value == f64::INFINITY {
        return "rigid".to_owned();
    }
    // The digits after these are those of a reader's arithmetic.
    let value = format!("{value:.9e}").parse().unwrap_or(value);
    let size = value.abs();
    if size == 0.0 {
        return "0".to_owned();
    }
    let text = if (1e-4..1e6).contains(&size) || !size.is_finite() {
        value.to_string()
    } else {
        with_power(&format!("{value:e}"))
    };
    text.replace('-', "\u{2212}")
}

/// A value that was computed, in so many significant digits.
pub(super) fn digits(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return given(value);
    }
    let after_point = digits.saturating_sub(1);
    let rounded = format!("{value:.after_point$e}");
    let Some((_, exponent)) = rounded.split_once('e') else {
        return rounded;
    };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if !(-4..9).contains(&exponent) {
        return with_power(&rounded).replace('-', "\u{2212}");
    }
    let decimals = i32::try_from(after_point).unwrap_or(0) - exponent;
    let decimals = usize::try_from(decimals).unwrap_or(0);
    format!("{value:.decimals$}").replace('-', "\u{2212}")
}

/// `1.5e-7` as `1.5·10⁻⁷`.
fn with_power(text: &str) -> String {
    let Some((mantissa, exponent)) = text.split_once('e') else {
        return text.to_owned();
    };
    format!("{mantissa}\u{b7}10{}", superscript(exponent))
}

/// A frequency with as many decimals as show two digits of its error, Hz.
pub(super) fn frequency(value_hz: f64, error_hz: f64) -> String {
    if value_hz == 0.0 {
        return "0".to_owned();
    }
    if !(1e-4..1e6).contains(&value_hz) {
        return digits(value_hz, 6);
    }
    let decimals = 1_i32.saturating_sub(error_hz.log10().floor() as i32);
    let decimals = decimals.clamp(*DECIMALS.start(), *DECIMALS.end());
    let decimals = usize::try_from(decimals).unwrap_or(4);
    format!("{value_hz:.decimals$}")
}

/// A frequency for people, with four decimals or four digits, Hz.
pub(super) fn short_frequency(value_hz: f64) -> String {
    if (0.1..1e4).contains(&value_hz) {
        format!("{value_hz:.4}")
    } else {
        digits(value_hz, 4)
    }
}

/// An error, in two digits.
pub(super) fn error(value: f64) -> String {
    digits(value, 2)
}

/// A share in percent, without a digit that says nothing.
pub(super) fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    if percent.abs() < 0.05 {
        return "0".to_owned();
    }
    format!("{percent:.1}").replace('-', "\u{2212}")
}

/// A margin in percent, as it was given.
pub(super) fn margin_percent(share: f64) -> String {
    given(100.0 * share)
}

/// A relative difference in percent with its sign, to three digits.
pub(super) fn signed_percent(share: f64) -> String {
    let percent = 100.0 * share;
    if percent == 0.0 {
        return "0".to_owned();
    }
    let sign = if percent > 0.0 { "+" } else { "\u{2212}" };
    format!("{sign}{}", digits(percent.abs(), 3))
}

/// "1 mode", "2 modes".
pub(super) fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

/// A mass in tonnes, or in kilograms where it is small.
pub(super) fn mass(kg: f64) -> String {
    if kg >= 1000.0 {
        format!("{} t", digits(kg / 1000.0, 4))
    } else {
        format!("{} kg", digits(kg, 4))
    }
}

#[cfg(test)]
mod tests {
    use super::{digits, frequency, given, margin_percent, mass, percent, signed_percent};

    #[test]
    fn margins_are_shown_as_they_were_given() {
        let shown = [0.03, 2.55, 5.0, 7.0, 12.5].map(|percent| margin_percent(percent / 100.0));
        assert_eq!(shown, ["0.03", "2.55", "5", "7", "12.5"]);
    }

    #[test]
    fn values_are_shown_as_they_were_given() {
        assert_eq!(given(0.027), "0.027");
        assert_eq!(given(2.1e11), "2.1\u{b7}10\u{b9}\u{b9}");
        assert_eq!(given(-4.2e-7), "\u{2212}4.2\u{b7}10\u{207b}\u{2077}");
        assert_eq!(given(f64::INFINITY), "rigid");
        assert_eq!(given(-0.0), "0");
        assert_eq!(given(22.750_000_000_002_6), "22.75");
    }

    #[test]
    fn computed_values_have_their_digits() {
        assert_eq!(digits(347_460.22, 4), "347460");
        assert_eq!(digits(0.046_871, 4), "0.04687");
        assert_eq!(digits(9.999_96, 4), "10.00");
        assert_eq!(digits(3.3e-9, 2), "3.3\u{b7}10\u{207b}\u{2079}");
        assert_eq!(mass(349_389.9), "349.4 t");
    }

    #[test]
    fn frequencies_show_two_digits_of_their_error() {
        assert_eq!(frequency(0.324_056_78, 3.1e-6), "0.3240568");
        assert_eq!(frequency(0.324_056_78, 0.02), "0.3241");
        assert_eq!(frequency(0.324_056_78, 0.0), "0.32405678000");
        assert_eq!(frequency(0.0, 0.0), "0");
    }

    #[test]
    fn percents_have_signs_where_they_are_differences() {
        assert_eq!(percent(0.1234), "12.3");
        assert_eq!(percent(-1e-9), "0");
        assert_eq!(signed_percent(0.000_123), "+0.0123");
        assert_eq!(signed_percent(-0.051), "\u{2212}5.10");
        assert_eq!(signed_percent(1.2e-9), "+1.20\u{b7}10\u{207b}\u{2077}");
    }
}
