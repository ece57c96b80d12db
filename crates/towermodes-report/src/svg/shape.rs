//! What a drawing consists of.

use super::colour::Colour;
use super::style::{Stroke, TextStyle};

/// A point on the sheet: x to the right, y downwards.
pub type Point = (f64, f64);

/// One shape, or shapes that are drawn in another way together.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Shape {
    /// A line through points, interrupted between runs.
    Lines {
        /// The runs of points that are joined.
        runs: Vec<Vec<Point>>,
        /// How the line is drawn.
        stroke: Stroke,
    },
    /// A closed surface.
    Surface {
        /// Its corners, in runs as of a line; the last run is closed.
        runs: Vec<Vec<Point>>,
        /// Its colours.
        paint: Paint,
    },
    /// A rectangle.
    Rectangle {
        /// Its place and size.
        area: Area,
        /// Its colours.
        paint: Paint,
    },
    /// A disc.
    Disc {
        /// Its middle.
        centre: Point,
        /// Its radius.
        radius: f64,
        /// Its colours.
        paint: Paint,
    },
    /// A text whose baseline is at a point.
    Text {
        /// The point.
        at: Point,
        /// The text.
        text: String,
        /// How it is written.
        style: TextStyle,
    },
    /// Shapes that are cut at the edges of a rectangle.
    Clipped {
        /// A name that no other group of the drawing has.
        name: String,
        /// The rectangle.
        area: Area,
        /// The shapes.
        shapes: Vec<Shape>,
    },
    /// Shapes that are moved downwards.
    Lowered {
        /// How far.
        by: f64,
        /// The shapes.
        shapes: Vec<Shape>,
    },
}

/// The colours of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Paint {
    /// The surface itself.
    pub(crate) fill: Colour,
    /// Its edge, if it has one.
    pub(crate) edge: Option<Stroke>,
}

/// The place and the size of a rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Area {
    /// Its upper left corner.
    pub(crate) left_top: Point,
    /// Its width and height, not negative.
    pub(crate) size: (f64, f64),
}

impl Paint {
    /// The colours of a surface, with those of an edge if there is a stroke.
    pub(super) fn new(fill: Colour, edge: Option<&Stroke>) -> Self {
        let edge = edge.copied();
        Self { fill, edge }
    }
}

impl Area {
    /// A rectangle; a negative width or height is none.
    pub(super) fn new(left_top: Point, size: (f64, f64)) -> Self {
        let size = (size.0.max(0.0), size.1.max(0.0));
        Self { left_top, size }
    }
}

/// Points in runs: where a point is not finite, a run ends.
pub(super) fn runs(points: &[Point]) -> Vec<Vec<Point>> {
    let runs = points.split(|(x, y)| !(x.is_finite() && y.is_finite()));
    let runs = runs.filter(|run| !run.is_empty());
    runs.map(<[Point]>::to_vec).collect()
}
