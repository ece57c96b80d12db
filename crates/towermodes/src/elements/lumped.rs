//! Rigid half-segments joined by massless beam elements, as general multibody programs model beams
//! (Adams).
//!
//! A segment of length L is a prismatic beam with the section at its middle. Its two halves are
//! rigid bodies, and between them, in the middle, are all the springs of the segment's exact static
//! stiffness: EI/L, 12EI/(L³(1+φ)), EA/L, GJ/L. Every frequency converges as n⁻².

use super::{Assembly, springs};
use crate::tower::Piece;

/// Adds one segment between two heights (m).
pub(super) fn add_segment(assembly: &mut Assembly<'_>, piece: &Piece, base_m: f64, top_m: f64) {
    let middle_m = 0.5 * (base_m + top_m);
    let section = piece.section_at(middle_m);
    assembly.add_prismatic_body(&section, base_m, middle_m);
    assembly.add_joint(middle_m, &springs::prismatic(&section, top_m - base_m));
    assembly.add_prismatic_body(&section, middle_m, top_m);
}
