//! The rigid multibody joint element as published, with its misprints corrected.
//!
//! Nikolić & Šalinić, *Free vibration analysis of the horizontal axis wind turbine tower*. A
//! segment of length L is a prismatic beam with the section at its middle, and becomes three rigid
//! bodies, [0, L/4], [L/4, L/2] and [L/2, L], and two joints:
//!
//! | at | components | stiffness |
//! |---|---|---|
//! | L/4 | both deflections, axial, torsion | 12EI/(L³(1+φ)), EA/L, GJ/L |
//! | L/2 | both bending rotations | EI/L |
//!
//! The springs are those of the segment's exact static stiffness; φ = 12EI/(κGAL²) with shear, 0
//! without. Bending converges as n⁻², torsion and axial, whose joint is off the middle, only as
//! n⁻¹; with shear, bending converges as n⁻¹ in the end.

use super::{Assembly, springs};
use crate::chain::JointFlexibility;
use crate::tower::{Piece, Planes};

/// Adds one segment between two heights (m).
pub(super) fn add_segment(assembly: &mut Assembly<'_>, piece: &Piece, base_m: f64, top_m: f64) {
    let length = top_m - base_m;
    let at = |fraction: f64| base_m + fraction * length;
    let section = piece.section_at(at(0.5));
    let all = springs::prismatic(&section, length);
    let slide = JointFlexibility {
        bending_per_n_m: Planes::default(),
        ..all
    };
    assembly.add_prismatic_body(&section, base_m, at(0.25));
    assembly.add_joint(at(0.25), &slide);
    assembly.add_prismatic_body(&section, at(0.25), at(0.5));
    assembly.add_joint(at(0.5), &springs::hinge(all.bending_per_n_m));
    assembly.add_prismatic_body(&section, at(0.5), top_m);
}
