//! The tower as a drawing: heights to scale, diameters and walls by stated factors.

mod body;
mod callouts;
mod floating;
mod foundation;
mod layout;
mod machine;
mod numbers;
mod small;
mod stations;
mod surroundings;
mod view;
mod wires;

pub(super) use floating::{keel_m, platform, surface_m};
pub(super) use foundation::on_diagonal;
pub(super) use machine::{MachineForm, is_there as has_machine};
pub(super) use small::{draw_small, levels, small_view};
pub(super) use surroundings::{ground_m, water_m};
pub(super) use view::View;
pub(super) use wires::wires_ground_m;

use towermodes::{Tower, TowerDescription};

use super::enlargement::factor;
use super::outline::is_nominal;
use crate::svg::{Axes, Colour, Drawing, Figure, TextStyle};
use body::{draw_body, draw_masses};
use callouts::{Callout, Column, draw_callouts};
use foundation::draw_foundation;
use layout::{TICKS, WIDTH, sheet};
use machine::{draw_machine, is_there};
use surroundings::draw_water_and_ground;

/// A tower with what is on it, under it and around it, as its description says.
///
/// Heights and lengths have one scale. Diameters are drawn wider and walls thicker by round factors
/// that the picture names; a tower of which only the stiffness is known is as wide as the steel
/// tube of the same bending stiffness whose wall is a 200th of its diameter, which goes with the
/// fourth root of EI. Machine and platform are silhouettes without measures, with their centres of
/// mass to scale.
pub fn tower(description: &TowerDescription, tower: &Tower) -> Figure {
    let (view, height) = sheet(description, tower);
    let mut drawing = Drawing::new(WIDTH, height);
    draw_scene(&mut drawing, &view, description, tower);
    let column = Column {
        elbow_x: view.frame.right + 6.0,
        left: view.frame.right + 32.0,
        right: WIDTH - 6.0,
        range: [2.0, height - 24.0],
    };
    let left_out = draw_callouts(
        &mut drawing,
        &column,
        &callouts_of(&view, description, tower),
    );
    draw_note(&mut drawing, &view, tower, left_out.text());
    let name = tower.name();
    let title = if name.is_empty() {
        "The tower".to_owned()
    } else {
        format!("The tower: {name}")
    };
    Figure {
        name: "tower".to_owned(),
        title,
        description: numbers::description(description, tower),
        drawing,
        table: numbers::table(description, tower),
    }
}

fn draw_scene(drawing: &mut Drawing, view: &View, description: &TowerDescription, tower: &Tower) {
    draw_water_and_ground(drawing, view, description, tower);
    floating::draw_sea(drawing, view, description);
    let heights_m = [view.low_m(), view.high_m];
    let axes = Axes::new(view.frame, [0.0, 1.0], heights_m, [false, false]);
    axes.draw_y(drawing, "height z (m)", TICKS);
    surroundings::draw_soil(drawing, view, description, tower);
    wires::draw_wires(drawing, view, description, tower);
    if let Some(platform) = floating::platform(description) {
        floating::draw_platform(drawing, view, tower, platform);
    }
    draw_foundation(drawing, view, tower, &description.foundation);
    let water = description.water.filter(|water| water.flooded);
    draw_body(drawing, view, tower, water.map(|water| water.level_m));
    draw_masses(drawing, view, description);
    draw_machine(drawing, view, tower, 1.0);
}

fn callouts_of(view: &View, description: &TowerDescription, tower: &Tower) -> Vec<Callout> {
    let mut callouts: Vec<Callout> = machine::callout(view, tower).into_iter().collect();
    callouts.extend(foundation::callout(view, tower, &description.foundation));
    callouts.extend(floating::callouts(view, tower, description));
    callouts.extend(surroundings::callouts(view, description, tower));
    callouts.extend(wires::callouts(view, description, tower));
    callouts.extend(stations::mass_callouts(view, tower));
    callouts.extend(stations::station_callouts(view, tower));
    callouts
}

/// Says what is to scale and what is not.
fn draw_note(drawing: &mut Drawing, view: &View, tower: &Tower, left_out: Option<String>) {
    let width = factor(view.diameter_factor);
    let mut note = if is_nominal(tower) {
        format!(
            "Heights to scale. Width {width}: steel tube of the same EI, wall 1/200 of Ø (∝ fourth root of EI)."
        )
    } else {
        let wall = factor(view.wall_factor);
        format!("Heights to scale, diameters {width}, walls {wall}.")
    };
    if is_there(tower.rna()) {
        note.push_str(" x, downwind, to the right.");
    }
    if let Some(left_out) = left_out {
        note.push_str(&format!(" {left_out}"));
    }
    let style = TextStyle::new(10.0).colour(Colour::Muted);
    drawing.text((12.0, drawing.height - 8.0), &note, &style);
}
