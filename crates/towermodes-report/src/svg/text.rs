//! Measures the width of text.

use std::sync::OnceLock;

use ttf_parser::Face;

/// Height of a line of text in units of its size.
pub const LINE_HEIGHT: f64 = 1.3;

/// The width of a text at a size, in the units of the drawing.
///
/// It is measured with DejaVu Sans, which is as wide as Verdana and wider than Helvetica and Arial:
/// text that fits in this font fits in the fonts of any browser.
pub fn text_width(text: &str, size: f64, is_bold: bool) -> f64 {
    let Some(face) = face(is_bold) else {
        return size * text.chars().count() as f64;
    };
    let width = |c: char| {
        let glyph = face.glyph_index(c);
        let advance = glyph.and_then(|glyph| face.glyph_hor_advance(glyph));
        advance.map_or(1.0, |advance| {
            f64::from(advance) / f64::from(face.units_per_em())
        })
    };
    size * text.chars().map(width).sum::<f64>()
}

/// The width of the widest of some texts.
pub(crate) fn widest<'a>(texts: impl Iterator<Item = &'a str>, size: f64, is_bold: bool) -> f64 {
    texts.fold(0.0, |widest, text| {
        text_width(text, size, is_bold).max(widest)
    })
}

/// The font, regular or bold.
pub(crate) fn face(is_bold: bool) -> Option<&'static Face<'static>> {
    static REGULAR: OnceLock<Option<Face<'static>>> = OnceLock::new();
    static BOLD: OnceLock<Option<Face<'static>>> = OnceLock::new();
    let face = if is_bold {
        BOLD.get_or_init(|| Face::parse(dejavu::sans::bold(), 0).ok())
    } else {
        REGULAR.get_or_init(|| Face::parse(dejavu::sans::regular(), 0).ok())
    };
    face.as_ref()
}

#[cfg(test)]
mod tests {
    use super::text_width;

    #[test]
    fn widths_are_those_of_the_font() {
        // DejaVu Sans: 2048 units to the em; 0 is 1303 wide, W 2025.
        assert!((text_width("00", 2048.0, false) - 2606.0).abs() < 1e-9);
        assert!((text_width("W", 2048.0, false) - 2025.0).abs() < 1e-9);
        assert!(text_width("W", 10.0, true) > text_width("W", 10.0, false));
    }
}
