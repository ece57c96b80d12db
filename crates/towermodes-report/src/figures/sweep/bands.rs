//! The frequencies that excitations exclude, behind the histograms of a sweep: the margins of 1P
//! and of the blade passing frequency, and the number of rows within them.

use towermodes::number::{digits, percent};

use crate::figures::chart::legend::{Entry, words};
use crate::svg::{Anchor, Axes, Colour, Dash, Drawing, Stroke, TextStyle};

/// Size of the names of the bands.
const SIZE: f64 = 11.0;
/// An axis is extended to a band that is at most this share of its range away.
const NEAR: f64 = 1.0;
/// The share of its range by which the axis extends into a band.
const INSIDE: f64 = 0.12;

/// The frequencies that excitations of the rotor exclude.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SweepBands {
    /// The required distance |n Ω/f − 1|, for example 0.05.
    pub margin: f64,
    /// Whether the rows are drawn at random, so that shares of them estimate probabilities.
    pub are_random: bool,
    /// The bands, by increasing multiple.
    pub bands: Vec<SweepBand>,
}

/// The frequencies around a multiple of the rotor speed in operation.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepBand {
    /// The multiple n of the rotor speed.
    pub multiple: usize,
    /// The excitation at the lowest and at the highest operating speed, Hz.
    pub operation_hz: [f64; 2],
    /// The frequencies whose distance from the excitation is below the margin, Hz.
    pub margin_hz: [f64; 2],
    /// For each mode the share of rows in which the margin is violated; none if no row has the
    /// mode.
    pub violated: Vec<Option<ViolatedShare>>,
}

/// A share of rows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViolatedShare {
    /// The share, 0 to 1.
    pub share: f64,
    /// The interval that contains the probability with 95 % confidence.
    pub interval: [f64; 2],
}

/// The stroke of the borders of a margin.
fn edge() -> Stroke {
    Stroke::new(Colour::Fail, 0.9)
}

/// The stroke of the lowest and the highest operating speed.
fn operation() -> Stroke {
    Stroke::new(Colour::Fail, 1.2).dashed(Dash::Dotted)
}

impl SweepBands {
    /// A range extended into the next band on each side, if one is near.
    pub(super) fn extended(&self, [low, high]: [f64; 2]) -> [f64; 2] {
        let width = high - low;
        let near = |distance: f64| (0.0..=NEAR * width).contains(&distance);
        let below = self.bands.iter().map(|band| band.margin_hz[1]);
        let below = below.filter(|hz| near(low - hz)).fold(f64::NAN, f64::max);
        let above = self.bands.iter().map(|band| band.margin_hz[0]);
        let above = above.filter(|hz| near(hz - high)).fold(f64::NAN, f64::min);
        // NaN is neither smaller nor larger.
        [
            low.min(below - INSIDE * width),
            high.max(above + INSIDE * width),
        ]
    }

    /// Draws the bands on the field, behind everything that is drawn later.
    pub(super) fn draw(&self, drawing: &mut Drawing, axes: &Axes, range: [f64; 2]) {
        let frame = axes.frame;
        let clipped = |hz: f64| axes.x.at(hz.clamp(range[0], range[1]));
        let is_visible = |hz: f64| range[0] < hz && hz < range[1];
        for band in &self.bands {
            let [left, right] = band.margin_hz.map(clipped);
            if right - left <= 0.0 {
                continue;
            }
            let size = (right - left, frame.bottom - frame.top);
            drawing.rectangle((left, frame.top), size, Colour::TooNear, None);
            let strokes = [(band.margin_hz, edge()), (band.operation_hz, operation())];
            for (ends, stroke) in strokes {
                for hz in ends.into_iter().filter(|hz| is_visible(*hz)) {
                    let x = axes.x.at(hz);
                    drawing.line((x, frame.top), (x, frame.bottom), &stroke);
                }
            }
        }
    }

    /// Writes the names of the bands below the upper border of the field.
    pub(super) fn draw_names(&self, drawing: &mut Drawing, axes: &Axes, range: [f64; 2]) {
        let style = TextStyle::new(SIZE).bold().anchor(Anchor::Middle);
        let clipped = |hz: f64| axes.x.at(hz.clamp(range[0], range[1]));
        for band in &self.bands {
            let [left, right] = band.margin_hz.map(clipped);
            if right - left > 2.5 * SIZE {
                let at = (0.5 * (left + right), axes.frame.top + 28.0);
                drawing.text(at, &format!("{}P", band.multiple), &style);
            }
        }
    }

    /// "probability of violating the 5 % margin: 1P below 0.0038 %, 3P 14.5 % (14.3 to 14.7 %)".
    pub(super) fn in_words(&self, mode: usize) -> String {
        let of_band = |band: &SweepBand| {
            let violated = (*band.violated.get(mode)?)?;
            let shares = match self.are_random {
                true => with_confidence(violated),
                false => format!("{} %", digits(100.0 * violated.share, 3)),
            };
            Some(format!("{}P {shares}", band.multiple))
        };
        let shares: Vec<String> = self.bands.iter().filter_map(of_band).collect();
        let what = match self.are_random {
            true => "probability of a distance",
            false => "share of rows with a distance",
        };
        match shares.is_empty() {
            true => String::new(),
            false => format!(
                "{what} below {} %: {}",
                percent(self.margin),
                shares.join(", ")
            ),
        }
    }

    /// The legend of the shades and lines in fields of these ranges; empty without bands.
    pub(super) fn legend(&self, ranges: &[[f64; 2]]) -> Vec<Entry> {
        if self.bands.is_empty() {
            return Vec::new();
        }
        let names = self.bands.iter().map(|band| format!("{}P", band.multiple));
        let names: Vec<String> = names.collect();
        let names = names.join(" or ");
        let within = format!("within {} % of {names} in operation", percent(self.margin));
        let at_ends = format!("{names} at the lowest and highest rotor speed");
        let mut entries = vec![((Colour::TooNear, edge()).into(), within)];
        let mut ends = self.bands.iter().flat_map(|band| band.operation_hz);
        let is_drawn = |hz: f64| ranges.iter().any(|[low, high]| *low < hz && hz < *high);
        if ends.any(is_drawn) {
            entries.push((operation().into(), at_ends));
        }
        if self.are_random {
            entries.push(words("in brackets: 95 % confidence".to_owned()));
        }
        entries
    }
}

/// "14.5 % (14.3 to 14.7 %)"; if no row or every row is violated, only the bound.
fn with_confidence(violated: ViolatedShare) -> String {
    let [low, high] = violated.interval;
    let percent = |share: f64| digits(100.0 * share, 3);
    if violated.share == 0.0 {
        return format!("below {} %", digits(100.0 * high, 2));
    }
    if violated.share == 1.0 {
        return format!("above {} %", digits(100.0 * low, 5));
    }
    format!(
        "{} % ({} to {} %)",
        percent(violated.share),
        percent(low),
        percent(high)
    )
}

#[cfg(test)]
mod tests {
    use super::{SweepBand, SweepBands, ViolatedShare, with_confidence};

    #[test]
    fn a_range_reaches_into_a_near_band_alone() {
        let band = |margin_hz| SweepBand {
            multiple: 1,
            operation_hz: margin_hz,
            margin_hz,
            violated: Vec::new(),
        };
        let bands = SweepBands {
            bands: vec![band([0.1, 0.2]), band([0.35, 0.6])],
            ..SweepBands::default()
        };
        let close = |found: [f64; 2], expected: [f64; 2]| {
            let differences = found.iter().zip(expected).map(|(a, b)| (a - b).abs());
            assert!(differences.fold(0.0, f64::max) < 1e-12, "{found:?}");
        };
        // 3P is 0.05 Hz away, 1P 0.1 Hz.
        close(bands.extended([0.3, 0.35]), [0.3, 0.356]);
        close(bands.extended([0.25, 0.34]), [0.1892, 0.3608]);
        close(bands.extended([0.15, 0.16]), [0.15, 0.16]);
        close(bands.extended([1.0, 1.1]), [1.0, 1.1]);
    }

    /// The ends of the operating range are at 0.1 and 0.2 Hz.
    #[test]
    fn the_legend_names_only_lines_that_are_drawn() {
        let bands = SweepBands {
            bands: vec![SweepBand {
                multiple: 1,
                operation_hz: [0.1, 0.2],
                margin_hz: [0.09, 0.22],
                violated: Vec::new(),
            }],
            ..SweepBands::default()
        };
        assert_eq!(bands.legend(&[[0.21, 0.3]]).len(), 1);
        assert_eq!(bands.legend(&[[0.21, 0.3], [0.15, 0.3]]).len(), 2);
    }

    #[test]
    fn no_and_all_rows_have_a_bound() {
        let shown = |share, interval| with_confidence(ViolatedShare { share, interval });
        assert_eq!(shown(0.0, [0.0, 3.8e-5]), "below 0.0038 %");
        assert_eq!(shown(1.0, [0.999_962, 1.0]), "above 99.996 %");
        assert_eq!(shown(0.145, [0.143, 0.147]), "14.5 % (14.3 to 14.7 %)");
    }
}
