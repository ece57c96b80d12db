//! Numbers with their units, as labels say them.

use crate::svg::{number, superscript};

const MINUS: &str = "\u{2212}";

/// A number with so many significant digits and no zeros at its end; a power of ten where it is far
/// from one.
pub(super) fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return number(value, 1.0);
    }
    let exponent = value.abs().log10().floor();
    if (-3.0..6.0).contains(&exponent) {
        let decimals = (digits as f64 - 1.0 - exponent).clamp(0.0, 9.0) as usize;
        return fixed(value, decimals);
    }
    let text = format!("{value:.precision$e}", precision = digits - 1);
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    format!("{}\u{b7}10{}", trimmed(mantissa), superscript(exponent))
}

/// A number with at most so many decimals; without zeros at its end.
fn fixed(value: f64, decimals: usize) -> String {
    trimmed(&format!("{value:.decimals$}"))
}

fn trimmed(text: &str) -> String {
    let text = if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        text
    };
    if text == "-0" {
        return "0".to_owned();
    }
    text.replace('-', MINUS)
}

/// A height or a length in m, to the millimetre: "87.6".
pub(super) fn metres(value_m: f64) -> String {
    if value_m.abs() < 1e7 && (value_m == 0.0 || value_m.abs() >= 1e-3) {
        return fixed(value_m, 3);
    }
    significant(value_m, 4)
}

/// A wall with its unit: "27 mm".
pub(super) fn wall(value_m: f64) -> String {
    format!("{} mm", significant(1e3 * value_m, 4))
}

/// A mass with its unit: "350 t", "85 kg".
pub(super) fn mass(value_kg: f64) -> String {
    if value_kg.abs() >= 1e3 || value_kg == 0.0 {
        return format!("{} t", significant(1e-3 * value_kg, 4));
    }
    format!("{} kg", significant(value_kg, 3))
}

/// A stiffness with its unit; "rigid" where it is infinite.
pub(super) fn stiffness(value: f64, unit: &str) -> String {
    if value == f64::INFINITY {
        return "rigid".to_owned();
    }
    format!("{} {unit}", significant(value, 3))
}

/// A frequency in Hz to four digits, zeros at its end too, without its unit.
pub(super) fn frequency(value_hz: f64) -> String {
    let exponent = value_hz.abs().log10().floor();
    if !(-3.0..4.0).contains(&exponent) {
        return significant(value_hz, 4);
    }
    let decimals = (3.0 - exponent) as usize;
    format!("{value_hz:.decimals$}")
}

/// A factor that something is drawn larger by: "×5".
pub(super) fn factor(value: f64) -> String {
    format!("\u{d7}{}", significant(value, 1))
}

/// One, two or five times a power of ten: the least that is not below a number, or the greatest
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
    use super::{factor, frequency, mass, metres, round_factor, significant, stiffness, wall};

    #[test]
    fn numbers_are_short() {
        assert_eq!(significant(0.322_126, 4), "0.3221");
        assert_eq!(significant(1.15e6, 3), "1.15\u{b7}10\u{2076}");
        assert_eq!(significant(-4.95e8, 3), "\u{2212}4.95\u{b7}10\u{2078}");
        assert_eq!(significant(1.0e-4, 3), "1\u{b7}10\u{207b}\u{2074}");
        assert_eq!(significant(0.0, 3), "0");
        assert_eq!(significant(120.0, 2), "120");
    }

    #[test]
    fn quantities_have_units() {
        assert_eq!(metres(87.6), "87.6");
        assert_eq!(metres(-45.0), "\u{2212}45");
        assert_eq!(metres(-0.0), "0");
        assert_eq!(metres(1_000_030.5), "1000030.5");
        assert_eq!(wall(0.0351), "35.1 mm");
        assert_eq!(mass(350e3), "350 t");
        assert_eq!(mass(85.0), "85 kg");
        assert_eq!(stiffness(f64::INFINITY, "N/m"), "rigid");
        assert_eq!(frequency(0.184), "0.1840");
        assert_eq!(frequency(11.964), "11.96");
        assert_eq!(frequency(0.0), "0");
        assert_eq!(frequency(0.000_812_34), "8.123\u{b7}10\u{207b}\u{2074}");
        assert_eq!(factor(0.5), "\u{d7}0.5");
        assert_eq!(factor(20.0), "\u{d7}20");
    }

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
        assert!(round_factor(1e300, true) >= 1e300);
    }
}
