//! Shapes and text on a sheet.

use std::fmt::Write;

use towermodes::is_printable;

use super::colour::Colour;
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
    /// Whether it shares more than an edge with another.
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
    body: String,
    labels: Vec<LabelBox>,
}

impl Drawing {
    /// An empty sheet.
    pub fn new(width: f64, height: f64) -> Self {
        Self {
            width,
            height,
            body: String::new(),
            labels: Vec::new(),
        }
    }

    /// The elements of SVG.
    pub fn body(&self) -> &str {
        &self.body
    }

    /// The texts that were written.
    pub fn labels(&self) -> &[LabelBox] {
        &self.labels
    }

    /// A straight line.
    pub fn line(&mut self, from: (f64, f64), to: (f64, f64), stroke: &Stroke) {
        self.polyline(&[from, to], stroke);
    }

    /// A line through points; where a point is not finite it is interrupted.
    pub fn polyline(&mut self, points: &[(f64, f64)], stroke: &Stroke) {
        let path = path_through(points);
        if path.is_empty() {
            return;
        }
        let attributes = stroke_attributes(stroke);
        self.put(&format!(
            r#"<path class="s-{}" fill="none" {attributes} d="{path}"/>"#,
            stroke.colour.name()
        ));
    }

    /// A closed surface, with an edge if there is a stroke.
    pub fn polygon(&mut self, points: &[(f64, f64)], fill: Colour, edge: Option<&Stroke>) {
        let path = path_through(points);
        if path.is_empty() {
            return;
        }
        let painted = painted(fill, edge);
        self.put(&format!(r#"<path {painted} d="{path}Z"/>"#));
    }

    /// A rectangle, with an edge if there is a stroke.
    pub fn rectangle(
        &mut self,
        left_top: (f64, f64),
        size: (f64, f64),
        fill: Colour,
        edge: Option<&Stroke>,
    ) {
        let (x, y) = left_top;
        let (width, height) = size;
        let painted = painted(fill, edge);
        self.put(&format!(
            r#"<rect {painted} x="{}" y="{}" width="{}" height="{}"/>"#,
            short(x),
            short(y),
            short(width.max(0.0)),
            short(height.max(0.0))
        ));
    }

    /// A disc, with an edge if there is a stroke.
    pub fn disc(&mut self, center: (f64, f64), radius: f64, fill: Colour, edge: Option<&Stroke>) {
        let painted = painted(fill, edge);
        self.put(&format!(
            r#"<circle {painted} cx="{}" cy="{}" r="{}"/>"#,
            short(center.0),
            short(center.1),
            short(radius)
        ));
    }

    /// A mark at a point, `radius` from its middle to its edge.
    pub fn marker(&mut self, marker: Marker, at: (f64, f64), radius: f64, colour: Colour) {
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
    pub fn text(&mut self, at: (f64, f64), text: &str, style: &TextStyle) {
        let (x, y) = at;
        let anchor = match style.anchor {
            Anchor::Start => "",
            Anchor::Middle => r#" text-anchor="middle""#,
            Anchor::End => r#" text-anchor="end""#,
        };
        let weight = if style.is_bold {
            r#" font-weight="700""#
        } else {
            ""
        };
        let turn = if style.is_turned {
            format!(r#" transform="rotate(-90 {} {})""#, short(x), short(y))
        } else {
            String::new()
        };
        self.put(&format!(
            r#"<text class="f-{}" x="{}" y="{}" font-size="{}"{anchor}{weight}{turn}>{}</text>"#,
            style.colour.name(),
            short(x),
            short(y),
            short(style.size),
            escaped(text)
        ));
        self.labels.push(label_box(at, text, style));
    }

    /// Draws inside a rectangle; everything beyond it is cut. `name` must be unique in the drawing.
    pub fn clipped(
        &mut self,
        name: &str,
        left_top: (f64, f64),
        size: (f64, f64),
        draw: impl FnOnce(&mut Self),
    ) {
        self.put(&format!(
            r#"<clipPath id="{ID}{name}"><rect x="{}" y="{}" width="{}" height="{}"/></clipPath><g clip-path="url(#{ID}{name})">"#,
            short(left_top.0),
            short(left_top.1),
            short(size.0),
            short(size.1)
        ));
        draw(self);
        self.put("</g>");
    }

    /// The same on a sheet that is higher by so much, with the room above it.
    pub(super) fn lowered(self, by: f64) -> Self {
        let mut labels = self.labels;
        for label in &mut labels {
            label.top += by;
            label.bottom += by;
        }
        Self {
            width: self.width,
            height: self.height + by,
            body: format!(
                "<g transform=\"translate(0 {})\">\n{}</g>\n",
                short(by),
                self.body
            ),
            labels,
        }
    }

    fn put(&mut self, element: &str) {
        self.body.push_str(element);
        self.body.push('\n');
    }
}

/// Stands before every id of a drawing; a figure puts its own name there.
pub(super) const ID: &str = "@id@";

fn label_box(at: (f64, f64), text: &str, style: &TextStyle) -> LabelBox {
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

fn painted(fill: Colour, edge: Option<&Stroke>) -> String {
    match edge {
        None => format!(r#"class="f-{}""#, fill.name()),
        Some(stroke) => format!(
            r#"class="f-{} s-{}" {}"#,
            fill.name(),
            stroke.colour.name(),
            stroke_attributes(stroke)
        ),
    }
}

fn stroke_attributes(stroke: &Stroke) -> String {
    let mut attributes = format!(r#"stroke-width="{}""#, short(stroke.width));
    if let Some(pattern) = stroke.dash.pattern() {
        let _ = write!(attributes, r#" stroke-dasharray="{pattern}""#);
    }
    attributes.push_str(r#" stroke-linejoin="round""#);
    attributes
}

fn path_through(points: &[(f64, f64)]) -> String {
    let mut path = String::new();
    let mut is_drawing = false;
    for (x, y) in points {
        if !(x.is_finite() && y.is_finite()) {
            is_drawing = false;
            continue;
        }
        let command = if is_drawing { 'L' } else { 'M' };
        let _ = write!(path, "{command}{} {}", short(*x), short(*y));
        is_drawing = true;
    }
    path
}

/// A length in hundredths of a pixel, without zeros at its end.
pub(super) fn short(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

/// The text that [`escaped`] wrote.
pub(super) fn unescaped(text: &str) -> String {
    let signs = text
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&quot;", "\"");
    signs.replace("&amp;", "&")
}

/// A text escaped for SVG, without characters that XML forbids.
pub(super) fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            // XML has no control characters, and marks of direction would show numbers backwards.
            c if !is_printable(c) || matches!(c, '\u{fffe}' | '\u{ffff}') => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::{Drawing, escaped, short};
    use crate::svg::{Anchor, Colour, Stroke, TextStyle};

    #[test]
    fn lengths_are_short() {
        assert_eq!(short(1.0), "1");
        assert_eq!(short(-0.001), "0");
        assert_eq!(short(120.0), "120");
        assert_eq!(short(0.126), "0.13");
    }

    #[test]
    fn text_cannot_break_out_of_its_element() {
        assert_eq!(escaped("a<b & \"c\"\u{1}"), "a&lt;b &amp; &quot;c&quot; ");
        assert_eq!(escaped("\u{202e}0.32 Hz\u{2069}"), " 0.32 Hz ");
    }

    #[test]
    fn boxes_of_turned_text_stand_upright() {
        let mut drawing = Drawing::new(100.0, 100.0);
        let style = TextStyle::new(10.0).anchor(Anchor::Middle).turned();
        drawing.text((20.0, 50.0), "height", &style);
        let label = &drawing.labels()[0];
        assert!(label.bottom - label.top > label.right - label.left);
        assert!((0.5 * (label.bottom + label.top) - 50.0).abs() < 1e-9);
    }

    #[test]
    fn lines_are_interrupted_where_there_is_no_number() {
        let mut drawing = Drawing::new(10.0, 10.0);
        let points = [
            (0.0, 0.0),
            (1.0, 1.0),
            (f64::NAN, 0.0),
            (2.0, 2.0),
            (3.0, 3.0),
        ];
        drawing.polyline(&points, &Stroke::new(Colour::Ink, 1.0));
        assert!(drawing.body().contains("M0 0L1 1M2 2L3 3"));
    }
}
