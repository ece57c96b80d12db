//! Tower, RNA, foundation and surroundings as bodies in space that a script animates.

mod body;
mod foundation;
mod rna;
mod solids;
mod surroundings;

use towermodes::{PointMass, Tower, TowerDescription};

pub use body::{Body, Form, Substance};

use super::parts::Parts;
use crate::number::five_digits;
use solids::{ball, circle, link};

/// Half of the side of the blocks of soil, water and ground, as a fraction of the tower height.
const HALF_SIDE: f64 = 0.22;
/// Largest number of drawn masses; the heaviest are drawn.
const MOST_MASSES: usize = 40;
/// Largest number of drawn sets of wires.
const MOST_WIRES: usize = 12;
/// Radius of the lightest mass and the additional radius of the heaviest, as fractions of the
/// tower's height.
const MASS: [f64; 2] = [0.008, 0.012];
/// Heights or distances larger than this multiple of the tower height are not drawn.
const FAR: f64 = 4.0;

/// The bodies of a description, in the order ground, soil, foundation, wires, masses, RNA, water.
///
/// The forms are those of the drawing: RNA, platform and blades have no dimensions in a
/// description and are nominal.
pub(super) fn scene(description: &TowerDescription, tower: &Tower) -> Vec<Body> {
    let parts = Parts::new(description, tower);
    let mut bodies = surroundings::ground(&parts);
    bodies.extend(foundation::foundation(&parts));
    bodies.extend(wires(&parts));
    bodies.extend(masses(&parts));
    bodies.extend(rna::rna(&parts));
    bodies.extend(surroundings::water(&parts));
    let is_drawn = |body: &Body| body.points.iter().flatten().all(|value| value.is_finite());
    bodies.retain(is_drawn);
    bodies.iter_mut().for_each(round);
    bodies
}

/// The corners of the platform of a floating tower; none for other towers.
pub(super) fn hull(parts: &Parts<'_>) -> Vec<[f64; 3]> {
    let platform = parts.platform();
    platform.map_or_else(Vec::new, |platform| foundation::hull(parts, &platform))
}

/// Balls on the axis, larger for larger masses, the heaviest first.
fn masses(parts: &Parts<'_>) -> Vec<Body> {
    let mut masses: Vec<_> = parts.masses().collect();
    masses.sort_by(|a, b| b.0.mass_kg.total_cmp(&a.0.mass_kg));
    masses.truncate(MOST_MASSES);
    let ball_of = |(mass, share): (&PointMass, f64)| {
        let radius_m = (MASS[0] + MASS[1] * share) * parts.tower.height_m();
        ball(mass.height_m, [0.0, 0.0, mass.height_m], radius_m)
    };
    masses.into_iter().map(ball_of).collect()
}

/// Each set of wires, to anchors at equal angles around the tower.
fn wires(parts: &Parts<'_>) -> Vec<Body> {
    let ground_m = parts.wires_ground_m();
    let farthest_m = FAR * parts.tower.height_m();
    let mut bodies = Vec::new();
    for wires in parts.description.wires.iter().take(MOST_WIRES) {
        let down_m = wires.height_m - ground_m;
        let reach_m = down_m / wires.angle_deg.to_radians().tan();
        let drawn = (farthest_m / reach_m).min(1.0);
        for (x, y) in circle(wires.count.min(MOST_WIRES)) {
            let start = [0.0, 0.0, wires.height_m];
            let (reach_m, down_m) = (drawn * reach_m, drawn * down_m);
            let end = [x * reach_m, y * reach_m, wires.height_m - down_m];
            bodies.push(link(wires.height_m, Form::Line, [start, end]));
        }
    }
    bodies
}

/// Rounds to five significant digits, which are enough for a picture.
fn round(body: &mut Body) {
    let numbers = body.points.iter_mut().flatten();
    for value in numbers.chain(&mut body.radius_m).chain(&mut body.follows_m) {
        *value = five_digits(*value);
    }
}
