//! The first bending frequencies against the stiffness of the soil, or against the depth of scour.

use towermodes::number::Plain;
use towermodes::{Family, Rotor};
use towermodes_analysis::soil_band::{BandMode, ScourCurve, SoilBand};

use super::end_labels::{self, EndLabel};
use crate::svg::{
    Axes, Colour, Dash, DataTable, Drawing, Figure, Frame, Marker, Stroke, TextStyle,
};

const WIDTH: f64 = 900.0;
const HEIGHT: f64 = 420.0;
const TOP: f64 = 18.0;
/// Below the field: numbers and name of the axis.
const BELOW: f64 = 46.0;
/// Room above the highest and below the lowest frequency, as a fraction of their difference.
const ROOM: f64 = 0.25;
/// The axis covers at least this fraction of the frequency, so that a line looks flat if it is.
const LEAST_RANGE: f64 = 0.02;

/// What the frequencies are drawn against.
struct Against<'a> {
    name: &'static str,
    values: &'a [f64],
    is_logarithmic: bool,
    modes: Vec<&'a BandMode>,
    rotor: Option<&'a Rotor>,
}

/// The first bending frequencies against the factor of the soil stiffness.
pub fn soil(band: &SoilBand, rotor: Option<&Rotor>) -> Figure {
    let against = Against {
        name: "factor on the stiffness of the soil (–)",
        values: &band.factors,
        is_logarithmic: true,
        modes: first_bending(&band.modes),
        rotor,
    };
    against.figure(
        "soil",
        "First bending frequencies against the stiffness of the soil",
    )
}

/// The first bending frequencies against the depth of local scour.
pub fn scour(curve: &ScourCurve, rotor: Option<&Rotor>) -> Figure {
    let against = Against {
        name: "depth of local scour (m)",
        values: &curve.depths_m,
        is_logarithmic: false,
        modes: first_bending(&curve.modes),
        rotor,
    };
    against.figure(
        "scour",
        "First bending frequencies against the depth of scour",
    )
}

fn first_bending(modes: &[BandMode]) -> Vec<&BandMode> {
    let bends = |mode: &&BandMode| {
        let families = [Family::ForeAft, Family::SideSide];
        mode.order == 1 && families.contains(&mode.family)
    };
    modes.iter().filter(bends).collect()
}

impl Against<'_> {
    fn figure(&self, name: &str, title: &str) -> Figure {
        Figure {
            name: name.to_owned(),
            title: title.to_owned(),
            description: self.description(),
            drawing: self.drawing(),
            table: self.table(),
        }
    }

    /// Value and frequency of a mode where it has one.
    fn points(&self, mode: &BandMode) -> Vec<[f64; 2]> {
        let pairs = self.values.iter().zip(&mode.at);
        let pairs = pairs.filter_map(|(value, at)| Some([*value, at.as_ref()?.frequency_hz]));
        pairs.collect()
    }

    fn description(&self) -> String {
        let each = self.modes.iter().filter_map(|mode| {
            let points = self.points(mode);
            let ([from, from_hz], [to, to_hz]) = (points.first()?, points.last()?);
            Some(format!(
                "{} from {from_hz:.4} Hz at {} to {to_hz:.4} Hz at {}",
                mode.label,
                Plain(*from),
                Plain(*to)
            ))
        });
        let each: Vec<String> = each.collect();
        format!("Frequencies against {}: {}.", self.name, each.join("; "))
    }

    fn range_hz(&self) -> [f64; 2] {
        let points = self.modes.iter().flat_map(|mode| self.points(mode));
        let (low, high) = points.fold((f64::INFINITY, 0.0_f64), |(low, high), [_, hz]| {
            (low.min(hz), high.max(hz))
        });
        let low = low.min(high);
        let room = (ROOM * (high - low)).max(LEAST_RANGE * high).max(1e-9);
        [(low - room).max(0.0), high + room]
    }

    fn drawing(&self) -> Drawing {
        let mut drawing = Drawing::new(WIDTH, HEIGHT);
        let range_hz = self.range_hz();
        let mut frame = Frame {
            left: Axes::left_margin(range_hz, false, 6),
            top: TOP,
            right: WIDTH,
            bottom: HEIGHT - BELOW,
        };
        let x_range = [
            self.values.first().copied().unwrap_or(0.0),
            self.values.last().copied().unwrap_or(1.0),
        ];
        let axes = |frame| Axes::new(frame, x_range, range_hz, [self.is_logarithmic, false]);
        let modes = self.modes.iter().enumerate();
        let labels: Vec<EndLabel> = modes
            .map(|(index, mode)| self.end_label(index, mode, &axes(frame)))
            .collect();
        frame.right -= end_labels::column_width(&labels);
        let axes = axes(frame);
        if let Some(rotor) = self.rotor {
            excitations(&mut drawing, &axes, range_hz, rotor);
        }
        self.draw_axes(&mut drawing, &axes);
        for (index, mode) in self.modes.iter().enumerate() {
            let places: Vec<_> = self
                .points(mode)
                .iter()
                .map(|[x, hz]| axes.at(*x, *hz))
                .collect();
            let colour = Colour::Series(index);
            let stroke = Stroke::new(colour, 1.8).dashed(Dash::of_series(index));
            drawing.polyline(&places, &stroke);
            for place in places {
                drawing.marker(Marker::of_series(index), place, 4.0, colour);
            }
        }
        end_labels::draw(
            &mut drawing,
            frame.right,
            [frame.top, frame.bottom],
            &labels,
        );
        drawing
    }

    fn draw_axes(&self, drawing: &mut Drawing, axes: &Axes) {
        match self.is_logarithmic {
            true => {
                let ticks = self
                    .values
                    .iter()
                    .filter(|value| value.log2().fract() == 0.0);
                let ticks: Vec<(f64, String)> = ticks
                    .map(|value| (*value, Plain(*value).to_string()))
                    .collect();
                axes.draw_x_at(drawing, self.name, &ticks);
            }
            false => axes.draw_x(drawing, self.name, 7),
        }
        axes.draw_y(drawing, "natural frequency (Hz)", 6);
    }

    fn end_label(&self, index: usize, mode: &BandMode, axes: &Axes) -> EndLabel {
        let points = self.points(mode);
        EndLabel {
            y: points.last().map_or(0.0, |[x, hz]| axes.at(*x, *hz).1),
            text: mode.label.clone(),
            colour: Colour::Series(index),
            marker: Some(Marker::of_series(index)),
            is_bold: false,
        }
    }

    /// One row for each value, one column for each mode.
    fn table(&self) -> DataTable {
        let names = self.modes.iter().map(|mode| format!("{} (Hz)", mode.label));
        let row = |(place, value): (usize, &f64)| {
            let frequencies = self.modes.iter().map(|mode| {
                let at = mode.at.get(place).copied().flatten();
                at.map_or_else(String::new, |at| format!("{:.6}", at.frequency_hz))
            });
            std::iter::once(Plain(*value).to_string())
                .chain(frequencies)
                .collect()
        };
        DataTable {
            header: std::iter::once(self.name.to_owned()).chain(names).collect(),
            rows: self.values.iter().enumerate().map(row).collect(),
        }
    }
}

/// The ranges of 1P and of the blade passing frequency in operation, as far as they are in the
/// field.
fn excitations(drawing: &mut Drawing, axes: &Axes, [low, high]: [f64; 2], rotor: &Rotor) {
    let Frame { left, right, .. } = axes.frame;
    for multiple in [1, rotor.blades] {
        let hz = [rotor.lowest_rpm, rotor.highest_rpm].map(|rpm| multiple as f64 * rpm / 60.0);
        let (from, to) = (hz[0].max(low), hz[1].min(high));
        if from >= to {
            continue;
        }
        let [top, bottom] = [to, from].map(|hz| axes.y.at(hz));
        let size = (right - left, bottom - top);
        drawing.rectangle((left, top), size, Colour::Band, None);
        let style = TextStyle::new(11.0).colour(Colour::Muted);
        drawing.text(
            (left + 6.0, top + 14.0),
            &format!("{multiple}P in operation"),
            &style,
        );
    }
}
