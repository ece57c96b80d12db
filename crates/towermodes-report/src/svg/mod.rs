//! A small writer of SVG: shapes in the colours of a role, text that is measured, axes.

mod axes;
mod colour;
mod drawing;
mod figure;
mod heading;
mod outlines;
mod scale;
mod style;
mod text;

pub use axes::{Axes, Frame, spread};
pub use colour::{Colour, Theme, contrast, stylesheet};
pub use drawing::{Drawing, LabelBox};
pub use figure::{DataTable, Figure, Look};
pub use heading::Heading;
pub use outlines::outlined;
pub use scale::{Scale, number, power_of_ten};
pub use style::{Anchor, Dash, Marker, Stroke, TextStyle};
pub use text::{LINE_HEIGHT, text_width};
