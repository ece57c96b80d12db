//! Data of each joint of a chain in a mode.

/// A joint in a mode, in (x, y, z, rotation about x, y, z).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct JointState {
    /// Height, m.
    pub height_m: f64,
    /// Whether it is the base, which the foundation alone holds.
    pub is_base: bool,
    /// The components in which it moves.
    pub moves: [bool; 6],
    /// The motion of the body above, at the joint.
    pub motion: [f64; 6],
    /// The motion of the body above relative to the one below.
    pub own: [f64; 6],
    /// The square of each component's coordinate: twice its strain energy.
    pub strain: [f64; 6],
    /// The translational load (S − λM) v of the body above and of all others above it.
    pub load: [f64; 3],
}
