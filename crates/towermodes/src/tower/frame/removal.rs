//! A frame without some of its springs and masses, whose elements stay as they are.

use super::coat::Substance;
use super::description::FrameDescription;
use super::foundation::FrameFoundation;
use super::member::MemberKind;
use super::soil::FrameSoil;
use crate::space::SpatialMatrix;
use crate::tower::parts::rigid_body::RigidBody;

impl FrameFoundation {
    /// Removes the body of the transition piece, the springs and the inertia of the supports, and
    /// the hydrostatic stiffness of a floating frame.
    pub(in crate::tower) fn remove_platform_and_supports(&mut self) {
        self.platform = RigidBody::default();
        if let Some(held) = &mut self.held {
            held.water = SpatialMatrix::default();
            held.water_on_joints.clear();
        }
        for support in &mut self.numbers_mut().supports {
            (support.stiffness, support.inertia) =
                (SpatialMatrix::default(), SpatialMatrix::default());
        }
    }

    /// Removes the moorings of a frame that floats.
    pub(in crate::tower) fn remove_moorings(&mut self) {
        if let Some(held) = &mut self.held {
            held.moorings = SpatialMatrix::default();
            held.moorings_on_joints.clear();
        }
    }

    /// Removes the springs of the soil along members and the water around them.
    pub(in crate::tower) fn remove_surroundings(&mut self) {
        self.remove_coats(Substance::Water);
        let FrameDescription {
            members,
            added_masses,
            riders,
            ..
        } = self.numbers_mut();
        added_masses.clear();
        riders.clear();
        let soil = members.iter_mut().flat_map(|member| &mut member.soil);
        soil.for_each(FrameSoil::remove_springs);
    }

    /// Removes the mass of the members themselves and the masses on joints.
    pub(in crate::tower) fn remove_masses_of_members(&mut self) {
        let FrameDescription {
            members, masses, ..
        } = self.numbers_mut();
        masses.clear();
        for member in members {
            match &mut member.kind {
                MemberKind::Beam { material, .. } => material.density_kg_per_m3 = 0.0,
                MemberKind::Cable { mass_kg_per_m, .. } | MemberKind::Rigid { mass_kg_per_m } => {
                    *mass_kg_per_m = 0.0;
                }
                MemberKind::Spring(_) => {}
            }
        }
    }

    /// Removes the mass of coats of a substance.
    pub(in crate::tower) fn remove_coats(&mut self, substance: Substance) {
        let members = self.numbers_mut().members.iter_mut();
        let coats = members.flat_map(|member| &mut member.coats);
        coats
            .filter(|coat| coat.kind.substance() == substance)
            .for_each(|coat| coat.remove_mass());
    }
}
