//! The standard normal distribution: its probability and its quantile.
//!
//! The functions of `libm` give the same results on every machine, so the drawn values are the same
//! too.

/// The probability that a standard normal value is below x.
pub(crate) fn probability(x: f64) -> f64 {
    0.5 * libm::erfc(-x * std::f64::consts::FRAC_1_SQRT_2)
}

/// The value that a standard normal value is below with the probability p, 0 < p < 1.
///
/// Algorithm AS 241 of M. J. Wichura, Applied Statistics 37 (1988), 477–484: relative error about
/// 1e-16.
pub(super) fn quantile(p: f64) -> f64 {
    let q = p - 0.5;
    if q.abs() <= 0.425 {
        let r = 0.180_625 - q * q;
        return q * ratio(r, &CENTRE);
    }
    let tail = if q < 0.0 { p } else { 1.0 - p };
    let r = libm::sqrt(-libm::log(tail));
    let value = match r <= 5.0 {
        true => ratio(r - 1.6, &TAIL),
        false => ratio(r - 5.0, &FAR_TAIL),
    };
    value.copysign(q)
}

/// A rational function, by Horner's rule from the highest power.
fn ratio(r: f64, [above, below]: &[[f64; 8]; 2]) -> f64 {
    let polynomial = |coefficients: &[f64; 8]| coefficients.iter().fold(0.0, |sum, c| sum * r + c);
    polynomial(above) / polynomial(below)
}

/// Coefficients for |p − 1/2| ≤ 0.425.
#[rustfmt::skip]
const CENTRE: [[f64; 8]; 2] = [
    [2.509_080_928_730_122_7e3, 3.343_057_558_358_813e4, 6.726_577_092_700_87e4, 4.592_195_393_154_987e4,
     1.373_169_376_550_946e4, 1.971_590_950_306_551_3e3, 1.331_416_678_917_843_8e2, 3.387_132_872_796_366_5],
    [5.226_495_278_852_854e3, 2.872_908_573_572_194_3e4, 3.930_789_580_009_271e4, 2.121_379_430_158_659_7e4,
     5.394_196_021_424_751e3, 6.871_870_074_920_579e2, 4.231_333_070_160_091e1, 1.0],
];

/// Coefficients for tails down to exp(−25).
#[rustfmt::skip]
const TAIL: [[f64; 8]; 2] = [
    [7.745_450_142_783_414e-4, 2.272_384_498_926_918_4e-2, 2.417_807_251_774_506e-1, 1.270_458_252_452_368_4,
     3.647_848_324_763_204_5, 5.769_497_221_460_691, 4.630_337_846_156_546, 1.423_437_110_749_683_5],
    [1.050_750_071_644_416_9e-9, 5.475_938_084_995_345e-4, 1.519_866_656_361_645_7e-2, 1.481_039_764_274_800_8e-1,
     6.897_673_349_851e-1, 1.676_384_830_183_803_8, 2.053_191_626_637_759, 1.0],
];

/// Coefficients for the tails beyond exp(−25).
#[rustfmt::skip]
const FAR_TAIL: [[f64; 8]; 2] = [
    [2.010_334_399_292_288_1e-7, 2.711_555_568_743_487_6e-5, 1.242_660_947_388_078_4e-3, 2.653_218_952_657_612_4e-2,
     2.965_605_718_285_048_7e-1, 1.784_826_539_917_291_3, 5.463_784_911_164_114, 6.657_904_643_501_103],
    [2.044_263_103_389_939_8e-15, 1.421_511_758_316_446e-7, 1.846_318_317_510_054_8e-5, 7.868_691_311_456_133e-4,
     1.487_536_129_085_061_5e-2, 1.369_298_809_227_358e-1, 5.998_322_065_558_88e-1, 1.0],
];

#[cfg(test)]
mod tests {
    use super::{probability, quantile};

    /// mpmath 1.3 at 50 digits: p, and the root x of `erfc(-x/sqrt(2))/2 - p`.
    const QUANTILES: [(f64, f64); 12] = [
        (1e-300, -37.0470962993612),
        (1e-100, -21.273453560965326),
        (1e-20, -9.262340089798407),
        (1.1102230246251565e-16, -8.209536151601387),
        (1e-09, -5.9978070150076865),
        (0.0001, -3.7190164854556804),
        (0.01, -2.326347874040841),
        (0.074, -1.4466320671589785),
        (0.3, -0.5244005127080408),
        (0.75, 0.6744897501960817),
        (0.99, 2.3263478740408408),
        (0.999999, 4.753424308817087),
    ];

    /// mpmath 1.3 at 50 digits: x and `erfc(-x/sqrt(2))/2`.
    const PROBABILITIES: [(f64, f64); 8] = [
        (-30.0, 4.906713927148187e-198),
        (-12.5, 3.732564298877713e-36),
        (-5.0, 2.866515718791939e-07),
        (-1.0, 0.15865525393145705),
        (-0.1, 0.460172162722971),
        (0.3, 0.6179114221889527),
        (2.0, 0.9772498680518208),
        (6.0, 0.9999999990134123),
    ];

    #[test]
    fn quantiles_have_fifteen_digits() {
        for (p, expected) in QUANTILES {
            let error = (quantile(p) / expected - 1.0).abs();
            assert!(error < 5e-16, "{p}: {} {expected} {error:e}", quantile(p));
        }
        assert_eq!(quantile(0.5), 0.0);
    }

    /// The rounding of x/√2 changes the probability of a tail by a factor of x² times this
    /// rounding.
    #[test]
    fn probabilities_have_all_digits_that_x_has() {
        for (x, expected) in PROBABILITIES {
            let error = (probability(x) / expected - 1.0).abs();
            assert!(
                error < 4e-16 * (1.0 + x * x),
                "{x}: {} {expected} {error:e}",
                probability(x)
            );
        }
    }

    /// The three approximations agree at their borders: the quantile increases there.
    #[test]
    fn pieces_meet() {
        for border in [0.075, 0.925, (-25.0_f64).exp()] {
            let [below, above] = [border * (1.0 - 1e-13), border * (1.0 + 1e-13)].map(quantile);
            assert!(below < above && above - below < 1e-11, "{border}");
        }
    }
}
