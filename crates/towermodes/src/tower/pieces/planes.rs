//! The two bending planes.

/// A bending plane of a tower.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Plane {
    /// Bending in the plane of the wind: translation x, rotation about y.
    ForeAft,
    /// Bending across the wind: translation y, rotation about x.
    SideSide,
}

/// A quantity with a value for each bending plane.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Planes<T> {
    /// Its value for bending in the fore-aft plane.
    pub fore_aft: T,
    /// Its value for bending in the side-side plane.
    pub side_side: T,
}

impl<T: Copy> Planes<T> {
    /// The same value in both planes.
    #[inline]
    pub fn both(value: T) -> Self {
        Self {
            fore_aft: value,
            side_side: value,
        }
    }

    /// The value of one plane.
    #[inline]
    pub fn of(&self, plane: Plane) -> T {
        match plane {
            Plane::ForeAft => self.fore_aft,
            Plane::SideSide => self.side_side,
        }
    }

    /// Both values changed in the same way.
    #[inline]
    pub fn map<U>(self, mut change: impl FnMut(T) -> U) -> Planes<U> {
        Planes {
            fore_aft: change(self.fore_aft),
            side_side: change(self.side_side),
        }
    }

    /// Each plane's value of this and of another quantity made into one.
    #[inline]
    pub fn zip<U: Copy, V>(self, other: Planes<U>, mut make: impl FnMut(T, U) -> V) -> Planes<V> {
        Planes {
            fore_aft: make(self.fore_aft, other.fore_aft),
            side_side: make(self.side_side, other.side_side),
        }
    }
}

impl<T: PartialEq> Planes<T> {
    /// Whether both planes have the same value.
    #[inline]
    pub fn are_equal(&self) -> bool {
        self.fore_aft == self.side_side
    }
}
