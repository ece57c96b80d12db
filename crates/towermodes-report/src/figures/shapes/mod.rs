//! The shapes of the modes beside the tower: a panel for each family, with a common axis of
//! heights.

mod curves;
mod layout;
mod numbers;
mod panels;
mod strip;

use towermodes::{Family, Mode, Solution, Tower, TowerDescription};

pub(crate) use curves::Part;

use super::enlargement::factor;
use super::outline::is_nominal;
use super::parts::Parts;
use crate::svg::{Colour, Drawing, Figure, TextStyle};
use layout::{WIDTH, column, rows, sheet_height, strips};
use panels::panels;
use strip::draw_strip;

/// The mode shapes of a tower over its height, by family, each normalised to its largest
/// deflection; torsion and yaw to their largest rotation.
///
/// At most six modes of a family are drawn. If all side-side modes equal the fore-aft ones, one
/// panel shows both. Coupled modes have a panel for each of x, y, z and the rotation about z that
/// takes part in them.
pub fn shapes(description: &TowerDescription, tower: &Tower, solution: &Solution) -> Figure {
    let panels = panels(solution);
    let column = column(tower);
    let rows = rows(&panels, column);
    let height = sheet_height(rows.len());
    let mut drawing = Drawing::new(WIDTH, height);
    let mut note = String::new();
    for (index, strip) in strips(&rows, height, column).iter().enumerate() {
        let view = draw_strip(&mut drawing, strip, Parts::new(description, tower), index);
        note = note_of(tower, (view.diameter_factor, view.wall_factor));
    }
    note.push_str(&left_out(solution));
    let style = TextStyle::new(10.0).colour(Colour::Muted);
    drawing.text((12.0, height - 8.0), &note, &style);
    Figure {
        name: "shapes".to_owned(),
        title: title(tower, solution),
        description: numbers::description(tower, solution),
        drawing,
        table: numbers::table(solution),
    }
}

fn title(tower: &Tower, solution: &Solution) -> String {
    let count = solution.modes.len();
    let modes = match count {
        1 => "Shape of the lowest mode".to_owned(),
        count => format!("Shapes of the lowest {count} modes"),
    };
    match tower.name() {
        "" => modes,
        name => format!("{modes}: {name}"),
    }
}

/// The note on the modes that no panel shows, because nearly only members of the substructure move
/// in them.
fn left_out(solution: &Solution) -> String {
    let local = |mode: &&Mode| mode.family == Family::Substructure;
    match solution.modes.iter().filter(local).count() {
        0 => String::new(),
        1 => " Not drawn: 1 local mode of the substructure.".to_owned(),
        count => format!(" Not drawn: {count} local modes of the substructure."),
    }
}

/// The note on the scales of the tower and on the dotted lines.
fn note_of(tower: &Tower, (diameters, walls): (f64, f64)) -> String {
    let tower_note = if is_nominal(tower) {
        format!(
            "Tower: heights to scale, width {} (\u{221d} fourth root of EI).",
            factor(diameters)
        )
    } else {
        format!(
            "Tower: heights to scale, diameters {}, walls {}.",
            factor(diameters),
            factor(walls)
        )
    };
    match tower.point_masses().len() {
        0 => tower_note,
        1..=strip::MOST_MASSES => format!("{tower_note} Dotted lines: point masses."),
        count => format!("{tower_note} {count} point masses, drawn on the tower only."),
    }
}
