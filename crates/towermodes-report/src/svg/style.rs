//! The styles of lines, markers and texts.

use super::colour::Colour;

/// The style of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    /// Its colour.
    pub colour: Colour,
    /// Its width.
    pub width: f64,
    /// Its dash pattern.
    pub dash: Dash,
}

impl Stroke {
    /// A solid line.
    pub fn new(colour: Colour, width: f64) -> Self {
        Self {
            colour,
            width,
            dash: Dash::Whole,
        }
    }

    /// The same stroke with a dash pattern.
    pub fn dashed(self, dash: Dash) -> Self {
        Self { dash, ..self }
    }
}

/// The dash pattern of a line, which distinguishes lines without colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dash {
    /// Solid.
    Whole,
    /// Dashed.
    Dashed,
    /// Dotted.
    Dotted,
    /// Alternating dashes and dots.
    DashDot,
    /// Long dashes.
    Long,
}

impl Dash {
    /// The dash pattern of a member of a series, from 0.
    pub fn of_series(index: usize) -> Self {
        [
            Self::Whole,
            Self::Dashed,
            Self::DashDot,
            Self::Dotted,
            Self::Long,
        ][index % 5]
    }

    /// The lengths of dashes and gaps alternating; empty for a solid line.
    pub(crate) fn lengths(self) -> &'static [f32] {
        match self {
            Self::Whole => &[],
            Self::Dashed => &[6.0, 4.0],
            Self::Dotted => &[1.5, 3.0],
            Self::DashDot => &[8.0, 3.0, 1.5, 3.0],
            Self::Long => &[14.0, 5.0],
        }
    }
}

/// A marker at a point, which distinguishes series without colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Marker {
    /// A disc.
    Disc,
    /// A square.
    Square,
    /// A triangle.
    Triangle,
    /// A diamond.
    Diamond,
    /// A cross.
    Cross,
    /// A ring.
    Ring,
}

impl Marker {
    /// The markers of a series in their order.
    pub const SERIES: [Self; 6] = [
        Self::Disc,
        Self::Square,
        Self::Triangle,
        Self::Diamond,
        Self::Cross,
        Self::Ring,
    ];

    /// The marker of a member of a series, from 0. From the seventh member on markers repeat.
    pub fn of_series(index: usize) -> Self {
        Self::SERIES[index % Self::SERIES.len()]
    }
}

/// The part of a text that is at its position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// Its beginning.
    Start,
    /// Its middle.
    Middle,
    /// Its end.
    End,
}

/// The style of a text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TextStyle {
    /// Size of the letters.
    pub size: f64,
    /// Colour.
    pub colour: Colour,
    /// The part of the text that is at its position.
    pub anchor: Anchor,
    /// Whether it is bold.
    pub is_bold: bool,
    /// Whether the text is vertical, upwards.
    pub is_turned: bool,
}

impl TextStyle {
    /// Text of a size in ink colour, beginning at its position.
    pub fn new(size: f64) -> Self {
        Self {
            size,
            colour: Colour::Ink,
            anchor: Anchor::Start,
            is_bold: false,
            is_turned: false,
        }
    }

    /// The same style in another colour.
    pub fn colour(self, colour: Colour) -> Self {
        Self { colour, ..self }
    }

    /// The same style with another anchor.
    pub fn anchor(self, anchor: Anchor) -> Self {
        Self { anchor, ..self }
    }

    /// The same style in bold.
    pub fn bold(self) -> Self {
        Self {
            is_bold: true,
            ..self
        }
    }

    /// The same style for vertical text.
    pub fn turned(self) -> Self {
        Self {
            is_turned: true,
            ..self
        }
    }
}
