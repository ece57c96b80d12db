//! The legend of a figure, in rows.

use super::WIDTH;
use crate::svg::{Colour, Drawing, Frame, LINE_HEIGHT, Marker, Stroke, TextStyle, text_width};

/// Size of the letters.
const SIZE: f64 = 11.0;
/// Length of a sample of a line.
const LINE: f64 = 28.0;
/// Width of the sample of a marker without line.
const MARKER: f64 = 12.0;
/// Distance from a sample to its text.
const SPACE: f64 = 6.0;
/// Distance from an entry to the next.
const BETWEEN: f64 = 22.0;

/// Room below a legend at the lower end of a sheet.
const FOOT: f64 = 6.0;

/// The sample of an entry; an entry with only a text has no line, marker or area.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(in crate::figures) struct Sample {
    /// The stroke of a line.
    pub(in crate::figures) line: Option<Stroke>,
    /// The marker.
    pub(in crate::figures) marker: Option<(Marker, Colour)>,
    /// The colour of an area, with the stroke of its edges.
    pub(in crate::figures) surface: Option<(Colour, Stroke)>,
}

impl Sample {
    fn width(&self) -> f64 {
        match (self.line, self.marker, self.surface) {
            (Some(_), ..) | (.., Some(_)) => LINE,
            (None, Some(_), None) => MARKER,
            (None, None, None) => 0.0,
        }
    }

    fn draw(&self, drawing: &mut Drawing, (x, middle): (f64, f64)) {
        if let Some((colour, edge)) = &self.surface {
            let (top, bottom) = (middle - 0.4 * SIZE, middle + 0.4 * SIZE);
            drawing.rectangle((x, top), (LINE, bottom - top), *colour, None);
            for y in [top, bottom] {
                drawing.line((x, y), (x + LINE, y), edge);
            }
        }
        if let Some(stroke) = &self.line {
            drawing.line((x, middle), (x + LINE, middle), stroke);
        }
        if let Some((marker, colour)) = self.marker {
            drawing.marker(marker, (x + 0.5 * self.width(), middle), 4.5, colour);
        }
    }

    /// Distance from the beginning of an entry to its text.
    fn indent(&self) -> f64 {
        match self.width() {
            0.0 => 0.0,
            width => width + SPACE,
        }
    }
}

impl From<Stroke> for Sample {
    fn from(line: Stroke) -> Self {
        let line = Some(line);
        Self {
            line,
            ..Self::default()
        }
    }
}

impl From<(Marker, Colour)> for Sample {
    fn from(marker: (Marker, Colour)) -> Self {
        let marker = Some(marker);
        Self {
            marker,
            ..Self::default()
        }
    }
}

impl From<(Colour, Stroke)> for Sample {
    fn from(surface: (Colour, Stroke)) -> Self {
        let surface = Some(surface);
        Self {
            surface,
            ..Self::default()
        }
    }
}

/// An entry: its sample and its text.
pub(in crate::figures) type Entry = (Sample, String);

/// An entry with only a text.
pub(in crate::figures) fn words(text: String) -> Entry {
    (Sample::default(), text)
}

fn width(entry: &Entry) -> f64 {
    entry.0.indent() + text_width(&entry.1, SIZE, false)
}

/// The entries of each row of a legend of this width.
fn rows(entries: &[Entry], room: f64) -> Vec<Vec<&Entry>> {
    let mut rows: Vec<Vec<&Entry>> = Vec::new();
    let mut used = f64::INFINITY;
    for entry in entries {
        let more = width(entry) + BETWEEN;
        match rows.last_mut() {
            Some(row) if used + more <= room + BETWEEN => {
                row.push(entry);
                used += more;
            }
            _ => {
                rows.push(vec![entry]);
                used = more;
            }
        }
    }
    rows
}

/// The height of a row.
const ROW: f64 = 1.2 * LINE_HEIGHT * SIZE;

/// A legend of a given width, below and to the right of a point.
pub(in crate::figures) struct Legend {
    pub(in crate::figures) left_top: (f64, f64),
    pub(in crate::figures) room: f64,
    pub(in crate::figures) entries: Vec<Entry>,
}

impl Legend {
    /// A legend whose upper edge is at a height, below a field and of the same width.
    pub(in crate::figures) fn below(frame: &Frame, top: f64, entries: Vec<Entry>) -> Self {
        Self {
            left_top: (frame.left, top),
            room: frame.right - frame.left,
            entries,
        }
    }

    pub(in crate::figures) fn height(&self) -> f64 {
        ROW * rows(&self.entries, self.room).len() as f64
    }

    /// An empty sheet that ends below the legend.
    pub(in crate::figures) fn sheet(&self) -> Drawing {
        Drawing::new(WIDTH, (self.left_top.1 + self.height() + FOOT).ceil())
    }

    pub(in crate::figures) fn draw(&self, drawing: &mut Drawing) {
        let (left, top) = self.left_top;
        for (index, row) in rows(&self.entries, self.room).into_iter().enumerate() {
            let mut x = left;
            let middle = top + (index as f64 + 0.5) * ROW;
            for entry in row {
                let (sample, text) = entry;
                sample.draw(drawing, (x, middle));
                let at = (x + sample.indent(), middle + 0.35 * SIZE);
                drawing.text(at, text, &TextStyle::new(SIZE));
                x += width(entry) + BETWEEN;
            }
        }
    }
}
