//! The limits of the values of a quantity.

/// The limits of the values of a quantity; infinity may be allowed in addition, for "rigid".
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
    /// Positive and of any magnitude: coordinates are scaled by the springs.
    Spring,
    /// Positive or zero and of any magnitude: coordinates are scaled by the springs.
    Stiffness,
    /// Positive and at most this number.
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
    /// A moment of inertia; the check of the whole tensor limits it.
    Inertia,
    /// No limit here; the check of its struct limits it.
    Elsewhere,
}

/// Whether the values of a quantity can be negative or zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Nature {
    /// A height in the datum of the tower file.
    Height,
    /// A coordinate, an angle, a product of inertia, Poisson's ratio: positive, negative or zero.
    Signed,
    /// A mass, a spring: positive, or zero where there is none.
    Amount,
    /// A length, a density, a factor: always positive.
    Size,
}

impl Nature {
    /// Whether it is positive, or zero where there is none.
    pub fn is_amount(self) -> bool {
        match self {
            Self::Amount | Self::Size => true,
            Self::Height | Self::Signed => false,
        }
    }
}

impl Limit {
    /// The nature of values with this limit.
    pub fn nature(self) -> Nature {
        match self {
            Self::Height => Nature::Height,
            Self::Finite
            | Self::Coordinate
            | Self::Slope
            | Self::PoissonsRatioOfSoil
            | Self::Elsewhere => Nature::Signed,
            Self::Depth
            | Self::NotNegative
            | Self::Stiffness
            | Self::LossFactor
            | Self::Inertia => Nature::Amount,
            Self::Length | Self::Positive | Self::Spring | Self::UpTo(_) | Self::AtLeast(_) => {
                Nature::Size
            }
            Self::Within([least, _]) if least < 0.0 => Nature::Signed,
            Self::Within(_) => Nature::Amount,
        }
    }
}
