//! Curves of the frequencies against one or two varied inputs.

use towermodes::number::Rounded;

use super::{ModeColumn, VariedColumn, panel_height};
use crate::figures::chart::{Axis, Chart, Series, WIDTH, range, six_decimals};
use crate::svg::{DataTable, Drawing, Figure};
use crate::wording::counted;

/// Largest number of curves for the values of an input, because more cannot be distinguished.
pub(super) const MOST_LEVELS: usize = 7;
/// Largest number of modes, because more cannot be distinguished.
const MOST_MODES: usize = 14;
/// Largest number of panels.
const MOST_PANELS: usize = 6;
/// Curves with more points are thinned out, because no screen shows them.
const MOST_POINTS: usize = 2000;

/// A curve for each mode.
pub(super) fn of_one(varied: &VariedColumn<'_>, modes: &[ModeColumn<'_>]) -> Figure {
    let shown = &modes[..modes.len().min(MOST_MODES)];
    let all = by_value(varied, |_| true);
    let rows = thinned(&all);
    let curves = shown
        .iter()
        .map(|mode| (mode.label.to_owned(), points(&rows, varied, mode)));
    let description = format!(
        "Natural frequencies of {} against {}, {}.{}{}",
        counted(shown.len(), "mode"),
        varied.name,
        counted(all.len(), "row"),
        points_in_words(rows.len(), all.len()),
        not_shown(modes.len() - shown.len())
    );
    let title = format!("Natural frequencies against {}", varied.name);
    figure(title, description, &[panel(None, varied, curves)])
}

/// A panel for each mode, with a curve for each value of `other`.
pub(super) fn of_two(
    varied: &VariedColumn<'_>,
    other: &VariedColumn<'_>,
    levels: &[f64],
    modes: &[ModeColumn<'_>],
) -> Figure {
    let shown = &modes[..modes.len().min(MOST_PANELS)];
    let rows = levels
        .iter()
        .map(|level| thinned(&by_value(varied, |row| other.values[row] == *level)));
    let rows: Vec<Vec<usize>> = rows.collect();
    let name = |level: &f64| format!("{} = {}", other.name, Rounded(*level));
    let panels = shown.iter().map(|mode| {
        let curves = levels.iter().zip(&rows);
        let curves = curves.map(|(level, rows)| (name(level), points(rows, varied, mode)));
        panel(Some(mode.label.to_owned()), varied, curves)
    });
    let description = format!(
        "Natural frequencies of {} against {}, one panel for each mode, one curve for each of {} of {}.{}",
        counted(shown.len(), "mode"),
        varied.name,
        counted(levels.len(), "value"),
        other.name,
        not_shown(modes.len() - shown.len())
    );
    let title = format!(
        "Natural frequencies against {} and {}",
        varied.name, other.name
    );
    figure(title, description, &panels.collect::<Vec<Chart>>())
}

/// A figure of panels one below the other.
fn figure(title: String, description: String, panels: &[Chart]) -> Figure {
    let height = panel_height(panels.len());
    let mut drawing = Drawing::new(WIDTH, height * panels.len().max(1) as f64);
    for (index, panel) in panels.iter().enumerate() {
        let top = height * index as f64;
        panel.draw(&mut drawing, [top, top + height]);
    }
    Figure {
        name: "sweep".to_owned(),
        title,
        description,
        table: table(panels),
        drawing,
    }
}

/// A panel of curves, each with a label and points by increasing x.
fn panel(
    title: Option<String>,
    varied: &VariedColumn<'_>,
    curves: impl Iterator<Item = (String, Vec<[f64; 2]>)>,
) -> Chart {
    let series = |(index, (label, points))| Series {
        index,
        label,
        points,
    };
    let series: Vec<Series> = curves.enumerate().map(series).collect();
    let shown = || series.iter().flat_map(Series::finite);
    Chart {
        title,
        x: Axis::linear(&varied.axis_name(), range(shown().map(|[x, _]| x), 0.0)),
        y: Axis::linear(
            "natural frequency (Hz)",
            range(shown().map(|[_, y]| y), 0.06),
        ),
        series,
        ..Chart::default()
    }
}

pub(super) fn not_shown(modes: usize) -> String {
    match modes {
        0 => String::new(),
        1 => " 1 further mode is not shown.".to_owned(),
        hidden => format!(" {hidden} further modes are not shown."),
    }
}

/// " Each curve shows 2000 of these rows."; empty if it shows all.
fn points_in_words(shown: usize, all: usize) -> String {
    match shown < all {
        true => format!(" Each curve shows {shown} of these rows."),
        false => String::new(),
    }
}

/// The selected rows by increasing value.
fn by_value(varied: &VariedColumn<'_>, is_selected: impl Fn(usize) -> bool) -> Vec<usize> {
    let values = &varied.values;
    let rows = (0..values.len()).filter(|&row| values[row].is_finite() && is_selected(row));
    let mut rows: Vec<usize> = rows.collect();
    rows.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    rows
}

/// A selection of many rows at equal distances, including the first and the last, so that a curve
/// covers the whole range of values.
fn thinned(rows: &[usize]) -> Vec<usize> {
    if rows.len() <= MOST_POINTS {
        return rows.to_vec();
    }
    let last = rows.len() - 1;
    let places = (0..MOST_POINTS).map(|point| point * last / (MOST_POINTS - 1));
    places.map(|place| rows[place]).collect()
}

fn points(rows: &[usize], varied: &VariedColumn<'_>, mode: &ModeColumn<'_>) -> Vec<[f64; 2]> {
    let point = |row: &usize| [varied.values[*row], mode.frequency_hz[*row]];
    rows.iter().map(point).collect()
}

/// One row per point; if there are several panels, with the mode of each.
fn table(panels: &[Chart]) -> DataTable {
    let x_name = panels.first().map_or("", |panel| &panel.x.name);
    let row = |panel: &Chart, label: &str, [x, y]: [f64; 2]| {
        let own = [label.to_owned(), Rounded(x).to_string(), six_decimals(y)];
        panel.title.iter().cloned().chain(own).collect()
    };
    let rows = panels.iter().flat_map(|panel| {
        let series = panel.series.iter();
        series.flat_map(move |of| {
            of.points
                .iter()
                .map(move |point| row(panel, &of.label, *point))
        })
    });
    match panels {
        [Chart { title: None, .. }] => DataTable::new(["mode", x_name, "frequency (Hz)"], rows),
        _ => DataTable::new(["mode", "curve", x_name, "frequency (Hz)"], rows),
    }
}
