//! The modes of a turbine with rotating rotor: still pictures of each, and the data for their
//! animation.

mod animation;
mod geometry;
mod numbers;
mod panel;

use towermodes::turbine::{Turbine, TurbineModes};

pub use animation::{AnimatedHarmonic, AnimatedWhirl, WhirlAnimation, whirl_animation};

use crate::number::short;
use crate::svg::{Colour, Drawing, Figure, TextStyle};
use panel::{PANEL, Scene, draw_panel};

/// The largest number of sections of the tower, and of a blade.
const MOST_SECTIONS: usize = 20;
/// The largest number of modes in the figure.
const MOST_MODES: usize = 18;
/// Panels in a row.
const COLUMNS: usize = 3;
/// Width of the sheet.
const WIDTH: f64 = 900.0;
/// Left edge of the first panel, and distance between panels.
const GAPS: (f64, f64) = (12.0, 10.0);
/// Room above and below the panels.
const ENDS: (f64, f64) = (10.0, 44.0);
/// The largest deflection in a still picture, as a fraction of the tower height.
const REACH: f64 = 0.1;

/// The modes of a turbine at a rotor speed: for each mode two still pictures a quarter of a period
/// apart, from the side and from downwind. At most 18 modes are drawn.
pub fn whirl(turbine: &Turbine, modes: &TurbineModes) -> Figure {
    let drawn = modes.modes.len().min(MOST_MODES);
    let rows = drawn.div_ceil(COLUMNS).max(2);
    let height = ENDS.0 + rows as f64 * PANEL.1 + ENDS.1;
    let mut drawing = Drawing::new(WIDTH, height);
    let scene = Scene::new(turbine, modes, REACH);
    for (index, mode) in modes.modes.iter().take(MOST_MODES).enumerate() {
        let column = (index % COLUMNS) as f64;
        let left = GAPS.0 + column * (PANEL.0 + GAPS.1);
        let top = ENDS.0 + (index / COLUMNS) as f64 * PANEL.1;
        draw_panel(&mut drawing, &scene, (index + 1, mode), (left, top));
    }
    let style = TextStyle::new(10.0).colour(Colour::Muted);
    for (line, note) in notes(modes).iter().enumerate() {
        let y = height - 24.0 + 15.0 * line as f64;
        drawing.text((GAPS.0, y), note, &style);
    }
    Figure {
        name: "turbine-modes".to_owned(),
        title: numbers::title(turbine, modes),
        description: numbers::description(modes),
        drawing,
        table: numbers::table(modes),
    }
}

/// The notes on the meaning of the lines.
fn notes(modes: &TurbineModes) -> [String; 2] {
    let left_out = match modes.modes.len().saturating_sub(MOST_MODES) {
        0 => String::new(),
        more => format!(" The {more} modes above are not drawn."),
    };
    let arrow = match modes.rotor_speed_rpm > 0.0 {
        true => ", the arrow shows the direction of rotation",
        false => "",
    };
    [
        "Solid, in the colour of the Campbell diagram: the largest deflection; dashed: a quarter of a period later, with the rotor rotated; thin: positions of the tips at all azimuths.".to_owned(),
        format!(
            "Grey: undeformed. Left: from the side; right: from downwind{arrow}; the largest deflection is {} % of the tower's height.{left_out}",
            short(100.0 * REACH, 3)
        ),
    ]
}

/// Heights of the sections of the tower, m.
fn tower_heights(turbine: &Turbine, modes: &TurbineModes) -> Vec<f64> {
    let mut shapes = modes.modes.iter().map(|mode| &mode.shape.tower);
    match shapes.find(|tower| !tower.is_empty()) {
        Some(tower) => tower.iter().map(|section| section.height_m).collect(),
        None => vec![turbine.tower().base_m(), turbine.tower().top_m()],
    }
}

/// At most this number of elements of a list at about equal distances, including the first and the
/// last.
fn few<T: Clone>(all: &[T], most: usize) -> Vec<T> {
    if all.len() <= most {
        return all.to_vec();
    }
    let last = all.len() - 1;
    let places = (0..most).map(|k| (k * last + (most - 1) / 2) / (most - 1));
    places.map(|place| all[place].clone()).collect()
}
