//! A picture as PNG, painted from the shapes of its drawing. Its text has a font that is part of
//! the program, so it is the same on every system.

mod letters;
mod painter;

use thiserror::Error;
use tiny_skia::Pixmap;

use crate::svg::{Figure, Theme};
use painter::Painter;

/// Pictures with a larger width or height, in pixels, are refused: each pixel needs four bytes.
pub const MAX_PIXELS: u32 = 10_000;

/// Smaller scales are refused, because every picture would be narrower than ten pixels.
pub const MIN_SCALE: f64 = 0.01;

/// Why a picture was not drawn.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RasterError {
    /// The scale is NaN, or too small for a picture.
    #[error("the scale is {scale}; it must be at least {MIN_SCALE}")]
    Scale {
        /// The requested scale.
        scale: f64,
    },
    /// The picture has too many pixels.
    #[error(
        "{width} by {height} at scale {scale} gives {} by {} pixels; each must be at most {MAX_PIXELS}, so the scale must be at most {:.2}",
        (.width * .scale).ceil(), (.height * .scale).ceil(), largest_scale(*.width, *.height)
    )]
    Size {
        /// The width of the drawing.
        width: f64,
        /// The height of the drawing.
        height: f64,
        /// The requested scale.
        scale: f64,
    },
    /// The pixels could not be written as PNG: a bug of the program.
    #[error("the pixels cannot be written: {0}")]
    Encoding(String),
}

/// The largest scale at which a drawing is not refused, rounded down to the digits shown.
fn largest_scale(width: f64, height: f64) -> f64 {
    (100.0 * f64::from(MAX_PIXELS) / width.max(height)).floor() / 100.0
}

/// A picture as PNG, in one theme, with `scale` pixels for each unit of its drawing.
///
/// # Errors
/// [`RasterError`]: a scale below [`MIN_SCALE`], or a side of more than [`MAX_PIXELS`] pixels.
pub fn png(figure: &Figure, theme: Theme, scale: f64) -> Result<Vec<u8>, RasterError> {
    let encoded = pixels(figure, theme, scale)?.encode_png();
    encoded.map_err(|error| RasterError::Encoding(error.to_string()))
}

fn pixels(figure: &Figure, theme: Theme, scale: f64) -> Result<Pixmap, RasterError> {
    let (width, height) = size(figure, scale)?;
    let mut painter = Painter::new(width, height, theme, scale).ok_or(RasterError::Size {
        width: figure.drawing.width,
        height: figure.drawing.height,
        scale,
    })?;
    painter.paint(figure.drawing.shapes());
    Ok(painter.pixmap)
}

/// Width and height in whole pixels.
fn size(figure: &Figure, scale: f64) -> Result<(u32, u32), RasterError> {
    if !(scale.is_finite() && scale >= MIN_SCALE) {
        return Err(RasterError::Scale { scale });
    }
    let (width, height) = (figure.drawing.width, figure.drawing.height);
    // Below a thousandth of a pixel is rounding.
    let pixels = |length: f64| (length * scale - 1e-3).ceil();
    let fits = |length: f64| (1.0..=f64::from(MAX_PIXELS)).contains(&pixels(length));
    if fits(width) && fits(height) {
        Ok((pixels(width) as u32, pixels(height) as u32))
    } else {
        Err(RasterError::Size {
            width,
            height,
            scale,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{RasterError, pixels, png};
    use crate::svg::{Colour, DataTable, Drawing, Figure, LabelBox, Stroke, TextStyle, Theme};

    fn figure(width: f64, height: f64) -> Figure {
        let mut drawing = Drawing::new(width, height);
        drawing.text((10.0, 30.0), "87.6 m", &TextStyle::new(20.0));
        drawing.text((10.0, 70.0), "ζ ≤ 5·10⁻⁴", &TextStyle::new(20.0).bold());
        drawing.line((0.0, 90.0), (200.0, 90.0), &Stroke::new(Colour::Ink, 2.0));
        Figure {
            name: "test".to_owned(),
            title: "A test".to_owned(),
            description: "Two texts and a line.".to_owned(),
            drawing,
            table: DataTable::default(),
        }
    }

    /// Number of pixels in the box of a label that are closer to black than to white.
    fn dark_pixels(figure: &Figure, label: &LabelBox, theme: Theme, scale: f64) -> usize {
        let pixmap = pixels(figure, theme, scale).expect("pixels");
        let within = |x: u32, y: u32| {
            let (x, y) = ((f64::from(x) + 0.5) / scale, (f64::from(y) + 0.5) / scale);
            (label.left..label.right).contains(&x) && (label.top..label.bottom).contains(&y)
        };
        let (width, height) = (pixmap.width(), pixmap.height());
        let all = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let colours = all
            .filter(|(x, y)| within(*x, *y))
            .filter_map(|(x, y)| pixmap.pixel(x, y));
        let dark = colours
            .filter(|c| u16::from(c.red()) + u16::from(c.green()) + u16::from(c.blue()) < 3 * 128);
        dark.count()
    }

    #[test]
    fn the_header_has_the_size_and_the_colours() {
        let png = png(&figure(300.0, 100.0), Theme::Light, 1.5).expect("a PNG");
        // PNG, third edition, 5.2 and 11.2.1: signature, IHDR, width, height, 8 bits, colour with
        // alpha.
        assert_eq!(png[..8], [0x89, b'P', b'N', b'G', 13, 10, 26, 10]);
        assert_eq!(png[12..16], *b"IHDR");
        assert_eq!(png[16..20], 450_u32.to_be_bytes());
        assert_eq!(png[20..24], 150_u32.to_be_bytes());
        assert_eq!(png[24..26], [8, 6]);
    }

    #[test]
    fn text_is_drawn_in_its_box() {
        let figure = figure(300.0, 100.0);
        for (index, label) in figure.labels().iter().enumerate() {
            let dark = dark_pixels(&figure, label, Theme::Light, 2.0);
            let all = 4.0 * (label.right - label.left) * (label.bottom - label.top);
            // Letters cover about a fifth of their box; none at all, or a box of missing glyphs, is
            // another matter.
            let share = dark as f64 / all;
            assert!((0.08..0.45).contains(&share), "label {index}: {share}");
        }
        let labels = figure.labels();
        let on_dark = dark_pixels(&figure, &labels[0], Theme::Dark, 1.0) as f64;
        let all = (labels[0].right - labels[0].left) * (labels[0].bottom - labels[0].top);
        assert!(on_dark / all > 0.6, "letters are light on dark paper");
    }

    #[test]
    fn bold_text_is_bold() {
        let with = |style: TextStyle| {
            let mut figure = figure(300.0, 100.0);
            figure.drawing = Drawing::new(300.0, 100.0);
            figure.drawing.text((10.0, 60.0), "mode", &style);
            // The same box for both, so that ink is compared with ink.
            let label = LabelBox {
                text: String::new(),
                left: 0.0,
                top: 0.0,
                right: 300.0,
                bottom: 100.0,
            };
            dark_pixels(&figure, &label, Theme::Light, 1.0)
        };
        let (regular, bold) = (
            with(TextStyle::new(40.0)),
            with(TextStyle::new(40.0).bold()),
        );
        assert!(5 * bold > 6 * regular, "{bold} beside {regular}");
    }

    #[test]
    fn sizes_that_cannot_be_are_refused() {
        let figure = figure(900.0, 500.0);
        let scale_error = |scale: f64| png(&figure, Theme::Light, scale).expect_err("refused");
        assert_eq!(scale_error(0.0), RasterError::Scale { scale: 0.0 });
        assert_eq!(
            scale_error(1e-9).to_string(),
            "the scale is 0.000000001; it must be at least 0.01"
        );
        assert!(matches!(scale_error(f64::NAN), RasterError::Scale { .. }));
        assert_eq!(
            scale_error(11.2).to_string(),
            "900 by 500 at scale 11.2 gives 10080 by 5600 pixels; each must be at most 10000, so the scale must be at most 11.11"
        );
        assert!(matches!(scale_error(1e300), RasterError::Size { .. }));
        assert_eq!(
            super::size(&figure, 10_000.0 / 900.0).ok(),
            Some((10_000, 5556))
        );
    }
}
