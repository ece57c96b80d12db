//! An expected value: its quantity, its number and its tolerance.

use towermodes::Family;

use crate::misprint::Misprint;

/// The uncertainty of the last digit of an expected value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Digits {
    /// The value was rounded for print: half a unit of the last digit.
    Printed,
    /// The value was computed: about one unit of the last digit.
    Computed,
}

/// The quantity that a value belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// The frequency of a mode by family and order within the family, from 1; fore-aft means both
    /// modes of a pair if the planes are equal.
    Mode(Family, usize),
    /// The frequency of a mode by its index, from 1, in the list of all modes; for coupled motions,
    /// which belong to no single family.
    Lowest(usize),
    /// The factor on gravity at which the tower buckles; it has no unit.
    BucklingLoadFactor,
    /// The mass of a frame.
    Mass,
    /// Number of motions of a mechanism without stiffness.
    MotionsWithoutStiffness,
    /// The weight of a floating tower with its platform.
    Weight,
    /// The residual upward force of weight, buoyancy and lines of a floating tower.
    ForceLeft,
    /// An entry of the mooring stiffness for the motions (x, y, z, rotation about x, y, z) of the
    /// platform; row and column from 0.
    Stiffness(usize, usize),
    /// A force or moment on the platform, by the index of its motion, from 0.
    Force(usize),
    /// The tension of a line, from 1, at its upper end: the horizontal component, or the vertical
    /// one if true.
    Tension(usize, bool),
    /// The position at rest of an object in the mooring lines: a coordinate (x, y, z, rotation
    /// about x, y, z), from 0.
    Place(Hanging, usize),
}

/// An object that the mooring lines hold, by its number, from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hanging {
    /// A free point.
    Point(usize),
    /// A body.
    Body(usize),
    /// A rod.
    Rod(usize),
}

/// Directions and rotations in names of quantities.
const AXES: [&str; 6] = ["x", "y", "z", "turn x", "turn y", "turn z"];

impl Quantity {
    /// Its unit, if it is not a frequency.
    pub(crate) fn unit(self) -> Option<&'static str> {
        match self {
            Self::Mode(..) | Self::Lowest(_) => None,
            Self::BucklingLoadFactor | Self::MotionsWithoutStiffness => Some("1"),
            Self::Mass => Some("kg"),
            Self::Weight | Self::ForceLeft => Some("N"),
            Self::Stiffness(0..3, 0..3) => Some("N/m"),
            Self::Stiffness(0..3, _) | Self::Stiffness(_, 0..3) => Some("N"),
            Self::Stiffness(..) => Some("N m"),
            Self::Force(0..3) | Self::Tension(..) => Some("N"),
            Self::Force(_) => Some("N m"),
            Self::Place(_, 0..3) => Some("m"),
            Self::Place(..) => Some("rad"),
        }
    }
}

/// A value that is expected of a solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Expected {
    /// The quantity.
    pub quantity: Quantity,
    /// The value, in the case's unit.
    pub value: f64,
    /// Digits given after the decimal point.
    pub decimals: usize,
    /// The value that should have been printed, if the printed one is known to be wrong.
    pub misprint: Option<Misprint>,
}

impl Expected {
    /// The values of the modes of one family in increasing order, separated by spaces, with the
    /// digits of the source.
    ///
    /// # Panics
    /// If a text is not a number, which is an error in the manual itself.
    pub fn series(family: Family, values: &str) -> Vec<Self> {
        let series = (1..).zip(values.split_whitespace());
        series
            .map(|(order, text)| Self::of(family, order, text))
            .collect()
    }

    /// The values of both bending planes if these differ, as in [`series`](Self::series).
    ///
    /// # Panics
    /// As [`series`](Self::series).
    pub fn planes(fore_aft: &str, side_side: &str) -> Vec<Self> {
        let mut values = Self::series(Family::ForeAft, fore_aft);
        values.extend(Self::series(Family::SideSide, side_side));
        values
    }

    /// The values of the lowest of all modes, separated by spaces, with the digits of the source.
    ///
    /// # Panics
    /// As [`series`](Self::series).
    pub fn lowest(values: &str) -> Vec<Self> {
        let places = (1..).zip(values.split_whitespace());
        places
            .map(|(place, text)| Self::parsed(Quantity::Lowest(place), text))
            .collect()
    }

    /// One value with the digits of the source.
    ///
    /// # Panics
    /// As [`series`](Self::series).
    pub fn of(family: Family, order: usize, text: &str) -> Self {
        Self::parsed(Quantity::Mode(family, order), text)
    }

    /// The factor on gravity at which the tower buckles, with the digits of the source.
    ///
    /// # Panics
    /// As [`series`](Self::series).
    pub fn buckling_load_factor(text: &str) -> Self {
        Self::parsed(Quantity::BucklingLoadFactor, text)
    }

    /// A value of any quantity, with the digits of the source.
    ///
    /// # Panics
    /// As [`series`](Self::series).
    pub fn parsed(quantity: Quantity, text: &str) -> Self {
        Self {
            quantity,
            value: text.parse().expect("a number of the manual"),
            decimals: text.split_once('.').map_or(0, |(_, digits)| digits.len()),
            misprint: None,
        }
    }

    /// The value marked as a misprint, with the correct value.
    #[must_use]
    pub fn instead_of(mut self, correct: f64, reason: &'static str) -> Self {
        self.misprint = Some(Misprint { correct, reason });
        self
    }

    /// The name of its quantity: "bending 2", "mode 2".
    pub fn what(&self, planes_are_equal: bool) -> String {
        match self.quantity {
            Quantity::Mode(Family::ForeAft, order) if planes_are_equal => {
                format!("bending {order}")
            }
            Quantity::Mode(family, order) => format!("{} {order}", family.name()),
            Quantity::Lowest(place) => format!("mode {place}"),
            Quantity::BucklingLoadFactor => "buckling load factor".into(),
            Quantity::Mass => "mass".into(),
            Quantity::Weight => "weight".into(),
            Quantity::ForceLeft => "force left".into(),
            Quantity::MotionsWithoutStiffness => "motions without stiffness".into(),
            Quantity::Stiffness(i, j) => format!("K{}{}", i + 1, j + 1),
            Quantity::Force(i) => format!("F{}", i + 1),
            Quantity::Tension(line, true) => format!("line {line} V"),
            Quantity::Tension(line, false) => format!("line {line} H"),
            Quantity::Place(part, axis) => format!("{} {}", part.name(), AXES[axis]),
        }
    }

    /// The uncertainty of the given digits, in the case's unit.
    pub(crate) fn open(&self, digits: Digits) -> f64 {
        let unit = 0.1_f64.powi(self.decimals as i32);
        match digits {
            // The exact value may lie at the limit of the rounding.
            Digits::Printed => 0.5 * unit * (1.0 + 1e-9),
            Digits::Computed => unit,
        }
    }
}

impl Hanging {
    fn name(self) -> String {
        match self {
            Self::Point(number) => format!("point {number}"),
            Self::Body(number) => format!("body {number}"),
            Self::Rod(number) => format!("rod {number}"),
        }
    }
}

/// The families in which an expected mode must occur: both bending planes if they are equal,
/// otherwise the family itself.
pub(crate) fn families(family: Family, planes_are_equal: bool) -> [Family; 2] {
    match family {
        Family::ForeAft if planes_are_equal => [Family::ForeAft, Family::SideSide],
        other => [other, other],
    }
}
