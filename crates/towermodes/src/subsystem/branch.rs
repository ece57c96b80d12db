//! A tower as a branch of links: the equations that a supporting structure needs.

use crate::space::SpatialMatrix;

/// A subsystem of all motions as links from its base up, whose vector holds the coordinates of the
/// base and then those of each link.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Branch {
    /// The motion (m or rad) of the base for each of its coordinates; 0 where it is held.
    pub units: [f64; 6],
    /// Inertia, stiffness to the ground and geometric stiffness that are attached to the base.
    pub base: [SpatialMatrix; 3],
    /// The links, from the base up.
    pub links: Vec<BranchLink>,
}

/// A link: what it carries moves by X v + T y, with the motion v of what carries it and its own
/// coordinates y.
#[derive(Debug, Clone, PartialEq)]
pub struct BranchLink {
    /// X.
    pub transfer: SpatialMatrix,
    /// T: 6 rows.
    pub tips: [Vec<f64>; 6],
    /// Inertia, stiffness to the ground and geometric stiffness for v and y, row by row; empty
    /// where there is none.
    pub matrices: [Vec<f64>; 3],
    /// The same of a rigid body that it carries, for its motion.
    pub body: [SpatialMatrix; 3],
}
