//! The types of values.

use super::{Given, Input};

/// The type of a field that is a value of the tower file.
pub trait Value {
    /// The content of the field if the tower file does not give the value.
    fn blank(input: &Input) -> Self
    where
        Self: Sized;
    /// The content of the field.
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
