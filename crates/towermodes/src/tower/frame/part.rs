//! The parts of a frame by their numbers.

/// A part of a frame by its number, from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FramePart {
    /// The whole frame.
    Whole,
    /// A joint.
    Joint(usize),
    /// A member.
    Member(usize),
    /// A support.
    Support(usize),
    /// A mass on a joint.
    Mass(usize),
    /// An added mass on a joint.
    AddedMass(usize),
    /// Marine growth on members.
    Growth(usize),
    /// The transition piece.
    Transition,
    /// The body of the transition piece.
    Platform,
}
