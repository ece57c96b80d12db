//! A visible heading above a standalone picture, for example for an attachment.

use super::figure::Figure;
use super::style::TextStyle;
use super::text::{LINE_HEIGHT, text_width};
use super::{Colour, Stroke};

/// Size of the title.
const TITLE: f64 = 16.0;
/// Size of the lines below it.
const LINES: f64 = 12.0;
/// Distance from the edges of the sheet to the text.
const MARGIN: f64 = 12.0;
/// Room below the heading.
const BELOW: f64 = 10.0;
/// The largest number of lines of a text; the rest is cut.
const MOST_LINES: [usize; 2] = [2, 5];

/// The heading of a picture.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Heading {
    /// The title in bold: the tower's name. An empty title is omitted.
    pub title: String,
    /// The paragraphs below it: first, in muted letters, the content of the picture and the method,
    /// then the conclusions.
    pub lines: Vec<String>,
}

impl Heading {
    /// The lines of the title and of the paragraphs for the width of a sheet, with their style.
    fn broken(&self, width: f64) -> Vec<(String, TextStyle)> {
        let title = TextStyle::new(TITLE).bold();
        let line = TextStyle::new(LINES);
        let first = [line.colour(Colour::Muted)].into_iter();
        let styles = first.chain(std::iter::repeat(line));
        let lines = self.lines.iter().zip(styles);
        let lines = lines.map(|(text, style)| (text, style, MOST_LINES[1]));
        let all = std::iter::once((&self.title, title, MOST_LINES[0])).chain(lines);
        let room = width - 2.0 * MARGIN;
        all.flat_map(|(text, style, most)| {
            let lines = broken(text, room, &style, most);
            lines.into_iter().map(move |line| (line, style))
        })
        .collect()
    }
}

impl Figure {
    /// The picture with a heading above it; unchanged if the heading is empty.
    #[must_use]
    pub fn headed(self, heading: &Heading) -> Self {
        let lines = heading.broken(self.drawing.width);
        if lines.is_empty() {
            return self;
        }
        let heights = lines.iter().map(|(_, style)| LINE_HEIGHT * style.size);
        // Whole, so that the sheet's size is as short a number as before.
        let height = (MARGIN + heights.sum::<f64>() + BELOW - 1e-9).ceil();
        let mut drawing = self.drawing.lowered(height);
        let mut top = MARGIN;
        for (text, style) in &lines {
            drawing.text((MARGIN, top + style.size), text, style);
            top += LINE_HEIGHT * style.size;
        }
        let edge = (height - 0.5 * BELOW, Stroke::new(Colour::Grid, 1.0));
        let width = drawing.width;
        drawing.line((MARGIN, edge.0), (width - MARGIN, edge.0), &edge.1);
        Self { drawing, ..self }
    }
}

/// A text in at most `most` lines no wider than `room`, broken between words, and within words that
/// are too wide; the rest is cut with "…".
pub(crate) fn broken(text: &str, room: f64, style: &TextStyle, most: usize) -> Vec<String> {
    let width = |text: &str| text_width(text, style.size, style.is_bold);
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let joined = lines.last().map(|line| format!("{line} {word}"));
        match (joined, lines.last_mut()) {
            (Some(joined), Some(line)) if width(&joined) <= room => *line = joined,
            _ => lines.extend(pieces(word, room, &width)),
        }
    }
    if lines.len() > most {
        lines.truncate(most);
        if let Some(last) = lines.last_mut() {
            while !last.is_empty() && width(&format!("{last}\u{2026}")) > room {
                last.pop();
            }
            last.push('\u{2026}');
        }
    }
    lines
}

/// A word divided into pieces that fit.
fn pieces(word: &str, room: f64, width: &impl Fn(&str) -> f64) -> Vec<String> {
    let mut pieces = vec![String::new()];
    for c in word.chars() {
        let longer = pieces
            .last()
            .map_or_else(String::new, |last| format!("{last}{c}"));
        match pieces.last_mut() {
            Some(last) if last.is_empty() || width(&longer) <= room => *last = longer,
            _ => pieces.push(c.to_string()),
        }
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::{Heading, broken};
    use crate::svg::{DataTable, Drawing, Figure, Look, TextStyle, text_width};

    fn figure() -> Figure {
        let mut drawing = Drawing::new(300.0, 200.0);
        drawing.text((10.0, 20.0), "at the top", &TextStyle::new(12.0));
        Figure {
            name: "test".to_owned(),
            title: "A test".to_owned(),
            description: "A text.".to_owned(),
            drawing,
            table: DataTable::default(),
        }
    }

    /// 12 above, a title of 1.3·16, two lines of 1.3·12, 10 below: the picture moves down by 74.
    #[test]
    fn the_picture_is_below_its_heading() {
        let heading = Heading {
            title: "Tower".to_owned(),
            lines: vec!["Mode shapes".to_owned(), "rmje-exact".to_owned()],
        };
        let headed = figure().headed(&heading);
        assert!((headed.drawing.height - 274.0).abs() < 1e-9);
        let tops: Vec<f64> = headed.labels().iter().map(|label| label.top).collect();
        let lowered = figure().labels()[0].top + 74.0;
        assert!((tops[0] - lowered).abs() < 1e-9, "{tops:?}");
        for (index, label) in headed.labels().iter().enumerate() {
            let others = &headed.labels()[index + 1..];
            assert!(!others.iter().any(|other| label.overlaps(other)));
        }
        let svg = headed.to_svg(Look::Inline);
        assert!(svg.contains(r#"<g transform="translate(0 74)">"#), "{svg}");
        assert!(svg.contains(">Tower</text>"));
    }

    #[test]
    fn without_words_there_is_no_heading() {
        assert_eq!(figure().headed(&Heading::default()), figure());
    }

    #[test]
    fn long_titles_are_broken_and_very_long_ones_are_cut() {
        let style = TextStyle::new(12.0);
        let fits = |line: &String| text_width(line, 12.0, false) <= 200.0;
        let words = "a tower with a name ".repeat(4);
        let lines = broken(&words, 200.0, &style, 9);
        assert!(lines.len() > 1 && lines.iter().all(fits), "{lines:?}");
        assert_eq!(lines.join(" "), words.trim_end());
        let one = broken(&"W".repeat(500), 200.0, &style, 2);
        assert!(one.len() == 2 && one.iter().all(fits), "{one:?}");
        assert!(one[1].ends_with('\u{2026}'));
        assert!(broken("  ", 200.0, &style, 2).is_empty());
    }
}
