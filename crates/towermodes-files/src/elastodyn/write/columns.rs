//! Columns of numbers with only as many digits as they need.

/// Smallest number of digits.
const LEAST_DIGITS: usize = 9;
/// Number of digits that represents any number exactly.
const ALL_DIGITS: usize = 17;
/// Digits are added until no number is changed by more than this fraction.
const TOLERANCE: f64 = 1e-13;

/// A column of numbers with as many digits as all of them need, the same for each.
pub(crate) fn column(values: &[f64]) -> Vec<String> {
    in_fewest_digits(values, |printed| {
        let mut pairs = printed.iter().zip(values);
        pairs.all(|(printed, value)| (printed - value).abs() <= TOLERANCE * value.abs())
    })
}

/// A column of heights: additionally, increasing heights still increase when they are read back.
pub(super) fn rising_column(values: &[f64]) -> Vec<String> {
    in_fewest_digits(values, |printed| {
        let rises = printed.windows(2).all(|pair| pair[1] > pair[0]);
        let mut pairs = printed.iter().zip(values);
        rises && pairs.all(|(printed, value)| (printed - value).abs() <= TOLERANCE)
    })
}

fn in_fewest_digits(values: &[f64], is_enough: impl Fn(&[f64]) -> bool) -> Vec<String> {
    let printed = |digits: usize| -> Vec<String> {
        let texts = values.iter().map(|&value| scientific(value, digits));
        texts.collect()
    };
    for digits in LEAST_DIGITS..ALL_DIGITS {
        let texts = printed(digits);
        let read = texts.iter().map(|text| text.parse().unwrap_or(f64::NAN));
        if is_enough(&read.collect::<Vec<f64>>()) {
            return texts;
        }
    }
    printed(ALL_DIGITS)
}

/// A number with this number of digits in the format of Fortran programs: `1.00474549E-01`.
fn scientific(value: f64, digits: usize) -> String {
    let decimals = digits - 1;
    let text = format!("{value:.decimals$e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let (sign, exponent) = match exponent.strip_prefix('-') {
        Some(exponent) => ('-', exponent),
        None => ('+', exponent),
    };
    format!("{mantissa}E{sign}{exponent:0>2}")
}

#[cfg(test)]
mod tests {
    use super::{column, rising_column, scientific};

    #[test]
    fn numbers_are_written_as_fortran_does() {
        assert_eq!(scientific(0.0, 9), "0.00000000E+00");
        assert_eq!(scientific(6.14343e11, 9), "6.14343000E+11");
        assert_eq!(scientific(0.1, 9), "1.00000000E-01");
        assert_eq!(scientific(-1.5e-200, 9), "-1.50000000E-200");
    }

    #[test]
    fn a_column_has_the_digits_that_its_longest_number_needs() {
        assert_eq!(column(&[5590.87]), ["5.59087000E+03"]);
        assert_eq!(
            column(&[1.0, 1.234_567_890_12]),
            ["1.00000000000E+00", "1.23456789012E+00"]
        );
        let third: f64 = column(&[1.0 / 3.0])[0].parse().expect("a number");
        assert!((third - 1.0 / 3.0).abs() < 1e-13);
    }

    #[test]
    fn heights_that_nearly_touch_stay_apart() {
        let heights = [0.0, 0.5, 0.5 + f64::EPSILON, 1.0 - f64::EPSILON, 1.0];
        let read = rising_column(&heights)
            .iter()
            .map(|text| text.parse().expect("a number"))
            .collect::<Vec<f64>>();
        assert_eq!(read, heights);
        let tiny = rising_column(&[0.0, 1e-300, 1.0]);
        assert_eq!(tiny[1], "1.00000000E-300");
    }
}
