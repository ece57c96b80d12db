//! A tower before and after its design: diameters and wall thicknesses over the height, frequencies
//! with their bands.

use towermodes::number::digits;
use towermodes::{Station, TowerDescription};

use super::chart::WIDTH;
use super::chart::legend::{Entry, Legend, Sample};
use crate::svg::{
    Anchor, Axes, Colour, Dash, DataTable, Drawing, Figure, Frame, Marker, Stroke, TextStyle,
    extent, widest,
};
use crate::wording::structure_mass;

const TOP: f64 = 14.0;
/// Height of the fields of diameters and wall thicknesses.
const FIELD: f64 = 380.0;
/// Room below a field for the numbers and the name of its axis.
const BELOW: f64 = 52.0;
/// Height of the row of a mode.
const ROW: f64 = 30.0;
/// Height of the field of frequencies if it is the only one.
const LOWEST: f64 = 300.0;
const SIZE: f64 = 12.0;
/// Approximate number of numbers along an axis.
const TICKS: usize = 6;

/// A frequency with its goal.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignedMode<'a> {
    /// Its name: "1st fore-aft bending".
    pub label: &'a str,
    /// The lowest and the highest frequency allowed, Hz; 0 and infinity without a limit.
    pub band_hz: [f64; 2],
    /// The frequency of the original tower, Hz; none if it has no such mode.
    pub before_hz: Option<f64>,
    /// The frequency of the tower found, Hz.
    pub after_hz: f64,
}

/// A tower before and after its design, with its mass and its frequencies; diameters and wall
/// thicknesses only for a tower of stations.
pub fn design(
    [before, after]: [&TowerDescription; 2],
    mass_kg: [f64; 2],
    modes: &[DesignedMode<'_>],
) -> Figure {
    let mass = mass_kg.map(|kg| digits(kg / 1000.0, 4));
    let has_stations = !after.stations.is_empty();
    let profile = if has_stations {
        "Outer diameter and wall thickness over the height, dashed before and solid after. "
    } else {
        ""
    };
    let words = |mode: &DesignedMode<'_>| {
        let [low, high] = mode.band_hz.map(|hz| digits(hz, 4));
        let after = digits(mode.after_hz, 4);
        let band = match mode.band_hz {
            [0.0, f64::INFINITY] => "without a limit".to_owned(),
            [0.0, _] => format!("at most {high} Hz"),
            [_, f64::INFINITY] => format!("at least {low} Hz"),
            _ => format!("from {low} to {high} Hz"),
        };
        format!(" The {} is {after} Hz; its goal is {band}.", mode.label)
    };
    let goals: String = modes.iter().map(words).collect();
    Figure {
        name: "design".to_owned(),
        title: format!("Design: {} t before, {} t after", mass[0], mass[1]),
        description: format!(
            "{profile}Frequencies before and after, with their target bands.{goals}"
        ),
        drawing: drawing([before, after], has_stations, modes),
        table: table((structure_mass(after.foundation.frame()), mass_kg), modes),
    }
}

fn drawing(
    towers: [&TowerDescription; 2],
    has_stations: bool,
    modes: &[DesignedMode<'_>],
) -> Drawing {
    let mut top = TOP;
    if has_stations {
        top += FIELD + BELOW + TOP;
    }
    let frequencies = frequencies_frame(modes, top, if has_stations { 0.0 } else { LOWEST });
    let legend = Legend {
        left_top: (14.0, frequencies.bottom + BELOW),
        room: WIDTH - 28.0,
        entries: entries(has_stations, modes),
    };
    let mut drawing = legend.sheet();
    if has_stations {
        draw_profiles(&mut drawing, towers);
    }
    draw_frequencies(&mut drawing, frequencies, modes);
    legend.draw(&mut drawing);
    drawing
}

/// Draws diameters on the left and wall thicknesses on the right, over the same heights.
fn draw_profiles(drawing: &mut Drawing, towers: [&TowerDescription; 2]) {
    let of = |value: fn(&Station) -> f64| {
        towers.map(|tower| -> Vec<(f64, f64)> {
            let stations = tower.stations.iter();
            stations
                .map(|station| (value(station), station.height_m))
                .collect()
        })
    };
    let fields = [
        ("outer diameter (m)", of(|station| station.outer_diameter_m)),
        (
            "wall thickness (mm)",
            of(|station| 1e3 * station.wall_thickness_m),
        ),
    ];
    let stations = towers.into_iter().flat_map(|tower| &tower.stations);
    let heights = extent(stations.map(|station| station.height_m)).unwrap_or([0.0, 1.0]);
    let left = Axes::left_margin(heights, false, TICKS);
    let width = 0.5 * (WIDTH - 14.0) - left;
    for (place, (name, [before, after])) in fields.iter().enumerate() {
        let begin = left + place as f64 * (left + width);
        let frame = Frame {
            left: begin,
            top: TOP,
            right: begin + width,
            bottom: TOP + FIELD,
        };
        let [_, widest] = extent(before.iter().chain(after).map(|(x, _)| *x)).unwrap_or([0.0; 2]);
        let axes = Axes::new(frame, [0.0, 1.05 * widest], heights, [false, false]);
        axes.draw_x(drawing, name, TICKS);
        axes.draw_y(drawing, "height (m)", TICKS);
        for (points, stroke) in [(before, before_stroke()), (after, after_stroke())] {
            let points: Vec<(f64, f64)> = points.iter().map(|(x, y)| axes.at(*x, *y)).collect();
            drawing.polyline(&points, &stroke);
        }
    }
}

fn before_stroke() -> Stroke {
    Stroke::new(Colour::Series(1), 1.6).dashed(Dash::Dashed)
}

fn after_stroke() -> Stroke {
    Stroke::new(Colour::Series(0), 2.2)
}

fn frequencies_frame(modes: &[DesignedMode<'_>], top: f64, lowest: f64) -> Frame {
    let names = modes.iter().map(|mode| mode.label);
    Frame {
        left: widest(names, SIZE, false) + 24.0,
        top,
        right: WIDTH - 14.0,
        bottom: top + (ROW * modes.len() as f64).max(lowest).max(ROW),
    }
}

/// Draws a row for each mode: its band as an area, a ring for the frequency before and a disc for
/// that after.
fn draw_frequencies(drawing: &mut Drawing, frame: Frame, modes: &[DesignedMode<'_>]) {
    let ends = modes.iter().flat_map(|mode| mode.band_hz);
    let ends = ends.filter(|hz| *hz > 0.0 && hz.is_finite());
    let values = modes
        .iter()
        .flat_map(|mode| [mode.before_hz, Some(mode.after_hz)]);
    let all = values.flatten().chain(ends);
    let range = extent(all).map_or([0.0, 1.0], |[low, high]| [0.95 * low, 1.05 * high]);
    let axes = Axes::new(frame, range, [0.0, 1.0], [false, false]);
    let height = (frame.bottom - frame.top) / modes.len().max(1) as f64;
    for (row, mode) in modes.iter().enumerate() {
        let middle = frame.top + height * (row as f64 + 0.5);
        let [left, right] = mode
            .band_hz
            .map(|hz| axes.x.at(hz.clamp(range[0], range[1])));
        let size = (right - left, 0.6 * ROW);
        let top = middle - 0.3 * ROW;
        drawing.rectangle((left, top), size, Colour::Window, None);
    }
    axes.draw_x(drawing, "natural frequency (Hz)", 8);
    for (row, mode) in modes.iter().enumerate() {
        let middle = frame.top + height * (row as f64 + 0.5);
        let name = TextStyle::new(SIZE).anchor(Anchor::End);
        drawing.text((frame.left - 8.0, middle + 0.35 * SIZE), mode.label, &name);
        if let Some(hz) = mode.before_hz {
            let at = (axes.x.at(hz), middle);
            drawing.marker(Marker::Ring, at, 5.0, Colour::Series(1));
        }
        let at = (axes.x.at(mode.after_hz), middle);
        drawing.marker(Marker::Disc, at, 5.0, Colour::Series(0));
    }
}

fn entries(has_stations: bool, modes: &[DesignedMode<'_>]) -> Vec<Entry> {
    let of = |stroke: Stroke, marker: Marker| Sample {
        line: has_stations.then_some(stroke),
        marker: (!modes.is_empty()).then_some((marker, stroke.colour)),
        surface: None,
    };
    let mut entries = vec![
        (of(before_stroke(), Marker::Ring), "before".to_owned()),
        (of(after_stroke(), Marker::Disc), "after".to_owned()),
    ];
    if !modes.is_empty() {
        let band = (Colour::Window, Stroke::new(Colour::Grid, 1.0));
        entries.push((band.into(), "band of the frequency".to_owned()));
    }
    entries
}

fn table((mass, mass_kg): (&str, [f64; 2]), modes: &[DesignedMode<'_>]) -> DataTable {
    let header = ["", "lowest", "highest", "before", "after"];
    let limit = |hz: f64| match hz > 0.0 && hz.is_finite() {
        true => digits(hz, 6),
        false => String::new(),
    };
    let mut rows = vec![vec![
        format!("{mass} (kg)"),
        String::new(),
        String::new(),
        digits(mass_kg[0], 6),
        digits(mass_kg[1], 6),
    ]];
    rows.extend(modes.iter().map(|mode| {
        vec![
            format!("{} (Hz)", mode.label),
            limit(mode.band_hz[0]),
            limit(mode.band_hz[1]),
            mode.before_hz.map_or(String::new(), |hz| digits(hz, 6)),
            digits(mode.after_hz, 6),
        ]
    }));
    DataTable::new(header, rows)
}
