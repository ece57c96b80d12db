//! The static stiffness of a frame at one of its joints.

use super::assembly::{Purpose, assemble};
use super::error::FrameSolveError;
use super::mechanism::least_lambda;
use super::parts::inverse_of_columns;
use super::pencil::FramePencil;
use super::recipe::FrameRecipe;
use super::solve::check_stiffness;
use super::tension::ForcesAtRest;
use crate::eigen::Pencil;
use crate::tower::frame::Frame;

/// Exact to rounding for members in any soil.
const DEGREE: usize = 12;

/// The static stiffness of a frame at a joint: forces and moments (x, y, z, about x, y, z) on the
/// joint for unit motions of it, N/m, N, N m, without the stiffness of weight. For a pile in soil
/// this is the stiffness of its head.
///
/// # Errors
/// [`FrameSolveError::HeldJoint`] if the joint does not exist or cannot move, and as
/// [`solve_frame`](super::solve_frame).
pub fn static_stiffness(frame: &Frame, joint: usize) -> Result<[[f64; 6]; 6], FrameSolveError> {
    let recipe = FrameRecipe::Spectral { degree: DEGREE };
    let assembled = assemble(
        frame,
        recipe,
        &ForcesAtRest::default(),
        Purpose::Frequencies,
    )?;
    let Some(node) = assembled.joints.get(joint).copied().flatten() else {
        let known = frame.description().joints.get(joint);
        let joint = known.map_or_else(|| joint.to_string(), |joint| joint.name.clone());
        return Err(FrameSolveError::HeldJoint { joint });
    };
    let mut pencil = FramePencil::new(assembled.equations);
    let modes = pencil.count_below_lambda(least_lambda());
    if modes > 0 {
        let joints = (&assembled.joints[..], &assembled.joint_of_node[..]);
        if let Some(mechanism) = check_stiffness(frame, joints, &mut pencil)? {
            return Err(mechanism);
        }
        return Err(FrameSolveError::TooSoft { modes });
    }
    pencil.factorize();
    let nodes = pencil.equations.nodes.len();
    let column = |component: usize| {
        let mut forces = vec![[0.0; 6]; nodes];
        forces[node][component] = 1.0;
        let mut x = vec![0.0; pencil.size()];
        pencil.equations.gather(&mut forces, &mut x);
        pencil.solve(&mut x);
        let mut motions = Vec::new();
        pencil.equations.set_motions(&x, &mut motions);
        motions[node].to_vec()
    };
    let columns: Vec<Vec<f64>> = (0..6).map(column).collect();
    let inverse = inverse_of_columns(&columns, 6);
    Ok(std::array::from_fn(|i| {
        std::array::from_fn(|j| 0.5 * (inverse[i][j] + inverse[j][i]))
    }))
}
