//! Labels in a column to the right of the ends of lines, moved apart, each with a leader.

use crate::svg::{Colour, Drawing, Marker, Stroke, TextStyle, broken, spread, text_width};

/// Size of the letters.
const SIZE: f64 = 11.0;
/// Distance from label to label.
pub(in crate::figures) const GAP: f64 = 14.0;
/// Length of the leader, from the field to a label.
const LEADER: f64 = 22.0;
/// Width of a marker before a label.
const MARKER: f64 = 14.0;
/// Distance between the labels and the edge of the picture.
const MARGIN: f64 = 10.0;
/// Wider labels are cut.
const WIDEST: f64 = 270.0;

/// The label at the end of a line.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::figures) struct EndLabel {
    /// The height at which the line ends.
    pub(in crate::figures) y: f64,
    /// Its text.
    pub(in crate::figures) text: String,
    /// The colour of the line.
    pub(in crate::figures) colour: Colour,
    /// The marker of the line.
    pub(in crate::figures) marker: Option<Marker>,
    /// Whether it is bold.
    pub(in crate::figures) is_bold: bool,
}

impl EndLabel {
    fn marker_width(&self) -> f64 {
        if self.marker.is_some() { MARKER } else { 0.0 }
    }

    fn style(&self) -> TextStyle {
        let style = TextStyle::new(SIZE);
        if self.is_bold { style.bold() } else { style }
    }

    fn width(&self) -> f64 {
        self.marker_width() + text_width(&self.text, SIZE, self.is_bold)
    }
}

/// The width that a column of these labels needs to the right of a field.
pub(in crate::figures) fn column_width(labels: &[EndLabel]) -> f64 {
    let widest = labels.iter().map(EndLabel::width).fold(0.0, f64::max);
    LEADER + widest.min(WIDEST) + MARGIN
}

/// Writes the labels to the right of `x`, within `range`.
pub(in crate::figures) fn draw(
    drawing: &mut Drawing,
    x: f64,
    range: [f64; 2],
    labels: &[EndLabel],
) {
    let ends: Vec<f64> = labels
        .iter()
        .map(|label| label.y.clamp(range[0], range[1]))
        .collect();
    let places = spread(&ends, GAP, range);
    for (label, (end, place)) in labels.iter().zip(ends.iter().zip(places)) {
        let stroke = Stroke::new(label.colour, 0.8);
        let (from, to) = (x + 3.0, x + LEADER - 4.0);
        drawing.polyline(
            &[
                (from, *end),
                (from + 3.0, *end),
                (to - 3.0, place),
                (to, place),
            ],
            &stroke,
        );
        if let Some(marker) = label.marker {
            drawing.marker(marker, (x + LEADER + 3.0, place), 4.0, label.colour);
        }
        let text = cut(&label.text, WIDEST - label.marker_width(), &label.style());
        let at = (x + LEADER + label.marker_width(), place + 0.35 * SIZE);
        drawing.text(at, &text, &label.style());
    }
}

/// A text cut to a width.
fn cut(text: &str, width: f64, style: &TextStyle) -> String {
    broken(text, width, style, 1).concat()
}

#[cfg(test)]
mod tests {
    use super::{WIDEST, cut};
    use crate::svg::{TextStyle, text_width};

    #[test]
    fn what_does_not_fit_is_cut() {
        let style = TextStyle::new(super::SIZE);
        assert_eq!(cut("1st torsion", WIDEST, &style), "1st torsion");
        let cut = cut(&"1st torsion ".repeat(9), WIDEST, &style);
        assert!(cut.starts_with("1st torsion 1st") && cut.ends_with('\u{2026}'));
        assert!(text_width(&cut, 11.0, false) <= WIDEST);
    }
}
