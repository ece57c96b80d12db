//! The springs of a segment: the flexibilities of its exact static stiffness, all in one joint. Elements share them out.

use crate::chain::JointFlexibility;
use crate::tower::{Compliance, Section};

/// Of a prismatic segment of a length (m): L/EI, L³(1+φ)/(12EI) with φ = 12EI/(κGAL²) written out, L/EA, L/GJ.
#[inline]
pub(super) fn prismatic(section: &Section, length: f64) -> JointFlexibility {
    let bending = length / section.bending_n_m2;
    JointFlexibility {
        deflection_m_per_n: bending * length * length / 12.0
            + section.shear_flexibility_per_n * length,
        bending_per_n_m: bending,
        axial_m_per_n: length / section.axial_n,
        torsion_per_n_m: length / section.torsion_n_m2,
    }
}

/// Of any segment, about its elastic centre.
#[inline]
pub(super) fn exact(compliance: &Compliance) -> JointFlexibility {
    JointFlexibility {
        deflection_m_per_n: compliance.deflection_m_per_n + compliance.shear_m_per_n,
        bending_per_n_m: compliance.bending_per_n_m,
        axial_m_per_n: compliance.axial_m_per_n,
        torsion_per_n_m: compliance.torsion_per_n_m,
    }
}

/// A joint that only bends.
pub(super) fn hinge(bending_per_n_m: f64) -> JointFlexibility {
    JointFlexibility {
        bending_per_n_m,
        ..JointFlexibility::default()
    }
}
