//! The cardanic joint beam element, prismatic and with exact sections.
//!
//! A reconstruction of the element of Zhao, Maißer & Wu, whose text is not openly available, from
//! its description by Nikolić & Šalinić: one rigid body and two rotational joints more than theirs,
//! rotating instead of sliding. A segment of length L becomes four rigid bodies, with bending
//! hinges of stiffness 2EI/L at kL and (1−k)L, and in the middle a joint for axial motion, torsion
//! and, where the tower shears, sliding (EA/L, GJ/L, κGA/L).
//!
//! The hinges give a prismatic segment its exact static deflection if (1−k)² + k² = 2/3, so k = (1
//! − 1/√3)/2: the two-point Gauss rule. With exact sections they are the Gauss rule of the measure
//! dz/EI.

use super::{Assembly, springs};
use crate::chain::JointFlexibility;
use crate::tower::{Piece, Plane, Planes, compliance, gauss_hinges};

/// k = (1 − 1/√3)/2, the statically exact place of the hinges.
pub const GAUSS_HINGE_POSITION: f64 = 0.211_324_865_405_187_1;

/// Adds one prismatic segment between two heights (m), its section that of the middle, hinges at
/// `position` of the length from each end.
pub(super) fn add_prismatic_segment(
    assembly: &mut Assembly<'_>,
    piece: &Piece,
    base_m: f64,
    top_m: f64,
    position: f64,
) {
    let (length, middle_m) = (top_m - base_m, 0.5 * (base_m + top_m));
    let section = piece.section_at(middle_m);
    let all = springs::prismatic(&section, length);
    let hinge = springs::hinge(all.bending_per_n_m.map(|whole| 0.5 * whole));
    let (lower_m, upper_m) = (base_m + position * length, top_m - position * length);
    let middle = JointFlexibility {
        deflection_m_per_n: section.shear_flexibility_per_n.map(|shear| shear * length),
        bending_per_n_m: Planes::default(),
        ..all
    };
    assembly.add_prismatic_body(&section, base_m, lower_m);
    assembly.add_joint(lower_m, &hinge);
    assembly.add_prismatic_body(&section, lower_m, middle_m);
    assembly.add_joint(middle_m, &middle);
    assembly.add_prismatic_body(&section, middle_m, upper_m);
    assembly.add_joint(upper_m, &hinge);
    assembly.add_prismatic_body(&section, upper_m, top_m);
}

/// Adds one segment between two heights (m) with exact integrals; the joint between the hinges sits
/// at the centre of flexibility.
pub(super) fn add_exact_segment(
    assembly: &mut Assembly<'_>,
    piece: &Piece,
    base_m: f64,
    top_m: f64,
) {
    let whole = compliance(piece, base_m, top_m);
    let joints_of = |plane| {
        let bending = whole.bending.of(plane);
        let [lower, upper] = gauss_hinges(piece, base_m, top_m, plane, &bending).map(|hinge| {
            (
                hinge.height_m,
                springs::hinge(Planes::both(hinge.bending_per_n_m)),
            )
        });
        let middle = JointFlexibility {
            // Shear belongs into a sliding joint of its own: in the hinges' spacing it would push
            // them off a short segment.
            deflection_m_per_n: whole.bending.map(|plane| plane.shear_m_per_n),
            bending_per_n_m: Planes::default(),
            ..springs::exact(&whole)
        };
        [lower, (bending.elastic_centre_m, middle), upper]
    };
    let [lower, middle, upper] = joints_of(Plane::ForeAft);
    if assembly.planes_share_joints(piece) {
        assembly.add_exact_bodies(piece, base_m, top_m, [lower, middle, upper]);
        return;
    }
    let [a, b, c] = [lower, middle, upper].map(|(height_m, joint)| (height_m, joint.split()[0]));
    let [d, e, f] =
        joints_of(Plane::SideSide).map(|(height_m, joint)| (height_m, joint.split()[1]));
    assembly.add_exact_bodies(piece, base_m, top_m, [a, b, c, d, e, f]);
}
