//! The rigid multibody element of a tapered tower: one joint at the elastic centre, exact integrals.
//!
//! A segment becomes two rigid bodies, which keep the exact mass, centre and inertia of what they replace, and one joint at the elastic
//! centre z_c = ∫ z dz/EI ÷ ∫ dz/EI, where a force does not turn it:
//!
//! 1/k_θ = ∫ dz/EI,  1/k_w = ∫ (z−z_c)² dz/EI + ∫ dz/(κGA),  1/k_axial = ∫ dz/EA,  1/k_torsion = ∫ dz/GJ.
//!
//! So the segment's static stiffness is exact for any taper, and every frequency converges as n⁻².

use super::{Assembly, springs};
use crate::tower::{Piece, compliance};

/// Adds one segment between two heights (m).
pub(super) fn add_segment(assembly: &mut Assembly<'_>, piece: &Piece, base_m: f64, top_m: f64) {
    let compliance = compliance(piece, base_m, top_m);
    let centre_m = compliance.elastic_centre_m;
    assembly.add_exact_body(piece, base_m, centre_m);
    assembly
        .chains
        .add_joint(centre_m, &springs::exact(&compliance));
    assembly.add_exact_body(piece, centre_m, top_m);
}
