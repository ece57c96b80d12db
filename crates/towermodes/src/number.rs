//! Numbers as people write them.
//!
//! The rule for every text that a person reads: at most seven significant digits, plainly from 1e-4
//! to 1e7 and with an exponent beyond. More digits appear only where two numbers that differ would
//! otherwise look the same ([`Apart`]), or where a text asks for so many decimals. Files that a
//! program reads back have all digits; they do not use this.

use std::fmt;

/// Significant digits of a number in a text.
const DIGITS: usize = 7;
/// Digits that show every double exactly.
const ALL_DIGITS: usize = 17;

/// Shows a number in a text: plainly where that is short, with an exponent where it is not, and
/// never with more than seven significant digits. With a precision it shows so many digits after
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

/// Shows the first of two numbers with as many digits as tell it from the second, and no fewer than
/// [`Plain`] would.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Apart(pub(crate) f64, pub(crate) f64);

impl fmt::Display for Apart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(shown, other) = *self;
        let tells = |digits: &usize| rounded(shown, *digits) != rounded(other, *digits);
        let digits = (DIGITS..ALL_DIGITS).find(tells);
        // Equal numbers need no more digits than one of them does.
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

/// Rounded to six significant digits.
pub(crate) fn significant(value: f64) -> f64 {
    rounded(value, 6)
}

/// A number with four significant digits and its trailing zeros, as frequencies are read, and with
/// an exponent below 1e-3 and from 1e5.
///
/// # Example
/// ```
/// assert_eq!(towermodes::four_digits(0.345), "0.3450");
/// assert_eq!(towermodes::four_digits(3.2e-7), "3.200e-7");
/// ```
pub fn four_digits(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !(1e-3..1e5).contains(&value.abs()) {
        return format!("{value:.3e}");
    }
    let decimals = (3.0 - value.abs().log10().floor()).max(0.0) as usize;
    format!("{value:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::{Apart, Plain, four_digits};

    #[test]
    fn four_digits_whatever_the_size() {
        let shown = [0.345, 12.1, 0.001_234, 0.0, 4321.7, 12_345.6, 3.2e-7].map(four_digits);
        assert_eq!(
            shown,
            [
                "0.3450", "12.10", "0.001234", "0", "4322", "12346", "3.200e-7"
            ]
        );
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
