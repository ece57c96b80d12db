//! A sheet on which shapes and texts are drawn.

use super::colour::Colour;
use super::shape::{Area, Paint, Point, Shape, runs};
use super::style::{Anchor, Marker, Stroke, TextStyle};
use super::text::text_width;

/// A text that was written and the box around it.
#[derive(Debug, Clone, PartialEq)]
pub struct LabelBox {
    /// The text.
    pub text: String,
    /// The left edge.
    pub left: f64,
    /// The upper edge.
    pub top: f64,
    /// The right edge.
    pub right: f64,
    /// The lower edge.
    pub bottom: f64,
}

impl LabelBox {
    /// Whether it overlaps another box by more than an edge.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }
}

/// A sheet: x to the right, y downwards, in pixels.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    /// Its width.
    pub width: f64,
    /// Its height.
    pub height: f64,
    shapes: Vec<Shape>,
    labels: Vec<LabelBox>,
}

impl Drawing {
    /// An empty sheet.
    pub fn new(width: f64, height: f64) -> Self {
        Self {
            width,
            height,
            shapes: Vec::new(),
            labels: Vec::new(),
        }
    }

    /// The shapes, in the order in which they are drawn.
    pub(crate) fn shapes(&self) -> &[Shape] {
        &self.shapes
    }

    /// The texts that were written.
    pub fn labels(&self) -> &[LabelBox] {
        &self.labels
    }

    /// A straight line.
    pub fn line(&mut self, from: Point, to: Point, stroke: &Stroke) {
        self.polyline(&[from, to], stroke);
    }

    /// A line through points; it is interrupted where a point is not finite.
    pub fn polyline(&mut self, points: &[Point], stroke: &Stroke) {
        let (runs, stroke) = (runs(points), *stroke);
        if !runs.is_empty() {
            self.shapes.push(Shape::Lines { runs, stroke });
        }
    }

    /// A filled polygon, with an edge if there is a stroke.
    pub fn polygon(&mut self, points: &[Point], fill: Colour, edge: Option<&Stroke>) {
        let (runs, paint) = (runs(points), Paint::new(fill, edge));
        if !runs.is_empty() {
            self.shapes.push(Shape::Surface { runs, paint });
        }
    }

    /// A rectangle, with an edge if there is a stroke.
    pub fn rectangle(
        &mut self,
        left_top: Point,
        size: (f64, f64),
        fill: Colour,
        edge: Option<&Stroke>,
    ) {
        let (area, paint) = (Area::new(left_top, size), Paint::new(fill, edge));
        self.shapes.push(Shape::Rectangle { area, paint });
    }

    /// A disc, with an edge if there is a stroke.
    pub fn disc(&mut self, centre: Point, radius: f64, fill: Colour, edge: Option<&Stroke>) {
        let paint = Paint::new(fill, edge);
        self.shapes.push(Shape::Disc {
            centre,
            radius,
            paint,
        });
    }

    /// A marker at a point; `radius` is the distance from its middle to its edge.
    pub fn marker(&mut self, marker: Marker, at: Point, radius: f64, colour: Colour) {
        let (x, y) = at;
        if !(x.is_finite() && y.is_finite()) {
            return;
        }
        let (r, stroke) = (radius, Stroke::new(colour, 0.4 * radius));
        match marker {
            Marker::Disc => self.disc(at, r, colour, None),
            Marker::Ring => self.disc(at, r, Colour::Paper, Some(&stroke)),
            Marker::Square => {
                self.rectangle((x - 0.9 * r, y - 0.9 * r), (1.8 * r, 1.8 * r), colour, None);
            }
            Marker::Triangle => self.polygon(
                &[(x - r, y + 0.8 * r), (x + r, y + 0.8 * r), (x, y - r)],
                colour,
                None,
            ),
            Marker::Diamond => {
                let r = 1.2 * r;
                self.polygon(
                    &[(x - r, y), (x, y + r), (x + r, y), (x, y - r)],
                    colour,
                    None,
                );
            }
            Marker::Cross => {
                self.line((x - r, y - r), (x + r, y + r), &stroke);
                self.line((x - r, y + r), (x + r, y - r), &stroke);
            }
        }
    }

    /// A text whose baseline is at the point.
    pub fn text(&mut self, at: Point, text: &str, style: &TextStyle) {
        self.shapes.push(Shape::Text {
            at,
            text: text.to_owned(),
            style: *style,
        });
        self.labels.push(label_box(at, text, style));
    }

    /// Draws inside a rectangle; everything outside is cut. `name` must be unique in the drawing.
    pub fn clipped(
        &mut self,
        name: &str,
        left_top: Point,
        size: (f64, f64),
        draw: impl FnOnce(&mut Self),
    ) {
        let before = self.shapes.len();
        draw(self);
        let shapes = self.shapes.split_off(before);
        self.shapes.push(Shape::Clipped {
            name: name.to_owned(),
            area: Area::new(left_top, size),
            shapes,
        });
    }

    /// The drawing on a sheet that is higher by this amount, with the additional room above.
    pub(super) fn lowered(self, by: f64) -> Self {
        let mut labels = self.labels;
        for label in &mut labels {
            label.top += by;
            label.bottom += by;
        }
        let shapes = self.shapes;
        Self {
            width: self.width,
            height: self.height + by,
            shapes: vec![Shape::Lowered { by, shapes }],
            labels,
        }
    }
}

fn label_box(at: Point, text: &str, style: &TextStyle) -> LabelBox {
    let width = text_width(text, style.size, style.is_bold);
    let before = match style.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => 0.5 * width,
        Anchor::End => width,
    };
    let (x, y) = at;
    let (above, below) = (0.78 * style.size, 0.24 * style.size);
    let text = text.to_owned();
    if style.is_turned {
        return LabelBox {
            text,
            left: x - above,
            right: x + below,
            top: y + before - width,
            bottom: y + before,
        };
    }
    LabelBox {
        text,
        left: x - before,
        right: x - before + width,
        top: y - above,
        bottom: y + below,
    }
}

#[cfg(test)]
mod tests {
    use super::Drawing;
    use crate::svg::{Anchor, TextStyle};

    #[test]
    fn boxes_of_turned_text_stand_upright() {
        let mut drawing = Drawing::new(100.0, 100.0);
        let style = TextStyle::new(10.0).anchor(Anchor::Middle).turned();
        drawing.text((20.0, 50.0), "height", &style);
        let label = &drawing.labels()[0];
        assert!(label.bottom - label.top > label.right - label.left);
        assert!((0.5 * (label.bottom + label.top) - 50.0).abs() < 1e-9);
    }
}
