//! How numbers are written in every text that a person reads.
//!
//! [`Plain`] and [`Rounded`] write values of the input, [`digits`] and [`four_digits`] computed
//! values, [`end_of_range`] proved ones, [`with_error`] frequencies, [`percent`] fractions. All of
//! them write small and large numbers with an exponent. Files that a program reads back have all
//! digits; they do not use this module.

use std::fmt;

/// Significant digits of a number in a text.
const DIGITS: usize = 7;
/// Digits that show every double exactly.
const ALL_DIGITS: usize = 17;

/// Shows a number in a text: plainly where that is short, with an exponent where it is not, and
/// never with more than seven significant digits. A precision gives the number of digits after
/// the point.
///
/// # Example
/// ```
/// use towermodes::Plain;
///
/// assert_eq!(Plain(98462.00139662865).to_string(), "98462");
/// assert_eq!(Plain(0.0268).to_string(), "0.0268");
/// assert_eq!(Plain(2.1e11).to_string(), "2.1e11");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plain(
    /// The number.
    pub f64,
);

impl fmt::Display for Plain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match f.precision() {
            None => write_short(f, self.0, DIGITS),
            Some(digits) if is_plain(self.0) => write!(f, "{:.digits$}", self.0),
            Some(digits) => write!(f, "{:.digits$e}", self.0),
        }
    }
}

/// Writes the first of two numbers with as many digits as distinguish it from the second, and at
/// least as many as [`Plain`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Apart(pub(crate) f64, pub(crate) f64);

impl fmt::Display for Apart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(shown, other) = *self;
        let tells = |digits: &usize| rounded(shown, *digits) != rounded(other, *digits);
        let digits = (DIGITS..ALL_DIGITS).find(tells);
        // Equal numbers need no additional digits.
        let digits = if shown == other { Some(DIGITS) } else { digits };
        write_short(f, shown, digits.unwrap_or(ALL_DIGITS))
    }
}

fn write_short(f: &mut fmt::Formatter<'_>, value: f64, digits: usize) -> fmt::Result {
    let value = rounded(value, digits);
    if is_plain(value) {
        write!(f, "{value}")
    } else {
        write!(f, "{value:e}")
    }
}

fn is_plain(value: f64) -> bool {
    let size = value.abs();
    size == 0.0 || (1e-4..1e7).contains(&size) || !size.is_finite()
}

fn rounded(value: f64, digits: usize) -> f64 {
    let decimals = digits - 1;
    format!("{value:.decimals$e}").parse().unwrap_or(value)
}

/// A value rounded to six significant digits.
pub(crate) fn significant(value: f64) -> f64 {
    rounded(value, 6)
}

/// Shows a number with at most six significant digits, which is a millimetre of a tower and a
/// kilogram of its nacelle: plainly from 1e-4 to 1e7, with an exponent beyond.
///
/// # Example
/// ```
/// use towermodes::number::Rounded;
///
/// assert_eq!(Rounded(0.001_234_567).to_string(), "0.00123457");
/// assert_eq!(Rounded(2.1e11).to_string(), "2.1e11");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rounded(
    /// The number.
    pub f64,
);

impl fmt::Display for Rounded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // -0 + 0 is 0.
        write!(f, "{}", Plain(significant(self.0) + 0.0))
    }
}

/// A computed value with `count` significant digits, trailing zeros included: plainly from 1e-4 to
/// 1e6, with an exponent beyond.
///
/// # Example
/// ```
/// use towermodes::number::digits;
///
/// assert_eq!(digits(0.345, 4), "0.3450");
/// assert_eq!(digits(9.999_96, 4), "10.00");
/// assert_eq!(digits(3.3e-9, 2), "3.3e-9");
/// ```
#[must_use]
pub fn digits(value: f64, count: usize) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let after_point = count.saturating_sub(1);
    let scientific = format!("{value:.after_point$e}");
    let exponent = scientific.split_once('e').map(|(_, exponent)| exponent);
    match exponent.and_then(|exponent| exponent.parse::<isize>().ok()) {
        Some(exponent) if (-4..6).contains(&exponent) => {
            let decimals = after_point.saturating_add_signed(-exponent);
            format!("{value:.decimals$}")
        }
        _ => scientific,
    }
}

/// A computed value with four significant digits, as [`digits`].
#[must_use]
pub fn four_digits(value: f64) -> String {
    digits(value, 4)
}

/// The end of a range below which something is proved up to `limit`: rounded down, never up, to the
/// fewest significant digits that keep it above `last`, the last value in the range; at least
/// `count`.
///
/// # Example
/// ```
/// use towermodes::number::end_of_range;
///
/// assert_eq!(end_of_range(0.320_69, 0.3205, 4), "0.3206");
/// assert_eq!(end_of_range(0.320_669_7, 0.320_628_0, 4), "0.32066");
/// ```
#[must_use]
pub fn end_of_range(limit: f64, last: f64, count: usize) -> String {
    let is_within = |shown: &String| {
        let shown = shown.parse::<f64>();
        shown.is_ok_and(|shown| last < shown && shown <= limit)
    };
    let mut ends = (count..ALL_DIGITS).map(|count| rounded_down(limit, count));
    ends.find(is_within)
        .unwrap_or_else(|| digits(limit, ALL_DIGITS))
}

/// A positive value with `count` significant digits, as [`digits`], but rounded down.
fn rounded_down(value: f64, count: usize) -> String {
    let nearest = digits(value, count);
    if nearest.parse().is_ok_and(|nearest: f64| nearest <= value) {
        return nearest;
    }
    let last_digit = 10_f64.powf(value.log10().floor() + 1.0 - count as f64);
    digits(value - last_digit, count)
}

/// A number with at most `decimals` digits after the point and without zeros at its end.
///
/// # Example
/// ```
/// assert_eq!(towermodes::number::fixed(12.10, 3), "12.1");
/// ```
#[must_use]
pub fn fixed(value: f64, decimals: usize) -> String {
    trimmed(&format!("{value:.decimals$}")).to_owned()
}

/// A written number without zeros at its end, nor a minus sign before 0.
#[must_use]
pub fn trimmed(text: &str) -> &str {
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => text,
    };
    if text == "-0" { "0" } else { text }
}

/// A frequency, or its error, with as many decimals as show two digits of the error; at least 4 and
/// at most 11, the range of a double.
///
/// `value_hz` is the number to write: the frequency, its error, or another estimate of the
/// frequency. A value that its decimals cannot show is written as "<0.0001". Beyond 1e-4 to 1e6 Hz
/// the value has an exponent and seven digits.
///
/// # Example
/// ```
/// use towermodes::number::with_error;
///
/// assert_eq!(with_error(0.321_456_789, 0.321_456_789, 3e-6), "0.3214568");
/// assert_eq!(with_error(3e-6, 0.321_456_789, 3e-6), "0.0000030");
/// ```
#[must_use]
pub fn with_error(value_hz: f64, frequency_hz: f64, error_hz: f64) -> String {
    if frequency_hz > 0.0 && !(1e-4..1e6).contains(&frequency_hz) {
        return format!("{value_hz:.6e}");
    }
    // An error of 0 has as many decimals as there can be: log10(0) is -∞.
    let decimals = 1_i32.saturating_sub(error_hz.log10().floor() as i32);
    let decimals = usize::try_from(decimals.clamp(4, 11)).unwrap_or_default();
    let least = format!("0.{}1", "0".repeat(decimals - 1));
    if value_hz > 0.0 && least.parse().is_ok_and(|least: f64| value_hz < least) {
        return format!("<{least}");
    }
    format!("{value_hz:.decimals$}")
}

/// A fraction that was given in percent, in percent again: 5, not 5.000000000000001.
#[must_use]
pub fn percent(fraction: f64) -> f64 {
    (fraction * 1e11).round() / 1e9
}

#[cfg(test)]
mod tests {
    use super::{
        Apart, Plain, Rounded, digits, end_of_range, fixed, four_digits, percent, with_error,
    };

    #[test]
    fn four_digits_whatever_the_size() {
        let shown = [0.345, 12.1, 0.001_234, 0.0, 4321.7, 12_345.6, 3.2e-7].map(four_digits);
        assert_eq!(
            shown,
            [
                "0.3450", "12.10", "0.001234", "0", "4322", "12346", "3.200e-7"
            ]
        );
        // Rounding may carry into the next power of ten.
        let shown = [9.999_96, 999_999.4, -26_054_943.0, f64::NAN].map(four_digits);
        assert_eq!(shown, ["10.00", "1.000e6", "-2.605e7", "NaN"]);
        assert_eq!(digits(0.046_871, 2), "0.047");
    }

    #[test]
    fn the_end_of_a_range_is_within_it() {
        let ends = [
            // Enough digits, but rounded up they would be beyond the limit.
            (8.32367, 8.2),
            (0.999_96, 0.9),
            // A narrow gap, on one side of the fourth digit and across it.
            (0.320_669_7, 0.320_628_0),
            (0.320_600_1, 0.320_599_9),
            (1_234.567_891, 1_234.567_89),
            (0.0, 0.0),
        ];
        let shown = ends.map(|(limit, last)| end_of_range(limit, last, 4));
        let expected = ["8.323", "0.9999", "0.32066", "0.3206", "1234.567891", "0"];
        assert_eq!(shown, expected);
    }

    #[test]
    fn six_digits_are_shown() {
        let shown = [
            98_462.001_396,
            -0.0,
            0.001_234_567,
            1.234_567_8e-7,
            9_999_999.9,
        ]
        .map(|value| Rounded(value).to_string());
        assert_eq!(shown, ["98462", "0", "0.00123457", "1.23457e-7", "1e7"]);
        assert_eq!(Rounded(1.0 / 3.0).to_string(), "0.333333");
        assert_eq!(Rounded(2.1e11).to_string(), "2.1e11");
    }

    #[test]
    fn decimals_have_no_zeros_at_the_end() {
        let shown = [87.6, 120.0, -0.000_1, 0.5].map(|value| fixed(value, 3));
        assert_eq!(shown, ["87.6", "120", "0", "0.5"]);
    }

    #[test]
    fn frequencies_have_the_digits_that_their_error_leaves() {
        assert_eq!(with_error(0.321_456_789, 0.321_456_789, 3e-6), "0.3214568");
        assert_eq!(with_error(0.321_456_789, 0.321_456_789, 0.1), "0.3215");
        assert_eq!(with_error(0.25, 0.25, 0.0), "0.25000000000");
        assert_eq!(with_error(1e-13, 0.25, 1e-13), "<0.00000000001");
        assert_eq!(with_error(2.5e-7, 2.5e-7, 1e-9), "2.500000e-7");
    }

    #[test]
    fn margins_are_shown_as_they_were_given() {
        let shown = [0.03, 2.55, 5.0, 7.0, 12.5].map(|given| percent(given / 100.0));
        assert_eq!(shown, [0.03, 2.55, 5.0, 7.0, 12.5]);
    }

    #[test]
    fn short_numbers_stay_plain() {
        let shown = [87.6, 0.027, -1.0, 0.0, 2.1e11, 1e-9, f64::NAN].map(|x| Plain(x).to_string());
        assert_eq!(shown, ["87.6", "0.027", "-1", "0", "2.1e11", "1e-9", "NaN"]);
        assert_eq!(
            format!("{:.2} {:.2}", Plain(1.0), Plain(1.234e-9)),
            "1.00 1.23e-9"
        );
    }

    #[test]
    fn long_numbers_are_rounded_to_seven_digits() {
        let shown = [98_462.001_396_628_65, 1.0 / 3.0, 1e300 / 3.0, 9_999_999.9]
            .map(|x| Plain(x).to_string());
        assert_eq!(shown, ["98462", "0.3333333", "3.333333e299", "1e7"]);
    }

    #[test]
    fn numbers_that_differ_look_different() {
        assert_eq!(Apart(87.6, 87.600_000_001).to_string(), "87.6");
        assert_eq!(Apart(87.600_000_001, 87.6).to_string(), "87.600000001");
        assert_eq!(Apart(1.0 / 3.0, 0.5).to_string(), "0.3333333");
        assert_eq!(Apart(5.0, 5.0).to_string(), "5");
    }
}
