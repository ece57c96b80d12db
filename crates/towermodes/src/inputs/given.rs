//! A value as it is given.

/// A value as it is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Given {
    /// A number.
    Number(f64),
    /// A number that may be absent.
    Optional(Option<f64>),
    /// A number at the top and one at the bottom of a layer; the tower file may give one for both.
    Pair(Option<[f64; 2]>),
    /// Coordinates x downwind, y side-side, z up.
    Triple([f64; 3]),
    /// A number of objects.
    Count(usize),
    /// Yes or no.
    Flag(bool),
    /// One of several names; none where a name may be absent.
    Name(Option<usize>, &'static [&'static str]),
}

impl Given {
    /// The number or the count, if it is one of these and given.
    pub fn number(self) -> Option<f64> {
        match self {
            Self::Number(value) => Some(value),
            Self::Optional(value) => value,
            Self::Count(count) => Some(count as f64),
            Self::Pair(_) | Self::Triple(_) | Self::Flag(_) | Self::Name(..) => None,
        }
    }

    /// The numbers of a pair, if it is one and given.
    pub fn pair(self) -> Option<[f64; 2]> {
        match self {
            Self::Pair(pair) => pair,
            Self::Number(_)
            | Self::Optional(_)
            | Self::Triple(_)
            | Self::Count(_)
            | Self::Flag(_)
            | Self::Name(..) => None,
        }
    }

    /// The number; or the number at one end of a pair, `place` 0 for the top and 1 for the bottom;
    /// or one of the coordinates.
    pub fn at(self, place: Option<usize>) -> Option<f64> {
        match (self, place) {
            (Self::Triple(triple), Some(place)) => triple.get(place).copied(),
            (_, Some(place)) => self.pair()?.get(place).copied(),
            (_, None) => self.number(),
        }
    }

    /// Whether it is a number, given or not.
    pub fn is_number(self) -> bool {
        matches!(self, Self::Number(_) | Self::Optional(_))
    }

    /// The same type of value with another number, of a pair given at both ends; anything else
    /// stays as it is.
    #[must_use]
    pub fn with_number(self, number: f64) -> Self {
        match self {
            Self::Number(_) => Self::Number(number),
            Self::Optional(_) => Self::Optional(Some(number)),
            Self::Pair(_) => Self::Pair(Some([number; 2])),
            other @ (Self::Triple(_) | Self::Count(_) | Self::Flag(_) | Self::Name(..)) => other,
        }
    }

    /// The same with another number at one end of a pair, or as one of the coordinates.
    #[must_use]
    pub fn with(self, place: Option<usize>, number: f64) -> Self {
        match (self, place) {
            (Self::Pair(Some([_, bottom])), Some(0)) => Self::Pair(Some([number, bottom])),
            (Self::Pair(Some([top, _])), Some(_)) => Self::Pair(Some([top, number])),
            (Self::Triple(mut triple), Some(place)) => {
                triple[place] = number;
                Self::Triple(triple)
            }
            _ => self.with_number(number),
        }
    }
}
