//! Soil and water around the tower.

use towermodes::tower::Piece;
use towermodes::{GroundLayer, TowerDescription};

use super::callouts::Callout;
use super::view::View;
use crate::figures::scour::Hole;
use crate::figures::symbols::{hatching, held_below, held_left, spring, waves};
use crate::number::{length, short, stiffness};
use crate::svg::{Colour, Dash, Drawing, Stroke};

/// The width of the bar of the largest soil stiffness.
const WIDEST_BAR: f64 = 80.0;
/// Distance from the tower to the fixed ends of the springs.
const SPRING: f64 = 34.0;
/// Distance from the lowest spring to the base.
const BASE: f64 = 15.0;
/// Distance between springs.
const SPRING_GAP: f64 = 22.0;
/// The largest number of hatched layers of soil.
const MOST_LAYERS: usize = 12;

/// Draws water and ground, behind everything else.
pub(super) fn draw_water_and_ground(drawing: &mut Drawing, view: &View<'_>) {
    let frame = view.frame;
    let within = |height_m: f64| view.y(height_m).clamp(frame.top, frame.bottom);
    let ground = view.parts.ground_m().map_or(frame.bottom, within);
    let hole = view.parts.hole().filter(|_| ground < frame.bottom);
    let floor = hole.map_or(ground, |hole| within(hole.bottom_m));
    let around_m = view.parts.description.water.map(|water| water.level_m);
    if let Some(level_m) = around_m.or_else(|| view.parts.substructure()?.water_m()) {
        let level = within(level_m);
        let size = (frame.right - frame.left, floor - level);
        drawing.rectangle((frame.left, level), size, Colour::Water, None);
        if view.shows(level_m) {
            waves(drawing, frame.left, frame.right, level);
        }
    }
    if ground < frame.bottom {
        view.fill_below(drawing, floor, Colour::Soil);
        match hole {
            Some(hole) => draw_hole(drawing, view, &hole, [ground, floor]),
            None => held_below(drawing, frame.left + 6.0, frame.right, ground),
        }
    }
    draw_original(drawing, view);
}

/// Draws the soil beside a hole, whose sides begin at the pile, and the ground around it.
fn draw_hole(drawing: &mut Drawing, view: &View<'_>, hole: &Hole, [ground, floor]: [f64; 2]) {
    let frame = view.frame;
    let radius = view.radius_at(hole.bottom_m);
    let reach = radius + hole.beside_m(hole.top_m) * view.per_m;
    let edge = Stroke::new(Colour::Ink, 1.4);
    for (side, end) in [(-1.0, frame.left), (1.0, frame.right)] {
        let at = |distance: f64| (view.axis_x + side * distance).clamp(frame.left, frame.right);
        let (rim, foot) = ((at(reach), ground), (at(radius), floor));
        let soil = [(end, ground), rim, foot, (end, floor)];
        drawing.polygon(&soil, Colour::Soil, None);
        drawing.line(rim, foot, &edge);
        let (from, to) = match side < 0.0 {
            true => (end + 6.0, rim.0),
            false => (rim.0, end),
        };
        if from < to {
            held_below(drawing, from, to, ground);
        }
    }
}

/// Draws the level before scour, dashed.
fn draw_original(drawing: &mut Drawing, view: &View<'_>) {
    let levels = view.parts.scoured_levels();
    let original_m = levels.first().map(|(height_m, _)| *height_m);
    if let Some(height_m) = original_m.filter(|height_m| view.shows(*height_m)) {
        let y = view.y(height_m);
        let dashed = Stroke::new(Colour::Muted, 1.0).dashed(Dash::Dashed);
        drawing.line((view.frame.left, y), (view.frame.right, y), &dashed);
    }
}

/// Draws the layers of soil: hatched with springs on the left, and on the right bars whose width is
/// proportional to the stiffness.
pub(super) fn draw_soil(drawing: &mut Drawing, view: &View<'_>) {
    let most = stiffest(view).map_or(0.0, |(_, most)| most);
    if most <= 0.0 {
        return;
    }
    let frame = view.frame;
    let beside = beside(view);
    let border = Stroke::new(Colour::Muted, 0.7);
    for (layer, rows) in view
        .parts
        .description
        .soil
        .iter()
        .enumerate()
        .take(MOST_LAYERS)
    {
        let (Some(bottom), Some(top)) = (rows.first(), rows.last()) else {
            continue;
        };
        let within = |height_m: f64| view.y(height_m).clamp(frame.top, frame.bottom);
        let lowest_m = bottom.height_m;
        let (top, bottom) = (within(top.height_m), within(lowest_m));
        let left_top = (frame.left, top + 8.0);
        let size = (
            view.axis_x - beside - SPRING - frame.left,
            bottom - top - 8.0,
        );
        let name = format!("layer{layer}");
        hatching(drawing, &name, left_top, size, layer % 2 == 0);
        // The soil goes on below the tip of a pile.
        if view.parts.tower.base_m() < lowest_m {
            drawing.line((frame.left, bottom), (frame.right, bottom), &border);
        }
    }
    draw_bars(drawing, view, most);
    draw_soil_springs(drawing, view, most);
}

fn draw_bars(drawing: &mut Drawing, view: &View<'_>, most: f64) {
    let from = view.axis_x + beside(view) + 4.0;
    let edge = Stroke::new(Colour::Ink, 0.9);
    let mut bar: Vec<(f64, f64)> = Vec::new();
    let draw = |drawing: &mut Drawing, bar: &mut Vec<(f64, f64)>| {
        if let [(_, first), .., (_, last)] = bar[..] {
            bar.extend([(from, last), (from, first)]);
            drawing.polygon(bar, Colour::Band, Some(&edge));
        }
        bar.clear();
    };
    for piece in view.parts.tower.pieces() {
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

fn draw_soil_springs(drawing: &mut Drawing, view: &View<'_>, most: f64) {
    let wall = view.axis_x - beside(view) - SPRING;
    let tower = view.parts.tower;
    let mut held = tower.pieces().iter().filter(|piece| is_held(piece));
    let Some(first) = held.next() else { return };
    let last = held.next_back().unwrap_or(first);
    let top = view.y(last.top_m);
    // The base has springs of its own.
    let free = (view.base() - BASE).max(top + 2.0);
    let bottom = view.y(first.base_m).min(free);
    let count = ((bottom - top) / SPRING_GAP).clamp(1.0, 60.0) as usize;
    for k in 0..count {
        let y = top + (bottom - top) * (k as f64 + 0.5) / count as f64;
        let height_m = view.high_m - (y - view.frame.top) / view.per_m;
        let height_m = height_m.clamp(first.base_m, last.top_m);
        let there = springs_at(tower.piece_at(height_m), height_m);
        if there > 1e-6 * most {
            let radius = view.radius_at(height_m);
            spring(drawing, (view.axis_x - radius, y), (wall, y), 4.0);
        }
    }
    held_left(drawing, wall, top, bottom);
}

/// Half of the largest width of the tower in the soil.
fn beside(view: &View<'_>) -> f64 {
    let in_soil = view
        .parts
        .tower
        .pieces()
        .iter()
        .filter(|piece| is_held(piece));
    let ends = in_soil.flat_map(|piece| [piece.base_m, piece.top_m]);
    ends.map(|height_m| view.radius_at(height_m))
        .fold(0.0, f64::max)
}

/// Whether a piece has soil springs.
fn is_held(piece: &Piece) -> bool {
    springs_at(piece, piece.base_m) > 0.0 || springs_at(piece, piece.top_m) > 0.0
}

/// The stiffer of the soil's springs in x and y at a height in a piece, N/m².
fn springs_at(piece: &Piece, height_m: f64) -> f64 {
    let springs = piece.section_at(height_m).soil;
    springs.x_n_per_m2.max(springs.y_n_per_m2)
}

/// The height of the largest soil stiffness, m, and its value in x or y, N/m².
fn stiffest(view: &View<'_>) -> Option<(f64, f64)> {
    let pieces = view.parts.tower.pieces().iter();
    let ends = pieces.flat_map(|piece| {
        [piece.base_m, piece.top_m].map(|height_m| (height_m, springs_at(piece, height_m)))
    });
    ends.max_by(|a, b| a.1.total_cmp(&b.1))
        .filter(|(_, stiffness)| *stiffness > 0.0)
}

/// The labels of soil and water.
pub(super) fn callouts(view: &View<'_>) -> Vec<Callout> {
    let description = view.parts.description;
    let level = |height_m: f64, name: String| {
        let text = format!("z = {} m: {name}", length(height_m));
        let at = (view.frame.right, view.y(height_m));
        view.shows(height_m).then(|| Callout::whole(at, vec![text]))
    };
    let scoured = view.parts.scoured_levels();
    let water = description.water.iter().flat_map(|water| {
        let flooded = if water.flooded { ", tower flooded" } else { "" };
        let bed_m = view.parts.bed_m(water);
        let surface = level(water.level_m, format!("water level{flooded}"));
        let bed = scoured
            .is_empty()
            .then(|| level(bed_m, "seabed".to_owned()));
        [surface, bed.flatten()]
    });
    let beds = scoured
        .iter()
        .map(|(height_m, name)| level(*height_m, name.clone()));
    let soil = stiffest(view).map(|(height_m, most)| {
        let x = view.axis_x + beside(view) + 4.0 + WIDEST_BAR;
        let text = format!("soil springs, largest {}", stiffness(most, "N/m²"));
        // A little inside the bar, as the base has its own label.
        Callout::whole((x, view.y(height_m) - 6.0), vec![text])
    });
    let added = added_mass(description).map(|(height_m, most)| {
        let text = format!("added mass, largest {} kg/m", short(most, 4));
        Callout::whole(view.on_shell(height_m), vec![text])
    });
    let levels = water.chain(beds).flatten();
    let layers = layers(view).into_iter();
    levels.chain(layers).chain(soil).chain(added).collect()
}

/// The name and the range of each layer of soil around the pile, at its middle.
fn layers(view: &View<'_>) -> Vec<Callout> {
    let (given, tower) = (view.parts.given, view.parts.tower);
    let Some(ground) = &given.ground else {
        return Vec::new();
    };
    let surface_m = tower.ground_surface_m().unwrap_or(ground.surface_m);
    let layers = ground.layers.iter().enumerate().take(MOST_LAYERS);
    let callout = |(index, layer): (usize, &GroundLayer)| {
        let top_m = layer.top_m.min(surface_m);
        let bottom_m = layer.bottom_m.max(tower.base_m());
        let middle_m = 0.5 * (top_m + bottom_m);
        let name = given.part_names.ground.get(index);
        let name = name.map(|name| name.trim()).filter(|name| !name.is_empty());
        let name = name.map_or_else(|| format!("layer {}", index + 1), str::to_owned);
        let [top, bottom] = [layer.top_m, layer.bottom_m].map(length);
        let text = format!("{name} ({}), z = {top} to {bottom} m", layer.soil.noun());
        let at = (view.frame.right, view.y(middle_m));
        (bottom_m < top_m && view.shows(middle_m)).then(|| Callout::whole(at, vec![text]))
    };
    layers.filter_map(callout).collect()
}

/// The height of the largest added mass of a table, m, and its value, kg/m.
fn added_mass(description: &TowerDescription) -> Option<(f64, f64)> {
    let rows = description.added_mass.iter().flatten();
    let most = rows.max_by(|a, b| a.mass_kg_per_m.total_cmp(&b.mass_kg_per_m))?;
    (most.mass_kg_per_m > 0.0).then_some((most.height_m, most.mass_kg_per_m))
}
