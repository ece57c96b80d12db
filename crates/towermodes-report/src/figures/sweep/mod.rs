//! The results of a sweep: for one varied input curves of the frequencies, for two a panel of
//! curves for each mode, and for any other sweep the distribution of each frequency.

mod bands;
mod curves;
mod distribution;

pub use bands::{SweepBand, SweepBands, ViolatedShare};

use crate::svg::Figure;

/// The columns of a sweep that a picture shows; all have a value for each row that is shown, NaN if
/// the row has none.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SweepColumns<'a> {
    /// The number of rows of the sweep. The columns may contain a random selection of them, which
    /// the description then states.
    pub rows: u64,
    /// The varied inputs.
    pub varied: Vec<VariedColumn<'a>>,
    /// The frequencies.
    pub modes: Vec<ModeColumn<'a>>,
    /// The frequencies that the rotor excludes, shown behind histograms; empty if its speed is
    /// unknown or if they are not requested.
    pub bands: SweepBands,
}

/// A varied input.
#[derive(Debug, Clone, PartialEq)]
pub struct VariedColumn<'a> {
    /// Its name, `rna.mass` or `scale(stations[*].wall)`.
    pub name: &'a str,
    /// Its unit; empty for a factor.
    pub unit: &'a str,
    /// Its value in each row.
    pub values: Vec<f64>,
}

/// The frequency of a mode.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeColumn<'a> {
    /// Its name: "1st fore-aft bending".
    pub label: &'a str,
    /// Its frequency in each row, Hz.
    pub frequency_hz: Vec<f64>,
}

/// The height of each of several panels.
fn panel_height(panels: usize) -> f64 {
    if panels <= 1 { 480.0 } else { 300.0 }
}

impl SweepColumns<'_> {
    /// " The picture shows 999512 rows, selected at random from 4000000."; empty if all rows are
    /// shown.
    fn selection(&self) -> String {
        let shown = self.modes.first().map_or(0, |mode| mode.frequency_hz.len());
        match self.rows > shown as u64 {
            true => format!(
                " The picture shows {shown} rows, selected at random from {}.",
                self.rows
            ),
            false => String::new(),
        }
    }
}

impl VariedColumn<'_> {
    /// "rna.mass (kg)".
    fn axis_name(&self) -> String {
        match self.unit {
            "" => format!("{} (−)", self.name),
            unit => format!("{} ({unit})", self.name),
        }
    }

    /// Its different values in increasing order; none if there are more than `most`.
    fn levels(&self, most: usize) -> Option<Vec<f64>> {
        let mut levels: Vec<f64> = Vec::new();
        for value in self
            .values
            .iter()
            .copied()
            .filter(|value| value.is_finite())
        {
            if let Err(place) = levels.binary_search_by(|level| level.total_cmp(&value)) {
                if levels.len() == most {
                    return None;
                }
                levels.insert(place, value);
            }
        }
        Some(levels)
    }
}

/// The picture of a sweep.
pub fn sweep(columns: &SweepColumns<'_>) -> Figure {
    let mut figure = of_all(columns);
    figure.description.push_str(&columns.selection());
    figure
}

/// The picture of the rows in these columns.
fn of_all(columns: &SweepColumns<'_>) -> Figure {
    match &columns.varied[..] {
        [one] => curves::of_one(one, &columns.modes),
        [first, second] => {
            // The curves are those of the number with few values.
            let of_second = second.levels(curves::MOST_LEVELS);
            let of_first = first.levels(curves::MOST_LEVELS);
            match (of_second, of_first) {
                (Some(levels), _) => curves::of_two(first, second, &levels, &columns.modes),
                (None, Some(levels)) => curves::of_two(second, first, &levels, &columns.modes),
                (None, None) => distribution::of_each(columns),
            }
        }
        _ => distribution::of_each(columns),
    }
}
