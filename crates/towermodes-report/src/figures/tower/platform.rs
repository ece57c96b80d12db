//! A floating platform: a nominal hull, its centre of mass to scale, its moorings.

use towermodes::space::SpatialMatrix;
use towermodes::{FloatingPlatform, Foundation, Tower, TowerDescription};

use super::callouts::{Callout, Subject};
use super::view::View;
use crate::figures::outline::outer_diameter_m;
use crate::figures::symbols::{center_of_mass, waves};
use crate::number::{length, mass, stiffness};
use crate::svg::{Colour, Dash, Drawing, Stroke};

/// A platform whose centre is deeper below the base than this many heights of the tower is not
/// drawn whole.
const DEEPEST: f64 = 4.0;

/// The platform of a floating tower.
pub(in crate::figures) fn platform(description: &TowerDescription) -> Option<&FloatingPlatform> {
    match &description.foundation {
        Foundation::Floating(platform) => Some(platform),
        _ => None,
    }
}

/// The lowest height of the platform as it is drawn, m.
pub(in crate::figures) fn keel_m(platform: &FloatingPlatform, tower: &Tower) -> f64 {
    let (base_m, height_m) = (tower.base_m(), tower.height_m());
    let below = |depth_m: f64| depth_m.clamp(0.1 * height_m, DEEPEST * height_m);
    let of_center = below(base_m - platform.center_m[2]);
    let mut depth_m = of_center + (0.25 * of_center).min(0.2 * height_m);
    if let Some(surface_m) = surface_m(platform) {
        depth_m = depth_m.max(below(base_m - surface_m + 0.1 * height_m));
    }
    base_m - depth_m
}

/// The drawn water level, m: the reference height of the hydrostatic stiffness.
pub(in crate::figures) fn surface_m(platform: &FloatingPlatform) -> Option<f64> {
    let has_buoyancy = platform.hydrostatic.matrix != SpatialMatrix::default();
    has_buoyancy.then_some(platform.hydrostatic.height_m)
}

fn half_width(view: &View, tower: &Tower) -> f64 {
    let radius = view.radius(outer_diameter_m(tower, tower.base_m()));
    (1.5 * radius).clamp(18.0, 60.0)
}

/// Draws the water that the platform floats in, unless the description has water of its own.
pub(super) fn draw_sea(drawing: &mut Drawing, view: &View, description: &TowerDescription) {
    let surface_m = platform(description).and_then(surface_m);
    let Some(surface_m) = surface_m.filter(|_| description.water.is_none()) else {
        return;
    };
    if !view.shows(surface_m) {
        return;
    }
    let (frame, y) = (view.frame, view.y(surface_m));
    let size = (frame.right - frame.left, frame.bottom - y);
    drawing.rectangle((frame.left, y), size, Colour::Water, None);
    waves(drawing, frame.left, frame.right, y);
}

/// Draws the platform and its moorings.
pub(super) fn draw_platform(
    drawing: &mut Drawing,
    view: &View,
    tower: &Tower,
    platform: &FloatingPlatform,
) {
    let (base, keel) = (view.y(tower.base_m()), view.y(keel_m(platform, tower)));
    let half = half_width(view, tower);
    if platform.mooring.matrix != SpatialMatrix::default() {
        draw_moorings(drawing, view, platform, (base, keel, half));
    }
    draw_hull(drawing, view, tower, platform);
}

/// Draws the body alone.
pub(super) fn draw_hull(
    drawing: &mut Drawing,
    view: &View,
    tower: &Tower,
    platform: &FloatingPlatform,
) {
    let (base, keel) = (view.y(tower.base_m()), view.y(keel_m(platform, tower)));
    let radius = view.radius(outer_diameter_m(tower, tower.base_m()));
    let half = half_width(view, tower);
    let shoulder = base + (0.15 * (keel - base)).min(40.0);
    let x = view.axis_x;
    let body = [
        (x - radius, base),
        (x + radius, base),
        (x + half, shoulder),
        (x + half, keel),
        (x - half, keel),
        (x - half, shoulder),
    ];
    let edge = Stroke::new(Colour::Ink, 1.2).dashed(Dash::Dashed);
    drawing.polygon(&body, Colour::Steel, Some(&edge));
    let center = center(view, platform);
    if shows_center(view, platform) {
        if (center.0 - x).abs() > half || !(base..=keel).contains(&center.1) {
            let arm = Stroke::new(Colour::Ink, 1.0).dashed(Dash::Dashed);
            drawing.line((x, center.1.clamp(base, keel)), center, &arm);
        }
        center_of_mass(drawing, center, 7.0);
    }
}

fn center(view: &View, platform: &FloatingPlatform) -> (f64, f64) {
    let [x_m, _, z_m] = platform.center_m;
    (view.x(x_m), view.y(z_m))
}

fn shows_center(view: &View, platform: &FloatingPlatform) -> bool {
    let x = center(view, platform).0;
    view.shows(platform.center_m[2]) && (view.frame.left..=view.frame.right).contains(&x)
}

/// Lines that hang to both sides; where they end is not known.
fn draw_moorings(
    drawing: &mut Drawing,
    view: &View,
    platform: &FloatingPlatform,
    (base, keel, half): (f64, f64, f64),
) {
    let from = view
        .y(platform.mooring.height_m)
        .clamp(base + 0.3 * (keel - base), keel);
    let to = view.frame.bottom - 8.0;
    let line = Stroke::new(Colour::Muted, 1.3).dashed(Dash::Long);
    for (side, edge) in [
        (-1.0, view.frame.left + 12.0),
        (1.0, view.frame.right - 12.0),
    ] {
        let start = view.axis_x + side * half;
        let points: Vec<(f64, f64)> = (0..=24)
            .map(|k| {
                let share = f64::from(k) / 24.0;
                let drop = 1.0 - (1.0 - share) * (1.0 - share);
                (start + share * (edge - start), from + drop * (to - from))
            })
            .collect();
        drawing.polyline(&points, &line);
        let anchor = [
            (edge - 5.0, to + 5.0),
            (edge + 5.0, to + 5.0),
            (edge, to - 4.0),
        ];
        drawing.polygon(&anchor, Colour::Ink, None);
    }
}

/// The labels of the platform, its moorings and the water surface.
pub(super) fn callouts(view: &View, tower: &Tower, description: &TowerDescription) -> Vec<Callout> {
    let Some(platform) = platform(description) else {
        return Vec::new();
    };
    let whole = |(at, lines): ((f64, f64), Vec<String>)| Callout {
        at,
        lines,
        subject: Subject::Whole,
    };
    let has_water = description.water.is_some();
    let texts = [
        Some(hull_text(view, tower, platform)),
        mooring_text(view, platform),
        surface_text(view, platform).filter(|_| !has_water),
    ];
    texts.into_iter().flatten().map(whole).collect()
}

fn hull_text(view: &View, tower: &Tower, platform: &FloatingPlatform) -> ((f64, f64), Vec<String>) {
    let [x, y, z] = platform.center_m.map(length);
    let beyond = match shows_center(view, platform) {
        true => "",
        false => " (not drawn)",
    };
    let (base, keel) = (view.y(tower.base_m()), view.y(keel_m(platform, tower)));
    let center = view.y(platform.center_m[2]).clamp(base, keel);
    let lines = vec![
        format!(
            "floating platform {}, shape unknown",
            mass(platform.mass_kg)
        ),
        format!("centre of mass ({x}, {y}) m from the axis, z = {z} m{beyond}"),
    ];
    ((view.axis_x + half_width(view, tower), center), lines)
}

fn mooring_text(view: &View, platform: &FloatingPlatform) -> Option<((f64, f64), Vec<String>)> {
    let mooring = &platform.mooring.matrix;
    let value = |i: usize| stiffness(mooring[i][i], "").trim_end().to_owned();
    let lines = || {
        vec![
            "mooring stiffness in x, y, z:".to_owned(),
            format!("{}, {}, {} N/m", value(0), value(1), value(2)),
        ]
    };
    let at = (view.frame.right - 40.0, view.frame.bottom - 14.0);
    (*mooring != SpatialMatrix::default()).then(|| (at, lines()))
}

fn surface_text(view: &View, platform: &FloatingPlatform) -> Option<((f64, f64), Vec<String>)> {
    let surface_m = surface_m(platform).filter(|surface_m| view.shows(*surface_m))?;
    let z = length(surface_m);
    let text = format!("z = {z} m: reference of the hydrostatic stiffness");
    Some(((view.frame.right, view.y(surface_m)), vec![text]))
}
