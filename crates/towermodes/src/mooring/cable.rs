//! An elastic line in its vertical plane: its properties and its shape.

/// Properties of a line that is not lighter than water.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cable {
    /// Weight in water w, N/m; zero or positive.
    pub(super) weight_n_per_m: f64,
    /// EA, N.
    pub(super) axial_stiffness_n: f64,
    /// L, m.
    pub(super) length_m: f64,
    /// C_B.
    pub(super) seabed_friction: f64,
}

/// The shape and the tensions of a line between its lower and its upper end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Profile {
    /// Horizontal tension at the upper end H, N.
    pub(super) horizontal_n: f64,
    /// Horizontal tension at the lower end, N; smaller by the friction on the seabed.
    pub(super) lower_horizontal_n: f64,
    /// Downward force of the line on the lower end, N; negative if it pulls upwards.
    pub(super) lower_n: f64,
    /// Downward force V of the line on the upper end, N.
    pub(super) upper_n: f64,
    /// Height of the lower end above the lowest point of the line, m.
    pub(super) sag_m: f64,
    /// Length on the seabed L_B, m.
    pub(super) on_seabed_m: f64,
    /// Whether it has no horizontal tension, because it lies loosely on the seabed, or no tension
    /// at all.
    pub(super) is_slack: bool,
    /// H/x, N/m: the stiffness normal to the plane.
    pub(super) transverse_n_per_m: f64,
    /// The derivatives of (H, lower, upper pull) by (span, height of the lower, of the upper end)
    /// without friction, N/m; symmetric.
    pub(super) stiffness: [[f64; 3]; 3],
}

impl Profile {
    /// A line without weight and without tension.
    pub(super) fn without_force() -> Self {
        Self {
            horizontal_n: 0.0,
            lower_horizontal_n: 0.0,
            lower_n: 0.0,
            upper_n: 0.0,
            sag_m: 0.0,
            on_seabed_m: 0.0,
            is_slack: true,
            transverse_n_per_m: 0.0,
            stiffness: [[0.0; 3]; 3],
        }
    }
}
