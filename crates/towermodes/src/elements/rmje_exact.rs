//! The rigid multibody element of a tapered tower: one joint at the centre of flexibility, exact
//! integrals.
//!
//! A segment becomes two rigid bodies, which have the exact mass, centre and inertia of the parts
//! they replace, and one joint at the centre of flexibility z_c = ∫ z dz/EI ÷ ∫ dz/EI, where a
//! force does not turn it:
//!
//! 1/k_θ = ∫ dz/EI, 1/k_w = ∫ (z−z_c)² dz/EI + ∫ dz/(κGA), 1/k_axial = ∫ dz/EA, 1/k_torsion = ∫
//! dz/GJ.
//!
//! Where the bending planes differ, each has its own centre and so its own joint; torsion and axial
//! motion go with fore-aft bending.
//!
//! So the segment's static stiffness is exact for any taper, and every frequency converges as n⁻².

use super::{Assembly, springs};
use crate::tower::{Piece, compliance};

/// Adds one segment between two heights (m).
pub(super) fn add_segment(assembly: &mut Assembly<'_>, piece: &Piece, base_m: f64, top_m: f64) {
    let compliance = compliance(piece, base_m, top_m);
    let (centres, joint) = (compliance.bending, springs::exact(&compliance));
    let fore_aft_m = centres.fore_aft.elastic_centre_m;
    if assembly.planes_share_joints(piece) {
        assembly.add_exact_bodies(piece, base_m, top_m, [(fore_aft_m, joint)]);
        return;
    }
    let [others, side_side] = joint.split();
    let joints = [
        (fore_aft_m, others),
        (centres.side_side.elastic_centre_m, side_side),
    ];
    assembly.add_exact_bodies(piece, base_m, top_m, joints);
}
