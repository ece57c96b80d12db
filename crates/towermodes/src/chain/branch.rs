//! A chain as a branch of a frame: each joint with the body above it is a link.

use super::model::{Chain, Link};
use crate::space::{SpatialMatrix, levers, transform_motion};
use crate::subsystem::{Branch, BranchLink};

impl<const D: usize> Chain<D> {
    /// The joints as links, and the matrices at a moving base; D is 6.
    pub(super) fn branch(&self) -> Branch {
        let mut branch = Branch::default();
        let mut height_m = self.links.first().map_or(0.0, |link| link.height_m);
        for (joint, link) in self.links.iter().enumerate() {
            if joint == 0 && link.spring == 0.0 {
                branch.units = std::array::from_fn(|i| link.root[i]);
                branch.base = self.body(joint);
                continue;
            }
            branch.links.push(BranchLink {
                transfer: transfer::<D>(link.height_m - height_m),
                tips: tips(link),
                matrices: [Vec::new(), Vec::new(), pressed(link)],
                body: self.body(joint),
            });
            height_m = link.height_m;
        }
        branch
    }

    /// Inertia, stiffness to the ground and geometric stiffness of the body above a joint.
    fn body(&self, joint: usize) -> [SpatialMatrix; 3] {
        let whole = |matrix: Option<&[[f64; D]; D]>| {
            let entry = |i: usize, j: usize| matrix.map_or(0.0, |matrix| matrix[i][j]);
            std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
        };
        let mut geometric = [[0.0; 6]; 6];
        for lever in levers(D) {
            geometric[lever.by][lever.by] = -self.links[joint].geometric_n_m;
        }
        [
            whole(self.inertias.get(joint)),
            whole(self.foundation.get(joint)),
            geometric,
        ]
    }
}

/// X(h).
fn transfer<const D: usize>(rise_m: f64) -> SpatialMatrix {
    let mut matrix = [[0.0; 6]; 6];
    for column in 0..D {
        let mut motion = [0.0; D];
        motion[column] = 1.0;
        transform_motion(&mut motion, rise_m);
        for (row, entry) in matrix.iter_mut().zip(motion) {
            row[column] = entry;
        }
    }
    matrix
}

/// The motion of the body for the coordinates of its joint: one column for each spring that is not
/// rigid.
fn tips<const D: usize>(link: &Link<D>) -> [Vec<f64>; 6] {
    let moving: Vec<usize> = (0..D).filter(|i| link.root[*i] != 0.0).collect();
    let entry = |i: usize, k: usize| if i == k { link.root[k] } else { 0.0 };
    std::array::from_fn(|i| moving.iter().map(|k| entry(i, *k)).collect())
}

/// A shear deflection δ under a compression N works by −N δ θ, with the rotation θ of the body; for
/// the motion below the joint and its coordinates.
fn pressed<const D: usize>(link: &Link<D>) -> Vec<f64> {
    if link.compression_n == 0.0 {
        return Vec::new();
    }
    let moving: Vec<usize> = (0..D).filter(|i| link.root[*i] != 0.0).collect();
    let rows = 6 + moving.len();
    let mut matrix = vec![0.0; rows * rows];
    for lever in levers(D) {
        let place = |component: usize| moving.iter().position(|k| *k == component);
        let Some(slides) = place(lever.moved) else {
            continue;
        };
        let slid = link.root[lever.moved] * lever.sign * -link.compression_n;
        let mut couple = |with: usize, factor: f64| {
            matrix[(6 + slides) * rows + with] += slid * factor;
            matrix[with * rows + 6 + slides] += slid * factor;
        };
        couple(lever.by, 1.0);
        if let Some(rotates) = place(lever.by) {
            couple(6 + rotates, link.root[lever.by]);
        }
    }
    matrix
}
