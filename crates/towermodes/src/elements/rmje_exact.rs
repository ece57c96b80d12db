//! The rigid multibody element of a tapered tower: one joint at the elastic centre, exact integrals.
//!
//! A segment becomes two rigid bodies, which keep the exact mass, centre and inertia of what they replace, and one joint at the elastic
//! centre z_c = ∫ z dz/EI ÷ ∫ dz/EI, where a force does not turn it:
//!
//! 1/k_θ = ∫ dz/EI,  1/k_w = ∫ (z−z_c)² dz/EI + ∫ dz/(κGA),  1/k_axial = ∫ dz/EA,  1/k_torsion = ∫ dz/GJ.
//!
//! So the segment's static stiffness is exact for any taper, and every frequency converges as n⁻².

use super::Assembly;
use crate::chain::{JointFlexibility, RigidBody};
use crate::tower::{Piece, compliance, mass_integrals};

/// Adds one segment between two heights (m).
pub(super) fn add_segment(assembly: &mut Assembly<'_>, piece: &Piece, base_m: f64, top_m: f64) {
    let compliance = compliance(piece, base_m, top_m);
    let centre_m = compliance.elastic_centre_m;
    let flexibility = JointFlexibility {
        deflection_m_per_n: compliance.deflection_m_per_n + compliance.shear_m_per_n,
        bending_per_n_m: compliance.bending_per_n_m,
        axial_m_per_n: compliance.axial_m_per_n,
        torsion_per_n_m: compliance.torsion_per_n_m,
    };
    exact_body(assembly, piece, base_m, centre_m);
    assembly.chains.add_joint(centre_m, &flexibility);
    exact_body(assembly, piece, centre_m, top_m);
}

/// The tower between two heights (m) as a rigid body, about its middle.
fn exact_body(assembly: &mut Assembly<'_>, piece: &Piece, base_m: f64, top_m: f64) {
    let reference_m = 0.5 * (base_m + top_m);
    let mass = mass_integrals(piece, base_m, top_m, reference_m);
    let transverse = mass.second_moment_kg_m2 + assembly.rotary_share() * mass.rotary_inertia_kg_m2;
    let body = RigidBody {
        mass_kg: mass.mass_kg,
        first_moment_kg_m: mass.first_moment_kg_m,
        inertia_xx_kg_m2: transverse,
        inertia_yy_kg_m2: transverse,
        inertia_zz_kg_m2: 2.0 * mass.rotary_inertia_kg_m2,
    };
    assembly.chains.add_body(reference_m, &body);
}
