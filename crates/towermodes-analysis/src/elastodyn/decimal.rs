//! Polynomials rounded to the decimals of a tower file.

use thiserror::Error;

use super::polynomial::TowerPolynomial;
use towermodes::Plain;

/// Default number of decimals in a tower file: at least eight digits of the largest coefficients.
pub const COEFFICIENT_DECIMALS: u32 = 8;
/// The largest number of decimals: more have no meaning in double precision.
pub const MAX_DECIMALS: u32 = 15;
/// OpenFAST refuses coefficients whose sum differs from 1 by more than this.
pub const SUM_TOLERANCE: f64 = 0.0015;
/// Larger coefficients do not describe a mode shape of a tower; known coefficients are at most some
/// hundreds.
const MAX_COEFFICIENT: f64 = 1e12;

/// A polynomial in whole units of its last decimal, whose coefficients sum to 1 exactly.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DecimalPolynomial {
    units: [i128; 5],
    decimals: u32,
}

/// Why a polynomial cannot be rounded to decimals that sum to 1.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum RoundingError {
    /// The number of decimals is out of range.
    #[error(
        "coefficients cannot have {decimals} decimals; the number must be from 1 to {MAX_DECIMALS}"
    )]
    Decimals {
        /// The requested number.
        decimals: u32,
    },
    /// A coefficient is not finite or far too large for a mode shape.
    #[error("the coefficient of x^{power} is {}, which is too large for a mode shape", Plain(*.value))]
    Coefficient {
        /// The power of x of this coefficient.
        power: usize,
        /// Its value.
        value: f64,
    },
    /// The deflection of the top is not 1.
    #[error("the coefficients sum to {:.7}, but OpenFAST requires 1 within {SUM_TOLERANCE}", Plain(*.sum))]
    Sum {
        /// The sum.
        sum: f64,
    },
}

impl TowerPolynomial {
    /// The coefficients rounded to decimals that sum to 1 exactly.
    ///
    /// They are first divided by their sum, which only scales the shape; the remainder of the
    /// rounding is added to the largest coefficient, whose relative change is smallest.
    ///
    /// # Errors
    /// [`RoundingError`]: the number of decimals or a coefficient is out of range, or the sum is
    /// not 1.
    pub fn rounded(&self, decimals: u32) -> Result<DecimalPolynomial, RoundingError> {
        if !(1..=MAX_DECIMALS).contains(&decimals) {
            return Err(RoundingError::Decimals { decimals });
        }
        let coefficients = self.coefficients;
        for (power, value) in (2..).zip(coefficients) {
            if value.is_nan() || value.abs() > MAX_COEFFICIENT {
                return Err(RoundingError::Coefficient { power, value });
            }
        }
        // The coefficients are bounded, so their sum is finite.
        let sum = self.sum();
        if (sum - 1.0).abs() > SUM_TOLERANCE {
            return Err(RoundingError::Sum { sum });
        }
        let one = 10_i128.pow(decimals);
        let mut units = coefficients.map(|c| (c / sum * one as f64).round() as i128);
        let left: i128 = one - units.iter().sum::<i128>();
        if let Some(largest) = units.iter_mut().max_by_key(|units| units.abs()) {
            *largest += left;
        }
        Ok(DecimalPolynomial { units, decimals })
    }
}

impl DecimalPolynomial {
    /// The polynomial with the decimals as numbers, as a program reads them.
    pub fn polynomial(&self) -> TowerPolynomial {
        TowerPolynomial {
            coefficients: self.texts().map(|text| text.parse().unwrap_or(f64::NAN)),
        }
    }

    /// The coefficients in units of the last decimal.
    pub fn units(&self) -> [i128; 5] {
        self.units
    }

    /// The coefficients as texts.
    pub fn texts(&self) -> [String; 5] {
        let one = 10_u128.pow(self.decimals);
        let width = self.decimals as usize;
        self.units.map(|units| {
            let sign = if units < 0 { "-" } else { "" };
            let size = units.unsigned_abs();
            format!("{sign}{}.{:0width$}", size / one, size % one)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{RoundingError, TowerPolynomial};

    /// Numbers from −1 to 1 (Knuth's linear congruential generator).
    fn random(state: &mut u64) -> f64 {
        *state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (*state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// The digits of a printed number without its point, as a whole number.
    fn whole(text: &str, decimals: usize) -> i128 {
        let (_, fraction) = text.split_once('.').expect("a point");
        assert_eq!(fraction.len(), decimals, "{text}");
        text.replace('.', "").parse().expect("digits")
    }

    #[test]
    fn printed_digits_add_up_to_one_whatever_the_coefficients() {
        let mut state = 7;
        for trial in 0..3000_u32 {
            let decimals = 1 + trial % 15;
            let size = [1.0, 290.0, 3000.0][trial as usize % 3];
            let mut coefficients = [0.0; 5].map(|_: f64| size * random(&mut state));
            coefficients[4] = 1.0 - coefficients[..4].iter().sum::<f64>();
            let rounded = TowerPolynomial { coefficients }.rounded(decimals);
            let rounded = rounded.expect("decimals");
            let texts = rounded.texts();
            let sum: i128 = texts.iter().map(|t| whole(t, decimals as usize)).sum();
            assert_eq!(sum, 10_i128.pow(decimals));
            // Half a unit each, and for one what the others leave: no more than five halves.
            let unit = 10.0_f64.powi(-(decimals as i32));
            let parsed = texts.map(|text| text.parse::<f64>().expect("a number"));
            for (printed, c) in parsed.iter().zip(coefficients) {
                assert!((printed - c).abs() <= 2.5 * unit + 1e-15 * size * 8.0);
            }
            assert_eq!(parsed, rounded.polynomial().coefficients);
        }
    }

    #[test]
    fn what_rounding_leaves_goes_to_the_largest() {
        let coefficients = [1.0 / 3.0, 1.0 / 3.0, -8.0, 25.0 / 3.0, 0.0];
        let rounded = TowerPolynomial { coefficients }.rounded(3).expect("sum 1");
        // 0.333 + 0.333 − 8.000 + 8.333 + 0.000 is 0.999.
        assert_eq!(
            rounded.texts(),
            ["0.333", "0.333", "-8.000", "8.334", "0.000"]
        );
    }

    #[test]
    fn a_sum_a_little_off_is_divided_out_and_others_are_refused() {
        let rounded = |coefficients| TowerPolynomial { coefficients }.rounded(6);
        let scaled = rounded([0.5, 0.4995, 0.0, 0.0, 0.0]).expect("0.9995");
        // 0.5/0.9995 = 0.50025012…
        assert_eq!(scaled.texts()[0], "0.500250");
        assert_eq!(
            rounded([0.5, 0.498, 0.0, 0.0, 0.0]),
            Err(RoundingError::Sum { sum: 0.998 })
        );
        for value in [f64::INFINITY, 1e300] {
            let power = 4;
            let refused = rounded([0.0, 1.0, value, 0.0, 0.0]);
            assert_eq!(refused, Err(RoundingError::Coefficient { power, value }));
        }
        assert!(rounded([f64::NAN; 5]).is_err());
        let one = TowerPolynomial {
            coefficients: [1.0, 0.0, 0.0, 0.0, 0.0],
        };
        assert!(one.rounded(0).is_err() && one.rounded(16).is_err());
    }

    #[test]
    fn small_negative_numbers_keep_their_sign_and_zero_has_none() {
        let coefficients = [1.04, -0.04, -1e-9, 0.0, -0.0];
        let rounded = TowerPolynomial { coefficients }.rounded(2).expect("sum 1");
        assert_eq!(rounded.texts(), ["1.04", "-0.04", "0.00", "0.00", "0.00"]);
        let one = TowerPolynomial { coefficients }.rounded(9).expect("sum 1");
        assert_eq!(one.texts()[2], "-0.000000001");
    }
}
