//! The rotor-nacelle assembly in space: the silhouette of the drawing with a depth, and blades of a
//! nominal length.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::solids::{ball, circle, solid};
use super::{Body, FAR, MASS, Substance};
use crate::figures::parts::{Parts, RnaForm};

/// Length of a blade as a fraction of the tower height above water or ground; for most turbines the
/// fraction is 0.6 to 0.8.
const BLADE: f64 = 0.6;
/// Number of blades if the input does not give it.
const USUAL_BLADES: usize = 3;
/// Range of the unit of length of the nacelle, as fractions of the tower height.
const UNIT: [f64; 2] = [0.012, 0.035];
/// Largest height of a nacelle as a fraction of the tower height.
const HIGHEST: f64 = 0.075;
/// Positions along a blade, and the distances of its edges from its axis there, as fractions of its
/// length.
const OUTLINE: [(f64, [f64; 2]); 4] = [
    (0.0, [-0.017, 0.017]),
    (0.2, [-0.02, 0.045]),
    (0.6, [-0.014, 0.028]),
    (1.0, [-0.004, 0.006]),
];

/// Nacelle, hub, blades and the centre of mass; nothing without an RNA.
pub(super) fn rna(parts: &Parts<'_>) -> Vec<Body> {
    let Some(rna) = parts.rna() else {
        return Vec::new();
    };
    let (top_m, height_m) = (parts.tower.top_m(), parts.tower.height_m());
    let unit_m = RnaForm::UNITS * parts.radius_m(top_m);
    let unit_m = unit_m.clamp(UNIT[0] * height_m, UNIT[1] * height_m);
    let form = RnaForm::new(unit_m, rna.center_m[2], HIGHEST * height_m);
    let mut bodies = vec![nacelle(&form, top_m), hub(&form, top_m)];
    let rotor = parts.description.rotor;
    let blades = rotor.map_or(USUAL_BLADES, |rotor| rotor.blades);
    let length_m = BLADE * (top_m - foot_m(parts));
    let turns = (0..blades).map(|k| TAU * k as f64 / blades as f64);
    bodies.extend(turns.map(|turn| blade(&form, top_m, (length_m, turn))));
    let [x, y, z] = rna.center_m;
    if rna.mass_kg > 0.0 && rna.center_m.iter().all(|c| c.abs() < FAR * height_m) {
        bodies.push(ball(top_m, [x, y, top_m + z], MASS[0] * height_m));
    }
    bodies
}

/// Height at which the tower leaves water or ground, m.
fn foot_m(parts: &Parts<'_>) -> f64 {
    let (base_m, top_m) = (parts.tower.base_m(), parts.tower.top_m());
    let surfaces = [parts.water_m(), parts.ground_m()];
    let foot_m = surfaces.into_iter().flatten().fold(base_m, f64::max);
    if foot_m < top_m { foot_m } else { base_m }
}

fn nacelle(form: &RnaForm, top_m: f64) -> Body {
    let half_m = 0.5 * form.height;
    let ends = [form.front, form.back];
    let corners = ends.into_iter().flat_map(|x| {
        let edge = |y: f64| [[x, y, top_m], [x, y, top_m + form.height]];
        [edge(-half_m), edge(half_m)].into_iter().flatten()
    });
    solid(Some(top_m), Substance::Rna, corners.collect())
}

/// Half an ellipsoid upwind of the nacelle.
fn hub(form: &RnaForm, top_m: f64) -> Body {
    let middle_m = top_m + 0.5 * form.height;
    let slices = (0..4).map(|k| FRAC_PI_2 * f64::from(k) / 3.0);
    let slice = |angle: f64| {
        let (x, radius) = (
            form.front - form.nose_length * angle.sin(),
            form.nose_radius * angle.cos(),
        );
        circle(12).map(move |(a, b)| [x, radius * a, middle_m + radius * b])
    };
    solid(
        Some(top_m),
        Substance::Rotor,
        slices.flat_map(slice).collect(),
    )
}

/// A blade rotated about the shaft by an angle; the first points up.
fn blade(form: &RnaForm, top_m: f64, (length_m, turn): (f64, f64)) -> Body {
    let middle_m = top_m + 0.5 * form.height;
    let (sin, cos) = turn.sin_cos();
    let place = |along: f64, across: f64| {
        [
            form.blades_at,
            along * sin + across * cos,
            middle_m + along * cos - across * sin,
        ]
    };
    let edges = OUTLINE
        .into_iter()
        .flat_map(|(share, edges)| edges.map(|edge| place(share * length_m, edge * length_m)));
    solid(Some(top_m), Substance::Rotor, edges.collect())
}
