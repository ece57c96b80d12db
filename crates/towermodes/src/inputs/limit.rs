//! Which values a quantity can have at all.

/// Which values a quantity can have at all, beside the infinity that may stand for "rigid".
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Limit {
    /// Any finite number.
    Finite,
    /// A height in the datum of the stations, m: of either sign or zero.
    Height,
    /// Another coordinate, m: of either sign or zero.
    Coordinate,
    /// A depth, m: positive or zero.
    Depth,
    /// A length, m: positive.
    Length,
    /// Positive.
    Positive,
    /// Positive or zero.
    NotNegative,
    /// Positive, and of any size: springs are scaled to themselves.
    Spring,
    /// Positive or zero, and of any size: springs are scaled to themselves.
    Stiffness,
    /// Positive, up to a number.
    UpTo(f64),
    /// From the first number to the second.
    Within([f64; 2]),
    /// An angle from the horizontal, degrees: from 0 to 90.
    Slope,
    /// A loss factor: from 0 to 1.
    LossFactor,
    /// At least so many.
    AtLeast(u64),
    /// Poisson's ratio of soil: from 0 to 0.5.
    PoissonsRatioOfSoil,
    /// None; the check of its struct limits it.
    Elsewhere,
}
