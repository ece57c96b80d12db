//! Texts as outlines of their letters.

use tiny_skia::{Path, PathBuilder};
use ttf_parser::{GlyphId, OutlineBuilder};

use crate::svg::{Anchor, Point, TextStyle, face, text_width};

/// The outlines of a text in DejaVu Sans, with its anchor at the origin and the widths that
/// [`text_width`] measures; none for a text without visible letters.
///
/// Letters that the font does not have are drawn as its symbol for a missing letter.
pub(super) fn outlines(text: &str, style: &TextStyle) -> Option<Path> {
    let face = face(style.is_bold)?;
    let width = |text: &str| text_width(text, style.size, style.is_bold);
    let mut pen = Pen {
        path: PathBuilder::new(),
        scale: style.size / f64::from(face.units_per_em()),
        left: match style.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => -0.5 * width(text),
            Anchor::End => -width(text),
        },
    };
    for letter in text.chars() {
        let glyph = face.glyph_index(letter).unwrap_or(GlyphId(0));
        face.outline_glyph(glyph, &mut pen);
        pen.left += width(letter.encode_utf8(&mut [0; 4]));
    }
    pen.path.finish()
}

/// Builds outlines: the units of the font point upwards, those of the drawing downwards.
struct Pen {
    path: PathBuilder,
    scale: f64,
    left: f64,
}

impl Pen {
    fn point(&self, x: f32, y: f32) -> (f32, f32) {
        let (x, y): Point = (f64::from(x), f64::from(y));
        (
            (self.left + self.scale * x) as f32,
            (-self.scale * y) as f32,
        )
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.point(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.point(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.point(x1, y1), self.point(x, y));
        self.path.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2)) = (self.point(x1, y1), self.point(x2, y2));
        let (x, y) = self.point(x, y);
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}

#[cfg(test)]
mod tests {
    use super::outlines;
    use crate::svg::{Anchor, TextStyle};

    /// DejaVu Sans draws I from x = 201 to 403 and y = 0 to 1493 of 2048: a hundredth of that.
    #[test]
    fn a_letter_has_the_outline_of_the_font() {
        let path = outlines("I", &TextStyle::new(20.48)).expect("ink");
        let bounds = path.bounds();
        let expected = [2.01, 4.03, -14.93, 0.0];
        let found = [bounds.left(), bounds.right(), bounds.top(), bounds.bottom()];
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-5, "{found} is not {expected}");
        }
        assert!(outlines(" ", &TextStyle::new(20.48)).is_none());
    }

    /// I is 604 wide.
    #[test]
    fn anchors_are_by_measured_widths() {
        for (anchor, before) in [(Anchor::Middle, 3.02), (Anchor::End, 6.04)] {
            let style = TextStyle::new(20.48).anchor(anchor);
            let left = outlines("I", &style).expect("ink").bounds().left();
            assert!((left - (2.01 - before)).abs() < 1e-5, "{anchor:?}: {left}");
        }
    }
}
