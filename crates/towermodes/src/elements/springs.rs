//! The springs of a segment: the flexibilities of its exact static stiffness, all in one joint.
//! Elements distribute them over their joints.

use crate::chain::JointFlexibility;
use crate::tower::{Compliance, Plane, Planes, Section, Tower, compliance};

/// The springs of a prismatic segment of a length (m):
#[inline]
pub(super) fn prismatic(section: &Section, length: f64) -> JointFlexibility {
    let bending = section.bending_n_m2.map(|ei| length / ei);
    let sliding = |bending: f64, shear: f64| bending * length * length / 12.0 + shear * length;
    JointFlexibility {
        deflection_m_per_n: bending.zip(section.shear_flexibility_per_n, sliding),
        bending_per_n_m: bending,
        axial_m_per_n: length / section.axial_n,
        torsion_per_n_m: length / section.torsion_n_m2,
    }
}

/// The springs of any segment, about the centre of flexibility of each plane.
#[inline]
pub(super) fn exact(compliance: &Compliance) -> JointFlexibility {
    let bending = compliance.bending;
    JointFlexibility {
        deflection_m_per_n: bending.map(|plane| plane.deflection_m_per_n + plane.shear_m_per_n),
        bending_per_n_m: bending.map(|plane| plane.bending_per_n_m),
        axial_m_per_n: compliance.axial_m_per_n,
        torsion_per_n_m: compliance.torsion_per_n_m,
    }
}

/// The fraction of the transverse flexibility of a segment between two heights (m) that is shear.
pub(crate) fn shear_fraction(tower: &Tower, plane: Plane, base_m: f64, top_m: f64) -> f64 {
    if !tower.shears() {
        return 0.0;
    }
    let piece = tower.piece_at(0.5 * (base_m + top_m));
    let compliance = compliance(piece, base_m, top_m).bending.of(plane);
    compliance.shear_m_per_n / (compliance.shear_m_per_n + compliance.deflection_m_per_n)
}

/// A joint that only bends.
pub(super) fn hinge(bending_per_n_m: Planes<f64>) -> JointFlexibility {
    JointFlexibility {
        bending_per_n_m,
        ..JointFlexibility::default()
    }
}
