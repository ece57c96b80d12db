//! The static stiffness of a frame at one of its joints.

use std::f64::consts::TAU;

use super::assembly::{assemble, inverse_of_columns};
use super::error::FrameSolveError;
use super::pencil::FramePencil;
use super::recipe::FrameRecipe;
use super::rigid::Motion;
use super::solve::{NO_STIFFNESS_HZ, check_stiffness};
use crate::eigen::{EigenWorkspace, Pencil};
use crate::space::SpatialMatrix;
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
    let assembled = assemble(frame, recipe, &[])?;
    let Some(node) = assembled.joints.get(joint).copied().flatten() else {
        let known = frame.description().joints.get(joint);
        let joint = known.map_or_else(|| joint.to_string(), |joint| joint.name.clone());
        return Err(FrameSolveError::HeldJoint { joint });
    };
    let mut pencil = FramePencil::new(assembled.equations);
    let least = (TAU * NO_STIFFNESS_HZ) * (TAU * NO_STIFFNESS_HZ);
    let modes = pencil.count_below_lambda(least);
    if modes > 0 {
        let mut workspace = EigenWorkspace::default();
        check_stiffness(frame, &assembled.joints, &mut pencil, &mut workspace)?;
        let joint = frame.description().joints[joint].name.clone();
        return Err(FrameSolveError::Mechanism { modes, joint });
    }
    pencil.factorize();
    let nodes = pencil.equations.nodes.len();
    let columns: [Motion; 6] = std::array::from_fn(|component| {
        let mut forces = vec![[0.0; 6]; nodes];
        forces[node][component] = 1.0;
        let mut x = vec![0.0; pencil.size()];
        pencil.equations.gather(&mut forces, &mut x);
        pencil.solve(&mut x);
        let mut motions = Vec::new();
        pencil.equations.set_motions(&x, &mut motions);
        motions[node]
    });
    let inverse: SpatialMatrix = inverse_of_columns(&columns);
    Ok(std::array::from_fn(|i| {
        std::array::from_fn(|j| 0.5 * (inverse[i][j] + inverse[j][i]))
    }))
}
