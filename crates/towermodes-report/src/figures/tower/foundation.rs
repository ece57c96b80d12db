//! The foundation: hatching, springs, a footing or a pile.

use towermodes::{Buried, ClosedForm, FoundationSprings, StiffnessFoundation, Support, TipSprings};

use super::callouts::Callout;
use super::substructure;
use super::view::View;
use crate::figures::parts::Parts;
use crate::figures::symbols::{held_below, held_left, rigid_link, spiral, spring, turn};
use crate::number::{length, mass, stiffness};
use crate::svg::{Colour, Drawing, Stroke};

/// Room that a foundation needs below the base.
pub(super) fn below(parts: &Parts<'_>) -> f64 {
    match parts.given.foundation.support() {
        Support::Clamped => 26.0,
        Support::Floating(_) => 16.0,
        Support::Frame(_) => substructure::BELOW,
        Support::Stiffness(_) | Support::Springs(_) | Support::Form(_) => 58.0,
    }
}

/// Draws the foundation at the base, except for a floating platform.
pub(super) fn draw_foundation(drawing: &mut Drawing, view: &View<'_>) {
    match (view.parts.given.foundation.support(), view.parts.springs()) {
        (Support::Floating(_) | Support::Frame(_), _) => {}
        (Support::Form(form), _) => {
            draw_in_soil(drawing, view, &InSoil::new(view, form.buried()));
        }
        (_, Some(springs)) => draw_springs(drawing, view, &springs),
        (_, None) => {
            let half = base_radius(view) + 18.0;
            held_below(drawing, view.axis_x - half, view.axis_x + half, view.base());
        }
    }
}

fn base_radius(view: &View<'_>) -> f64 {
    view.radius_at(view.parts.tower.base_m())
}

fn draw_springs(drawing: &mut Drawing, view: &View<'_>, springs: &FoundationSprings) {
    let (x, y) = (view.axis_x, view.base());
    let half = base_radius(view) + 5.0;
    if springs.lateral_n_per_m > 0.0 {
        let ends = ((x - half, y), (x - half - 38.0, y));
        link(drawing, springs.lateral_n_per_m, ends);
        held_left(drawing, x - half - 38.0, y - 10.0, y + 10.0);
    }
    if springs.vertical_n_per_m > 0.0 {
        let ends = ((x, y), (x, y + 38.0));
        link(drawing, springs.vertical_n_per_m, ends);
        held_below(drawing, x - 14.0, x + 14.0, y + 38.0);
    }
    if springs.rocking_n_m.is_infinite() {
        rigid_link(drawing, (x + half, y), (x + half + 20.0, y));
        held_below(drawing, x + half + 8.0, x + half + 32.0, y + 3.0);
    } else if springs.rocking_n_m > 0.0 {
        spiral(drawing, (x + half + 10.0, y), 9.0);
        held_below(drawing, x + half, x + half + 20.0, y + 12.0);
        drawing.line(
            (x + half, y),
            (x + half + 10.0, y),
            &Stroke::new(Colour::Ink, 1.1),
        );
    }
    if springs.torsion_n_m > 0.0 && springs.torsion_n_m.is_finite() {
        turn(drawing, (x, y + 18.0), half.clamp(16.0, 40.0));
    }
    let plate = Stroke::new(Colour::Ink, 3.0);
    drawing.line((x - half, y), (x + half, y), &plate);
}

/// Draws a spring, or a rigid link if its stiffness is infinite.
fn link(drawing: &mut Drawing, stiffness: f64, (from, to): ((f64, f64), (f64, f64))) {
    if stiffness.is_infinite() {
        rigid_link(drawing, from, to);
    } else {
        spring(drawing, from, to, 5.0);
    }
}

/// The drawn form of a footing or a pile.
struct InSoil {
    top: f64,
    half_width: f64,
    depth: f64,
    /// The height of the ground surface.
    ground: f64,
    is_to_scale: bool,
}

impl InSoil {
    fn new(view: &View<'_>, of: Buried) -> Self {
        let y = view.base();
        let wished = view.radius(2.0 * of.half_m[0]);
        let most = 0.5 * (view.frame.right - view.frame.left) - 16.0;
        let half_width = wished.min(most);
        let embedded = of.depth_m * view.per_m;
        let depth = embedded.clamp(9.0, 48.0);
        let top = match of.surface_above_base_m() > 0.0 {
            true => y - depth,
            false => y,
        };
        Self {
            top,
            half_width,
            depth,
            ground: if of.depth_m > 0.0 { top } else { y + depth },
            is_to_scale: half_width == wished && embedded <= 48.0,
        }
    }
}

fn draw_in_soil(drawing: &mut Drawing, view: &View<'_>, body: &InSoil) {
    view.fill_below(drawing, body.ground, Colour::Soil);
    held_below(
        drawing,
        view.frame.left + 6.0,
        view.frame.right,
        body.ground,
    );
    let left_top = (view.axis_x - body.half_width, body.top);
    let edge = Stroke::new(Colour::Ink, 1.2);
    let size = (2.0 * body.half_width, body.depth);
    drawing.rectangle(left_top, size, Colour::Band, Some(&edge));
}

/// The label of the foundation.
pub(super) fn callout(view: &View<'_>) -> Option<Callout> {
    let (x, y) = (view.axis_x, view.base());
    let half = base_radius(view);
    let (clamp, springs) = ((x + half + 14.0, y + 5.0), (x + half + 27.0, y + 6.0));
    let tip = view.parts.tower.springs_at_tip();
    let with_tip = |mut lines: Vec<String>| {
        lines.extend(tip.iter().flat_map(tip_lines));
        lines
    };
    Some(match view.parts.given.foundation.support() {
        Support::Floating(_) | Support::Frame(_) => return None,
        Support::Clamped => Callout::whole(clamp, vec!["clamped".to_owned()]),
        Support::Springs(_) if view.parts.springs().is_none() => {
            Callout::whole(clamp, vec!["springs, all rigid: clamped".to_owned()])
        }
        Support::Springs(given) => Callout::whole(springs, with_tip(spring_lines(given))),
        Support::Stiffness(matrices) => Callout::whole(springs, with_tip(matrix_lines(matrices))),
        Support::Form(form) => {
            let body = InSoil::new(view, form.buried());
            let at = (x + body.half_width, body.top + 0.6 * body.depth);
            Callout::whole(at, dimension_lines(form, body.is_to_scale))
        }
    })
}

/// The springs of the soil under the tip of a pile.
fn tip_lines(tip: &TipSprings) -> Vec<String> {
    let values = [
        ("lateral", tip.lateral_n_per_m, "N/m"),
        ("rocking", tip.rocking_n_m, "N m"),
        ("vertical", tip.vertical_n_per_m, "N/m"),
        ("torsion", tip.torsion_n_m, "N m"),
    ];
    in_pairs("soil springs at the pile tip: ", &values)
}

fn spring_lines(springs: &FoundationSprings) -> Vec<String> {
    let values = [
        ("lateral", springs.lateral_n_per_m, "N/m"),
        ("vertical", springs.vertical_n_per_m, "N/m"),
        ("rocking", springs.rocking_n_m, "N m"),
        ("torsion", springs.torsion_n_m, "N m"),
        ("coupling", springs.coupling_n, "N"),
    ];
    in_pairs("springs: ", &values)
}

/// The values that are not zero, two in a line, after a start.
fn in_pairs(start: &str, values: &[(&str, f64, &str)]) -> Vec<String> {
    let present = values.iter().filter(|(_, value, _)| *value != 0.0);
    let texts: Vec<String> = present
        .map(|(name, value, unit)| format!("{name} {}", stiffness(*value, unit)))
        .collect();
    texts
        .chunks(2)
        .enumerate()
        .map(|(row, pair)| {
            let start = if row == 0 { start } else { "" };
            format!("{start}{}", pair.join(", "))
        })
        .collect()
}

fn matrix_lines(foundation: &StiffnessFoundation) -> Vec<String> {
    let k = &foundation.stiffness;
    let of = |first: usize, unit: &str| {
        let value = |i: usize| stiffness(k[first + i][first + i], "").trim_end().to_owned();
        format!("{}, {}, {} {unit}", value(0), value(1), value(2))
    };
    let mut lines = vec![
        "6×6 stiffness matrix, diagonal:".to_owned(),
        format!("x, y, z: {}", of(0, "N/m")),
        format!("about x, y, z: {}", of(3, "N m")),
    ];
    let moving = foundation.inertia[0][0].max(foundation.inertia[1][1]);
    if moving > 0.0 {
        lines.push(format!("foundation mass {}", mass(moving)));
    }
    lines
}

/// The type of a foundation with its dimensions, and the resulting soil or springs.
fn dimension_lines(form: &dyn ClosedForm, is_to_scale: bool) -> Vec<String> {
    let of = form.buried();
    let ([x, y], depth) = (
        of.half_m.map(|half_m| length(2.0 * half_m)),
        length(of.depth_m),
    );
    let size = match (of.is_deep, of.is_round) {
        (true, _) => format!("diameter {x} m, {depth} m deep"),
        (false, true) => format!("radius {} m, embedded {depth} m", length(of.half_m[0])),
        (false, false) => format!("{x} m × {y} m, embedded {depth} m"),
    };
    let scale = if is_to_scale { "" } else { ", not to scale" };
    let mut lines = vec![format!("{}: {size}{scale}", of.noun)];
    match of.soil {
        Some(soil) => {
            let what = match soil.thickness_m.is_finite() {
                true => format!("stratum of {} m", length(soil.thickness_m)),
                false => "half-space".to_owned(),
            };
            let modulus = stiffness(soil.shear_modulus_pa, "Pa");
            lines.push(format!(
                "{what}: G {modulus}, ν {}",
                length(soil.poissons_ratio)
            ));
        }
        None => {
            let springs = FoundationSprings::of_matrix(&form.stiffness());
            lines.extend(springs.iter().flat_map(spring_lines));
        }
    }
    lines
}
