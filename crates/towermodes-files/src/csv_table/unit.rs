//! Units of length.

/// A unit of length.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Unit {
    Metres,
    Centimetres,
    Millimetres,
    Feet,
    Inches,
}

/// The units by their names in a header.
const UNITS: [(&str, Unit); 16] = [
    ("m", Unit::Metres),
    ("metre", Unit::Metres),
    ("metres", Unit::Metres),
    ("meter", Unit::Metres),
    ("meters", Unit::Metres),
    ("cm", Unit::Centimetres),
    ("mm", Unit::Millimetres),
    ("millimetre", Unit::Millimetres),
    ("millimetres", Unit::Millimetres),
    ("millimeters", Unit::Millimetres),
    ("ft", Unit::Feet),
    ("foot", Unit::Feet),
    ("feet", Unit::Feet),
    ("in", Unit::Inches),
    ("inch", Unit::Inches),
    ("inches", Unit::Inches),
];

impl Unit {
    pub(crate) fn called(name: &str) -> Option<Self> {
        let found = UNITS.iter().find(|(unit, _)| *unit == name);
        found.map(|(_, unit)| *unit)
    }

    /// A length in metres, rounded to the nearest number by a division, so that 27 mm is exactly
    /// 0.027 m.
    pub(crate) fn metres(self, value: f64) -> f64 {
        match self {
            Self::Metres => value,
            Self::Centimetres => value / 100.0,
            Self::Millimetres => value / 1000.0,
            // International foot and inch (1959).
            Self::Feet => value * 3048.0 / 10_000.0,
            Self::Inches => value * 254.0 / 10_000.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Unit;

    #[test]
    fn lengths_are_the_nearest_numbers() {
        assert_eq!(Unit::Millimetres.metres(27.0), 0.027);
        assert_eq!(Unit::Millimetres.metres(35.1), 0.0351);
        assert_eq!(Unit::Centimetres.metres(387.0), 3.87);
        assert_eq!(Unit::Feet.metres(1.0), 0.3048);
        assert_eq!(Unit::Inches.metres(1.0), 0.0254);
        assert_eq!(Unit::Metres.metres(87.6), 87.6);
    }
}
