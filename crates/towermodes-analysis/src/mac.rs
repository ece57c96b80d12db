//! The modal assurance criterion of two mode shapes.

/// The modal assurance criterion MAC = (Σ m a b)²/(Σ m a² Σ m b²) of two shapes sampled at the same
/// places: 1 for shapes that differ only by a factor, 0 for orthogonal shapes (Allemang & Brown
/// 1982). The masses m at the samples are 1 unless given.
///
/// None if the numbers of samples differ, a shape is zero everywhere, a mass is negative, or a
/// number is not finite.
///
/// # Example
/// ```
/// use towermodes_analysis::mac;
///
/// assert_eq!(mac(&[0.0, 0.25, 1.0], &[0.0, -0.5, -2.0], None), Some(1.0));
/// assert_eq!(mac(&[1.0, 1.0], &[1.0, -1.0], None), Some(0.0));
/// ```
pub fn mac(a: &[f64], b: &[f64], masses: Option<&[f64]>) -> Option<f64> {
    let n = a.len();
    let weighs = |masses: &[f64]| masses.len() == n && masses.iter().all(|&mass| mass >= 0.0);
    if b.len() != n || !masses.is_none_or(weighs) {
        return None;
    }
    // Scaled, so that no square overflows or vanishes.
    let largest = |x: &[f64]| x.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let (size_a, size_b) = (largest(a), largest(b));
    let heaviest = masses.map_or(1.0, largest);
    let mass = |i: usize| masses.map_or(1.0, |masses| masses[i] / heaviest);
    let (mut ab, mut aa, mut bb) = (0.0, 0.0, 0.0);
    for i in 0..n {
        let (a, b, mass) = (a[i] / size_a, b[i] / size_b, mass(i));
        ab += mass * a * b;
        aa += mass * a * a;
        bb += mass * b * b;
    }
    let mac = (ab / aa) * (ab / bb);
    mac.is_finite().then(|| mac.min(1.0))
}

#[cfg(test)]
mod tests {
    use super::mac;

    #[test]
    fn shapes_are_alike_up_to_a_factor() {
        let a = [0.0, 0.25, 1.0];
        assert_eq!(mac(&a, &[0.0, -0.5, -2.0], None), Some(1.0));
        // (1/4 + 1)²/((1/16 + 1)(1 + 1)) = 25/34.
        let b = [0.0, 1.0, 1.0];
        let plain = mac(&a, &b, None).expect("alike");
        assert!((plain - 25.0 / 34.0).abs() < 1e-15);
        // Masses 8, 4, 1: (1 + 1)²/((1/4 + 1)(4 + 1)) = 16/25.
        let weighted = mac(&a, &b, Some(&[8.0, 4.0, 1.0])).expect("alike");
        assert!((weighted - 0.64).abs() < 1e-15);
        assert_eq!(mac(&[1.0, 1.0], &[1.0, -1.0], None), Some(0.0));
    }

    #[test]
    fn what_cannot_be_compared_is_not() {
        assert_eq!(mac(&[1.0], &[1.0, 2.0], None), None);
        assert_eq!(mac(&[1.0], &[1.0], Some(&[])), None);
        assert_eq!(mac(&[0.0, 0.0], &[1.0, 2.0], None), None);
        assert_eq!(mac(&[f64::NAN, 1.0], &[1.0, 2.0], None), None);
        assert_eq!(mac(&[1.0, 1.0], &[1.0, 2.0], Some(&[-1.0, 3.0])), None);
        assert_eq!(mac(&[], &[], None), None);
        assert_eq!(mac(&[1e300, 1e300], &[1e-300, 1e-300], None), Some(1.0));
    }
}
