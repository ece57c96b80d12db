//! Small diagrams side by side: a value to the right against a height or radius upwards, with a
//! caption below.

use super::canvas::{ACROSS, Canvas, DOWN};
use crate::svg::number;

/// Number of characters of the width of a diagram.
const COLUMNS: usize = 16;
/// Number of characters of its height; odd, so that one is in the middle.
const ROWS: usize = 13;
/// Number of characters between two diagrams.
const GAP: usize = 2;
/// Number of dots from the undeformed axis to a value of 1.
const REACH: usize = COLUMNS * ACROSS / 2 - 1;
/// Number of dots from the top to the bottom.
const DOTS: usize = ROWS * DOWN;
/// Terminals with fewer columns show no diagrams.
const NARROWEST: usize = 30;

/// The style of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Line {
    /// A solid line.
    Whole,
    /// Single dots.
    Dots,
}

/// A value over a height: heights (m, in increasing order) and values from −1 to 1.
#[derive(Debug, Clone)]
pub(super) struct Curve {
    pub(super) points: Vec<(f64, f64)>,
    pub(super) line: Line,
}

/// A diagram with its caption.
#[derive(Debug, Clone)]
pub(super) struct Panel {
    pub(super) curves: Vec<Curve>,
    pub(super) captions: Vec<String>,
}

/// The diagrams in rows of at most `width` characters, with the heights from `low_m` to `high_m` on
/// the left of each row; empty if none fits.
pub(super) fn side_by_side(panels: &[Panel], [low_m, high_m]: [f64; 2], width: usize) -> String {
    let axis = axis([low_m, high_m]);
    let of_axis = axis.iter().map(|label| label.chars().count()).max();
    let room = width.saturating_sub(of_axis.unwrap_or(0));
    let in_a_row = (room + GAP - 1) / (COLUMNS + GAP);
    if width < NARROWEST || in_a_row == 0 {
        return String::new();
    }
    let rows = panels.chunks(in_a_row);
    let rows: Vec<String> = rows
        .map(|row| row_of_panels(row, &axis, [low_m, high_m]))
        .collect();
    rows.join("\n")
}

/// The lines of the axis on the left, all of equal width: numbers at the top, in the middle and at
/// the bottom.
fn axis([low_m, high_m]: [f64; 2]) -> Vec<String> {
    let step = (0.01 * (high_m - low_m)).min(0.1);
    let label = |height_m: f64| number(height_m, step);
    let labels = [
        (0, label(high_m) + " m"),
        (ROWS / 2, label(0.5 * (low_m + high_m)) + "  "),
        (ROWS - 1, label(low_m) + "  "),
    ];
    let widest = labels.iter().map(|(_, text)| text.chars().count()).max();
    let widest = widest.unwrap_or(0);
    let line = |row: usize| match labels.iter().find(|(at, _)| *at == row) {
        Some((_, text)) => format!("{text:>widest$} ┤"),
        None => format!("{:widest$} │", ""),
    };
    (0..ROWS).map(line).collect()
}

fn row_of_panels(panels: &[Panel], axis: &[String], heights_m: [f64; 2]) -> String {
    let drawn = panels.iter().map(|panel| drawn(&panel.curves, heights_m));
    let drawn: Vec<Vec<String>> = drawn.collect();
    let mut lines: Vec<String> = Vec::new();
    for (row, label) in axis.iter().enumerate() {
        lines.push(in_columns(label, drawn.iter().map(|panel| &panel[row])));
    }
    let captions = panels.iter().map(|panel| wrapped(&panel.captions));
    let captions: Vec<Vec<String>> = captions.collect();
    let deepest = captions.iter().map(Vec::len).max().unwrap_or(0);
    let margin = " ".repeat(axis[0].chars().count());
    let empty = String::new();
    for row in 0..deepest {
        let texts = captions
            .iter()
            .map(|lines| lines.get(row).unwrap_or(&empty));
        lines.push(in_columns(&margin, texts));
    }
    lines.concat()
}

/// A line: a text on the left, then a text for each diagram, centred below it.
fn in_columns<'a>(left: &str, texts: impl Iterator<Item = &'a String>) -> String {
    let mut line = left.to_owned();
    for (index, text) in texts.enumerate() {
        let gap = if index == 0 { 1 } else { GAP };
        line.push_str(&" ".repeat(gap));
        line.push_str(&format!("{text:^COLUMNS$}"));
    }
    line.truncate(line.trim_end().len());
    line.push('\n');
    line
}

/// The lines of characters of curves, with the undeformed axis in the middle.
fn drawn(curves: &[Curve], [low_m, high_m]: [f64; 2]) -> Vec<String> {
    let mut canvas = Canvas::new(COLUMNS, ROWS);
    (0..DOTS)
        .step_by(DOWN)
        .for_each(|y| canvas.dot(REACH, y + 1));
    for curve in curves {
        let at = |y: usize| {
            let share = y as f64 / (DOTS - 1) as f64;
            let value = value_at(&curve.points, high_m + share * (low_m - high_m));
            // Values beyond ±1 and NaN are not drawn.
            let x = REACH as f64 * (1.0 + value.clamp(-1.0, 1.0));
            if x.is_finite() {
                x.round() as usize
            } else {
                REACH
            }
        };
        match curve.line {
            Line::Whole => draw_whole(&mut canvas, at),
            Line::Dots => (0..DOTS).step_by(3).for_each(|y| canvas.dot(at(y), y)),
        }
    }
    canvas.lines().collect()
}

/// Draws the dots of every row, as many as are needed to connect the rows.
fn draw_whole(canvas: &mut Canvas, at: impl Fn(usize) -> usize) {
    canvas.dot(at(0), 0);
    for y in 1..DOTS {
        let (above, here) = (at(y - 1), at(y));
        // Each of the two rows takes its half of the way.
        let middle = (above + here) / 2;
        canvas.across(above, middle, y - 1);
        let next = if here > middle { middle + 1 } else { middle };
        canvas.across(next, here, y);
    }
}

/// The value at a height, by linear interpolation.
fn value_at(points: &[(f64, f64)], place_m: f64) -> f64 {
    let after = points.partition_point(|(at_m, _)| *at_m < place_m);
    match (points.get(after.wrapping_sub(1)), points.get(after)) {
        (Some((a_m, a)), Some((b_m, b))) => a + (b - a) * (place_m - a_m) / (b_m - a_m),
        (Some((_, value)), None) | (None, Some((_, value))) => *value,
        (None, None) => 0.0,
    }
}

/// Texts in lines that are no wider than a diagram, broken between words.
fn wrapped(texts: &[String]) -> Vec<String> {
    let mut lines = Vec::new();
    for text in texts {
        let mut line = String::new();
        for word in text.split(' ') {
            if !line.is_empty() && line.chars().count() + 1 + word.chars().count() > COLUMNS {
                lines.push(std::mem::take(&mut line));
            }
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(word);
        }
        lines.push(line);
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::{Curve, Line, Panel, side_by_side, value_at, wrapped};

    fn panel(values: [f64; 2], caption: &str) -> Panel {
        Panel {
            curves: vec![Curve {
                points: vec![(0.0, values[0]), (10.0, values[1])],
                line: Line::Whole,
            }],
            captions: vec![caption.to_owned()],
        }
    }

    #[test]
    fn a_straight_line_leans_to_the_right() {
        let text = side_by_side(&[panel([0.0, 1.0], "leaning")], [0.0, 10.0], 40);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 14);
        // The value 1 is 15 dots right of the dot 15: the left dot of the last of 16 characters
        // after seven of the axis.
        assert!(lines[0].starts_with("10.0 m ┤ "), "{text}");
        assert_eq!(lines[0].chars().count(), 9 + 16, "{text}");
        assert!(lines[6].starts_with(" 5.0   ┤"), "{text}");
        assert!(lines[12].starts_with("   0   ┤"), "{text}");
        // After 9 characters four of the nine that the word leaves.
        assert_eq!(lines[13], "             leaning");
    }

    #[test]
    fn rows_are_as_wide_as_there_is_room() {
        let panels = [(); 5].map(|()| panel([0.0, 1.0], "a mode"));
        for width in 30..=200 {
            let text = side_by_side(&panels, [0.0, 100.0], width);
            let widest = text.lines().map(|line| line.chars().count()).max();
            assert!(widest.is_some_and(|widest| widest <= width), "{width}");
        }
        assert_eq!(side_by_side(&panels, [0.0, 100.0], 29), "");
        // 8 characters of the axis, 1 and 16 for the first, 18 for each further one.
        let rows = |width| side_by_side(&panels, [0.0, 99.0], width).lines().count();
        assert_eq!(rows(9 + 16 + 4 * 18), 14);
        assert_eq!(rows(9 + 16 + 4 * 18 - 1), 29);
    }

    #[test]
    fn values_are_straight_between_points() {
        let points = [(0.0, 0.0), (10.0, 1.0), (20.0, -1.0)];
        assert_eq!(value_at(&points, 5.0), 0.5);
        assert_eq!(value_at(&points, 15.0), 0.0);
        assert_eq!(value_at(&points, 20.0), -1.0);
        assert_eq!(value_at(&points, 21.0), -1.0);
        assert_eq!(value_at(&points, -1.0), 0.0);
        assert_eq!(value_at(&[], 0.0), 0.0);
    }

    #[test]
    fn captions_are_broken_between_words() {
        let lines = wrapped(&["1st fore-aft and side-side bending".to_owned()]);
        assert_eq!(lines, ["1st fore-aft and", "side-side", "bending"]);
    }
}
