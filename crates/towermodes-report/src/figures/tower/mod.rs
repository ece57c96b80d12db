//! The tower as a drawing: heights to scale, diameters and wall thicknesses enlarged by stated
//! factors.

mod body;
mod callouts;
mod foundation;
mod layout;
mod numbers;
mod platform;
mod rna;
mod small;
mod stations;
mod substructure;
mod surroundings;
mod view;
mod wires;

pub(super) use small::{draw_small, levels, small_view};
pub(super) use view::View;

use towermodes::{Tower, TowerDescription};

use super::enlargement::factor;
use super::outline::is_nominal;
use super::parts::Parts;
use super::scour::Surface;
use crate::svg::{Colour, Drawing, Figure, TextStyle};
use body::{draw_body, draw_masses};
use callouts::{Callout, Column, draw_callouts};
use foundation::draw_foundation;
use layout::{TICKS, WIDTH, sheet};
use rna::draw_rna;
use surroundings::draw_water_and_ground;

/// A tower with RNA, foundation and surroundings, from its description.
///
/// Heights and lengths have the same scale. Diameters and wall thicknesses are enlarged by round
/// factors that the picture states. A tower given by a property table is drawn as wide as the steel
/// tube of the same bending stiffness with t = D/200, which is proportional to the fourth root of
/// EI. RNA and platform are nominal silhouettes with their centres of mass to scale.
pub fn tower(description: &TowerDescription, tower: &Tower) -> Figure {
    let given = description;
    let description = &given.with_ground_as_soil();
    let parts = Parts {
        given,
        surface: Surface::of(given),
        ..Parts::new(description, tower)
    };
    let (view, height) = sheet(parts);
    let mut drawing = Drawing::new(WIDTH, height);
    draw_scene(&mut drawing, &view);
    let column = Column {
        elbow_x: view.frame.right + 6.0,
        left: view.frame.right + 32.0,
        right: WIDTH - 6.0,
        range: [2.0, height - 24.0],
    };
    let left_out = draw_callouts(&mut drawing, &column, &callouts_of(&view));
    draw_note(&mut drawing, &view, left_out.text());
    let name = tower.name();
    let title = if name.is_empty() {
        "The tower".to_owned()
    } else {
        format!("The tower: {name}")
    };
    Figure {
        name: "tower".to_owned(),
        title,
        description: numbers::description(&parts),
        drawing,
        table: numbers::table(&parts),
    }
}

fn draw_scene(drawing: &mut Drawing, view: &View<'_>) {
    draw_water_and_ground(drawing, view);
    platform::draw_sea(drawing, view);
    view.draw_heights(drawing, TICKS);
    surroundings::draw_soil(drawing, view);
    wires::draw_wires(drawing, view);
    platform::draw_platform(drawing, view);
    draw_foundation(drawing, view);
    substructure::draw_substructure(drawing, view);
    draw_body(drawing, view);
    draw_masses(drawing, view);
    draw_rna(drawing, view, 1.0);
}

fn callouts_of(view: &View<'_>) -> Vec<Callout> {
    let mut callouts: Vec<Callout> = rna::callout(view).into_iter().collect();
    callouts.extend(foundation::callout(view));
    callouts.extend(platform::callouts(view));
    callouts.extend(substructure::callouts(view));
    callouts.extend(surroundings::callouts(view));
    callouts.extend(wires::callouts(view));
    callouts.extend(stations::mass_callouts(view));
    callouts.extend(stations::station_callouts(view));
    callouts
}

/// Writes which dimensions are to scale.
fn draw_note(drawing: &mut Drawing, view: &View<'_>, left_out: Option<String>) {
    let width = factor(view.diameter_factor);
    let mut note = if is_nominal(view.parts.tower) {
        format!(
            "Heights to scale. Width {width}: steel tube of the same EI, wall 1/200 of Ø (∝ fourth root of EI)."
        )
    } else {
        let wall = factor(view.wall_factor);
        format!("Heights to scale, diameters {width}, walls {wall}.")
    };
    if view.parts.rna().is_some() {
        note.push_str(" x, downwind, to the right.");
    }
    if let Some(left_out) = left_out {
        note.push_str(&format!(" {left_out}"));
    }
    let style = TextStyle::new(10.0).colour(Colour::Muted);
    drawing.text((12.0, drawing.height - 8.0), &note, &style);
}
