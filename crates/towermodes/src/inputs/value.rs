//! The types of values.

use super::Input;

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
    /// How many there are of something.
    Count(usize),
    /// Yes or no.
    Flag(bool),
    /// One of several names; none where a name may be absent.
    Name(Option<usize>, &'static [&'static str]),
}

/// The type of a field that is a value of the tower file.
pub trait Value {
    /// What the field holds where the tower file does not give the value.
    fn blank(input: &Input) -> Self
    where
        Self: Sized;
    /// What the field holds.
    fn given(&self) -> Given;
    /// Changes the field; a value of another type changes nothing.
    fn set(&mut self, given: Given);
}

/// One of several names.
pub trait Named: Copy + PartialEq + 'static {
    /// The names as in the tower file; the first one is the default of an optional key.
    const NAMES: &'static [&'static str];
    /// The choices in the same order.
    const CHOICES: &'static [Self];

    /// Its name in the tower file.
    fn name(self) -> &'static str {
        place_of(&self).map_or("", |place| Self::NAMES[place])
    }
}

impl Given {
    /// The number, also that of a count, if it is one and given.
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

    /// The number, or that at one end of a pair, 0 for the top and 1 for the bottom, or one of the
    /// coordinates.
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

impl Value for f64 {
    fn blank(input: &Input) -> Self {
        input.default
    }

    fn given(&self) -> Given {
        Given::Number(*self)
    }

    fn set(&mut self, given: Given) {
        *self = given.number().unwrap_or(*self);
    }
}

impl Value for Option<f64> {
    fn blank(_: &Input) -> Self {
        None
    }

    fn given(&self) -> Given {
        Given::Optional(*self)
    }

    fn set(&mut self, given: Given) {
        *self = given.number();
    }
}

impl Value for [f64; 2] {
    fn blank(input: &Input) -> Self {
        [input.default; 2]
    }

    fn given(&self) -> Given {
        Given::Pair(Some(*self))
    }

    fn set(&mut self, given: Given) {
        *self = given.pair().unwrap_or(*self);
    }
}

impl Value for Option<[f64; 2]> {
    fn blank(_: &Input) -> Self {
        None
    }

    fn given(&self) -> Given {
        Given::Pair(*self)
    }

    fn set(&mut self, given: Given) {
        *self = given.pair();
    }
}

impl Value for [f64; 3] {
    fn blank(input: &Input) -> Self {
        [input.default; 3]
    }

    fn given(&self) -> Given {
        Given::Triple(*self)
    }

    fn set(&mut self, given: Given) {
        if let Given::Triple(triple) = given {
            *self = triple;
        }
    }
}

impl Value for usize {
    fn blank(_: &Input) -> Self {
        0
    }

    fn given(&self) -> Given {
        Given::Count(*self)
    }

    fn set(&mut self, given: Given) {
        if let Given::Count(count) = given {
            *self = count;
        }
    }
}

impl Value for bool {
    fn blank(_: &Input) -> Self {
        false
    }

    fn given(&self) -> Given {
        Given::Flag(*self)
    }

    fn set(&mut self, given: Given) {
        *self = given == Given::Flag(true);
    }
}

impl<T: Named> Value for T {
    fn blank(_: &Input) -> Self {
        T::CHOICES[0]
    }

    fn given(&self) -> Given {
        Given::Name(place_of(self), T::NAMES)
    }

    fn set(&mut self, given: Given) {
        *self = chosen(given).unwrap_or(*self);
    }
}

impl<T: Named> Value for Option<T> {
    fn blank(_: &Input) -> Self {
        None
    }

    fn given(&self) -> Given {
        Given::Name(self.as_ref().and_then(place_of), T::NAMES)
    }

    fn set(&mut self, given: Given) {
        *self = chosen(given);
    }
}

fn place_of<T: Named>(choice: &T) -> Option<usize> {
    T::CHOICES.iter().position(|other| other == choice)
}

fn chosen<T: Named>(given: Given) -> Option<T> {
    match given {
        Given::Name(place, _) => T::CHOICES.get(place?).copied(),
        _ => None,
    }
}

/// The names of an enum's variants in the tower file.
macro_rules! names {
    ($type:ident: $($variant:ident = $name:literal),+ $(,)?) => {
        impl crate::inputs::Named for $type {
            const NAMES: &'static [&'static str] = &[$($name),+];
            const CHOICES: &'static [Self] = &[$(Self::$variant),+];
        }
    };
}
pub(crate) use names;
