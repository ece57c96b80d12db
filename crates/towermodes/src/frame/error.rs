//! Errors of the solution of a frame.

use thiserror::Error;

use crate::beam::MAX_DEGREE;
use crate::eigen::EigenError;

/// Why a frame was not solved.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum FrameSolveError {
    /// A frame that moves without resistance.
    #[error(
        "the frame is a mechanism: {modes} {} no stiffness; the first moves joint {joint} {motion}. Fix this motion by a support or a member, or give it a stiffness",
        if *.modes == 1 { "motion has" } else { "motions have" }
    )]
    Mechanism {
        /// How many motions have no stiffness.
        modes: usize,
        /// The joint where the first of these motions is free.
        joint: String,
        /// The largest motion of this joint, "along z" or "about x".
        motion: &'static str,
    },
    /// A frame whose members have nearly no stiffness beside their mass.
    #[error(
        "the members of the frame are too soft for their mass: {modes} {} below 2e-5 Hz; check the positions of the joints and the sections (m) and Young's modulus (Pa)",
        if *.modes == 1 { "mode is" } else { "modes are" }
    )]
    TooSoft {
        /// How many modes are nearly without stiffness.
        modes: usize,
    },
    /// A frame under a tower that no support resists.
    #[error(
        "the frame is not supported: no support has a stiffness against rigid-body motions. Fix a joint, or give a support a stiffness"
    )]
    NothingHolds,
    /// A stiffness with negative eigenvalues.
    #[error(
        "the frame is unstable: its stiffness has {negative} negative {}; check the stiffness matrices of supports and springs",
        if *.negative == 1 { "eigenvalue" } else { "eigenvalues" }
    )]
    Unstable {
        /// Number of negative eigenvalues.
        negative: usize,
    },
    /// Hinges and rigid links in a loop without a member that deforms.
    #[error(
        "joint {joint} is in a loop of rigid links and hinges without a flexible member; replace a rigid link by a beam"
    )]
    RigidLoop {
        /// A joint of the loop.
        joint: String,
    },
    /// Supports that rigid links connect.
    #[error(
        "rigid links connect joint {joint} with another supported joint, so its support has no separate effect; put both supports on one joint"
    )]
    RigidBetweenSupports {
        /// The joint.
        joint: String,
    },
    /// A joint without stiffness of its own.
    #[error(
        "joint {joint} is fixed or does not exist, so the frame has no stiffness at this joint"
    )]
    HeldJoint {
        /// The joint.
        joint: String,
    },
    /// A transition piece under a rotating rotor that rigid links and hinges connect with a
    /// support.
    #[error(
        "rigid links or hinges connect the transition piece with a support, at joint {joint}; under a rotating rotor there must be a flexible member between them: replace a rigid link by a beam, or give the support a stiffness and no fixed motion"
    )]
    RigidTransition {
        /// A joint of this connection.
        joint: String,
    },
    /// A frame under a tower without a transition piece that moves.
    #[error("the frame has no transition piece that could carry the tower; give its joints")]
    NoTransition,
    /// No modes requested, or more than there are.
    #[error("{modes} modes are requested; the frame has {available}")]
    Modes {
        /// The number requested.
        modes: usize,
        /// Degrees of freedom.
        available: usize,
    },
    /// Modes that no double-precision number resolves.
    #[error(
        "{modes} modes are requested, but the frame has only {resolved} that can be resolved: the others have no mass, or are too stiff for double precision"
    )]
    Unresolved {
        /// The number requested.
        modes: usize,
        /// The number of modes that are resolved.
        resolved: usize,
    },
    /// An impossible degree or number of divisions.
    #[error(
        "elements of degree {degree} cannot be made; the degree must be from 2 to {MAX_DEGREE}"
    )]
    Degree {
        /// The degree requested.
        degree: usize,
    },
    /// Zero or too many divisions.
    #[error("{divisions} parts of each member cannot be made; the number must be from 1 to 1000")]
    Divisions {
        /// The number requested.
        divisions: usize,
    },
    /// The eigenvalues were not found.
    #[error(transparent)]
    Eigen(#[from] EigenError),
}
