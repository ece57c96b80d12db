//! The shapes of a drawing as elements of SVG.

use std::fmt::Write;

use towermodes::is_printable;

use super::shape::{Area, Paint, Point, Shape};
use super::style::{Anchor, Stroke, TextStyle};

/// The elements of shapes, one per line; every id begins with `id`.
pub(super) fn elements(shapes: &[Shape], id: &str) -> String {
    let mut body = String::new();
    for shape in shapes {
        body.push_str(&element(shape, id));
        body.push('\n');
    }
    body
}

fn element(shape: &Shape, id: &str) -> String {
    match shape {
        Shape::Lines { runs, stroke } => format!(
            r#"<path class="s-{}" fill="none" {} d="{}"/>"#,
            stroke.colour.name(),
            stroke_attributes(stroke),
            path(runs)
        ),
        Shape::Surface { runs, paint } => {
            format!(r#"<path {} d="{}Z"/>"#, painted(paint), path(runs))
        }
        Shape::Rectangle { area, paint } => {
            format!("<rect {} {}/>", painted(paint), placed(area))
        }
        Shape::Disc {
            centre,
            radius,
            paint,
        } => format!(
            r#"<circle {} cx="{}" cy="{}" r="{}"/>"#,
            painted(paint),
            short(centre.0),
            short(centre.1),
            short(*radius)
        ),
        Shape::Text { at, text, style } => written(*at, text, style),
        Shape::Clipped { name, area, shapes } => format!(
            "<clipPath id=\"{id}{name}\"><rect {}/></clipPath><g clip-path=\"url(#{id}{name})\">\n{}</g>",
            placed(area),
            elements(shapes, id)
        ),
        Shape::Lowered { by, shapes } => format!(
            "<g transform=\"translate(0 {})\">\n{}</g>",
            short(*by),
            elements(shapes, id)
        ),
    }
}

fn written(at: Point, text: &str, style: &TextStyle) -> String {
    let (x, y) = (short(at.0), short(at.1));
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
        format!(r#" transform="rotate(-90 {x} {y})""#)
    } else {
        String::new()
    };
    format!(
        r#"<text class="f-{}" x="{x}" y="{y}" font-size="{}"{anchor}{weight}{turn}>{}</text>"#,
        style.colour.name(),
        short(style.size),
        escaped(text)
    )
}

fn placed(area: &Area) -> String {
    let Area { left_top, size } = area;
    format!(
        r#"x="{}" y="{}" width="{}" height="{}""#,
        short(left_top.0),
        short(left_top.1),
        short(size.0),
        short(size.1)
    )
}

fn painted(paint: &Paint) -> String {
    let fill = paint.fill.name();
    match paint.edge {
        None => format!(r#"class="f-{fill}""#),
        Some(stroke) => format!(
            r#"class="f-{fill} s-{}" {}"#,
            stroke.colour.name(),
            stroke_attributes(&stroke)
        ),
    }
}

fn stroke_attributes(stroke: &Stroke) -> String {
    let mut attributes = format!(r#"stroke-width="{}""#, short(stroke.width));
    let lengths = stroke.dash.lengths();
    if !lengths.is_empty() {
        let lengths: Vec<String> = lengths.iter().map(f32::to_string).collect();
        let _ = write!(attributes, r#" stroke-dasharray="{}""#, lengths.join(" "));
    }
    attributes.push_str(r#" stroke-linejoin="round""#);
    attributes
}

fn path(runs: &[Vec<Point>]) -> String {
    let mut path = String::new();
    for run in runs {
        for (index, (x, y)) in run.iter().enumerate() {
            let command = if index == 0 { 'M' } else { 'L' };
            let _ = write!(path, "{command}{} {}", short(*x), short(*y));
        }
    }
    path
}

/// A length in hundredths of a pixel, without trailing zeros.
fn short(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
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
    use super::{elements, escaped, short};
    use crate::svg::{Colour, Drawing, Stroke};

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
        assert!(elements(drawing.shapes(), "").contains("M0 0L1 1M2 2L3 3"));
    }
}
