//! The factor by which a small dimension is drawn enlarged: one, two or five times a power of ten.

use crate::number::short;

/// An enlargement factor in a label: "×5".
pub(super) fn factor(value: f64) -> String {
    format!("\u{d7}{}", short(value, 1))
}

/// One, two or five times a power of ten: the smallest that is not below a value, or the largest
/// that is not above it.
pub(super) fn round_factor(value: f64, is_above: bool) -> f64 {
    if !(value.is_finite() && value > 0.0) {
        return 1.0;
    }
    let exponent = value.log10().floor() as i32;
    let steps = (-1..=1).flat_map(|k| [1.0, 2.0, 5.0].map(|digit| (digit, exponent + k)));
    // Negative powers are divided by, so that 0.2 is the number that is written so.
    let mut factors = steps.map(|(digit, exponent)| {
        if exponent < 0 {
            digit / 10.0_f64.powi(-exponent)
        } else {
            digit * 10.0_f64.powi(exponent)
        }
    });
    let rounding = 1e-9 * value;
    let found = if is_above {
        factors.find(|factor| *factor >= value - rounding)
    } else {
        factors.rfind(|factor| *factor <= value + rounding)
    };
    found
        .filter(|factor| factor.is_finite() && *factor > 0.0)
        .unwrap_or(1.0)
}

#[cfg(test)]
mod tests {
    use super::{factor, round_factor};

    #[test]
    fn factors_are_round() {
        for (value, above, below) in [
            (1.0, 1.0, 1.0),
            (3.0, 5.0, 2.0),
            (5.1, 10.0, 5.0),
            (0.15, 0.2, 0.1),
            (20.0, 20.0, 20.0),
            (f64::NAN, 1.0, 1.0),
            (0.0, 1.0, 1.0),
        ] {
            assert_eq!(round_factor(value, true), above, "{value}");
            assert_eq!(round_factor(value, false), below, "{value}");
        }
        assert_eq!(factor(0.5), "\u{d7}0.5");
        assert_eq!(factor(20.0), "\u{d7}20");
        assert!(round_factor(1e300, true) >= 1e300);
    }
}
