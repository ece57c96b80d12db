//! Soil and water around the tower.

use towermodes::tower::Piece;
use towermodes::{Tower, TowerDescription};

use super::callouts::{Callout, Subject};
use super::platform::{platform, surface_m};
use super::view::View;
use crate::figures::outline::outer_diameter_m;
use crate::figures::symbols::{hatching, held_below, held_left, spring, waves};
use crate::number::{length, short, stiffness};
use crate::svg::{Colour, Drawing, Stroke};

/// The width of the bar of the largest soil stiffness.
const WIDEST_BAR: f64 = 80.0;
/// From the tower to the fixed ends of the springs.
const SPRING: f64 = 34.0;
/// From the lowest of them to the base.
const BASE: f64 = 15.0;
/// From spring to spring.
const SPRING_GAP: f64 = 22.0;
/// The largest number of hatched layers of soil.
const MOST_LAYERS: usize = 12;

/// The height of the ground around the tower, m, if there is any: the seabed, or the surface of the
/// soil.
pub(in crate::figures) fn ground_m(description: &TowerDescription, tower: &Tower) -> Option<f64> {
    let water = description.water;
    let bed_m = water.map(|water| water.bed_m.unwrap_or(tower.base_m()));
    let surfaces = description.soil.iter().filter_map(|rows| rows.last());
    let surface_m = surfaces.map(|row| row.height_m).reduce(f64::max);
    match (bed_m, surface_m) {
        (Some(bed_m), Some(surface_m)) => Some(bed_m.max(surface_m)),
        (bed_m, surface_m) => bed_m.or(surface_m),
    }
}

/// The height of the water surface, m: around the tower or its floating platform.
pub(in crate::figures) fn water_m(description: &TowerDescription) -> Option<f64> {
    let around_m = description.water.map(|water| water.level_m);
    around_m.or_else(|| platform(description).and_then(surface_m))
}

/// Draws water and ground, behind everything else.
pub(super) fn draw_water_and_ground(
    drawing: &mut Drawing,
    view: &View,
    description: &TowerDescription,
    tower: &Tower,
) {
    let frame = view.frame;
    let width = frame.right - frame.left;
    let within = |height_m: f64| view.y(height_m).clamp(frame.top, frame.bottom);
    let ground = ground_m(description, tower).map_or(frame.bottom, within);
    if let Some(water) = &description.water {
        let level = within(water.level_m);
        let size = (width, ground - level);
        drawing.rectangle((frame.left, level), size, Colour::Water, None);
        if view.shows(water.level_m) {
            waves(drawing, frame.left, frame.right, level);
        }
    }
    if ground < frame.bottom {
        let size = (width, frame.bottom - ground);
        drawing.rectangle((frame.left, ground), size, Colour::Soil, None);
        held_below(drawing, frame.left + 6.0, frame.right, ground);
    }
}

/// Draws the layers of soil: hatched with springs on the left, and on the right bars whose width is
/// proportional to the stiffness.
pub(super) fn draw_soil(
    drawing: &mut Drawing,
    view: &View,
    description: &TowerDescription,
    tower: &Tower,
) {
    let most = stiffest(tower).map_or(0.0, |(_, most)| most);
    if most <= 0.0 {
        return;
    }
    let frame = view.frame;
    let beside = beside(view, tower);
    let border = Stroke::new(Colour::Muted, 0.7);
    for (layer, rows) in description.soil.iter().enumerate().take(MOST_LAYERS) {
        let (Some(bottom), Some(top)) = (rows.first(), rows.last()) else {
            continue;
        };
        let within = |height_m: f64| view.y(height_m).clamp(frame.top, frame.bottom);
        let (top, bottom) = (within(top.height_m), within(bottom.height_m));
        let left_top = (frame.left, top + 8.0);
        let size = (
            view.axis_x - beside - SPRING - frame.left,
            bottom - top - 8.0,
        );
        let name = format!("layer{layer}");
        hatching(drawing, &name, left_top, size, layer % 2 == 0);
        drawing.line((frame.left, bottom), (frame.right, bottom), &border);
    }
    draw_bars(drawing, view, tower, most);
    draw_soil_springs(drawing, view, tower, most);
}

fn draw_bars(drawing: &mut Drawing, view: &View, tower: &Tower, most: f64) {
    let from = view.axis_x + beside(view, tower) + 4.0;
    let edge = Stroke::new(Colour::Ink, 0.9);
    let mut bar: Vec<(f64, f64)> = Vec::new();
    let draw = |drawing: &mut Drawing, bar: &mut Vec<(f64, f64)>| {
        if let [(_, first), .., (_, last)] = bar[..] {
            bar.extend([(from, last), (from, first)]);
            drawing.polygon(bar, Colour::Band, Some(&edge));
        }
        bar.clear();
    };
    for piece in tower.pieces() {
        let ends =
            [piece.base_m, piece.top_m].map(|height_m| (height_m, springs_at(piece, height_m)));
        if ends.iter().all(|(_, stiffness)| *stiffness == 0.0) {
            draw(drawing, &mut bar);
            continue;
        }
        let place = |(height_m, stiffness): (f64, f64)| {
            (from + WIDEST_BAR * stiffness / most, view.y(height_m))
        };
        bar.extend(ends.map(place));
    }
    draw(drawing, &mut bar);
}

fn draw_soil_springs(drawing: &mut Drawing, view: &View, tower: &Tower, most: f64) {
    let wall = view.axis_x - beside(view, tower) - SPRING;
    let is_held = |piece: &&Piece| {
        springs_at(piece, piece.base_m) > 0.0 || springs_at(piece, piece.top_m) > 0.0
    };
    let mut held = tower.pieces().iter().filter(is_held);
    let Some(first) = held.next() else { return };
    let last = held.next_back().unwrap_or(first);
    let top = view.y(last.top_m);
    // The base has springs of its own.
    let free = (view.y(tower.base_m()) - BASE).max(top + 2.0);
    let bottom = view.y(first.base_m).min(free);
    let count = ((bottom - top) / SPRING_GAP).clamp(1.0, 60.0) as usize;
    for k in 0..count {
        let y = top + (bottom - top) * (k as f64 + 0.5) / count as f64;
        let height_m = view.high_m - (y - view.frame.top) / view.per_m;
        let height_m = height_m.clamp(first.base_m, last.top_m);
        let there = springs_at(tower.piece_at(height_m), height_m);
        if there > 1e-6 * most {
            let radius = view.radius(outer_diameter_m(tower, height_m));
            spring(drawing, (view.axis_x - radius, y), (wall, y), 4.0);
        }
    }
    held_left(drawing, wall, top, bottom);
}

/// Half the largest width of the tower in the soil.
fn beside(view: &View, tower: &Tower) -> f64 {
    let in_soil = tower.pieces().iter().filter(|piece| {
        springs_at(piece, piece.base_m) > 0.0 || springs_at(piece, piece.top_m) > 0.0
    });
    let ends = in_soil.flat_map(|piece| [piece.base_m, piece.top_m]);
    let radii = ends.map(|height_m| view.radius(outer_diameter_m(tower, height_m)));
    radii.fold(0.0, f64::max)
}

/// The stiffer of the soil's springs in x and y at a height in a piece, N/m².
fn springs_at(piece: &Piece, height_m: f64) -> f64 {
    let springs = piece.section_at(height_m).soil;
    springs.x_n_per_m2.max(springs.y_n_per_m2)
}

/// The height of the largest soil stiffness, m, and its value in x or y, N/m².
fn stiffest(tower: &Tower) -> Option<(f64, f64)> {
    let pieces = tower.pieces().iter();
    let ends = pieces.flat_map(|piece| {
        [piece.base_m, piece.top_m].map(|height_m| (height_m, springs_at(piece, height_m)))
    });
    ends.max_by(|a, b| a.1.total_cmp(&b.1))
        .filter(|(_, stiffness)| *stiffness > 0.0)
}

/// The labels of soil and water.
pub(super) fn callouts(view: &View, description: &TowerDescription, tower: &Tower) -> Vec<Callout> {
    let mut callouts: Vec<Callout> = Vec::new();
    let mut whole = |at: (f64, f64), lines: Vec<String>| {
        callouts.push(Callout {
            at,
            lines,
            subject: Subject::Whole,
        });
    };
    let edge = view.frame.right;
    if let Some(water) = &description.water {
        if view.shows(water.level_m) {
            let flooded = if water.flooded { ", tower flooded" } else { "" };
            let text = format!("z = {} m: water level{flooded}", length(water.level_m));
            whole((edge, view.y(water.level_m)), vec![text]);
        }
        let bed_m = water.bed_m.unwrap_or(tower.base_m());
        if view.shows(bed_m) {
            whole(
                (edge, view.y(bed_m)),
                vec![format!("z = {} m: seabed", length(bed_m))],
            );
        }
    }
    if let Some((height_m, most)) = stiffest(tower) {
        let x = view.axis_x + beside(view, tower) + 4.0 + WIDEST_BAR;
        let text = format!("soil springs, largest {}", stiffness(most, "N/m²"));
        // A little inside the bar, as the base has its own label.
        whole((x, view.y(height_m) - 6.0), vec![text]);
    }
    if let Some((height_m, most)) = added_mass(description) {
        let radius = view.radius(outer_diameter_m(tower, height_m));
        let text = format!("added mass, largest {} kg/m", short(most, 4));
        whole((view.axis_x + radius, view.y(height_m)), vec![text]);
    }
    callouts
}

/// The height of the largest added mass of a table, m, and its value, kg/m.
fn added_mass(description: &TowerDescription) -> Option<(f64, f64)> {
    let rows = description.added_mass.iter().flatten();
    let most = rows.max_by(|a, b| a.mass_kg_per_m.total_cmp(&b.mass_kg_per_m))?;
    (most.mass_kg_per_m > 0.0).then_some((most.height_m, most.mass_kg_per_m))
}
