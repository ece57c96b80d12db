//! The tension along an element at rest.

/// The tension at five equally spaced points of an element, N, from where it begins on its member.
pub(super) type Tension = [f64; 5];

/// The tension at a fraction of an element: the polynomial through its five points.
pub(super) fn tension_at(tension: &Tension, s: f64) -> f64 {
    let point = |k: usize| k as f64 / 4.0;
    let weight = |k: usize| {
        let others = (0..5).filter(|other| *other != k);
        others
            .map(|other| (s - point(other)) / (point(k) - point(other)))
            .product::<f64>()
    };
    tension.iter().enumerate().map(|(k, n)| n * weight(k)).sum()
}
