//! Blocks, rings and balls.

use std::f64::consts::TAU;

use super::body::{Body, Form, Substance};

/// Number of corners that represent a circle.
const CORNERS: usize = 24;

/// A block around the tower axis that does not move, from one height to another, with the half side
/// `half_m`.
pub(super) fn block(of: Substance, half_m: f64, [low_m, high_m]: [f64; 2]) -> Body {
    let sides = [-half_m, half_m];
    let corners = sides.into_iter().flat_map(|x| sides.map(|y| (x, y)));
    let corner = |(x, y): (f64, f64)| [[x, y, low_m], [x, y, high_m]];
    solid(None, of, corners.flat_map(corner).collect())
}

/// The smallest convex body around points.
pub(super) fn solid(follows_m: Option<f64>, of: Substance, points: Vec<[f64; 3]>) -> Body {
    Body {
        follows_m,
        of,
        form: Form::Solid,
        points,
        radius_m: None,
    }
}

/// A ring of points around the tower's axis at a height.
pub(super) fn ring(radius_m: f64, height_m: f64) -> impl Iterator<Item = [f64; 3]> {
    circle(CORNERS).map(move |(a, b)| [radius_m * a, radius_m * b, height_m])
}

/// Points of the unit circle at equal angles, the first on the x axis.
pub(super) fn circle(corners: usize) -> impl Iterator<Item = (f64, f64)> {
    let angle = move |k: usize| TAU * k as f64 / corners as f64;
    (0..corners).map(move |k| (angle(k).cos(), angle(k).sin()))
}

/// A point mass that moves with the tower axis at a height.
pub(super) fn ball(follows_m: f64, center: [f64; 3], radius_m: f64) -> Body {
    Body {
        follows_m: Some(follows_m),
        of: Substance::Mass,
        form: Form::Ball,
        points: vec![center],
        radius_m: Some(radius_m),
    }
}

/// A link from a point that moves with the tower axis at a height to a point that does not move.
pub(super) fn link(follows_m: f64, form: Form, ends: [[f64; 3]; 2]) -> Body {
    Body {
        follows_m: Some(follows_m),
        of: Substance::Link,
        form,
        points: ends.to_vec(),
        radius_m: None,
    }
}
