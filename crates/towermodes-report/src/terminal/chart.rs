//! A line diagram in braille dots: y on a logarithmic axis upwards, x to the right, the name of
//! each line beside its end.

use super::canvas::{ACROSS, Canvas, DOWN};
use crate::svg::spread;
use crate::wording::counted;

/// The approximate number of rows, independent of the powers of ten.
const ROWS: usize = 16;
/// The largest number of columns of the field; more columns show no more details.
const WIDEST: usize = 72;
/// Narrower fields are not drawn; before this limit the names of the lines are omitted.
const NARROWEST: usize = 20;
/// Number of characters left of the field: a power of ten and the axis.
const AXIS: usize = 8;
/// Number of characters of the sample of a line with the spaces around it.
const SAMPLE: usize = 6;

/// Whether a line has the dot with this number along it.
type Style = fn(usize) -> bool;

/// The dash patterns of the lines, used in turn, with a sample of each.
const STYLES: [(&str, Style); 3] = [
    ("───", |_| true),
    ("╌╌╌", |step| step % 6 < 4),
    ("┈┈┈", |step| step.is_multiple_of(3)),
];

/// A line through points.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Series {
    /// Its character in the table.
    pub(super) mark: char,
    /// Its name.
    pub(super) name: String,
    /// x in increasing order, and y, all positive.
    pub(super) points: Vec<(f64, f64)>,
}

/// The x axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct XAxis {
    /// Its name.
    pub(super) name: &'static str,
    /// Whether it is logarithmic, as the y axis is.
    pub(super) is_logarithmic: bool,
}

impl XAxis {
    fn scaled(&self, x: f64) -> f64 {
        if self.is_logarithmic { x.log10() } else { x }
    }
}

/// The positions of values on the sheet of dots.
struct Places<'a> {
    x_axis: &'a XAxis,
    /// The scaled values at both ends of x.
    x: [f64; 2],
    /// The powers of ten at the top and at the bottom.
    decades: [i32; 2],
    rows_a_decade: usize,
    columns: usize,
}

impl<'a> Places<'a> {
    fn new(series: &[Series], x_axis: &'a XAxis, columns: usize) -> Self {
        let points = || series.iter().flat_map(|series| &series.points);
        let ends = |values: &mut dyn Iterator<Item = f64>| {
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
                [low.min(value), high.max(value)]
            })
        };
        let x = ends(&mut points().map(|point| x_axis.scaled(point.0)));
        let y = ends(&mut points().map(|point| point.1.log10()));
        let low = y[0].floor() as i32;
        let high = (y[1].ceil() as i32).max(low + 1);
        let count = usize::try_from(high - low).unwrap_or(1);
        Self {
            x_axis,
            x,
            decades: [high, low],
            rows_a_decade: (ROWS / count).max(1),
            columns,
        }
    }

    fn rows(&self) -> usize {
        let count = usize::try_from(self.decades[0] - self.decades[1]).unwrap_or(1);
        count * self.rows_a_decade + 1
    }

    /// The horizontal position in dots from the left.
    fn across(&self, x: f64) -> usize {
        let [low, high] = self.x;
        let share = match high - low {
            0.0 => 0.5,
            span => ((self.x_axis.scaled(x) - low) / span).clamp(0.0, 1.0),
        };
        // Not at the very edges, where a point would be cut.
        1 + (share * (self.columns * ACROSS - 3) as f64).round() as usize
    }

    /// The vertical position in dots from the top; a power of ten is in the middle of its row.
    fn down(&self, y: f64) -> usize {
        let below = (f64::from(self.decades[0]) - y.log10()).max(0.0);
        1 + (below * (self.rows_a_decade * DOWN) as f64).round() as usize
    }

    fn at(&self, (x, y): (f64, f64)) -> (usize, usize) {
        (self.across(x), self.down(y))
    }

    /// The power of ten of a row, if it has one.
    fn tick(&self, row: usize) -> String {
        if !row.is_multiple_of(self.rows_a_decade) {
            return format!("{:>1$} ", "│", AXIS - 1);
        }
        let exponent = self.decades[0] - (row / self.rows_a_decade) as i32;
        format!("{:>1$} ┤ ", format!("1e{exponent}"), AXIS - 3)
    }
}

/// The diagram, at most `width` characters wide; empty without points or room. If there are more
/// lines than rows, the rest is counted.
pub(super) fn chart(series: &[Series], x_axis: &XAxis, width: usize) -> String {
    let drawn: Vec<Series> = series
        .iter()
        .filter(|series| !series.points.is_empty())
        .cloned()
        .collect();
    let named = |series: &Series| SAMPLE + 2 + series.name.chars().count();
    let labels = drawn.iter().map(named).max().unwrap_or(0);
    let room = |labels: usize| width.saturating_sub(AXIS + labels).min(WIDEST);
    let (columns, has_names) = match room(labels) {
        columns if columns >= NARROWEST => (columns, true),
        _ => (room(SAMPLE + 1), false),
    };
    if drawn.is_empty() || columns < NARROWEST {
        return String::new();
    }
    let rows = Places::new(&drawn, x_axis, columns).rows();
    let hidden = drawn.len().saturating_sub(rows);
    let drawn = &drawn[..drawn.len() - hidden];
    let places = Places::new(drawn, x_axis, columns);
    let mut canvas = Canvas::new(columns, places.rows());
    for (index, series) in drawn.iter().enumerate() {
        draw(&mut canvas, &places, series, STYLES[index % STYLES.len()].1);
    }
    let labels = labels_of_rows(drawn, &places, has_names);
    let mut text = String::new();
    for (row, line) in canvas.lines().enumerate() {
        let label = labels.get(row).map_or("", String::as_str);
        let line = format!("{}{line}{label}", places.tick(row));
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text += &format!("{:>1$}{2}\n", "└", AXIS - 1, "─".repeat(columns + 1));
    text += &numbers(drawn, &places);
    if hidden > 0 {
        let lines = counted(hidden, "more line");
        text += &format!("{:AXIS$}{lines} not drawn\n", "");
    }
    text
}

/// Draws a line between neighbouring points, and each point as a cross.
fn draw(canvas: &mut Canvas, places: &Places<'_>, series: &Series, style: Style) {
    let points: Vec<(usize, usize)> = series.points.iter().map(|p| places.at(*p)).collect();
    let mut step = 0;
    for pair in points.windows(2) {
        step = canvas.line([pair[0], pair[1]], step, style);
    }
    for (x, y) in points {
        canvas.across(x.saturating_sub(1), x + 1, y);
        canvas.dot(x, y.saturating_sub(1));
        canvas.dot(x, y + 1);
    }
}

/// The labels to the right of each row: the names of the lines near their ends, moved apart.
fn labels_of_rows(series: &[Series], places: &Places<'_>, has_names: bool) -> Vec<String> {
    let row = |series: &Series| {
        let last = series.points.last().map_or(0, |point| places.down(point.1));
        last as f64 / DOWN as f64 - 0.5
    };
    let ends: Vec<f64> = series.iter().map(row).collect();
    let rows = spread(&ends, 1.0, [0.0, (places.rows() - 1) as f64]);
    let mut labels = vec![String::new(); places.rows()];
    for (index, (series, row)) in series.iter().zip(rows).enumerate() {
        let sample = STYLES[index % STYLES.len()].0;
        let name = if has_names { series.name.as_str() } else { "" };
        if let Some(label) = labels.get_mut(row.round() as usize) {
            *label = format!(" {sample} {} {name}", series.mark);
        }
    }
    labels
}

/// The numbers of x below their points, as many as fit, and the name of the axis.
fn numbers(series: &[Series], places: &Places<'_>) -> String {
    let values = series.iter().flat_map(|series| &series.points);
    let mut values: Vec<f64> = values.map(|point| point.0).collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    let mut line = String::new();
    for value in values {
        let label = value.to_string();
        let start = (places.across(value) / ACROSS).saturating_sub(label.len() / 2);
        if line.is_empty() || start > line.len() {
            line.push_str(&" ".repeat(start.saturating_sub(line.len())));
            line.push_str(&label);
        }
    }
    format!("{:AXIS$}{line}  {}\n", "", places.x_axis.name)
}

#[cfg(test)]
mod tests {
    use super::{Series, XAxis, chart};

    const N: XAxis = XAxis {
        name: "segments",
        is_logarithmic: true,
    };

    fn series(mark: char, points: &[(f64, f64)]) -> Series {
        Series {
            mark,
            name: "a mode".to_owned(),
            points: points.to_vec(),
        }
    }

    /// Two powers of ten have eight rows each; the field has 72 columns, its left edge is after 8
    /// characters.
    #[test]
    fn points_stand_where_they_belong() {
        let text = chart(&[series('1', &[(10.0, 1e-2), (100.0, 1e-4)])], &N, 120);
        let lines: Vec<Vec<char>> = text.lines().map(|line| line.chars().collect()).collect();
        let start = |row: usize| lines[row][..8].iter().collect::<String>();
        assert_eq!(start(0), " 1e-2 ┤ ", "{text}");
        assert_eq!(start(8), " 1e-3 ┤ ");
        assert_eq!(start(16), " 1e-4 ┤ ");
        assert_eq!(start(4), "      │ ");
        // Halfway down is halfway across.
        let dots = |row: usize| {
            let field = lines[row][8..].iter().take(72);
            let is_dot = |c: &&char| ('\u{2801}'..='\u{28ff}').contains(*c);
            let found = field.enumerate().find(|(_, c)| is_dot(c));
            found.map(|(at, _)| at)
        };
        assert_eq!(dots(0), Some(0), "{text}");
        assert!(dots(8).is_some_and(|at| (34..=37).contains(&at)), "{text}");
        assert!(dots(16).is_some_and(|at| at >= 69), "{text}");
        let ends: String = lines[16].iter().collect();
        assert!(ends.ends_with("─── 1 a mode"), "{text}");
        assert!(text.ends_with("100  segments\n"), "{text}");
    }

    /// Lines that end at the same point have labels in separate rows, and alternating styles.
    #[test]
    fn labels_are_apart() {
        let all = ['1', '2', '3', '4'].map(|mark| series(mark, &[(1.0, 1e-2), (2.0, 1e-3)]));
        let text = chart(&all, &N, 100);
        for label in ["─── 1", "╌╌╌ 2", "┈┈┈ 3", "─── 4"] {
            let rows = text.lines().filter(|line| line.contains(label));
            assert_eq!(rows.count(), 1, "{label}: {text}");
        }
    }

    #[test]
    fn it_is_as_wide_as_there_is_room() {
        let all = ['1', '2'].map(|mark| series(mark, &[(1.0, 1e-2), (2.0, 1e-3)]));
        for width in 35..=200 {
            let text = chart(&all, &N, width);
            let widest = text.lines().take(17).map(|line| line.chars().count()).max();
            assert!(
                widest.is_some_and(|widest| widest <= width),
                "{width}: {text}"
            );
        }
        assert_eq!(chart(&all, &N, 34), "");
        assert_eq!(chart(&[], &N, 100), "");
        assert_eq!(chart(&[series('1', &[])], &N, 100), "");
    }

    /// 16 powers of ten have one row each, 17 rows; of 20 lines three have no label and are only
    /// counted.
    #[test]
    fn more_lines_than_rows_are_counted() {
        let all = [(); 20].map(|()| series('*', &[(1.0, 1.0), (2.0, 1e-16)]));
        let text = chart(&all, &N, 100);
        assert_eq!(text.matches("a mode").count(), 17, "{text}");
        assert!(text.ends_with("3 more lines not drawn\n"), "{text}");
    }

    #[test]
    fn a_single_point_is_a_diagram() {
        let text = chart(&[series('1', &[(10.0, 1e-3)])], &N, 100);
        assert!(
            text.contains("1e-3 ┤") && text.contains("1 a mode"),
            "{text}"
        );
    }
}
