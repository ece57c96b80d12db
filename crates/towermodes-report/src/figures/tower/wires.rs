//! Guy wires beside the tower.

use towermodes::Wires;

use super::callouts::Callout;
use super::view::View;
use crate::number::{length, short, stiffness};
use crate::svg::{Colour, Drawing, Stroke};

/// If there are more sets of wires, they have a common callout.
const MOST_WIRES: usize = 6;

/// A drawn wire on the right side of the tower.
struct Drawn {
    /// Its beginning at the shell.
    start: (f64, f64),
    /// The horizontal and vertical distance of its anchor from there.
    anchor: (f64, f64),
}

impl Drawn {
    fn new(view: &View<'_>, wires: &Wires) -> Self {
        // From the shell as it is drawn, so that the angle is right and the end in sight.
        let start = view.on_shell(wires.height_m);
        let down = view.y(view.parts.wires_ground_m()) - start.1;
        Self {
            start,
            anchor: (down / wires.angle_deg.to_radians().tan(), down),
        }
    }

    /// The fraction of its length that is in the picture.
    fn share(&self, view: &View<'_>) -> f64 {
        let room = view.frame.right - self.start.0;
        if self.anchor.0 <= room {
            1.0
        } else {
            room / self.anchor.0
        }
    }
}

/// Draws taut wires on both sides, to the ground; wires that extend beyond the edge of the field
/// are cut there.
pub(super) fn draw_wires(drawing: &mut Drawing, view: &View<'_>) {
    let line = Stroke::new(Colour::Ink, 1.2);
    for wires in &view.parts.description.wires {
        let wire = Drawn::new(view, wires);
        let share = wire.share(view);
        for side in [-1.0, 1.0] {
            let (start_x, from) = wire.start;
            let start = (view.axis_x + side * (start_x - view.axis_x), from);
            let (reach, down) = wire.anchor;
            let end = (start.0 + side * share * reach, from + share * down);
            drawing.line(start, end, &line);
            if share == 1.0 {
                let (x, y) = end;
                let anchor = [(x - 5.0, y + 7.0), (x + 5.0, y + 7.0), (x, y - 2.0)];
                drawing.polygon(&anchor, Colour::Ink, None);
            } else {
                draw_cut(drawing, end, side, &line);
            }
        }
    }
}

/// Draws two strokes across the end of a wire, which show that it continues.
fn draw_cut(drawing: &mut Drawing, (x, y): (f64, f64), side: f64, line: &Stroke) {
    for back in [3.0, 7.0] {
        let middle = x - side * back;
        drawing.line(
            (middle - 2.0 * side, y + 6.0),
            (middle + 2.0 * side, y - 6.0),
            line,
        );
    }
}

/// The labels of the guy wires.
pub(super) fn callouts(view: &View<'_>) -> Vec<Callout> {
    let all = &view.parts.description.wires;
    let more = all.len().saturating_sub(MOST_WIRES);
    let callout = |(index, wires): (usize, &Wires)| {
        let mut lines = wire_lines(wires);
        let wire = Drawn::new(view, wires);
        if wire.share(view) < 1.0 {
            let away_m = wire.anchor.0 / view.per_m;
            lines.push(format!(
                "shortened in the picture: anchors {} m away",
                short(away_m, 3)
            ));
        }
        if index + 1 == MOST_WIRES && more > 0 {
            lines.push(format!("{more} more sets of guy wires"));
        }
        Callout::whole(wire.start, lines)
    };
    all.iter()
        .take(MOST_WIRES)
        .enumerate()
        .map(callout)
        .collect()
}

fn wire_lines(wires: &Wires) -> Vec<String> {
    vec![format!(
        "z = {} m: {} wires, {}°, {} each",
        length(wires.height_m),
        wires.count,
        short(wires.angle_deg, 3),
        stiffness(wires.stiffness_n_per_m, "N/m")
    )]
}
