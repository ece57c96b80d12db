//! The tube itself, with its walls, its masses and its axis.

use super::view::View;
use crate::figures::outline::{Shell, is_nominal, shells};
use crate::svg::{Colour, Dash, Drawing, Stroke};

/// The largest number of drawn shells, because more would be thinner than a pixel.
const MOST_SHELLS: usize = 1000;
/// Largest number of lines across the tower, because more would look like a grey area.
const MOST_BORDERS: usize = 80;

/// Draws the tower's wall from the base to the top.
pub(super) fn draw_body(drawing: &mut Drawing, view: &View<'_>) {
    let shells = few(&shells(view.parts.tower));
    let outside: Vec<(f64, f64, f64)> = shells
        .iter()
        .flat_map(|shell| ends(view, shell).map(|end| (end.y, end.outer, end.inner)))
        .collect();
    let surface = |pick: fn(&(f64, f64, f64)) -> f64| -> Vec<(f64, f64)> {
        let right = outside.iter().map(|end| (view.axis_x + pick(end), end.0));
        let left = outside.iter().map(|end| (view.axis_x - pick(end), end.0));
        right.chain(left.rev()).collect()
    };
    let edge = Stroke::new(Colour::Ink, 1.0);
    drawing.polygon(&surface(|end| end.1), Colour::Steel, Some(&edge));
    if !is_nominal(view.parts.tower) {
        draw_inside(drawing, view, &surface(|end| end.2));
        draw_borders(drawing, view, &shells);
    }
    let axis = Stroke::new(Colour::Muted, 0.7).dashed(Dash::DashDot);
    let x = view.axis_x;
    drawing.line((x, view.base()), (x, view.top()), &axis);
}

/// Draws the inside of the wall, with the water of a flooded tower.
fn draw_inside(drawing: &mut Drawing, view: &View<'_>, inner: &[(f64, f64)]) {
    drawing.polygon(inner, Colour::Paper, None);
    let water = view.parts.description.water;
    if let Some(water) = water.filter(|water| water.flooded) {
        let level = view.y(water.level_m);
        let (left, right) = (view.frame.left, view.frame.right);
        let size = (right - left, (view.frame.bottom - level).max(0.0));
        drawing.clipped("flooded", (left, level), size, |drawing| {
            drawing.polygon(inner, Colour::Water, None);
        });
    }
    let fine = Stroke::new(Colour::Ink, 0.6);
    let (right, left) = inner.split_at(inner.len() / 2);
    drawing.polyline(right, &fine);
    drawing.polyline(left, &fine);
}

/// Lines across the tower where shells meet at a station.
fn draw_borders(drawing: &mut Drawing, view: &View<'_>, shells: &[Shell]) {
    if shells.len() > MOST_BORDERS {
        return;
    }
    let fine = Stroke::new(Colour::Ink, 0.6);
    let stations_m = view.parts.tower.station_heights_m();
    for pair in shells.windows(2) {
        // Soil and water divide shells at other heights too.
        if !stations_m.contains(&pair[0].top_m) {
            continue;
        }
        let radius = view.radius(pair[0].outer_m[1].max(pair[1].outer_m[0]));
        let y = view.y(pair[0].top_m);
        drawing.line((view.axis_x - radius, y), (view.axis_x + radius, y), &fine);
    }
}

/// Draws the point masses on the tower axis, larger masses with a larger radius.
pub(super) fn draw_masses(drawing: &mut Drawing, view: &View<'_>) {
    let edge = Stroke::new(Colour::Paper, 0.8);
    let are_apart = view.parts.description.point_masses.len() <= MOST_BORDERS;
    for (mass, share) in view.parts.masses() {
        let center = (view.axis_x, view.y(mass.height_m));
        match are_apart {
            true => drawing.disc(center, 3.0 + 3.5 * share, Colour::Rna, Some(&edge)),
            false => drawing.disc(center, 1.0 + 3.0 * share, Colour::Rna, None),
        }
    }
}

/// An end of a shell on the sheet.
struct End {
    y: f64,
    outer: f64,
    inner: f64,
}

fn ends(view: &View<'_>, shell: &Shell) -> [End; 2] {
    let end = |index: usize, height_m: f64| {
        let outer_m = shell.outer_m[index];
        let outer = view.radius(outer_m);
        let wall = shell.wall_m.map_or(outer, |wall_m| {
            let is_solid = 2.0 * wall_m[index] >= outer_m;
            if is_solid {
                outer
            } else {
                view.wall(wall_m[index], outer_m)
            }
        });
        End {
            y: view.y(height_m),
            outer,
            inner: outer - wall,
        }
    };
    [end(0, shell.base_m), end(1, shell.top_m)]
}

/// At most [`MOST_SHELLS`] shells that cover the same height; each represents its neighbours above
/// it.
fn few(shells: &[Shell]) -> Vec<Shell> {
    let step = shells.len().div_ceil(MOST_SHELLS).max(1);
    let of_group = |group: &[Shell]| {
        let (first, last) = (group[0], group[group.len() - 1]);
        Shell {
            base_m: first.base_m,
            top_m: last.top_m,
            outer_m: [first.outer_m[0], last.outer_m[1]],
            wall_m: first
                .wall_m
                .zip(last.wall_m)
                .map(|(base, top)| [base[0], top[1]]),
        }
    };
    shells.chunks(step).map(of_group).collect()
}
