//! Curves of the frequencies against one or two varied numbers.

use towermodes::number::Rounded;

use super::panel::{Curve, Panel, stacked};
use super::{ModeColumn, VariedColumn};
use crate::svg::{DataTable, Figure};

/// Curves for more values of a number cannot be distinguished.
pub(super) const MOST_LEVELS: usize = 7;
/// More modes cannot be distinguished.
const MOST_MODES: usize = 14;
/// Panels of more modes are not shown.
const MOST_PANELS: usize = 6;
/// Curves of more points are thinned out: no screen shows them.
const MOST_POINTS: usize = 2000;

/// A curve for each mode.
pub(super) fn of_one(varied: &VariedColumn<'_>, modes: &[ModeColumn<'_>]) -> Figure {
    let shown = &modes[..modes.len().min(MOST_MODES)];
    let all = by_value(varied, |_| true);
    let rows = thinned(&all);
    let curves = shown.iter().map(|mode| Curve {
        label: mode.label.to_owned(),
        points: points(&rows, varied, mode),
    });
    let x_name = varied.axis_name();
    let panel = Panel {
        title: "",
        x_name: &x_name,
        curves: curves.collect(),
    };
    let description = format!(
        "Natural frequencies of {} against {}, {}.{}{}",
        count(shown.len(), "mode"),
        varied.name,
        count(all.len(), "row"),
        points_in_words(rows.len(), all.len()),
        not_shown(modes.len() - shown.len())
    );
    Figure {
        name: "sweep".to_owned(),
        title: format!("Natural frequencies against {}", varied.name),
        description,
        table: table(&x_name, std::slice::from_ref(&panel)),
        drawing: stacked(&[panel]),
    }
}

/// A panel for each mode, with a curve for each value of `other`.
pub(super) fn of_two(
    varied: &VariedColumn<'_>,
    other: &VariedColumn<'_>,
    levels: &[f64],
    modes: &[ModeColumn<'_>],
) -> Figure {
    let shown = &modes[..modes.len().min(MOST_PANELS)];
    let x_name = varied.axis_name();
    let rows: Vec<(f64, Vec<usize>)> = levels
        .iter()
        .map(|level| {
            let rows = by_value(varied, |row| other.values[row] == *level);
            (*level, thinned(&rows))
        })
        .collect();
    let panel = |mode: &'_ ModeColumn<'_>| {
        let curves = rows.iter().map(|(level, rows)| Curve {
            label: format!("{} = {}", other.name, Rounded(*level)),
            points: points(rows, varied, mode),
        });
        curves.collect::<Vec<Curve>>()
    };
    let panels: Vec<Panel<'_>> = shown
        .iter()
        .map(|mode| Panel {
            title: mode.label,
            x_name: &x_name,
            curves: panel(mode),
        })
        .collect();
    let description = format!(
        "Natural frequencies of {} against {}, one panel for each mode, one curve for each of {} of {}.{}",
        count(shown.len(), "mode"),
        varied.name,
        count(levels.len(), "value"),
        other.name,
        not_shown(modes.len() - shown.len())
    );
    Figure {
        name: "sweep".to_owned(),
        title: format!(
            "Natural frequencies against {} and {}",
            varied.name, other.name
        ),
        description,
        table: table(&x_name, &panels),
        drawing: stacked(&panels),
    }
}

/// "1 mode", "4 modes".
fn count(count: usize, noun: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {noun}{plural}")
}

pub(super) fn not_shown(modes: usize) -> String {
    match modes {
        0 => String::new(),
        hidden => format!(
            " {} not shown.",
            match hidden {
                1 => "1 further mode is".to_owned(),
                hidden => format!("{hidden} further modes are"),
            }
        ),
    }
}

/// " Each curve shows 2000 of these rows."; empty if it shows all.
fn points_in_words(shown: usize, all: usize) -> String {
    match shown < all {
        true => format!(" Each curve shows {shown} of these rows."),
        false => String::new(),
    }
}

/// The selected rows by rising value.
fn by_value(varied: &VariedColumn<'_>, is_selected: impl Fn(usize) -> bool) -> Vec<usize> {
    let values = &varied.values;
    let rows = (0..values.len()).filter(|&row| values[row].is_finite() && is_selected(row));
    let mut rows: Vec<usize> = rows.collect();
    rows.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    rows
}

/// Some of many rows at equal distances, with the first and the last: a curve reaches over the
/// whole range of values.
fn thinned(rows: &[usize]) -> Vec<usize> {
    if rows.len() <= MOST_POINTS {
        return rows.to_vec();
    }
    let last = rows.len() - 1;
    let places = (0..MOST_POINTS).map(|point| point * last / (MOST_POINTS - 1));
    places.map(|place| rows[place]).collect()
}

fn points(rows: &[usize], varied: &VariedColumn<'_>, mode: &ModeColumn<'_>) -> Vec<(f64, f64)> {
    let point = |row: &usize| (varied.values[*row], mode.frequency_hz[*row]);
    rows.iter().map(point).collect()
}

/// One row per point.
fn table(x_name: &str, panels: &[Panel<'_>]) -> DataTable {
    let rows = panels.iter().flat_map(|panel| {
        panel.curves.iter().flat_map(|curve| {
            curve.points.iter().map(|(x, y)| {
                vec![
                    panel.title.to_owned(),
                    curve.label.clone(),
                    Rounded(*x).to_string(),
                    if y.is_finite() {
                        format!("{y:.6}")
                    } else {
                        String::new()
                    },
                ]
            })
        })
    });
    let has_titles = panels.iter().any(|panel| !panel.title.is_empty());
    let keep = |row: Vec<String>| match has_titles {
        true => row,
        false => row.into_iter().skip(1).collect(),
    };
    let header = ["mode", "curve", x_name, "frequency (Hz)"];
    let header = if has_titles {
        &header[..]
    } else {
        &["mode", x_name, "frequency (Hz)"]
    };
    DataTable {
        header: header.iter().map(|name| (*name).to_owned()).collect(),
        rows: rows.map(keep).collect(),
    }
}
