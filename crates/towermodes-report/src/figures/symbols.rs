//! Symbols of engineering drawings: springs, hatching, water, centres of mass.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::svg::{Colour, Drawing, Stroke};

/// The stroke of a symbol.
fn ink() -> Stroke {
    Stroke::new(Colour::Ink, 1.1)
}

/// Draws a spring of this half width from one point to another.
pub(super) fn spring(drawing: &mut Drawing, from: (f64, f64), to: (f64, f64), half_width: f64) {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let length = dx.hypot(dy);
    if length < 1.0 {
        return;
    }
    let at = |share: f64, side: f64| {
        let across = side * half_width / length;
        (
            from.0 + share * dx - across * dy,
            from.1 + share * dy + across * dx,
        )
    };
    let turns = (length / 5.0).clamp(3.0, 9.0) as usize;
    let mut points = vec![at(0.0, 0.0), at(0.15, 0.0)];
    for turn in 0..turns {
        let side = if turn % 2 == 0 { 1.0 } else { -1.0 };
        points.push(at(0.15 + 0.7 * (turn as f64 + 0.5) / turns as f64, side));
    }
    points.extend([at(0.85, 0.0), at(1.0, 0.0)]);
    drawing.polyline(&points, &ink());
}

/// A rotational spring: a spiral that begins at a point and ends below it.
pub(super) fn spiral(drawing: &mut Drawing, center: (f64, f64), radius: f64) {
    let points: Vec<(f64, f64)> = (0..=40)
        .map(|k| {
            let share = f64::from(k) / 40.0;
            let angle = -PI + 2.25 * TAU * share - 1.5 * FRAC_PI_2 + FRAC_PI_2 * 0.5;
            let r = radius * share;
            (center.0 + r * angle.cos(), center.1 + r * angle.sin())
        })
        .collect();
    drawing.polyline(&points, &ink());
}

/// A rotation about a vertical axis: a part of an ellipse with an arrow.
pub(super) fn turn(drawing: &mut Drawing, center: (f64, f64), radius: f64) {
    let flat = 0.28 * radius;
    let at = |angle: f64| {
        (
            center.0 + radius * angle.cos(),
            center.1 + flat * angle.sin(),
        )
    };
    let points: Vec<(f64, f64)> = (0..=30)
        .map(|k| at(-0.35 * PI + 1.7 * PI * f64::from(k) / 30.0))
        .collect();
    drawing.polyline(&points, &ink());
    if let Some(&(x, y)) = points.last() {
        drawing.polygon(
            &[(x + 5.0, y - 3.0), (x - 3.0, y - 3.5), (x - 1.0, y + 3.5)],
            Colour::Ink,
            None,
        );
    }
}

/// A fixed support: a line with hatching below it.
pub(super) fn held_below(drawing: &mut Drawing, from_x: f64, to_x: f64, y: f64) {
    held(drawing, [(from_x, y), (to_x, y)], (-6.0, 7.0));
}

/// A fixed support on the left: a vertical line with hatching beside it.
pub(super) fn held_left(drawing: &mut Drawing, x: f64, from_y: f64, to_y: f64) {
    held(drawing, [(x, from_y), (x, to_y)], (-6.0, 5.0));
}

/// A line with short hatching strokes in a direction.
fn held(drawing: &mut Drawing, [from, to]: [(f64, f64); 2], (dx, dy): (f64, f64)) {
    drawing.line(from, to, &Stroke::new(Colour::Ink, 1.4));
    let fine = Stroke::new(Colour::Muted, 0.9);
    let length = (to.0 - from.0) + (to.1 - from.1);
    let strokes = (length / 6.0).clamp(1.0, 400.0) as usize;
    for k in 0..=strokes {
        let along = |a: f64, b: f64| a + (b - a) * k as f64 / strokes as f64;
        let (x, y) = (along(from.0, to.0), along(from.1, to.1));
        drawing.line((x, y), (x + dx, y + dy), &fine);
    }
}

/// A rigid link.
pub(super) fn rigid_link(drawing: &mut Drawing, from: (f64, f64), to: (f64, f64)) {
    drawing.line(from, to, &Stroke::new(Colour::Ink, 4.0));
}

/// The surface of water.
pub(super) fn waves(drawing: &mut Drawing, from_x: f64, to_x: f64, y: f64) {
    let steps = ((to_x - from_x) / 4.0).clamp(1.0, 400.0) as usize;
    let points: Vec<(f64, f64)> = (0..=steps)
        .map(|k| {
            let x = from_x + (to_x - from_x) * k as f64 / steps as f64;
            (x, y + 2.0 * (TAU * (x - from_x) / 32.0).sin())
        })
        .collect();
    drawing.polyline(&points, &Stroke::new(Colour::Series(0), 1.4));
}

/// Hatching of a rectangle, rising to the right or falling.
pub(super) fn hatching(
    drawing: &mut Drawing,
    name: &str,
    left_top: (f64, f64),
    size: (f64, f64),
    is_rising: bool,
) {
    let ((left, top), (width, height)) = (left_top, size);
    if !(width > 0.0 && height > 0.0) {
        return;
    }
    let fine = Stroke::new(Colour::Muted, 0.5);
    drawing.clipped(name, left_top, size, |drawing| {
        let strokes = ((width + height) / 12.0).clamp(1.0, 400.0) as usize;
        for k in 0..=strokes {
            let x = left - height + 12.0 * k as f64;
            let (low, high) = if is_rising {
                (top + height, top)
            } else {
                (top, top + height)
            };
            drawing.line((x, low), (x + height, high), &fine);
        }
    });
}

/// A centre of mass: a quartered disc.
pub(super) fn center_of_mass(drawing: &mut Drawing, center: (f64, f64), radius: f64) {
    let edge = Stroke::new(Colour::Ink, 1.2);
    drawing.disc(center, radius, Colour::Paper, Some(&edge));
    for quarter in [0.0, PI] {
        let mut sector = vec![center];
        sector.extend((0..=6).map(|k| {
            let angle = quarter + FRAC_PI_2 * f64::from(k) / 6.0;
            (
                center.0 + radius * angle.cos(),
                center.1 + radius * angle.sin(),
            )
        }));
        drawing.polygon(&sector, Colour::Ink, None);
    }
}
