//! Text as outlines of its letters, for a renderer without fonts.

use std::fmt::Write;

use ttf_parser::{GlyphId, OutlineBuilder};

use super::drawing::{short, unescaped};
use super::text::{face, text_width};

const TEXT: &str = "<text ";
const END: &str = "</text>";

/// A picture with every text element of [`Drawing::text`](super::Drawing::text) replaced by a path
/// of the letters' outlines in DejaVu Sans, placed by the widths that [`text_width`] measures.
///
/// Letters that the font does not have are drawn as its sign for a missing one.
pub fn outlined(svg: &str) -> String {
    let mut out = String::with_capacity(2 * svg.len());
    let mut rest = svg;
    while let Some((before, after)) = rest.split_once(TEXT) {
        out.push_str(before);
        let element = after.split_once(END);
        let parts = element.and_then(|(text, rest)| Some((text.split_once('>')?, rest)));
        let Some(((attributes, text), after)) = parts else {
            out.push_str(TEXT);
            rest = after;
            continue;
        };
        out.push_str(&path(attributes, &unescaped(text)));
        rest = after;
    }
    out.push_str(rest);
    out
}

/// The path of one text.
fn path(attributes: &str, text: &str) -> String {
    let number = |name: &str| attribute(attributes, name).and_then(|value| value.parse().ok());
    let (x, y): (f64, f64) = (number("x").unwrap_or(0.0), number("y").unwrap_or(0.0));
    let size = number("font-size").unwrap_or(0.0);
    let is_bold = attribute(attributes, "font-weight") == Some("700");
    let width = text_width(text, size, is_bold);
    let left = match attribute(attributes, "text-anchor") {
        Some("middle") => x - 0.5 * width,
        Some("end") => x - width,
        _ => x,
    };
    let turn = attribute(attributes, "transform").unwrap_or_default();
    let class = attribute(attributes, "class").unwrap_or_default();
    let outlines = outlines(text, (left, y), size, is_bold);
    format!(r#"<path class="{class}" transform="{turn}" d="{outlines}"/>"#)
}

/// The value of an attribute; `name` is preceded by a space or begins the list.
fn attribute<'a>(attributes: &'a str, name: &str) -> Option<&'a str> {
    let mut words = attributes.split('"');
    while let (Some(key), Some(value)) = (words.next(), words.next()) {
        if key.trim().strip_suffix('=') == Some(name) {
            return Some(value);
        }
    }
    None
}

/// The letters of a text from a point on its baseline, as path data.
fn outlines(text: &str, (left, y): (f64, f64), size: f64, is_bold: bool) -> String {
    let mut pen = Pen::default();
    let Some(face) = face(is_bold) else {
        return pen.data;
    };
    pen.scale = size / f64::from(face.units_per_em());
    (pen.left, pen.baseline) = (left, y);
    for letter in text.chars() {
        let glyph = face.glyph_index(letter).unwrap_or(GlyphId(0));
        face.outline_glyph(glyph, &mut pen);
        pen.left += text_width(letter.encode_utf8(&mut [0; 4]), size, is_bold);
    }
    pen.data
}

/// Writes path data: the units of the font upwards become those of the drawing downwards.
#[derive(Default)]
struct Pen {
    data: String,
    scale: f64,
    left: f64,
    baseline: f64,
}

impl Pen {
    fn put<const N: usize>(&mut self, command: char, points: [(f32, f32); N]) {
        self.data.push(command);
        for (x, y) in points {
            let x = self.left + self.scale * f64::from(x);
            let y = self.baseline - self.scale * f64::from(y);
            // Writing to a string cannot fail.
            let _ = write!(self.data, "{} {} ", short(x), short(y));
        }
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.put('M', [(x, y)]);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.put('L', [(x, y)]);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.put('Q', [(x1, y1), (x, y)]);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.put('C', [(x1, y1), (x2, y2), (x, y)]);
    }

    fn close(&mut self) {
        self.data.push('Z');
    }
}

#[cfg(test)]
mod tests {
    use super::outlined;

    #[test]
    fn a_letter_becomes_its_outline_where_the_text_was() {
        let svg = r#"<g><text class="f-ink" x="100" y="50" font-size="20.48">I</text></g>"#;
        // DejaVu Sans draws I from x = 201 to 403 and y = 0 to 1493 of 2048: a hundredth of that.
        let path = outlined(svg);
        assert!(
            path.starts_with(r#"<g><path class="f-ink" transform="" d="M102.01 "#),
            "{path}"
        );
        assert!(path.contains("104.03 "), "{path}");
        assert!(path.contains(" 35.07 "), "{path}");
        assert!(path.ends_with("\"/></g>"), "{path}");
    }

    #[test]
    fn anchors_are_by_measured_widths() {
        let at = |anchor: &str| {
            let svg = format!(
                r#"<text class="f-ink" x="100" y="50" font-size="20.48" text-anchor="{anchor}">I</text>"#
            );
            let path = outlined(&svg);
            let (_, data) = path.split_once("d=\"M").expect("a path");
            data.split(' ')
                .next()
                .and_then(|x| x.parse::<f64>().ok())
                .expect("a number")
        };
        // I is 604 wide.
        assert!((at("middle") - (100.0 - 3.02 + 2.01)).abs() < 0.011);
        assert!((at("end") - (100.0 - 6.04 + 2.01)).abs() < 0.011);
    }

    #[test]
    fn what_is_no_text_stays() {
        let svg = "<svg><path d=\"M0 0\"/><text unfinished";
        assert_eq!(outlined(svg), svg);
    }
}
