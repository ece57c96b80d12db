//! The forces in a frame at rest that change its stiffness: tensions along elements, and forces in
//! rigid links.

use crate::space::SpatialMatrix;

/// The forces in a frame at rest that change its stiffness.
#[derive(Debug, Clone, Default)]
pub(super) struct ForcesAtRest {
    /// The tension in each element of the members, by index of the edge.
    pub(super) tensions: Vec<(usize, Tension)>,
    /// The stiffness due to the force in each rigid link, by index of the edge.
    pub(super) turning: Vec<(usize, SpatialMatrix)>,
}

/// The tension at five equally spaced points of an element, N, beginning at the end with the lower
/// fraction of its member.
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
