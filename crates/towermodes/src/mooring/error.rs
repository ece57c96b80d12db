//! Errors in the description of a mooring system, and a search for its equilibrium that fails.

use std::fmt;

use thiserror::Error;

use crate::number::Plain;

/// A part of a mooring system. Indices count from 0, in messages from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MooringItem {
    /// The surroundings: depth, density, gravity.
    Site,
    /// A type of lines.
    LineType(usize),
    /// A point.
    Point(usize),
    /// A line.
    Line(usize),
    /// A body.
    Body(usize),
    /// A rod.
    Rod(usize),
}

impl fmt::Display for MooringItem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (name, index) = match *self {
            Self::Site => return write!(f, "the mooring"),
            Self::LineType(index) => ("line type", index),
            Self::Point(index) => ("point", index),
            Self::Line(index) => ("line", index),
            Self::Body(index) => ("body", index),
            Self::Rod(index) => ("rod", index),
        };
        write!(f, "{name} {}", index + 1)
    }
}

/// An impossible mooring system, with its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum MooringError {
    /// A value that is NaN or infinite.
    #[error("{quantity} of {item} is {value}, not a finite number")]
    NotFinite {
        /// The part.
        item: MooringItem,
        /// The quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// A value whose magnitude is larger than that of any real mooring system.
    #[error("{quantity} of {item} is {}{unit}; its magnitude must be at most {}{unit}", Plain(*.value), Plain(*.most))]
    TooLarge {
        /// The part.
        item: MooringItem,
        /// The quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// Unit of the value with a leading space, as the message shows it.
        unit: &'static str,
        /// Largest allowed magnitude.
        most: f64,
    },
    /// Zero or negative where only a positive number makes sense.
    #[error("{quantity} of {item} is {}{unit}; it must be positive", Plain(*.value))]
    NotPositive {
        /// The part.
        item: MooringItem,
        /// The quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// Unit of the value with a leading space, as the message shows it.
        unit: &'static str,
    },
    /// Negative where zero is the least.
    #[error("{quantity} of {item} is {}{unit}; it must not be negative", Plain(*.value))]
    Negative {
        /// The part.
        item: MooringItem,
        /// The quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// Unit of the value with a leading space, as the message shows it.
        unit: &'static str,
    },
    /// A part refers to another part that does not exist.
    #[error("{item} refers to {missing}, but the mooring has {count} of that kind")]
    Unknown {
        /// The part.
        item: MooringItem,
        /// What it refers to.
        missing: MooringItem,
        /// Number of existing parts of this kind.
        count: usize,
    },
    /// No lines.
    #[error("the mooring has no lines; it needs at least one between an anchor and the platform")]
    NoLines,
    /// No line is attached to the platform.
    #[error(
        "no line ends at the platform; attach an end of a line to a point of the platform, or to a body or a rod that is fixed to it"
    )]
    NotAtPlatform,
    /// Both ends of a line at one point.
    #[error("both ends of line {} are point {}; a line joins two points", .line + 1, .point + 1)]
    SamePoint {
        /// The line.
        line: usize,
        /// The point.
        point: usize,
    },
    /// A free point, body or rod without lines.
    #[error("{item} is free, but no line ends there; attach a line to it, or remove it")]
    Unconnected {
        /// The free part.
        item: MooringItem,
    },
    /// A rod whose ends are one point.
    #[error("the ends of rod {} are at the same position; a rod needs a length", .rod + 1)]
    RodWithoutLength {
        /// The rod.
        rod: usize,
    },
    /// A point under the seabed.
    #[error(
        "{item} is at z = {} m, under the seabed at z = {} m; move it up, or correct the depth",
        Plain(*.z_m), Plain(-*.depth_m)
    )]
    UnderSeabed {
        /// The point.
        item: MooringItem,
        /// Its height, m.
        z_m: f64,
        /// Depth of the seabed below still water, m.
        depth_m: f64,
    },
    /// A line that would have a larger strain than any rope can have.
    #[error(
        "line {} is too short: its ends are {} m apart and its length is {} m, so that it stretches by more than {} %, where every rope breaks; give it a length of at \
         least {} m, or correct the positions of its ends",
        .line + 1, Plain(*.distance_m), Plain(*.length_m), Plain(100.0 * .most), Plain(distance_m / (1.0 + most))
    )]
    TooShort {
        /// The line.
        line: usize,
        /// Its length without tension, m.
        length_m: f64,
        /// The distance of its ends, m.
        distance_m: f64,
        /// Largest allowed strain: elongation over length without tension.
        most: f64,
    },
    /// A line whose tension is too large or too small for double precision.
    #[error(
        "the tension of line {} is too large or too small to be computed, with its ends {} m apart and a length of {} m; correct its length, weight or stiffness",
        .line + 1, Plain(*.distance_m), Plain(*.length_m)
    )]
    NoTension {
        /// The line.
        line: usize,
        /// Its length without tension, m.
        length_m: f64,
        /// The distance of its ends, m.
        distance_m: f64,
    },
    /// A free part that sinks to the seabed.
    #[error(
        "{item} sinks to z = {} m, and the seabed is at z = {} m; the model has no contact between points and seabed: give it less mass, more volume or shorter lines, or \
         make it a fixed point",
        Plain(*.z_m), Plain(-*.depth_m)
    )]
    Sinks {
        /// The free part.
        item: MooringItem,
        /// Height z that the part reached in the search, m.
        z_m: f64,
        /// Depth of the seabed below still water, m.
        depth_m: f64,
    },
    /// The search for the equilibrium of the free parts has not ended.
    #[error(
        "no equilibrium of the free points and bodies was found in {steps} steps: a force of {} N remains at {item}; correct its mass and volume, or give a position nearer \
         to its equilibrium",
        Plain(*.force_n)
    )]
    NoEquilibrium {
        /// The part with the largest force.
        item: MooringItem,
        /// Remaining force on this part, N.
        force_n: f64,
        /// Number of steps of the search.
        steps: usize,
    },
    /// An unstable equilibrium: the stiffness is not positive.
    #[error(
        "the equilibrium of {item} is unstable: it would turn over or drift away; correct its centre of mass, its volume or its lines, or give a position nearer to its \
         stable equilibrium"
    )]
    Unstable {
        /// The free part.
        item: MooringItem,
    },
}

impl MooringError {
    /// The part that the error concerns; [`MooringItem::Site`] if it concerns the whole system.
    pub fn item(&self) -> MooringItem {
        match *self {
            Self::NotFinite { item, .. }
            | Self::TooLarge { item, .. }
            | Self::NotPositive { item, .. }
            | Self::Negative { item, .. }
            | Self::Unknown { item, .. }
            | Self::Unconnected { item }
            | Self::UnderSeabed { item, .. }
            | Self::Sinks { item, .. }
            | Self::NoEquilibrium { item, .. }
            | Self::Unstable { item } => item,
            Self::SamePoint { line, .. }
            | Self::TooShort { line, .. }
            | Self::NoTension { line, .. } => MooringItem::Line(line),
            Self::RodWithoutLength { rod } => MooringItem::Rod(rod),
            Self::NoLines | Self::NotAtPlatform => MooringItem::Site,
        }
    }
}
