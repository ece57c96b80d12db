//! The restoring stiffness of a floating frame: that of the rigid platform with the same masses;
//! its water planes act on the joints near them.

use towermodes::frame::{FrameFoundation, Restoring};
use towermodes::space::SpatialMatrix;
use towermodes::{ReferredMatrix, RigidBody};

use super::input::HydrodynInput;
use super::platform::HydrodynPlatform;
use super::spatial::{NONE, Vector, add, from_point};
use super::water_plane;
use crate::note::Note;

impl HydrodynInput {
    /// The restoring stiffness of a floating frame in this water, with gravity (m/s²), without
    /// moorings. `structure` is the mass of the frame without water, and its centre.
    pub(crate) fn restoring(
        &self,
        foundation: &FrameFoundation,
        structure: &RigidBody,
        gravity_m_per_s2: f64,
    ) -> (Restoring, Vec<Note>) {
        let HydrodynPlatform {
            mut platform,
            mut notes,
            ..
        } = self.platform(structure, gravity_m_per_s2);
        // Strips are on the members.
        platform.added_mass = ReferredMatrix::default();
        let planes = self.water_planes(gravity_m_per_s2).into_iter();
        let on_joints = planes.filter_map(|(at_m, matrix)| {
            let joint = foundation.nearest_joint(at_m)?;
            let joint_m = foundation.frame.description().joints[joint].position_m;
            Some((joint, from_point(&matrix, joint_m.map(|x| -x))))
        });
        let restoring = Restoring {
            water_planes: on_joints.collect(),
            platform,
        };
        notes.push(self.note_on_places());
        (restoring, notes)
    }

    /// The water plane of each strip member: its point, and its stiffness matrix about the origin.
    fn water_planes(&self, gravity_m_per_s2: f64) -> Vec<(Vector, SpatialMatrix)> {
        if self.is_static {
            return Vec::new();
        }
        let weight_of_water = self.water.density_kg_per_m3 * gravity_m_per_s2;
        let planes = water_plane::planes(&self.members, &self.water);
        let weighed = planes.map(|(at_m, plane)| {
            let mut matrix = NONE;
            add(&mut matrix, weight_of_water, &plane);
            (at_m, matrix)
        });
        weighed.collect()
    }

    fn note_on_places(&self) -> Note {
        let flow = match self.potential {
            Some(_) => "; the potential-flow body moves with the transition piece",
            None => "",
        };
        let message = format!(
            "the substructure floats: the stiffness of water planes of strip members, and of mooring lines between an anchor and the platform, acts on the nearest joints; the stiffness of other moorings, of buoyancy and of weights acts on the transition piece, and forces at rest do not change the stiffness of members{flow}"
        );
        Note::approximation(message).at(&self.sources[0], 0)
    }
}
