//! Units of the columns of a profile.

use crate::csv_table::Unit;

/// The dimension of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Dimension {
    Length,
    Pressure,
    Velocity,
    Number,
}

/// The factor from a unit to SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Factor {
    One,
    Length(Unit),
    /// A power of ten.
    Ten(i32),
    Times(f64),
}

/// Pounds-force per square foot in Pa: 0.45359237 kg · 9.80665 m/s² / (0.3048 m)².
const PSF: f64 = 47.880_258_980_335_84;

const PRESSURES: [(&str, Factor); 15] = [
    ("pa", Factor::One),
    ("n/m2", Factor::One),
    ("n/m²", Factor::One),
    ("kpa", Factor::Ten(3)),
    ("kn/m2", Factor::Ten(3)),
    ("kn/m²", Factor::Ten(3)),
    ("mpa", Factor::Ten(6)),
    ("mn/m2", Factor::Ten(6)),
    ("mn/m²", Factor::Ten(6)),
    ("gpa", Factor::Ten(9)),
    ("bar", Factor::Ten(5)),
    ("psf", Factor::Times(PSF)),
    ("ksf", Factor::Times(1e3 * PSF)),
    ("tsf", Factor::Times(2e3 * PSF)),
    ("psi", Factor::Times(144.0 * PSF)),
];

const VELOCITIES: [(&str, Factor); 4] = [
    ("m/s", Factor::One),
    ("m_per_s", Factor::One),
    ("ft/s", Factor::Length(Unit::Feet)),
    ("ft_per_s", Factor::Length(Unit::Feet)),
];

impl Dimension {
    /// The unit with a name in lower case.
    pub(super) fn unit(self, name: &str) -> Option<Factor> {
        let named = |list: &[(&str, Factor)]| {
            let found = list.iter().find(|(unit, _)| *unit == name);
            found.map(|(_, factor)| *factor)
        };
        match self {
            Self::Length => Unit::called(name).map(Factor::Length),
            Self::Pressure => named(&PRESSURES),
            Self::Velocity => named(&VELOCITIES),
            Self::Number => None,
        }
    }

    /// Its units in messages.
    pub(super) fn what(self) -> &'static str {
        match self {
            Self::Length => "unit of length",
            Self::Pressure => "unit of pressure",
            Self::Velocity => "unit of velocity",
            Self::Number => "unit of a number of blows",
        }
    }

    /// A unit for an example.
    pub(super) fn example(self) -> &'static str {
        match self {
            Self::Length => "m",
            Self::Pressure => "kPa",
            Self::Velocity => "m/s",
            Self::Number => "-",
        }
    }
}

/// The units of a dimension in a hint.
pub(super) fn units(dimension: Dimension) -> String {
    let units = match dimension {
        Dimension::Length => "m, cm, mm, ft and in",
        Dimension::Pressure => "Pa, kPa, MPa, GPa, N/m2, kN/m2, MN/m2, bar, psf, ksf, tsf and psi",
        Dimension::Velocity => "m/s and ft/s",
        Dimension::Number => "",
    };
    units.to_owned()
}

impl Factor {
    /// The value in SI units; with a power of ten it is the nearest number, so that 1.005 kPa is
    /// exactly 1005 Pa.
    pub(super) fn si(self, value: f64) -> f64 {
        match self {
            Self::One => value,
            Self::Length(unit) => unit.metres(value),
            Self::Ten(power) => format!("{value}e{power}").parse().unwrap_or(f64::INFINITY),
            Self::Times(factor) => value * factor,
        }
    }
}
