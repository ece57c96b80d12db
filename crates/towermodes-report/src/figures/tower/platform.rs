//! A floating platform: a nominal hull, its centre of mass to scale, its moorings.

use super::callouts::Callout;
use super::view::View;
use crate::figures::lines::{LinesAtRest, lines_at_rest};
use crate::figures::parts::Platform;
use crate::figures::symbols::{center_of_mass, waves};
use crate::number::{length, mass, stiffness};
use crate::svg::{Colour, Dash, Drawing, Stroke};
use crate::wording::counted;

fn half_width(view: &View<'_>) -> f64 {
    let radius = view.radius_at(view.parts.tower.base_m());
    (1.5 * radius).clamp(18.0, 60.0)
}

/// Draws the water in which the platform floats, unless the description contains water itself.
pub(super) fn draw_sea(drawing: &mut Drawing, view: &View<'_>) {
    if view.parts.description.water.is_some() {
        return;
    }
    let platform = view.parts.platform();
    if let Some(surface_m) = platform
        .and_then(|platform| platform.surface_m())
        .filter(|height_m| view.shows(*height_m))
    {
        let y = view.y(surface_m);
        view.fill_below(drawing, y, Colour::Water);
        waves(drawing, view.frame.left, view.frame.right, y);
    }
}

/// Draws the platform and its moorings, if there is one.
pub(super) fn draw_platform(drawing: &mut Drawing, view: &View<'_>) {
    if let Some(platform) = view.parts.platform() {
        match lines_at_rest(platform.of) {
            Some(at_rest) => draw_lines(drawing, view, &at_rest),
            None if platform.is_moored() => draw_moorings(drawing, view, &platform),
            None => {}
        }
        draw_hull(drawing, view);
    }
}

/// Draws the hull.
pub(super) fn draw_hull(drawing: &mut Drawing, view: &View<'_>) {
    let Some(platform) = view.parts.platform() else {
        return;
    };
    let (base, keel) = (view.base(), view.y(platform.keel_m()));
    let radius = view.radius_at(view.parts.tower.base_m());
    let half = half_width(view);
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
    let center = center(view, &platform);
    if shows_center(view, &platform) {
        if (center.0 - x).abs() > half || !(base..=keel).contains(&center.1) {
            let arm = Stroke::new(Colour::Ink, 1.0).dashed(Dash::Dashed);
            drawing.line((x, center.1.clamp(base, keel)), center, &arm);
        }
        center_of_mass(drawing, center, 7.0);
    }
}

fn center(view: &View<'_>, platform: &Platform<'_>) -> (f64, f64) {
    let [x_m, _, z_m] = platform.of.center_m;
    (view.x(x_m), view.y(z_m))
}

fn shows_center(view: &View<'_>, platform: &Platform<'_>) -> bool {
    let x = center(view, platform).0;
    view.shows(platform.of.center_m[2]) && (view.frame.left..=view.frame.right).contains(&x)
}

/// Draws the shapes of mooring lines at rest, as far as they are on the sheet.
fn draw_lines(drawing: &mut Drawing, view: &View<'_>, at_rest: &LinesAtRest<'_>) {
    let stroke = Stroke::new(Colour::Ink, 1.2);
    drawing.clipped(
        "lines",
        view.frame.left_top(),
        view.frame.size(),
        |drawing| {
            for line in &at_rest.lines {
                let places = line.places_m.iter();
                let places: Vec<(f64, f64)> =
                    places.map(|[x, _, z]| (view.x(*x), view.y(*z))).collect();
                drawing.polyline(&places, &stroke);
                if let (true, Some(fairlead)) = (line.is_on_platform, places.first()) {
                    // The hull is nominal: it may not reach the fairlead.
                    let arm = Stroke::new(Colour::Muted, 0.8).dashed(Dash::Dashed);
                    drawing.line(*fairlead, (view.axis_x, fairlead.1), &arm);
                }
            }
        },
    );
}

/// Draws suspended lines to both sides; their anchors are unknown.
fn draw_moorings(drawing: &mut Drawing, view: &View<'_>, platform: &Platform<'_>) {
    let (base, keel) = (view.base(), view.y(platform.keel_m()));
    let half = half_width(view);
    let fairlead = view.y(platform.of.mooring.height_m);
    let from = fairlead.clamp(base + 0.3 * (keel - base), keel);
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
pub(super) fn callouts(view: &View<'_>) -> Vec<Callout> {
    let Some(platform) = view.parts.platform() else {
        return Vec::new();
    };
    let has_water = view.parts.description.water.is_some();
    let texts = [
        Some(hull_text(view, &platform)),
        platform.is_moored().then(|| mooring_text(view, &platform)),
        surface_text(view, &platform).filter(|_| !has_water),
    ];
    texts.into_iter().flatten().collect()
}

fn hull_text(view: &View<'_>, platform: &Platform<'_>) -> Callout {
    let [x, y, z] = platform.of.center_m.map(length);
    let beyond = match shows_center(view, platform) {
        true => "",
        false => " (not drawn)",
    };
    let (base, keel) = (view.base(), view.y(platform.keel_m()));
    let center = view.y(platform.of.center_m[2]).clamp(base, keel);
    let mass = mass(platform.of.mass_kg);
    let lines = vec![
        format!("floating platform {mass}, shape unknown"),
        format!("centre of mass ({x}, {y}) m from the axis, z = {z} m{beyond}"),
    ];
    Callout::whole((view.axis_x + half_width(view), center), lines)
}

fn mooring_text(view: &View<'_>, platform: &Platform<'_>) -> Callout {
    let at_rest = lines_at_rest(platform.of);
    let mut mooring = platform.of.mooring.matrix;
    let mut lines = vec!["mooring stiffness in x, y, z:".to_owned()];
    if let Some(at_rest) = &at_rest {
        let of_lines = &at_rest.state.load.stiffness;
        let entries = mooring.as_flattened_mut().iter_mut();
        let sums = entries.zip(of_lines.as_flattened());
        sums.for_each(|(sum, own)| *sum += own);
        let count = counted(at_rest.lines.len(), "mooring line");
        lines[0] = format!("{count}, stiffness in x, y, z:");
    }
    let value = |i: usize| stiffness(mooring[i][i], "").trim_end().to_owned();
    lines.push(format!("{}, {}, {} N/m", value(0), value(1), value(2)));
    let at = match at_rest {
        Some(_) => (view.axis_x + half_width(view), view.frame.bottom - 14.0),
        None => (view.frame.right - 40.0, view.frame.bottom - 14.0),
    };
    Callout::whole(at, lines)
}

fn surface_text(view: &View<'_>, platform: &Platform<'_>) -> Option<Callout> {
    let surface_m = platform
        .surface_m()
        .filter(|surface_m| view.shows(*surface_m))?;
    let z = length(surface_m);
    let text = format!("z = {z} m: reference of the hydrostatic stiffness");
    Some(Callout::whole(
        (view.frame.right, view.y(surface_m)),
        vec![text],
    ))
}
