//! Two still pictures of a mode, from the side and from downwind.

use std::f64::consts::TAU;

use towermodes::turbine::{Turbine, TurbineMode, TurbineModes};

use super::geometry::{Geometry, Moment, Place};
use super::{MOST_SECTIONS, few, tower_heights};
use crate::figures::campbell::part_colour;
use crate::number::four_digits;
use crate::svg::{Colour, Dash, Drawing, Stroke, TextStyle};

/// Width and height of a panel.
pub(super) const PANEL: (f64, f64) = (285.0, 264.0);
/// Room above the views for name and frequency.
const HEADING: f64 = 34.0;
/// Distance between the views, and between panels.
const GAP: f64 = 8.0;
/// Radius of the arrow of rotation.
const ARROW: f64 = 26.0;
/// Number of points around the rotor.
const AROUND: usize = 36;

/// Common data of all panels: the turbine at rest, and the scale.
pub(super) struct Scene {
    geometry: Geometry,
    heights_m: Vec<f64>,
    speed_rad_per_s: f64,
    reach_m: f64,
    /// Pixels per metre.
    per_m: f64,
    /// The smallest x, y and z, m.
    low: Place,
    /// The largest x, y and z, m.
    high: Place,
}

/// The two views.
#[derive(Debug, Clone, Copy)]
enum View {
    Side,
    Downwind,
}

impl View {
    /// The coordinate that points to the right.
    fn across(self) -> usize {
        match self {
            Self::Side => 0,
            Self::Downwind => 1,
        }
    }
}

impl Scene {
    /// The scene of a turbine; the largest deflection is the fraction `reach` of the tower height.
    pub fn new(turbine: &Turbine, modes: &TurbineModes, reach: f64) -> Self {
        let geometry = Geometry::new(turbine);
        let heights_m = tower_heights(turbine, modes);
        let reach_m = reach * turbine.tower().height_m();
        let blade = modes.modes.first().map_or(&[][..], |m| &m.shape.blades);
        let tip_m = blade.last().map_or(0.0, |section| section.radius_m);
        let (mut low, mut high) = ([0.0_f64; 3], [0.0_f64; 3]);
        low[2] = turbine.tower().base_m();
        high[2] = turbine.tower().top_m();
        for place in (0..AROUND).map(|k| geometry.at_rest(tip_m, turn(k))) {
            for i in 0..3 {
                low[i] = low[i].min(place[i]);
                high[i] = high[i].max(place[i]);
            }
        }
        for i in 0..3 {
            // The base does not move up and down.
            low[i] -= if i == 2 { 0.0 } else { reach_m };
            high[i] += reach_m;
        }
        let size = |i: usize| high[i] - low[i];
        let room = (PANEL.0 - GAP, PANEL.1 - HEADING - GAP);
        let per_m = (room.0 / (size(0) + size(1))).min(room.1 / size(2));
        Self {
            geometry,
            heights_m,
            speed_rad_per_s: modes.rotor_speed_rpm * std::f64::consts::PI / 30.0,
            reach_m,
            per_m,
            low,
            high,
        }
    }

    /// The moment of a mode this number of periods after its largest deflection.
    fn after(&self, periods: f64, mode: &TurbineMode) -> Moment {
        let frequency_hz = mode.frequency.frequency_hz;
        let seconds = match frequency_hz > 0.0 {
            true => periods / frequency_hz,
            false => 0.0,
        };
        Moment {
            phase_rad: TAU * periods,
            turned_rad: self.speed_rad_per_s * seconds,
            scale_m: self.reach_m,
        }
    }
}

/// Draws the views of a mode with its number at a place on the sheet.
pub(super) fn draw_panel(
    drawing: &mut Drawing,
    scene: &Scene,
    (number, mode): (usize, &TurbineMode),
    (left, top): (f64, f64),
) {
    let name = format!("{number}. {}", mode.label());
    let frequency = format!("{} Hz", four_digits(mode.frequency.frequency_hz));
    drawing.text((left, top + 12.0), &name, &TextStyle::new(11.0));
    let muted = TextStyle::new(10.5).colour(Colour::Muted);
    drawing.text((left, top + 27.0), &frequency, &muted);
    let top = top + HEADING;
    let width = scene.per_m * (scene.high[0] - scene.low[0]);
    draw_view(drawing, scene, mode, (View::Side, [left, top]));
    let beside = left + width + GAP;
    draw_view(drawing, scene, mode, (View::Downwind, [beside, top]));
    draw_rotation(drawing, scene, [beside, top]);
}

fn draw_view(
    drawing: &mut Drawing,
    scene: &Scene,
    mode: &TurbineMode,
    (view, [left, top]): (View, [f64; 2]),
) {
    let across = view.across();
    let flat = |place: &Place| {
        (
            left + scene.per_m * (place[across] - scene.low[across]),
            top + scene.per_m * (scene.high[2] - place[2]),
        )
    };
    let mut draw = |lines: &[Vec<Place>], stroke: &Stroke| {
        for line in lines {
            let points: Vec<(f64, f64)> = line.iter().map(flat).collect();
            drawing.polyline(&points, stroke);
        }
    };
    draw(&undeformed(scene, mode), &Stroke::new(Colour::Muted, 0.8));
    let stills = [
        (0.25, Stroke::new(Colour::Ink, 1.0).dashed(Dash::Dashed)),
        (0.0, Stroke::new(part_colour(mode.name.part), 2.0)),
    ];
    for (periods, stroke) in stills {
        let moment = scene.after(periods, mode);
        let ring = Stroke {
            width: 0.6,
            ..stroke
        };
        draw(&[ring_of(scene, mode, &moment)], &ring);
        draw(&deformed(scene, mode, &moment), &stroke);
    }
}

/// Draws an arrow around the hub in the view from downwind, where the rotor rotates
/// counterclockwise.
fn draw_rotation(drawing: &mut Drawing, scene: &Scene, [left, top]: [f64; 2]) {
    if scene.speed_rad_per_s == 0.0 {
        return;
    }
    let [_, y, z] = scene.geometry.apex_m;
    let middle = (
        left + scene.per_m * (y - scene.low[1]),
        top + scene.per_m * (scene.high[2] - z),
    );
    let at = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        (middle.0 + ARROW * cos, middle.1 - ARROW * sin)
    };
    let stroke = Stroke::new(Colour::Ink, 1.3);
    let arc = (0..=12).map(|k| at(f64::from(k).mul_add(5.0, 15.0)));
    let arc: Vec<(f64, f64)> = arc.collect();
    let (x, y) = arc[arc.len() - 1];
    drawing.polyline(&arc, &stroke);
    // Along the circle at 75 degrees: to the left and a little upwards.
    let head = [(x - 4.8, y - 1.3), (x + 1.7, y + 5.1), (x + 4.1, y - 3.5)];
    drawing.polygon(&head, Colour::Ink, None);
}

/// Tower and blades at rest as straight lines, with the first blade up.
fn undeformed(scene: &Scene, mode: &TurbineMode) -> Vec<Vec<Place>> {
    let ends = |all: &[f64]| few(all, 2);
    let tower = ends(&scene.heights_m).into_iter();
    let radii = mode.shape.blades.iter().map(|section| section.radius_m);
    let radii = ends(&radii.collect::<Vec<f64>>());
    let blade = |azimuth: f64| {
        radii
            .iter()
            .map(|m| scene.geometry.at_rest(*m, azimuth))
            .collect()
    };
    let blades = scene.geometry.azimuths(0.0).into_iter().map(blade);
    std::iter::once(tower.map(|height| [0.0, 0.0, height]).collect())
        .chain(blades)
        .collect()
}

/// Tower and blades at a moment.
fn deformed(scene: &Scene, mode: &TurbineMode, moment: &Moment) -> Vec<Vec<Place>> {
    let tower = few(&mode.shape.tower, MOST_SECTIONS);
    let blades = few(&mode.shape.blades, MOST_SECTIONS);
    let blade = |azimuth: f64| {
        let at = |section| scene.geometry.deflected(section, azimuth, moment);
        blades.iter().map(at).collect()
    };
    let azimuths = scene.geometry.azimuths(moment.turned_rad);
    std::iter::once(
        tower
            .iter()
            .map(|section| moment.of_tower(section))
            .collect(),
    )
    .chain(azimuths.into_iter().map(blade))
    .collect()
}

/// The positions of the blade tip at all azimuths.
fn ring_of(scene: &Scene, mode: &TurbineMode, moment: &Moment) -> Vec<Place> {
    let Some(tip) = mode.shape.blades.last() else {
        return Vec::new();
    };
    let at = |k| scene.geometry.deflected(tip, turn(k), moment);
    (0..=AROUND).map(at).collect()
}

fn turn(k: usize) -> f64 {
    TAU * k as f64 / AROUND as f64
}
