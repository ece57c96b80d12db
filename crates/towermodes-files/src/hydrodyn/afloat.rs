//! What holds a frame that floats: water plane and lines on the joints near them, the rest on the
//! transition piece.

use towermodes::RigidBody;
use towermodes::frame::{FrameDescription, JointKind, Restoring};
use towermodes::space::SpatialMatrix;

use super::input::HydrodynInput;
use super::spatial::{NONE, Vector, add, difference, from_point, norm, of_mass};
use super::water_plane;
use crate::mooring::Fairlead;
use crate::note::Note;

/// The mooring system of a floater about the origin.
#[derive(Debug, Clone, Default)]
pub(crate) struct Moored {
    /// Stiffness: N/m, N, N m.
    pub(crate) stiffness: SpatialMatrix,
    /// Mass of what is fixed to the platform: kg, kg m, kg m².
    pub(crate) mass: SpatialMatrix,
    /// Its lines, if each holds one fairlead by itself.
    pub(crate) fairleads: Option<Vec<Fairlead>>,
}

impl HydrodynInput {
    /// What holds a frame that floats in this water, under gravity (m/s²). For rigid motions it is
    /// the stiffness of [`platform`](Self::platform), with the moorings, and with the weights of
    /// filling, growth and structure, whose mass has the moment `structure_kg_m` about z = 0.
    pub(crate) fn restoring(
        &self,
        frame: &FrameDescription,
        structure_kg_m: f64,
        moored: &Moored,
        gravity_m_per_s2: f64,
    ) -> (Restoring, Vec<Note>) {
        let on_origin = self.platform(&RigidBody::default(), gravity_m_per_s2);
        let mut rest = on_origin.platform.hydrostatic.matrix;
        let mut moorings = moored.stiffness;
        let moved = [self.filling(), self.growth()].map(|body| body.mass_kg * body.center_m[2]);
        let overturning_n_m = gravity_m_per_s2 * (structure_kg_m + moved[0] + moved[1]);
        (3..5).for_each(|i| rest[i][i] -= overturning_n_m);
        let planes = self.water_planes(gravity_m_per_s2);
        let lines = moored.fairleads.iter().flatten();
        let lines = lines.map(|(at_m, stiffness)| (*at_m, of_mass(stiffness, *at_m)));
        let on_joints = to_joints(frame, planes, &mut rest);
        let moorings_on_joints = to_joints(frame, lines, &mut moorings);
        let restoring = Restoring {
            matrix: rest,
            height_m: 0.0,
            on_joints,
            moorings,
            moorings_on_joints,
        };
        let mut notes = on_origin.notes;
        notes.push(self.note_on_places(moored));
        (restoring, notes)
    }

    /// The inertia of the potential-flow body's water and of the moorings' masses, on a joint.
    pub(crate) fn put_on_joint(&self, frame: &mut FrameDescription, joint: usize, moored: &Moored) {
        let mut inertia = moored.mass;
        if let Some(flow) = &self.potential {
            add(&mut inertia, 1.0, &flow.added_mass.infinite);
        }
        if inertia != NONE
            && let Some(at) = frame.joints.get(joint)
        {
            let inertia = from_point(&inertia, at.position_m.map(|x| -x));
            frame.added_masses.push((joint, inertia));
        }
    }

    /// The water plane of each strip member: its point, and its stiffness for the origin.
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

    fn note_on_places(&self, moored: &Moored) -> Note {
        let lines = match moored.fairleads {
            Some(_) => {
                "the stiffness of water planes of strip members and of mooring lines acts on the nearest joints"
            }
            None => {
                "the stiffness of water planes of strip members acts on the nearest joints, and the stiffness of the moorings on the transition piece"
            }
        };
        let flow = match self.potential {
            Some(_) => {
                "; the potential-flow body, with its added mass at infinite frequency, moves with the transition piece"
            }
            None => "",
        };
        let message = format!(
            "the substructure floats: {lines}; the stiffness of buoyancy and weights acts on the transition piece, and forces at rest do not change the stiffness of members{flow}"
        );
        Note::approximation(message).at(&self.sources[0], 0)
    }
}

/// Matrices for the origin that act at points, as matrices on the nearest joints; they are taken
/// from what acts on the origin.
fn to_joints(
    frame: &FrameDescription,
    local: impl IntoIterator<Item = (Vector, SpatialMatrix)>,
    rest: &mut SpatialMatrix,
) -> Vec<(usize, SpatialMatrix)> {
    let mut on_joints = Vec::new();
    for (at_m, matrix) in local {
        if let Some((joint, position_m)) = nearest_joint(frame, at_m) {
            add(rest, -1.0, &matrix);
            on_joints.push((joint, from_point(&matrix, position_m.map(|x| -x))));
        }
    }
    on_joints
}

/// The welded joint of a frame nearest to a point, and where it is.
fn nearest_joint(frame: &FrameDescription, point_m: Vector) -> Option<(usize, Vector)> {
    let joints = frame.joints.iter().enumerate();
    let welded = joints.filter(|(_, joint)| joint.kind == JointKind::Cantilever);
    let distances = welded.map(|(index, joint)| {
        let distance_m = norm(difference(joint.position_m, point_m));
        (distance_m, index, joint.position_m)
    });
    let nearest = distances.min_by(|a, b| a.0.total_cmp(&b.0));
    nearest.map(|(_, joint, position_m)| (joint, position_m))
}
