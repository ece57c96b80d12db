//! The shapes of a drawing.

use super::colour::Colour;
use super::style::{Stroke, TextStyle};

/// A point on the sheet: x to the right, y downwards.
pub type Point = (f64, f64);

/// One shape, or a group of shapes with a common change.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Shape {
    /// A line through points, with interruptions between runs.
    Lines {
        /// The runs of points that are joined.
        runs: Vec<Vec<Point>>,
        /// The stroke of the line.
        stroke: Stroke,
    },
    /// A filled area.
    Surface {
        /// Its corners in runs, as for a line; the last run is closed.
        runs: Vec<Vec<Point>>,
        /// Its colours.
        paint: Paint,
    },
    /// A rectangle.
    Rectangle {
        /// Its position and size.
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
        /// The style of the text.
        style: TextStyle,
    },
    /// Shapes that are cut at the edges of a rectangle.
    Clipped {
        /// A name that is unique among the groups of the drawing.
        name: String,
        /// The rectangle.
        area: Area,
        /// The shapes.
        shapes: Vec<Shape>,
    },
    /// Shapes that are moved downwards.
    Lowered {
        /// The distance.
        by: f64,
        /// The shapes.
        shapes: Vec<Shape>,
    },
}

/// The colours of an area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Paint {
    /// The fill.
    pub(crate) fill: Colour,
    /// Its edge, if it has one.
    pub(crate) edge: Option<Stroke>,
}

/// The position and the size of a rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Area {
    /// Its upper left corner.
    pub(crate) left_top: Point,
    /// Its width and height, not negative.
    pub(crate) size: (f64, f64),
}

impl Paint {
    /// The colours of an area, with the stroke of its edge if there is one.
    pub(super) fn new(fill: Colour, edge: Option<&Stroke>) -> Self {
        let edge = edge.copied();
        Self { fill, edge }
    }
}

impl Area {
    /// A rectangle; a negative width or height becomes zero.
    pub(super) fn new(left_top: Point, size: (f64, f64)) -> Self {
        let size = (size.0.max(0.0), size.1.max(0.0));
        Self { left_top, size }
    }
}

/// Points divided into runs: a run ends where a point is not finite.
pub(super) fn runs(points: &[Point]) -> Vec<Vec<Point>> {
    let runs = points.split(|(x, y)| !(x.is_finite() && y.is_finite()));
    let runs = runs.filter(|run| !run.is_empty());
    runs.map(<[Point]>::to_vec).collect()
}
