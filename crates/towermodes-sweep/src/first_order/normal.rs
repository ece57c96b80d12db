//! Probabilities of a normally distributed frequency.

use crate::sampling::probability;

/// The probability that a normal frequency is in a range.
pub(super) fn inside([low_hz, high_hz]: [f64; 2], mean_hz: f64, deviation_hz: f64) -> f64 {
    if deviation_hz == 0.0 {
        return f64::from(u8::from(low_hz < mean_hz && mean_hz < high_hz));
    }
    let [low, high] = [low_hz, high_hz].map(|hz| (hz - mean_hz) / deviation_hz);
    // Of the nearer tail, which has all digits.
    match low > 0.0 {
        true => probability(-low) - probability(-high),
        false => probability(high) - probability(low),
    }
}

#[cfg(test)]
mod tests {
    use super::inside;

    /// Φ(1) − Φ(−1), Φ(−9) − Φ(−10) and Φ(10) − Φ(9).
    #[test]
    fn probabilities_are_those_of_the_normal_distribution() {
        assert!((inside([0.9, 1.1], 1.0, 0.1) - 0.682_689_492_137_086).abs() < 1e-13);
        for range in [[1.9, 2.0], [0.0, 0.1]] {
            let far = inside(range, 1.0, 0.1);
            assert!(
                (far / 1.128_512_207_423_590_7e-19 - 1.0).abs() < 1e-9,
                "{far:e}"
            );
        }
        // An error of the frequency widens the range.
        assert_eq!(inside([0.9, 1.1], 1.0, 0.0), 1.0);
        assert_eq!(inside([1.1, 1.2], 1.0, 0.0), 0.0);
    }
}
