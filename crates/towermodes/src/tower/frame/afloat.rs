//! A floating frame, with its stiffness at the points where it acts.

use super::axes::{difference, norm};
use super::description::JointKind;
use super::foundation::FrameFoundation;
use super::restoring::Held;
use crate::mooring::{Fairlead, cross};
use crate::space::{SpatialMatrix, add_scaled, transform_matrix};
use crate::tower::parts::floating_platform::FloatingPlatform;
use crate::tower::support::base::symmetrized;

type Vector = [f64; 3];

impl FrameFoundation {
    /// Holds the frame of a tower by its water under gravity (m/s²) and by lines that are replaced
    /// by their stiffness: that of `linear`, and of it the part at fairleads.
    pub(in crate::tower) fn hold(
        &mut self,
        linear: &FloatingPlatform,
        fairleads: &[Fairlead],
        gravity_m_per_s2: f64,
    ) {
        let Some(restoring) = &self.restoring else {
            return;
        };
        let platform = &restoring.platform;
        let height_m = platform.hydrostatic.height_m;
        let mut water = symmetrized(&platform.hydrostatic.matrix);
        let turning_over = platform.mass_kg * (platform.center_m[2] - height_m) * gravity_m_per_s2;
        (3..5).for_each(|i| water[i][i] -= turning_over);
        for (joint, plane) in &restoring.water_planes {
            let arm_m = difference(self.joint_m(*joint), [0.0, 0.0, height_m]);
            add_scaled(&mut water, -1.0, &moved(plane, arm_m));
        }
        let mut moorings = symmetrized(&linear.mooring.matrix);
        transform_matrix(&mut moorings, linear.mooring.height_m - height_m);
        let mut moorings_on_joints = Vec::new();
        for fairlead in fairleads {
            let Some(joint) = self.nearest_joint(fairlead.position_m) else {
                continue;
            };
            let about = |point_m| {
                let arm_m = difference(fairlead.position_m, point_m);
                moved(&of_translations(&fairlead.stiffness), arm_m)
            };
            add_scaled(&mut moorings, -1.0, &about([0.0, 0.0, height_m]));
            moorings_on_joints.push((joint, about(self.joint_m(joint))));
        }
        self.held = Some(Held {
            water,
            water_on_joints: restoring.water_planes.clone(),
            moorings,
            moorings_on_joints,
            height_m,
        });
    }

    fn joint_m(&self, joint: usize) -> Vector {
        self.frame.description().joints[joint].position_m
    }

    /// The welded joint of the frame that is nearest to a point (m).
    pub fn nearest_joint(&self, point_m: [f64; 3]) -> Option<usize> {
        let joints = self.frame.description().joints.iter().enumerate();
        let welded = joints.filter(|(_, joint)| joint.kind == JointKind::Cantilever);
        let distances =
            welded.map(|(index, joint)| (index, norm(difference(joint.position_m, point_m))));
        distances
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .map(|(index, _)| index)
    }
}

/// The matrix of a stiffness against translations.
fn of_translations(stiffness: &[[f64; 3]; 3]) -> SpatialMatrix {
    let mut matrix = SpatialMatrix::default();
    for (row, own) in matrix.iter_mut().zip(stiffness) {
        row[..3].copy_from_slice(own);
    }
    matrix
}

/// Tᵀ K T with T = [[1, −[r]], [0, 1]]: the matrix for a point of a rigid body, of one for another
/// point at the arm r (m) from it.
fn moved(matrix: &SpatialMatrix, arm_m: Vector) -> SpatialMatrix {
    let unit = |i: usize| std::array::from_fn(|j| f64::from(u8::from(i == j)));
    let turned: [Vector; 3] = std::array::from_fn(|i| cross(unit(i), arm_m));
    let mut moved = *matrix;
    for row in &mut moved {
        for (j, turned) in turned.iter().enumerate() {
            row[3 + j] += (0..3).map(|l| row[l] * turned[l]).sum::<f64>();
        }
    }
    for (i, turned) in turned.iter().enumerate() {
        let of_force: [f64; 6] =
            std::array::from_fn(|j| (0..3).map(|l| turned[l] * moved[l][j]).sum());
        let moment = moved[3 + i].iter_mut().zip(of_force);
        moment.for_each(|(sum, own)| *sum += own);
    }
    moved
}
