//! What a mode is called.

use std::fmt;

/// The kind of motion of a mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Family {
    /// Bending in the plane of the wind: translation x, rotation about y.
    ForeAft,
    /// Bending across the wind: translation y, rotation about x.
    SideSide,
    /// Twist about the tower's axis.
    Torsion,
    /// Stretch along the tower's axis.
    Axial,
}

impl Family {
    /// Its name in results: `fore-aft`, `side-side`, `torsion`, `axial`.
    pub fn name(self) -> &'static str {
        match self {
            Self::ForeAft => "fore-aft",
            Self::SideSide => "side-side",
            Self::Torsion => "torsion",
            Self::Axial => "axial",
        }
    }

    /// What one of its modes is called, without the order.
    fn noun(self) -> &'static str {
        match self {
            Self::ForeAft => "fore-aft bending",
            Self::SideSide => "side-side bending",
            Self::Torsion => "torsion",
            Self::Axial => "axial",
        }
    }

    /// The label of its mode of an order (from 1): "2nd fore-aft bending".
    pub fn label(self, order: usize) -> String {
        format!("{} {}", Ordinal(order), self.noun())
    }
}

/// A number as 1st, 2nd, 3rd, 4th …
struct Ordinal(usize);

impl fmt::Display for Ordinal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let suffix = match (self.0 % 10, self.0 % 100) {
            (_, 11..=13) => "th",
            (1, _) => "st",
            (2, _) => "nd",
            (3, _) => "rd",
            _ => "th",
        };
        write!(f, "{}{suffix}", self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::Family;

    #[test]
    fn labels_use_english_ordinals() {
        let label = |order| Family::Torsion.label(order);
        assert_eq!(label(1), "1st torsion");
        assert_eq!(label(2), "2nd torsion");
        assert_eq!(label(11), "11th torsion");
        assert_eq!(label(22), "22nd torsion");
        assert_eq!(label(113), "113th torsion");
    }
}
