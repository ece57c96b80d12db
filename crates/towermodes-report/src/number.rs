//! The format of numbers in pictures and reports: that of [`towermodes::number`] with a minus sign
//! and powers of ten.

use towermodes::number;

/// The content of a cell without a value.
pub(crate) const NOTHING: &str = "\u{2013}";

/// Input values with at most this number of significant digits are shown as given.
const TYPED: usize = 6;
/// The number of digits of all other input values, which are results of some computation.
const DERIVED: usize = 4;

/// Typesets a number: `-1.5e-7` becomes `−1.5·10⁻⁷`.
pub(crate) fn typeset(text: &str) -> String {
    match text.split_once('e') {
        Some((mantissa, exponent)) if mantissa.ends_with(|c: char| c.is_ascii_digit()) => {
            format!("{}\u{b7}10{}", typeset(mantissa), superscript(exponent))
        }
        _ => text.replace('-', "\u{2212}"),
    }
}

/// An exponent in superscript: "-12" as "⁻¹²".
pub(crate) fn superscript(exponent: &str) -> String {
    let raised = exponent.chars().map(|c| match c {
        '-' => '\u{207b}',
        '1' => '\u{b9}',
        '2' => '\u{b2}',
        '3' => '\u{b3}',
        '0' | '4'..='9' => char::from_u32(0x2070 + (c as u32 - '0' as u32)).unwrap_or(c),
        c => c,
    });
    raised.collect()
}

/// An input value: as given if it has at most six significant digits, otherwise rounded to four
/// digits, or to an integer if that has more digits; in decimal notation if that is short,
/// otherwise as `2.1·10¹¹`; `rigid` for an infinite value.
pub(crate) fn given(value: f64) -> String {
    as_given(value, |value| {
        let size = value.abs();
        if (1e4..1e6).contains(&size) {
            return value.round();
        }
        let text = format!("{value:.after_point$e}", after_point = DERIVED - 1);
        text.parse().unwrap_or(value)
    })
}

/// A number rounded to five significant digits, for coordinates.
///
/// A scene contains thousands of numbers, and the page of the explorer requests a scene in every
/// frame; therefore a number is converted to text and back only if arithmetic could round it
/// differently.
pub(crate) fn five_digits(value: f64) -> f64 {
    let exact = || format!("{value:.4e}").parse().unwrap_or(value);
    let decade = value.abs().log10().floor();
    // A power of ten in this range is exact, so that one division or multiplication rounds once.
    let Some(places) = Some(4.0 - decade).filter(|places| places.abs() <= 22.0) else {
        return exact();
    };
    let power = 10.0_f64.powi(places.abs() as i32);
    let is_small = places > 0.0;
    let scaled = if is_small {
        value * power
    } else {
        value / power
    };
    let whole = scaled.round();
    let is_between = ((scaled - whole).abs() - 0.5).abs() < 1e-6;
    match is_between || !(1e4..1e5).contains(&scaled.abs()) {
        true => exact(),
        false if is_small => whole / power,
        false => whole * power,
    }
}

/// A length of the input, m: as given if it has at most six significant digits, otherwise to the
/// millimetre.
pub(crate) fn length(value_m: f64) -> String {
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
    if (1e-4..1e6).contains(&size) || !size.is_finite() {
        typeset(&value.to_string())
    } else {
        typeset(&format!("{value:e}"))
    }
}

/// The number of significant digits of the shortest decimal form of a number.
fn significant(value: f64) -> usize {
    let text = format!("{value:e}");
    let mantissa = text.split('e').next().unwrap_or_default();
    mantissa.chars().filter(char::is_ascii_digit).count()
}

/// A computed value with a number of significant digits.
pub(crate) fn digits(value: f64, count: usize) -> String {
    if value == f64::INFINITY {
        return "rigid".to_owned();
    }
    typeset(&number::digits(value, count))
}

/// A computed value with four significant digits: a frequency, a period.
pub(crate) fn four_digits(value: f64) -> String {
    digits(value, 4)
}

/// A value with at most this number of significant digits and without trailing zeros, for labels
/// of pictures.
pub(crate) fn short(value: f64, count: usize) -> String {
    let text = number::digits(value, count);
    let (mantissa, exponent) = text.split_at(text.find('e').unwrap_or(text.len()));
    typeset(&format!("{}{exponent}", number::trimmed(mantissa)))
}

/// A frequency with so many decimals that two digits of its error are visible, Hz.
pub(crate) fn frequency(value_hz: f64, error_hz: f64) -> String {
    if value_hz == 0.0 {
        return "0".to_owned();
    }
    typeset(&number::with_error(value_hz, value_hz, error_hz))
}

/// A fraction in percent with one decimal; 0 below 0.05 %.
pub(crate) fn percent(fraction: f64) -> String {
    let percent = 100.0 * fraction;
    if percent.abs() < 0.05 {
        return "0".to_owned();
    }
    typeset(&format!("{percent:.1}"))
}

/// A margin in percent, as it was given.
pub(crate) fn margin_percent(fraction: f64) -> String {
    given(number::percent(fraction))
}

/// A relative difference in percent with its sign, with three digits.
pub(crate) fn signed_percent(fraction: f64) -> String {
    let percent = 100.0 * fraction;
    if percent == 0.0 {
        return "0".to_owned();
    }
    let sign = if percent > 0.0 { "+" } else { "\u{2212}" };
    format!("{sign}{}", digits(percent.abs(), 3))
}

/// A mass with its unit: "350 t", or "85 kg" for a small one.
pub(crate) fn mass(value_kg: f64) -> String {
    if value_kg.abs() >= 1e3 || value_kg == 0.0 {
        format!("{} t", short(1e-3 * value_kg, 4))
    } else {
        format!("{} kg", short(value_kg, 4))
    }
}

/// A wall thickness with its unit: "27 mm".
pub(crate) fn wall(value_m: f64) -> String {
    format!("{} mm", short(1e3 * value_m, 4))
}

/// A stiffness with its unit; "rigid" for an infinite one.
pub(crate) fn stiffness(value: f64, unit: &str) -> String {
    if value == f64::INFINITY {
        return "rigid".to_owned();
    }
    format!("{} {unit}", short(value, 3))
}

#[cfg(test)]
mod tests {
    use super::{
        digits, five_digits, four_digits, frequency, given, length, mass, percent, short,
        signed_percent, stiffness, wall,
    };

    #[test]
    fn coordinates_have_five_digits() {
        assert_eq!(five_digits(0.322_126_8), 0.322_13);
        assert_eq!(five_digits(-123_456.0), -123_460.0);
        assert_eq!(five_digits(0.0), 0.0);
    }

    /// The arithmetic gives the same result as conversion to text and back, also for ties, next to
    /// powers of ten, and at the limits of double precision.
    #[test]
    fn five_digits_are_those_of_the_text() {
        let mut values = vec![
            1.0, 9.999_95, 99_999.5, 0.123_455, 1e-320, 1e308, 1e22, 1e-22,
        ];
        let mut seed = 1_u64;
        for _ in 0..200_000 {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let share = (seed >> 11) as f64 / (1_u64 << 53) as f64;
            let decade = ((seed >> 3) % 60) as i32 - 30;
            values.push((share - 0.5) * 10.0_f64.powi(decade));
            // A tie in its decimals.
            values.push(((share * 1e5).floor() + 0.5) / 10.0_f64.powi(decade.rem_euclid(12)));
        }
        for value in values.into_iter().flat_map(|value| [value, -value]) {
            let text: f64 = format!("{value:.4e}").parse().expect("a number");
            assert_eq!(five_digits(value), text, "{value:e}");
        }
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
        assert_eq!(four_digits(0.000_812_34), "0.0008123");
    }

    #[test]
    fn labels_are_short() {
        assert_eq!(short(0.322_126, 4), "0.3221");
        assert_eq!(short(1.15e6, 3), "1.15\u{b7}10\u{2076}");
        assert_eq!(short(-4.95e8, 3), "\u{2212}4.95\u{b7}10\u{2078}");
        assert_eq!(short(1.0e-5, 3), "1\u{b7}10\u{207b}\u{2075}");
        assert_eq!(short(0.0, 3), "0");
        assert_eq!(short(120.0, 2), "120");
    }

    #[test]
    fn quantities_have_units() {
        assert_eq!(wall(0.0351), "35.1 mm");
        assert_eq!(mass(349_389.9), "349.4 t");
        assert_eq!(mass(350e3), "350 t");
        assert_eq!(mass(85.0), "85 kg");
        assert_eq!(stiffness(f64::INFINITY, "N/m"), "rigid");
    }

    #[test]
    fn frequencies_show_two_digits_of_their_error() {
        assert_eq!(frequency(0.324_056_78, 3.1e-6), "0.3240568");
        assert_eq!(frequency(0.324_056_78, 1.0e-5), "0.324057");
        assert_eq!(frequency(0.324_056_78, 0.02), "0.3241");
        assert_eq!(frequency(2.5e-7, 1e-9), "2.500000\u{b7}10\u{207b}\u{2077}");
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
