//! Rigid half-segments joined by massless beam springs, as general multibody programs model beams (Adams).
//!
//! A segment of length L is a prismatic beam with the section at its middle. Its two halves are rigid bodies, and between them, in the
//! middle, are all the springs of the segment's exact static stiffness: EI/L, 12EI/(L³(1+φ)), EA/L, GJ/L. Every frequency converges
//! as n⁻².

use super::Assembly;
use crate::chain::JointFlexibility;
use crate::tower::Piece;

/// Adds one segment between two heights (m).
pub(super) fn add_segment(assembly: &mut Assembly<'_>, piece: &Piece, base_m: f64, top_m: f64) {
    let (length, middle_m) = (top_m - base_m, 0.5 * (base_m + top_m));
    let section = piece.section_at(middle_m);
    let bending = length / section.bending_n_m2;
    let flexibility = JointFlexibility {
        // L³(1+φ)/(12EI), with φ written out.
        deflection_m_per_n: bending * length * length / 12.0
            + section.shear_flexibility_per_n * length,
        bending_per_n_m: bending,
        axial_m_per_n: length / section.axial_n,
        torsion_per_n_m: length / section.torsion_n_m2,
    };
    assembly.add_prismatic_body(&section, base_m, middle_m);
    assembly.chains.add_joint(middle_m, &flexibility);
    assembly.add_prismatic_body(&section, middle_m, top_m);
}
