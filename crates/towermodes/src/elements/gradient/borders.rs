//! From derivatives with respect to segment borders to derivatives with respect to heights of the
//! tower.

use crate::elements::Mesh;
use crate::tower::{NumberPlace, Places, Tower};

/// Adds the derivatives with respect to the borders of a mesh to those with respect to the heights
/// that determine the spans: ends of pieces and attachments; borders inside a span move in
/// proportion.
pub(super) fn carry_to_heights(tower: &Tower, mesh: &Mesh, borders: &[f64], sums: &mut [f64]) {
    let knots = knots(tower);
    let mut first = 0;
    for (span, heights) in mesh.spans_with_borders() {
        let segments = heights.len() - 1;
        let (mut base, mut top) = (0.0, 0.0);
        for (k, value) in borders[first..=first + segments].iter().enumerate() {
            // The border between two spans moves with the upper one.
            let is_of_next = k == segments && first + segments + 1 < borders.len();
            if is_of_next {
                continue;
            }
            let share = k as f64 / segments as f64;
            base += (1.0 - share) * value;
            top += share * value;
        }
        first += segments;
        add_at(&knots, span.base_m, base, sums);
        add_at(&knots, span.top_m, top, sums);
    }
}

/// Adds the derivative with respect to a height (m).
fn add_at(knots: &[(f64, NumberPlace)], height_m: f64, value: f64, sums: &mut [f64]) {
    let above = knots.partition_point(|knot| knot.0 < height_m);
    let Some(&(above_m, place)) = knots.get(above) else {
        return;
    };
    match above.checked_sub(1).map(|below| knots[below]) {
        Some((below_m, below)) if above_m != height_m => {
            let share = (height_m - below_m) / (above_m - below_m);
            sums[below] += (1.0 - share) * value;
            sums[place] += share * value;
        }
        _ => sums[place] += value,
    }
}

/// The heights that determine the mesh, m, in increasing order, with their indices.
fn knots(tower: &Tower) -> Vec<(f64, NumberPlace)> {
    let places = Places::of(tower);
    let pieces = tower.pieces().iter().enumerate();
    let ends = pieces.map(|(index, piece)| (piece.top_m, places.piece(index)));
    let attached = tower.attachments().iter().enumerate();
    let attached = attached.map(|(index, a)| (a.height_m, places.attachment(index)));
    let base = (tower.base_m(), Places::BASE_HEIGHT);
    // Of several at one height the end of a piece is used: attachments move with it.
    let mut knots: Vec<_> = [base].into_iter().chain(ends).chain(attached).collect();
    knots.sort_by(|a, b| a.0.total_cmp(&b.0));
    knots.dedup_by(|later, first| later.0 == first.0);
    knots
}
