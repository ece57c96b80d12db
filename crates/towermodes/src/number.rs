//! Numbers as people write them.

use std::fmt;

/// Shows a number plainly where that is short, with an exponent where it is not; with a precision, so many digits after the point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Plain(pub(crate) f64);

impl fmt::Display for Plain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        let plainly = size == 0.0 || (1e-4..1e7).contains(&size) || !size.is_finite();
        match (plainly, f.precision()) {
            (true, None) => write!(f, "{}", self.0),
            (true, Some(digits)) => write!(f, "{:.digits$}", self.0),
            (false, None) => write!(f, "{:e}", self.0),
            (false, Some(digits)) => write!(f, "{:.digits$e}", self.0),
        }
    }
}

/// To six digits.
pub(crate) fn significant(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// Four digits, zeros at the end too, as frequencies are read: "0.3450"; with an exponent far from 1.
pub(crate) fn four_digits(value: f64) -> String {
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
    use super::{Plain, four_digits};

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
}
