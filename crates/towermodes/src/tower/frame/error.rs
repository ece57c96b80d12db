//! Errors in the description of a frame, with the place and the numbers.

use std::fmt;

use thiserror::Error;

use super::super::error::Problem;
use super::part::FramePart;
use crate::number::Plain;

/// An invalid description of a frame.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{place}: {problem}")]
pub struct FrameError {
    /// The place of the value.
    pub place: FramePlace,
    /// The problem, with its numbers.
    #[source]
    pub problem: FrameProblem,
}

/// A part of a frame.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum FramePlace {
    /// The whole frame.
    Frame,
    /// A joint, from 0, and its name.
    Joint(usize, String),
    /// A member, from 0, and its name.
    Member(usize, String),
    /// A support, from 0, and the name of its joint.
    Support(usize, String),
    /// A mass, from 0, and the name of its joint.
    Mass(usize, String),
    /// An added mass, from 0, and the name of its joint.
    AddedMass(usize, String),
    /// The transition piece.
    Transition,
}

impl FramePlace {
    /// The part by its number.
    pub fn part(&self) -> FramePart {
        match *self {
            Self::Frame => FramePart::Whole,
            Self::Joint(index, _) => FramePart::Joint(index),
            Self::Member(index, _) => FramePart::Member(index),
            Self::Support(index, _) => FramePart::Support(index),
            Self::Mass(index, _) => FramePart::Mass(index),
            Self::AddedMass(index, _) => FramePart::AddedMass(index),
            Self::Transition => FramePart::Transition,
        }
    }
}

impl fmt::Display for FramePlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Frame => write!(f, "frame"),
            Self::Joint(_, name) => write!(f, "joint {name}"),
            Self::Member(_, name) => write!(f, "member {name}"),
            Self::Support(_, name) => write!(f, "support of joint {name}"),
            Self::Mass(_, name) => write!(f, "mass on joint {name}"),
            Self::AddedMass(_, name) => write!(f, "added mass on joint {name}"),
            Self::Transition => write!(f, "transition piece"),
        }
    }
}

/// A problem in the description of a frame.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum FrameProblem {
    /// An impossible value.
    #[error(transparent)]
    Value(#[from] Problem),
    /// No joint or no member.
    #[error("a frame needs at least one member between two joints")]
    Empty,
    /// A joint number that does not exist.
    #[error("joint number {joint} does not exist; there are {joints} joints, numbered from 0")]
    NoJoint {
        /// The number.
        joint: usize,
        /// How many there are.
        joints: usize,
    },
    /// A member number that does not exist.
    #[error("member number {member} does not exist; there are {members} members, numbered from 0")]
    NoMemberNumber {
        /// The number.
        member: usize,
        /// How many there are.
        members: usize,
    },
    /// Two joints, or two members, with the same name.
    #[error("the name occurs twice; each joint and each member needs a unique name")]
    NameTwice,
    /// A member from a joint to itself, or between two joints at one point.
    #[error(
        "its joints are {} m apart; only a spring or a rigid link may have no length",
        Plain(*.length_m)
    )]
    NoLength {
        /// The distance, m.
        length_m: f64,
    },
    /// A wall thicker than the radius.
    #[error("wall {} m is more than half of the {} m wide section", Plain(*.wall_m), Plain(*.width_m))]
    WallTooThick {
        /// Wall thickness, m.
        wall_m: f64,
        /// Diameter or shorter side, m.
        width_m: f64,
    },
    /// A cable that is compressed.
    #[error(
        "pretension {} N: a cable cannot be compressed; give a pretension of 0 or more, or a beam",
        Plain(*.pretension_n)
    )]
    SlackCable {
        /// Pretension, N.
        pretension_n: f64,
    },
    /// A matrix that is not symmetric.
    #[error("entry ({row}, {column}) of its {matrix} is {}, but entry ({column}, {row}) is {}; the matrix must be symmetric", Plain(*.entry), Plain(*.other))]
    NotSymmetric {
        /// Name of the matrix.
        matrix: &'static str,
        /// Row, from 1.
        row: usize,
        /// Column, from 1.
        column: usize,
        /// The entry.
        entry: f64,
        /// The entry with row and column exchanged.
        other: f64,
    },
    /// A pin whose axis has no direction.
    #[error("the axis of the pin is zero; give a direction, for example (0, 1, 0)")]
    NoAxis,
    /// A universal joint with another number of members.
    #[error("a universal joint connects two members, but {members} end here")]
    UniversalMembers {
        /// How many members end here.
        members: usize,
    },
    /// A support of a joint with a hinge.
    #[error(
        "a pin, universal or ball joint cannot be supported; make the joint welded, and fix only its translations for a pinned foot: fixed = [\"x\", \"y\", \"z\"]"
    )]
    SupportOnHinge,
    /// A joint that must be welded.
    #[error(
        "a pin, universal or ball joint cannot carry {what}; put it on a welded joint, connected by a rigid link"
    )]
    MustBeWelded {
        /// The objects that it carries: "a mass".
        what: &'static str,
    },
    /// Two supports on one joint.
    #[error("the joint is supported twice; give one support for each joint")]
    SupportedTwice,
    /// A support and the transition piece on one joint.
    #[error(
        "joint {joint} is supported and belongs to the transition piece, which moves; remove one of the two"
    )]
    SupportedAndMoved {
        /// Name of the joint.
        joint: String,
    },
    /// A joint of the transition piece that is listed twice, or none.
    #[error("it needs at least one joint, each listed once")]
    TransitionJoints,
    /// A frame that should carry a tower.
    #[error(
        "a frame under a tower needs a transition piece that moves; give its reference point and joints"
    )]
    NoTransition,
    /// Added mass at a position that is not on a beam.
    #[error("added mass at {} of its length; the place must be from 0 to 1 on a beam", Plain(*.fraction))]
    RiderPlace {
        /// The fraction.
        fraction: f64,
    },
    /// Water or growth at positions outside the member.
    #[error("its water or growth is from {} to {} of its length; the range must rise within 0 to 1", Plain(.range[0]), Plain(.range[1]))]
    CoatRange {
        /// The range.
        range: [f64; 2],
    },
    /// Springs of soil that are on no beam or not in order.
    #[error(
        "the rows of its soil must have rising fractions from 0 to 1, at least two different ones, on a beam"
    )]
    SoilRows,
    /// Joints that rigid links connect although they are held differently.
    #[error(
        "rigid links connect two supported joints, which then cannot move; remove the links or one support"
    )]
    RigidBetweenSupports,
    /// Members that no other part is connected to.
    #[error("no member connects joint {joint} with joint {other}; a frame must be in one piece")]
    NotConnected {
        /// A joint of the first part.
        joint: String,
        /// A joint of another part.
        other: String,
    },
    /// A joint without members.
    #[error("no member ends at this joint; remove it")]
    NoMember,
    /// Axes that are not orthonormal.
    #[error("its axes are not three unit vectors at right angles (a right-handed system)")]
    Axes,
}
