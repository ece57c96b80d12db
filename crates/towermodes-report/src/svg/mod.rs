//! A small SVG writer: shapes whose colours are given by roles, measured text, axes.

mod axes;
mod colour;
mod drawing;
mod elements;
mod figure;
mod heading;
mod scale;
mod shape;
mod style;
mod text;

pub use axes::{Axes, Frame, Numbers, spread};
pub use colour::{Colour, Theme, contrast, stylesheet};
pub use drawing::{Drawing, LabelBox};
pub use figure::{DataTable, Figure, Look};
pub use heading::Heading;
pub(crate) use heading::broken;
pub(crate) use scale::extent;
pub use scale::{Scale, number, power_of_ten};
pub use shape::Point;
pub(crate) use shape::{Area, Paint, Shape};
pub use style::{Anchor, Dash, Marker, Stroke, TextStyle};
pub use text::{LINE_HEIGHT, text_width};
pub(crate) use text::{face, widest};
