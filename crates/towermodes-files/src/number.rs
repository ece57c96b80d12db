//! Numbers in notes, as people write them.

use std::fmt;

/// A number with six significant digits, which is a millimetre of a tower and a kilogram of its
/// machine: plain where that is short, with an exponent where it is not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rounded(pub(crate) f64);

impl fmt::Display for Rounded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rounded: f64 = format!("{:.5e}", self.0).parse().unwrap_or(self.0);
        let size = rounded.abs();
        match size == 0.0 || (1e-4..1e7).contains(&size) || !size.is_finite() {
            // Not -0.
            true => write!(f, "{}", rounded + 0.0),
            false => write!(f, "{rounded:e}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Rounded;

    #[test]
    fn six_digits_are_shown() {
        let shown = |value: f64| Rounded(value).to_string();
        assert_eq!(shown(98_462.001_396_628_65), "98462");
        assert_eq!(shown(87.600_000_000_1), "87.6");
        assert_eq!(shown(-0.0), "0");
        assert_eq!(shown(0.001_234_567), "0.00123457");
        assert_eq!(shown(2.1e11), "2.1e11");
        assert_eq!(shown(1.234_567_8e-7), "1.23457e-7");
        assert_eq!(shown(9_999_999.9), "1e7");
    }
}
