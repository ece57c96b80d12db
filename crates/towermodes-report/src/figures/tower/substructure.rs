//! A frame under the tower from the side: its members, supports and transition piece.

use towermodes::frame::{FrameMasses, FrameMember};

use super::callouts::Callout;
use super::view::View;
use crate::figures::substructure::{Substructure, radii_m};
use crate::figures::symbols::{center_of_mass, held_below, spring};
use crate::number::{length, mass};
use crate::svg::{Colour, Dash, Drawing, Stroke};
use crate::wording::counted;

/// Room below a frame for its supports.
pub(super) const BELOW: f64 = 30.0;
/// Length of the spring of a support that is not fixed.
const SPRING: f64 = 16.0;
/// A member whose ends are closer together on the sheet is seen along its axis.
const SHORT: f64 = 0.5;

/// Draws the frame, if there is one.
pub(super) fn draw_substructure(drawing: &mut Drawing, view: &View<'_>) {
    let Some(substructure) = view.parts.substructure() else {
        return;
    };
    let (left_top, size) = (view.frame.left_top(), view.frame.size());
    drawing.clipped(
        "substructure",
        left_top,
        (size.0, size.1 + BELOW),
        |drawing| {
            draw_supports(drawing, view, &substructure);
            draw_members(drawing, view);
            draw_transition(drawing, view, &substructure);
        },
    );
}

/// The position of a point; the axis of the tower passes through the reference point of the frame.
fn place(view: &View<'_>, substructure: &Substructure<'_>, point_m: [f64; 3]) -> (f64, f64) {
    let [axis_m, _, _] = substructure.of.reference_m();
    (view.x(point_m[0] - axis_m), view.y(point_m[2]))
}

/// Draws the members, those at the back first, as seen along y.
pub(super) fn draw_members(drawing: &mut Drawing, view: &View<'_>) {
    let Some(substructure) = view.parts.substructure() else {
        return;
    };
    let depth = |member: &&FrameMember| {
        let [a, b] = substructure.ends_m(member);
        a[1] + b[1]
    };
    let mut members: Vec<&FrameMember> = substructure.description().members.iter().collect();
    members.sort_by(|a, b| depth(b).total_cmp(&depth(a)));
    for member in members {
        let ends = substructure.ends_m(member);
        let [from, to] = ends.map(|end| place(view, &substructure, end));
        match radii_m(member) {
            Some(radii_m) => {
                let radii = radii_m.map(|radius_m| view.radius(2.0 * radius_m));
                let length = substructure.frame().length_m(member) * view.per_m;
                draw_tube(drawing, ([from, to], length), radii);
            }
            None => {
                let line = Stroke::new(Colour::Ink, 1.2).dashed(Dash::Dashed);
                drawing.line(from, to, &line);
            }
        }
    }
}

/// Draws a tube between two positions on the sheet, with its length in space.
fn draw_tube(
    drawing: &mut Drawing,
    ([from, to], length): ([(f64, f64); 2], f64),
    [r, s]: [f64; 2],
) {
    let edge = Stroke::new(Colour::Ink, 0.7);
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let size = dx.hypot(dy);
    if size < SHORT {
        // One that is short in space too is no more than a cut.
        if length > SHORT {
            drawing.disc(from, r.max(s), Colour::Steel, Some(&edge));
        }
        return;
    }
    let (nx, ny) = (-dy / size, dx / size);
    let side = |t: f64, u: f64| {
        [
            (from.0 + t * nx, from.1 + t * ny),
            (to.0 + u * nx, to.1 + u * ny),
        ]
    };
    let [[a, b], [d, c]] = [side(r, s), side(-r, -s)];
    drawing.polygon(&[a, b, c, d], Colour::Steel, None);
    drawing.line(a, b, &edge);
    drawing.line(d, c, &edge);
}

/// Draws hatching under fixed joints, and springs under the others.
fn draw_supports(drawing: &mut Drawing, view: &View<'_>, substructure: &Substructure<'_>) {
    let description = substructure.description();
    for support in &description.supports {
        let (x, y) = place(
            view,
            substructure,
            description.joints[support.joint].position_m,
        );
        let below = if support.is_clamped() { 0.0 } else { SPRING };
        if below > 0.0 {
            spring(drawing, (x, y), (x, y + below), 4.0);
        }
        held_below(drawing, x - 11.0, x + 11.0, y + below);
    }
}

/// Draws rigid links from the reference point of the transition piece to the joints that move with
/// it.
pub(super) fn draw_links(drawing: &mut Drawing, view: &View<'_>, width: f64) {
    let Some(substructure) = view.parts.substructure() else {
        return;
    };
    let Some(transition) = &substructure.description().transition else {
        return;
    };
    let middle = place(view, &substructure, transition.position_m);
    let link = Stroke::new(Colour::Ink, width);
    for joint in &transition.joints {
        let joint_m = substructure.description().joints[*joint].position_m;
        drawing.line(middle, place(view, &substructure, joint_m), &link);
    }
}

/// Draws the transition piece: its links and its centre of mass.
fn draw_transition(drawing: &mut Drawing, view: &View<'_>, substructure: &Substructure<'_>) {
    draw_links(drawing, view, 2.4);
    if substructure.of.platform.mass_kg > 0.0 {
        center_of_mass(
            drawing,
            place(view, substructure, center_m(substructure)),
            6.0,
        );
    }
}

/// The centre of mass of the transition piece, m.
fn center_m(substructure: &Substructure<'_>) -> [f64; 3] {
    let (reference, arm) = (
        substructure.of.reference_m(),
        substructure.of.platform.center_m,
    );
    std::array::from_fn(|i| reference[i] + arm[i])
}

/// The mass of the members, and with it the other masses that move with them.
fn masses_of(masses: &FrameMasses) -> String {
    let own = mass(masses.members_kg);
    let others = [
        (masses.joints_kg, "masses on joints"),
        (masses.growth_kg, "marine growth"),
        (masses.filling_kg, "fillings"),
    ];
    let others = others.into_iter().filter(|(mass_kg, _)| *mass_kg != 0.0);
    let others: Vec<String> = others
        .map(|(mass_kg, name)| format!("{name} {}", mass(mass_kg)))
        .collect();
    match others.is_empty() {
        true => own,
        false => format!("{own}; {}", others.join(", ")),
    }
}

/// The labels of the frame, its water and its ground.
pub(super) fn callouts(view: &View<'_>) -> Vec<Callout> {
    let Some(substructure) = view.parts.substructure() else {
        return Vec::new();
    };
    let description = substructure.description();
    let [low_m, high_m] = substructure.heights_m();
    let lines = vec![
        format!(
            "substructure: {}, {}",
            counted(description.joints.len(), "joint"),
            counted(description.members.len(), "member")
        ),
        masses_of(&substructure.frame().masses()),
    ];
    let members = description.members.iter();
    let rightmost = members
        .flat_map(|member| substructure.ends_m(member))
        .map(|end| place(view, &substructure, end))
        .filter(|(_, y)| *y > view.y(0.5 * (low_m + high_m)))
        .fold((view.axis_x, view.y(low_m)), |most, end| {
            if end.0 > most.0 { end } else { most }
        });
    let mut callouts = vec![Callout::whole(rightmost, lines)];
    let piece = &substructure.of.platform;
    if piece.mass_kg > 0.0 {
        let at = place(view, &substructure, center_m(&substructure));
        let text = format!("transition piece {}", mass(piece.mass_kg));
        callouts.push(Callout::whole(at, vec![text]));
    }
    let levels = [
        (substructure.water_m(), "water level"),
        (substructure.ground_m(), "mudline"),
    ];
    let is_own = view.parts.description.water.is_none();
    for (height_m, name) in levels.into_iter().filter(|_| is_own) {
        if let Some(height_m) = height_m.filter(|height_m| view.shows(*height_m)) {
            let text = format!("z = {} m: {name}", length(height_m));
            let at = (view.frame.right, view.y(height_m));
            callouts.push(Callout::whole(at, vec![text]));
        }
    }
    callouts
}
