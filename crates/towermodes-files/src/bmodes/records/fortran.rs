//! Numbers in fields as gfortran prints them; a number that does not fit its field is printed as
//! asterisks.

/// `Fw.d`.
pub(crate) fn fixed(value: f64, width: usize, digits: usize) -> String {
    if !value.is_finite() {
        return not_finite(value, width);
    }
    let text = format!("{value:.digits$}");
    // The zero before the point is left out where there is no room for it.
    let text = match text.len() > width {
        true => text.replacen("0.", ".", usize::from(value.abs() < 1.0)),
        false => text,
    };
    in_field(&text, width)
}

/// `Ew.d`: the mantissa is less than 1, and an exponent of three digits replaces the letter E.
pub(crate) fn exponential(value: f64, width: usize, digits: usize) -> String {
    if !value.is_finite() {
        return not_finite(value, width);
    }
    let text = format!("{:.*e}", digits.saturating_sub(1), value.abs());
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let mantissa = mantissa.replace('.', "");
    let exponent: i32 = exponent.parse().unwrap_or(0);
    // 1.2345 is 0.12345 times ten.
    let exponent = if value == 0.0 { 0 } else { exponent + 1 };
    let sign = if value.is_sign_negative() { "-" } else { "" };
    let text = match exponent.abs() {
        0..=99 => format!("{sign}0.{mantissa}E{exponent:+03}"),
        _ => format!("{sign}0.{mantissa}{exponent:+04}"),
    };
    in_field(&text, width)
}

/// `Iw` of a number that is not negative.
pub(crate) fn integer(value: usize, width: usize) -> String {
    in_field(&value.to_string(), width)
}

fn not_finite(value: f64, width: usize) -> String {
    let text = match (value.is_nan(), value > 0.0) {
        (true, _) => "NaN",
        (_, true) if width >= 8 => "Infinity",
        (_, true) => "Inf",
        (_, false) if width >= 9 => "-Infinity",
        (_, false) => "-Inf",
    };
    in_field(text, width)
}

fn in_field(text: &str, width: usize) -> String {
    if text.len() > width {
        "*".repeat(width)
    } else {
        format!("{text:>width$}")
    }
}

#[cfg(test)]
mod tests {
    use super::{exponential, fixed, integer};

    #[test]
    fn fixed_fields() {
        let f9_6 = |value| fixed(value, 9, 6);
        assert_eq!(f9_6(0.223645), " 0.223645");
        assert_eq!(f9_6(-0.0), "-0.000000");
        assert_eq!(f9_6(-1e-9), "-0.000000");
        assert_eq!(
            (f9_6(99.999999).as_str(), f9_6(99.9999996).as_str()),
            ("99.999999", "*********")
        );
        assert_eq!(
            (f9_6(-9.5).as_str(), f9_6(-10.0).as_str()),
            ("-9.500000", "*********")
        );
        assert_eq!(
            (f9_6(f64::NAN).as_str(), f9_6(f64::INFINITY).as_str()),
            ("      NaN", " Infinity")
        );
        assert_eq!(f9_6(1e300), "*********");
        assert_eq!(fixed(-0.5, 7, 4), "-0.5000");
        assert_eq!(fixed(-0.5, 6, 4), "-.5000");
    }

    #[test]
    fn exponential_fields() {
        let e12_5 = |value| exponential(value, 12, 5);
        assert_eq!(e12_5(1.6266), " 0.16266E+01");
        assert_eq!(e12_5(0.0081183), " 0.81183E-02");
        assert_eq!(e12_5(0.0), " 0.00000E+00");
        assert_eq!(e12_5(-0.42074), "-0.42074E+00");
        assert_eq!(e12_5(0.99999999), " 0.10000E+01");
        assert_eq!(e12_5(1e-120), " 0.10000-119");
        assert_eq!(e12_5(1e99), " 0.10000+100");
        assert_eq!(e12_5(f64::NEG_INFINITY), "   -Infinity");
        assert_eq!(exponential(1.0, 8, 5), "********");
    }

    #[test]
    fn integer_fields() {
        assert_eq!(
            (integer(7, 4).as_str(), integer(12345, 4).as_str()),
            ("   7", "****")
        );
    }
}
