//! The discretization error of a frequency, by Richardson extrapolation.
//!
//! A method whose error has the powers p, q, … of 1/n gives f(n) = f* + C n⁻ᵖ + D n⁻ᵠ + …. Meshes
//! that halve each other's segments give C, D, … and with them both the error and a better value
//! (Richardson 1911; Romberg 1955 for several powers).

/// The estimate of coarser or finer meshes for a frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// Estimate of |f* − f(n)|, Hz, 5 % larger than what the extrapolation gives.
    pub error_hz: f64,
    /// Estimate of f*, Hz.
    pub extrapolated_hz: f64,
    /// Difference between the values extrapolated with and without the finest mesh, Hz; 0 if there
    /// is no mesh more than the extrapolation needs.
    pub spread_hz: f64,
    /// Whether the meshes converge with the given powers, so that the spread is small relative to
    /// the error.
    pub is_regular: bool,
}

/// If the values extrapolated with and without the finest mesh differ by more than this many
/// errors, convergence is not regular. A term of the next even power, a thirtieth of the first,
/// makes them differ by about as much; an error that falls by one power less makes them differ by
/// twice.
const REGULAR: f64 = 1.5;
/// Spreads below this fraction of a frequency are rounding errors.
const ROUNDING: f64 = 1e-10;
/// An extrapolation is as often a little below the true error as above it: the powers that it
/// leaves out change it by less than 2 %. The estimate has this factor, so that it is a bound.
const MARGIN: f64 = 1.05;

/// Extrapolates the frequencies (Hz) of one mode on meshes from the finest to the coarsest, each
/// with half the segments of the one before, for an error with these powers of 1/n. The number of
/// meshes is the number of powers plus one or two.
///
/// For each power p in turn: fᵢ ← fᵢ + (fᵢ − fᵢ₊₁)/(2ᵖ − 1). The error is the difference between
/// the extrapolated value and `frequency_hz`, the frequency on one of the meshes, but at least the
/// change by the last power, and at least the spread (the difference of the values extrapolated
/// with and without the finest mesh) over 2ᵖ of the lowest power. Where the spread is large the
/// meshes do not converge with these powers yet, and the error is at least the spread: terms may
/// cancel, or two meshes agree by chance. The result is 1.05 times this error, because the
/// neglected powers make the true error larger as often as smaller.
///
/// Source: Richardson (1911); Romberg (1955) for several powers.
///
/// # Example
/// f(n) = 3 + 1/n² on 8, 4 and 2 segments:
/// ```
/// let meshes_hz = vec![3.0 + 1.0 / 64.0, 3.0 + 1.0 / 16.0, 3.25];
/// let estimate = towermodes::modes::richardson(meshes_hz[0], meshes_hz, &[2]);
/// assert!((estimate.extrapolated_hz - 3.0).abs() < 1e-14);
/// assert!((estimate.error_hz - 1.05 / 64.0).abs() < 1e-14 && estimate.is_regular);
/// ```
pub fn richardson(frequency_hz: f64, mut meshes_hz: Vec<f64>, powers: &[i32]) -> Estimate {
    extrapolate(frequency_hz, &mut meshes_hz, powers)
}

/// The extrapolated value without the errors of these powers of 1/n, from the values on several
/// meshes, the finest first, each with half the segments of the one before; the number of meshes is
/// one more than the number of powers. The values are overwritten. The second result is the change
/// by the last power.
pub(crate) fn without_powers(values: &mut [f64], powers: &[i32]) -> (f64, f64) {
    let mut last_change = 0.0;
    for (removed, &power) in powers.iter().enumerate() {
        let gain = 2.0_f64.powi(power) - 1.0;
        for finer in 0..values.len().saturating_sub(removed + 1) {
            let change = (values[finer] - values[finer + 1]) / gain;
            values[finer] += change;
            if finer == 0 {
                last_change = change;
            }
        }
    }
    (values.first().copied().unwrap_or(f64::NAN), last_change)
}

/// [`richardson`], which overwrites the frequencies of the meshes.
pub(crate) fn extrapolate(frequency_hz: f64, meshes_hz: &mut [f64], powers: &[i32]) -> Estimate {
    let mut last_change = 0.0_f64;
    let mut left = meshes_hz.len();
    for (removed, &power) in powers.iter().enumerate() {
        let gain = 2.0_f64.powi(power) - 1.0;
        for finer in 0..left.saturating_sub(1) {
            let change = (meshes_hz[finer] - meshes_hz[finer + 1]) / gain;
            meshes_hz[finer] += change;
            if finer == 0 && removed > 0 {
                last_change = change.abs();
            }
        }
        left = left.saturating_sub(1);
    }
    let meshes_hz = &meshes_hz[..left];
    let extrapolated_hz = meshes_hz.first().copied().unwrap_or(frequency_hz);
    let error_hz = (extrapolated_hz - frequency_hz).abs().max(last_change);
    let coarser_hz = meshes_hz.get(1).copied().unwrap_or(extrapolated_hz);
    let spread_hz = (extrapolated_hz - coarser_hz).abs();
    let is_regular = spread_hz <= (REGULAR * error_hz).max(ROUNDING * frequency_hz);
    let fraction = match powers.first() {
        Some(&power) if is_regular => 2.0_f64.powi(-power),
        _ => 1.0,
    };
    Estimate {
        error_hz: MARGIN * error_hz.max(fraction * spread_hz),
        // If the meshes are too coarse for all powers, the extrapolation is wrong; if this is
        // detected, the value of the mode's own mesh is used.
        extrapolated_hz: if extrapolated_hz > 0.0 {
            extrapolated_hz
        } else {
            frequency_hz
        },
        spread_hz,
        is_regular,
    }
}

#[cfg(test)]
mod tests {
    use super::richardson;

    #[test]
    fn meshes_that_agree_by_chance_are_found_out_by_another() {
        // The two finest agree, and the third shows that they have not converged.
        let two = richardson(1.0, vec![1.0, 1.0], &[2]);
        assert_eq!((two.error_hz, two.is_regular), (0.0, true));
        let three = richardson(1.0, vec![1.0, 1.0, 1.3], &[2]);
        assert!((three.error_hz - 1.05 * 0.1).abs() < 1e-15 && !three.is_regular);
        // Where the power is right the third changes nothing.
        let f = |n: f64| 3.0 + n.powi(-2);
        let smooth = richardson(f(8.0), vec![f(8.0), f(4.0), f(2.0)], &[2]);
        assert!((smooth.error_hz - 1.05 / 64.0).abs() < 1e-15 && smooth.is_regular);
    }

    #[test]
    fn meshes_that_fall_more_slowly_than_the_power_are_no_regular_convergence() {
        // n⁻¹ where n⁻² is expected: a third of the error is missed by two meshes, and the spread
        // of three tells.
        let f = |n: f64| 3.0 + n.powi(-1);
        let slow = richardson(f(8.0), vec![f(8.0), f(4.0), f(2.0)], &[2]);
        assert!(!slow.is_regular && slow.error_hz > (f(8.0) - 3.0) / 3.0);
        // A term of the next even power, a fortieth of the first on the finest mesh, is still
        // regular.
        let f = |n: f64| 3.0 + n.powi(-2) + 1.6 * n.powi(-4);
        assert!(richardson(f(8.0), vec![f(8.0), f(4.0), f(2.0)], &[2]).is_regular);
    }

    #[test]
    fn pure_powers_are_extrapolated_exactly() {
        for powers in [&[1][..], &[2], &[4], &[1, 2], &[2, 4]] {
            let f = |n: f64| 3.0 + powers.iter().map(|&p| 0.5 * n.powi(-p)).sum::<f64>();
            let meshes = [8.0, 4.0, 2.0].map(f)[..=powers.len()].to_vec();
            for chosen in meshes.clone() {
                let estimate = richardson(chosen, meshes.clone(), powers);
                assert!((estimate.extrapolated_hz - 3.0).abs() < 1e-14);
                let margin = 1.05 * (chosen - 3.0);
                assert!(estimate.error_hz >= margin - 1e-14);
                assert!(powers.len() > 1 || estimate.error_hz <= margin + 1e-14);
            }
        }
    }
}
