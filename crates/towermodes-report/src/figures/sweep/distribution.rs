//! The distribution of each frequency over the rows of a sweep.

use towermodes::number::digits;

use super::curves::not_shown;
use super::{ModeColumn, SweepBands, SweepColumns, panel_height};
use crate::figures::chart::legend::Legend;
use crate::figures::chart::{WIDTH, draw_title, frame, range};
use crate::svg::{Anchor, Axes, Colour, Dash, DataTable, Drawing, Figure, Stroke, TextStyle};

/// Largest number of panels.
const MOST_PANELS: usize = 6;
/// Room beside the panels and the legend.
const BESIDE: f64 = 24.0;
/// Size of the remark beside the title of a panel.
const REMARK: f64 = 11.0;
/// Smallest and largest number of classes of a histogram.
const CLASSES: [usize; 2] = [8, 60];
/// The quantiles that are marked.
const QUANTILES: [(f64, &str); 3] = [(0.05, "5 %"), (0.5, "50 %"), (0.95, "95 %")];

/// A histogram for each mode.
pub(super) fn of_each(columns: &SweepColumns<'_>) -> Figure {
    let shown = &columns.modes[..columns.modes.len().min(MOST_PANELS)];
    let histograms: Vec<Histogram<'_>> = shown.iter().map(Histogram::of).collect();
    let height = panel_height(histograms.len());
    let ranges: Vec<[f64; 2]> = histograms
        .iter()
        .map(|histogram| columns.bands.extended(histogram.range))
        .collect();
    let (bands, all) = (&columns.bands, height * histograms.len().max(1) as f64);
    let legend = Legend {
        left_top: (BESIDE, all),
        room: WIDTH - 2.0 * BESIDE,
        entries: bands.legend(&ranges),
    };
    let mut drawing = Drawing::new(WIDTH, all + legend.height());
    for (index, histogram) in histograms.iter().enumerate() {
        let top = height * index as f64;
        let remark = bands.in_words(index);
        histogram.draw(&mut drawing, [top, top + height], (bands, &remark));
    }
    legend.draw(&mut drawing);
    let names: Vec<&str> = columns.varied.iter().map(|varied| varied.name).collect();
    let words = histograms.iter().enumerate();
    let words = words.map(|(mode, histogram)| histogram.in_words(&bands.in_words(mode)));
    let words: Vec<String> = words.collect();
    let description = format!(
        "Histograms of {} natural frequencies over the rows of a sweep of {}. {}{}",
        shown.len(),
        names.join(", "),
        words.join(" "),
        not_shown(columns.modes.len() - shown.len())
    );
    Figure {
        name: "sweep".to_owned(),
        title: "Distribution of the natural frequencies".to_owned(),
        description,
        drawing,
        table: table(&histograms),
    }
}

/// A frequency in classes of equal width.
struct Histogram<'a> {
    label: &'a str,
    /// Number of rows with a frequency.
    rows: usize,
    range: [f64; 2],
    /// Share of the rows in each class, percent.
    shares: Vec<f64>,
    /// The values of [`QUANTILES`], Hz.
    quantiles: Vec<f64>,
}

impl<'a> Histogram<'a> {
    fn of(mode: &'a ModeColumn<'_>) -> Self {
        let values = mode
            .frequency_hz
            .iter()
            .copied()
            .filter(|hz| hz.is_finite());
        let mut values: Vec<f64> = values.collect();
        values.sort_by(f64::total_cmp);
        let range = range(values.iter().copied(), 0.0);
        let [fewest, most] = CLASSES;
        let count = ((values.len() as f64).sqrt().ceil() as usize).clamp(fewest, most);
        let mut shares = vec![0.0; count];
        for value in &values {
            let place = (value - range[0]) / (range[1] - range[0]) * count as f64;
            shares[(place as usize).min(count - 1)] += 100.0 / values.len() as f64;
        }
        Self {
            label: mode.label,
            rows: values.len(),
            range,
            shares,
            quantiles: QUANTILES
                .map(|(share, _)| quantile(&values, share))
                .to_vec(),
        }
    }

    /// Draws the histogram in front of the bands, with a remark beside its title.
    fn draw(&self, drawing: &mut Drawing, rows: [f64; 2], (bands, remark): (&SweepBands, &str)) {
        let range = bands.extended(self.range);
        let highest = self.shares.iter().copied().fold(0.0, f64::max).max(1e-9);
        // Room for the names of the quantiles.
        let y = [0.0, 1.15 * highest];
        let left = Axes::left_margin(y, false, 5);
        let title = Some(self.label);
        let frame = frame(title, rows, [left, WIDTH - BESIDE]);
        draw_title(drawing, title, &frame);
        let axes = Axes::new(frame, range, y, [false, false]);
        bands.draw(drawing, &axes, range);
        let beside = TextStyle::new(REMARK).anchor(Anchor::End);
        drawing.text((frame.right, frame.top - 10.0), remark, &beside);
        axes.draw_x(drawing, "natural frequency (Hz)", 6);
        axes.draw_y(drawing, "share of the rows (%)", 5);
        let edge = Stroke::new(Colour::Paper, 0.7);
        for (class, share) in self.shares.iter().enumerate() {
            let (from, top) = axes.at(self.edge(class), *share);
            let (to, bottom) = axes.at(self.edge(class + 1), 0.0);
            let size = (to - from, bottom - top);
            drawing.rectangle((from, top), size, Colour::Series(0), Some(&edge));
        }
        self.draw_quantiles(drawing, &axes);
        bands.draw_names(drawing, &axes, range);
    }

    fn draw_quantiles(&self, drawing: &mut Drawing, axes: &Axes) {
        let stroke = Stroke::new(Colour::Ink, 1.2).dashed(Dash::Dashed);
        let style = TextStyle::new(11.0).anchor(Anchor::Middle);
        let mut free = f64::NEG_INFINITY;
        for (value, (_, name)) in self.quantiles.iter().zip(QUANTILES) {
            let x = axes.x.at(*value);
            if !x.is_finite() {
                continue;
            }
            drawing.line((x, axes.frame.top + 14.0), (x, axes.frame.bottom), &stroke);
            // Names of equal quantiles would lie on each other.
            if x - 14.0 >= free {
                drawing.text((x, axes.frame.top + 10.0), name, &style);
                free = x + 14.0;
            }
        }
    }

    /// The lower edge of a class, Hz.
    fn edge(&self, class: usize) -> f64 {
        let share = class as f64 / self.shares.len() as f64;
        self.range[0] + share * (self.range[1] - self.range[0])
    }

    /// "1st fore-aft bending: 5 % of the rows below 0.3145 Hz, 50 % below 0.3214 Hz, …".
    fn in_words(&self, of_bands: &str) -> String {
        if self.rows == 0 {
            return format!("{}: no row has a frequency.", self.label);
        }
        let quantiles = self.quantiles.iter().zip(QUANTILES);
        let words: Vec<String> = quantiles
            .map(|(value, (_, name))| format!("{name} of the rows below {} Hz", digits(*value, 5)))
            .collect();
        let of_bands = match of_bands {
            "" => String::new(),
            words => format!("; {words}"),
        };
        format!("{}: {}{of_bands}.", self.label, words.join(", "))
    }
}

/// A quantile of sorted values, with linear interpolation.
fn quantile(sorted: &[f64], share: f64) -> f64 {
    if sorted.is_empty() {
        return f64::NAN;
    }
    let place = share * (sorted.len() - 1) as f64;
    let below = place.floor() as usize;
    let above = (below + 1).min(sorted.len() - 1);
    sorted[below] + (place - below as f64) * (sorted[above] - sorted[below])
}

/// One row per class.
fn table(histograms: &[Histogram<'_>]) -> DataTable {
    let of_one = |of: &'_ Histogram<'_>| -> Vec<Vec<String>> {
        let edge = |class: usize| digits(of.edge(class), 6);
        let share = |class: usize| format!("{:.3}", of.shares[class]);
        let row = |class| {
            vec![
                of.label.to_owned(),
                edge(class),
                edge(class + 1),
                share(class),
            ]
        };
        (0..of.shares.len()).map(row).collect()
    };
    let header = ["mode", "from (Hz)", "to (Hz)", "share of the rows (%)"];
    DataTable::new(header, histograms.iter().flat_map(of_one))
}

#[cfg(test)]
mod tests {
    use super::quantile;

    #[test]
    fn quantiles_are_linear_between_values() {
        let values = [1.0, 2.0, 3.0, 5.0];
        assert_eq!(quantile(&values, 0.5), 2.5);
        assert_eq!(quantile(&values, 1.0), 5.0);
        assert_eq!(quantile(&[4.0], 0.05), 4.0);
        assert!(quantile(&[], 0.5).is_nan());
    }
}
