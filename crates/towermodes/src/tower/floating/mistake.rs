//! Why a floating tower has no equilibrium.

use thiserror::Error;

use crate::mooring::MooringError;
use crate::number::Rounded;

/// Stiffness against rotation is that of small angles: beyond this tilt, degrees, it misses more
/// than some percent.
pub(super) const MOST_TILT_DEG: f64 = 15.0;

/// Why a floating tower has no known equilibrium.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum EquilibriumError {
    /// Gravity is omitted, so there is no weight to balance.
    #[error(
        "gravity is left out, so the floating tower has no weight that could be in balance; give gravity, or leave the lines at the reference position"
    )]
    NoGravity,
    /// The buoyancy is not given.
    #[error(
        "the buoyancy of the platform is not known, so its equilibrium cannot be computed; give buoyancy and buoyancy_center in [foundation]"
    )]
    NoBuoyancy,
    /// During the search a line cannot reach between its ends, or the free parts have no
    /// equilibrium.
    #[error(
        "the floating tower drifts to where its mooring lines cannot hold it: {0}; compare weight, buoyancy and the vertical force of the lines"
    )]
    Lines(MooringError),
    /// A stiffness is negative at the reference position.
    #[error(
        "the floating tower has no stable equilibrium: its stiffness against {motion} is negative; check the heights of masses, hydrostatic stiffness and fairleads"
    )]
    Unstable {
        /// The motion with the most negative stiffness.
        motion: &'static str,
    },
    /// A stiffness is negative on the way from the reference position, where it is positive.
    #[error(
        "the floating tower has no equilibrium near its reference position: where its forces move it, {} m and {} degrees away, its stiffness against {motion} is negative; the modes are computed at the reference position, where the tower is stable; compare weight, buoyancy and the vertical force of the lines",
        Rounded(*.shift_m), Rounded(*.tilt_deg)
    )]
    UnstableAway {
        /// The motion with the most negative stiffness.
        motion: &'static str,
        /// The distance from the reference position, m.
        shift_m: f64,
        /// The angle between the axis of the tower and the vertical, degrees.
        tilt_deg: f64,
    },
    /// The tilt is too large for linear hydrostatics.
    #[error("the floating tower tilts by {} degrees until its forces are in balance, more than the {MOST_TILT_DEG} degrees for which the hydrostatic stiffness holds; check the horizontal positions of masses, buoyancy and fairleads", Rounded(*.tilt_deg))]
    Tilts {
        /// The angle, degrees.
        tilt_deg: f64,
    },
    /// A force or moment remains at the end of the search.
    #[error("no equilibrium of the floating tower was found: a force or moment of {} N or N m remains in {motion}; if the platform has no stiffness against this motion, give mooring lines or their matrix", Rounded(*.left))]
    NotHeld {
        /// The motion.
        motion: &'static str,
        /// The largest force (N) or moment (N m) that is left.
        left: f64,
    },
}
