//! Numbers as Fortran reads them.

/// The shortest decimal form that is read back as the same number, always with a decimal point.
pub(super) fn number(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        // Minus zero is written as zero.
        return "0.0".into();
    }
    if (1e-3..1e7).contains(&size) {
        return format!("{value:?}");
    }
    let text = format!("{value:e}");
    match text.split_once('e') {
        Some((mantissa, exponent)) if mantissa.contains('.') => format!("{mantissa}E{exponent}"),
        Some((mantissa, exponent)) => format!("{mantissa}.0E{exponent}"),
        // Infinite or NaN; no tower has such numbers where this is called.
        None => text,
    }
}

/// A number rounded to fifteen digits, which all files have, without the rounding error of an
/// addition.
pub(super) fn rounded(value: f64) -> f64 {
    format!("{value:.14e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::{number, rounded};

    #[test]
    fn numbers_have_points() {
        let written = [87.6, 1.0, -0.0, 2.1e11, 1e8, 1e-7, 0.1 + 0.2].map(number);
        let expected = [
            "87.6",
            "1.0",
            "0.0",
            "2.1E11",
            "1.0E8",
            "1.0E-7",
            "0.30000000000000004",
        ];
        assert_eq!(written, expected);
        assert_eq!(rounded(97.6 - 45.1), 52.5);
    }
}
