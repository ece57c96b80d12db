//! The foundation in space: springs, a footing or a pile, a platform with its moorings.

use towermodes::{Buried, FoundationSprings, Support, Tower};

use super::solids::{ball, block, circle, link, ring, solid};
use super::{Body, FAR, Form, HALF_SIDE, MASS, Substance};
use crate::figures::lines::lines_at_rest;
use crate::figures::parts::{Parts, Platform};

/// Length of a spring and smallest thickness of a footing, as fractions of the tower height.
const SPRING: f64 = 0.08;
const FOOTING: f64 = 0.025;
/// Depth of the soil below a footing, as a fraction of the tower's height.
const HALF_SPACE: f64 = 0.12;
/// Largest depth of a drawn pile, as a fraction of the tower height.
const DEEPEST: f64 = 0.45;
/// Distance at which nominal moorings end, as a fraction of the tower height.
const ANCHORS: f64 = 0.45;

/// The bodies of a foundation; none for a clamped base.
pub(super) fn foundation(parts: &Parts<'_>) -> Vec<Body> {
    match (
        parts.given.foundation.support(),
        parts.platform(),
        parts.springs(),
    ) {
        (Support::Form(form), ..) => in_soil(parts.tower, form.buried()),
        (Support::Frame(_), ..) => transition_piece(parts).into_iter().collect(),
        (_, Some(platform), _) => floating(parts, &platform),
        (_, _, Some(given)) if !parts.tower.base().is_clamped() => springs(parts, &given),
        _ => Vec::new(),
    }
}

/// A plate at the base with a spring in each flexible direction.
fn springs(parts: &Parts<'_>, springs: &FoundationSprings) -> Vec<Body> {
    let tower = parts.tower;
    let (base_m, length_m) = (tower.base_m(), SPRING * tower.height_m());
    let radius_m = 1.2 * parts.radius_m(base_m);
    let half_m = 0.1 * length_m;
    let rims = ring(radius_m, base_m - half_m).chain(ring(radius_m, base_m + half_m));
    let mut bodies = vec![solid(Some(base_m), Substance::Foundation, rims.collect())];
    let gives_way = |stiffness: f64| stiffness.is_finite() && stiffness > 0.0;
    if gives_way(springs.lateral_n_per_m) {
        for (x, y) in circle(4) {
            let at = |r: f64| [x * r, y * r, base_m];
            let ends = [at(radius_m), at(radius_m + length_m)];
            bodies.push(link(base_m, Form::Spring, ends));
            bodies.push(post(ends[1], 0.3 * length_m));
        }
    }
    if gives_way(springs.vertical_n_per_m) {
        let ends = [[0.0, 0.0, base_m], [0.0, 0.0, base_m - length_m]];
        bodies.push(link(base_m, Form::Spring, ends));
        bodies.push(post(ends[1], 0.3 * length_m));
    }
    bodies
}

/// The fixed end of a spring.
fn post([x, y, z]: [f64; 3], half_m: f64) -> Body {
    let sides = [-half_m, half_m];
    let corners = sides.into_iter().flat_map(|a| {
        // Upright beside the tower, flat below it.
        sides.map(|b| match (x == 0.0, y == 0.0) {
            (true, true) => [a, b, z],
            _ if x.abs() > y.abs() => [x, a, z + b],
            _ => [a, y, z + b],
        })
    });
    solid(None, Substance::Ground, corners.collect())
}

/// A footing or a pile that moves with the base, and the soil under or around it.
fn in_soil(tower: &Tower, of: Buried) -> Vec<Body> {
    let (base_m, height_m) = (tower.base_m(), tower.height_m());
    let deepest_m = if of.is_deep { DEEPEST } else { HALF_SPACE } * height_m;
    let depth_m = of.depth_m.clamp(FOOTING * height_m, deepest_m);
    let [x_m, y_m] = of.half_m.map(|half_m| half_m.min(HALF_SIDE * height_m));
    let top_m = match of.surface_above_base_m() > 0.0 {
        true => base_m + depth_m,
        false => base_m,
    };
    let surface_m = match of.depth_m > 0.0 {
        true => top_m,
        false => base_m - depth_m,
    };
    let soil_m = [surface_m - HALF_SPACE * height_m - depth_m, surface_m];
    let outline = |height_m: f64| -> Vec<[f64; 3]> {
        match of.is_round {
            true => ring(x_m, height_m).collect(),
            false => [(-x_m, -y_m), (x_m, -y_m), (x_m, y_m), (-x_m, y_m)]
                .map(|(x, y)| [x, y, height_m])
                .to_vec(),
        }
    };
    let corners = [outline(top_m - depth_m), outline(top_m)].concat();
    vec![
        block(Substance::Soil, HALF_SIDE * height_m, soil_m),
        solid(Some(base_m), Substance::Foundation, corners),
    ]
}

/// Half of the width of a nominal hull, and the height of its shoulders, m.
fn hull_size_m(parts: &Parts<'_>, platform: &Platform<'_>) -> [f64; 2] {
    let (base_m, height_m) = (parts.tower.base_m(), parts.tower.height_m());
    let half_m = (1.5 * parts.radius_m(base_m)).clamp(0.03 * height_m, 0.1 * height_m);
    let down_m = (0.15 * (base_m - platform.keel_m())).min(0.1 * height_m);
    [half_m, base_m - down_m]
}

/// The corners of a nominal hull, because the input contains no shape.
pub(super) fn hull(parts: &Parts<'_>, platform: &Platform<'_>) -> Vec<[f64; 3]> {
    let base_m = parts.tower.base_m();
    let [half_m, shoulder_m] = hull_size_m(parts, platform);
    let rims = ring(parts.radius_m(base_m), base_m)
        .chain(ring(half_m, shoulder_m))
        .chain(ring(half_m, platform.keel_m()));
    rims.collect()
}

/// A nominal hull with its centre of mass and its moorings.
fn floating(parts: &Parts<'_>, platform: &Platform<'_>) -> Vec<Body> {
    let (base_m, height_m) = (parts.tower.base_m(), parts.tower.height_m());
    let corners = hull(parts, platform);
    let mut bodies = vec![solid(Some(base_m), Substance::Foundation, corners)];
    if platform
        .of
        .center_m
        .iter()
        .all(|c| c.abs() < FAR * height_m)
    {
        bodies.push(ball(base_m, platform.of.center_m, 1.5 * MASS[0] * height_m));
    }
    match lines_at_rest(platform.of) {
        Some(at_rest) => bodies.extend(at_rest.lines.into_iter().map(|line| Body {
            follows_m: line.is_on_platform.then_some(base_m),
            of: Substance::Link,
            form: Form::Line,
            points: line.places_m,
            radius_m: None,
        })),
        None if platform.is_moored() => bodies.extend(nominal_moorings(parts, platform)),
        None => {}
    }
    bodies
}

/// Three straight lines, because the input contains only a stiffness.
fn nominal_moorings(parts: &Parts<'_>, platform: &Platform<'_>) -> Vec<Body> {
    let (base_m, height_m) = (parts.tower.base_m(), parts.tower.height_m());
    let keel_m = platform.keel_m();
    let [half_m, shoulder_m] = hull_size_m(parts, platform);
    let fairlead_m = platform.of.mooring.height_m.clamp(keel_m, shoulder_m);
    let line = |(x, y): (f64, f64)| {
        let start = [x * half_m, y * half_m, fairlead_m];
        let reach_m = ANCHORS * height_m;
        let end = [x * reach_m, y * reach_m, keel_m - 0.1 * height_m];
        link(base_m, Form::Line, [start, end])
    };
    circle(3).map(line).collect()
}

/// The rigid transition piece of a frame, as the smallest body around its joints.
fn transition_piece(parts: &Parts<'_>) -> Option<Body> {
    let substructure = parts.substructure()?;
    let transition = substructure.description().transition.as_ref()?;
    let [x, y, _] = substructure.of.reference_m();
    let joints = transition.joints.iter();
    let joints = joints.map(|joint| substructure.description().joints[*joint].position_m);
    let corners = joints.chain([transition.position_m]);
    let corners: Vec<[f64; 3]> = corners.map(|[a, b, c]| [a - x, b - y, c]).collect();
    let base_m = parts.tower.base_m();
    (corners.len() > 3).then(|| solid(Some(base_m), Substance::Foundation, corners))
}
