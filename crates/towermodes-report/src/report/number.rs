//! Numbers as a report writes them.

use crate::svg::superscript;

/// Frequencies are shown with at least and at most this many decimals.
const DECIMALS: std::ops::RangeInclusive<i32> = 4..=8;

/// What stands in a cell where there is nothing.
pub(super) const NOTHING: &str = "\u{2013}";

/// Values of the input with at most so many significant digits are shown as they were given.
const TYPED: usize = 6;
/// Values with more are those of somebody's arithmetic, and have so many digits here.
const DERIVED: usize = 4;

/// A value of the input: as it was given if it has at most six significant digits, else rounded to
/// four, or to a whole number where that has more; plainly where that is short, else as `2.1·10¹¹`;
/// `rigid` of an infinite one.
pub(super) fn given(value: f64) -> String {
    as_given(value, |value| {
        let size = value.abs();
        if (1e4..1e6).contains(&size) {
            return value.round();
        }
        let text = format!("{value:.after_point$e}", after_point = DERIVED - 1);
        text.parse().unwrap_or(value)
    })
}

/// A length of the input, m: as it was given if it has at most six significant digits, else to the
/// millimetre.
pub(super) fn length(value_m: f64) -> String {
    if value_m.abs() < 1.0 {
        return given(value_m);
    }
    as_given(value_m, |value_m| (value_m * 1e3).round() / 1e3)
}

fn as_given(value: f64, round: impl Fn(f64) -> f64) -> String {
    if value == f64::INFINITY {
        return "rigid".to_owned();
    }
    // The digits after these are those of a reader's arithmetic.
    let value = format!("{value:.9e}").parse().unwrap_or(value);
    let value = if significant(value) > TYPED {
        round(value)
    } else {
        value
    };
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

/// How many significant digits a number has, written as briefly as it can be.
fn significant(value: f64) -> usize {
    let text = format!("{value:e}");
    let mantissa = text.split('e').next().unwrap_or_default();
    mantissa.chars().filter(char::is_ascii_digit).count()
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
    if !(-4..6).contains(&exponent) {
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

/// A frequency with as many decimals as show the first digit of its error, Hz.
pub(super) fn frequency(value_hz: f64, error_hz: f64) -> String {
    if value_hz == 0.0 {
        return "0".to_owned();
    }
    if !(1e-4..1e6).contains(&value_hz) {
        return digits(value_hz, 6);
    }
    let decimals = 0_i32.saturating_sub(error_hz.log10().floor() as i32);
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
    use super::{digits, frequency, given, length, margin_percent, mass, percent, signed_percent};

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
    fn what_has_more_than_six_digits_is_rounded_to_four() {
        // Six digits are typed by somebody.
        assert_eq!(given(9.806_65), "9.80665");
        assert_eq!(given(9.806_652), "9.807");
        assert_eq!(given(43_701_234.0), "4.37\u{b7}10\u{2077}");
        assert_eq!(given(-0.023_456_789), "\u{2212}0.02346");
        // Digits before the point are never lost.
        assert_eq!(given(98_462.001_396_628_65), "98462");
        assert_eq!(given(347_460.22), "347460");
        assert_eq!(given(1_234.567_8), "1235");
    }

    #[test]
    fn lengths_are_shown_to_the_millimetre() {
        assert_eq!(length(129.581_63), "129.582");
        assert_eq!(length(129.582), "129.582");
        assert_eq!(length(-1_234.567_89), "\u{2212}1234.568");
        assert_eq!(length(0.000_25), "0.00025");
        assert_eq!(length(87.6), "87.6");
    }

    #[test]
    fn computed_values_have_their_digits() {
        assert_eq!(digits(347_460.22, 4), "347460");
        assert_eq!(digits(0.046_871, 4), "0.04687");
        assert_eq!(digits(9.999_96, 4), "10.00");
        assert_eq!(digits(999_999.4, 4), "1.000\u{b7}10\u{2076}");
        assert_eq!(digits(26_054_943.0, 4), "2.605\u{b7}10\u{2077}");
        assert_eq!(digits(3.3e-9, 2), "3.3\u{b7}10\u{207b}\u{2079}");
        assert_eq!(mass(349_389.9), "349.4 t");
    }

    #[test]
    fn frequencies_end_with_the_first_digit_of_their_error() {
        assert_eq!(frequency(0.324_056_78, 3.1e-6), "0.324057");
        assert_eq!(frequency(0.324_056_78, 9.9e-6), "0.324057");
        assert_eq!(frequency(0.324_056_78, 1.0e-5), "0.32406");
        assert_eq!(frequency(0.324_056_78, 0.02), "0.3241");
        assert_eq!(frequency(0.324_056_784_2, 0.0), "0.32405678");
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
