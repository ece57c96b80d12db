//! An expected value: its quantity, its number and its tolerance.

use towermodes::Family;

/// What the last digit of an expected value means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Digits {
    /// It was printed, so it was rounded: half a unit of it is left open.
    Printed,
    /// It was computed and is known to about one unit.
    Computed,
}

/// What a value is a value of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// The frequency of a mode by family and order in it, from 1; fore-aft stands for both members
    /// of a pair where the planes are equal.
    Mode(Family, usize),
    /// The frequency of the mode at a place, from 1, in the list of all modes: where motions are
    /// coupled a family is only a name.
    Lowest(usize),
    /// The factor that all weights, multiplied by it, buckle the tower with; it has no unit.
    BucklingLoadFactor,
}

/// A value that is expected of a solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Expected {
    /// What it is a value of.
    pub quantity: Quantity,
    /// The value, in the case's unit.
    pub value: f64,
    /// Digits given after the decimal point.
    pub decimals: usize,
}

impl Expected {
    /// The values of the modes of one family from the first on, written as their source has them.
    ///
    /// # Panics
    /// If a text is not a number: the manual itself would be wrong.
    pub fn series(family: Family, values: &[&str]) -> Vec<Self> {
        let series = values.iter().enumerate();
        series
            .map(|(index, text)| Self::of(family, index + 1, text))
            .collect()
    }

    /// The values of the lowest of all modes, written as their source has them.
    ///
    /// # Panics
    /// As [`series`](Self::series).
    pub fn lowest(values: &[&str]) -> Vec<Self> {
        let places = values.iter().enumerate();
        places
            .map(|(index, text)| Self::parsed(Quantity::Lowest(index + 1), text))
            .collect()
    }

    /// One value, written as its source has it.
    ///
    /// # Panics
    /// As [`series`](Self::series).
    pub fn of(family: Family, order: usize, text: &str) -> Self {
        Self::parsed(Quantity::Mode(family, order), text)
    }

    /// The factor by which weights must grow to buckle the tower, written as its source has it.
    ///
    /// # Panics
    /// As [`series`](Self::series).
    pub fn buckling_load_factor(text: &str) -> Self {
        Self::parsed(Quantity::BucklingLoadFactor, text)
    }

    fn parsed(quantity: Quantity, text: &str) -> Self {
        Self {
            quantity,
            value: text.parse().expect("a number of the manual"),
            decimals: text.split_once('.').map_or(0, |(_, digits)| digits.len()),
        }
    }

    /// What it is a value of: "bending 2", "mode 2".
    pub fn what(&self, planes_are_equal: bool) -> String {
        match self.quantity {
            Quantity::Mode(Family::ForeAft, order) if planes_are_equal => {
                format!("bending {order}")
            }
            Quantity::Mode(family, order) => format!("{} {order}", family.name()),
            Quantity::Lowest(place) => format!("mode {place}"),
            Quantity::BucklingLoadFactor => "buckling load factor".into(),
        }
    }

    /// How much the digits given leave open, in the case's unit.
    pub(crate) fn open(&self, digits: Digits) -> f64 {
        let unit = 0.1_f64.powi(self.decimals as i32);
        match digits {
            // A printed value may lie on the edge of its rounding.
            Digits::Printed => 0.5 * unit * (1.0 + 1e-9),
            Digits::Computed => unit,
        }
    }
}

/// The families that have a mode that is expected of one: both bending planes if they are equal,
/// the family itself else.
pub(crate) fn families(family: Family, planes_are_equal: bool) -> [Family; 2] {
    match family {
        Family::ForeAft if planes_are_equal => [Family::ForeAft, Family::SideSide],
        other => [other, other],
    }
}
