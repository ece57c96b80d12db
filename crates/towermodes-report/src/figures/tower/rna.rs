//! The rotor-nacelle assembly: a nominal silhouette, its centre of mass to scale.

use towermodes::Tower;

use super::callouts::{Callout, Subject};
use super::view::View;
use crate::figures::outline::outer_diameter_m;
use crate::figures::symbols::center_of_mass;
use crate::number::{length, mass};
use crate::svg::{Colour, Dash, Drawing, Stroke};

/// Room that the silhouette needs above the tower.
pub(super) const ABOVE: f64 = 62.0;

/// Draws the RNA, if there is one; `scale` is the size of the silhouette, 1 in the picture of
/// the tower.
pub(super) fn draw_rna(drawing: &mut Drawing, view: &View, tower: &Tower, scale: f64) {
    let rna = tower.rna();
    if rna.is_absent() {
        return;
    }
    let silhouette = Silhouette::new(view, tower, scale);
    silhouette.draw(drawing);
    let center = center(view, tower);
    if rna.mass_kg > 0.0 && is_in_field(view, center) {
        if !silhouette.contains(center) {
            let arm = Stroke::new(Colour::Ink, 1.0).dashed(Dash::Dashed);
            drawing.line((view.axis_x, view.y(tower.top_m())), center, &arm);
        }
        center_of_mass(drawing, center, 3.0 + 3.0 * scale);
    }
}

/// The label of the RNA, if there is one.
pub(super) fn callout(view: &View, tower: &Tower) -> Option<Callout> {
    let rna = tower.rna();
    if rna.is_absent() {
        return None;
    }
    let [x, y, z] = rna.center_m.map(length);
    let mut lines = vec![format!("RNA {}", mass(rna.mass_kg))];
    if rna.mass_kg > 0.0 {
        let is_drawn = is_in_field(view, center(view, tower));
        let beyond = if is_drawn { "" } else { " (not drawn)" };
        lines.push(format!(
            "centre of mass ({x}, {y}, {z}) m from the tower top{beyond}"
        ));
    }
    let silhouette = Silhouette::new(view, tower, 1.0);
    Some(Callout {
        at: (silhouette.right, silhouette.top + 0.5 * silhouette.height),
        lines,
        subject: Subject::Whole,
    })
}

/// Where the centre of mass is.
fn center(view: &View, tower: &Tower) -> (f64, f64) {
    let center_m = tower.rna().center_m;
    (view.x(center_m[0]), view.y(tower.top_m() + center_m[2]))
}

fn is_in_field(view: &View, (x, y): (f64, f64)) -> bool {
    let frame = view.frame;
    (frame.left + 8.0..=frame.right - 8.0).contains(&x)
        && (frame.top + 7.0..=frame.bottom - 7.0).contains(&y)
}

/// Nacelle, hub and the roots of blades from the side, in any unit of length: x from the tower's
/// axis, heights from its top.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::figures) struct RnaForm {
    /// Where the nacelle begins, upwind.
    pub front: f64,
    /// Where it ends.
    pub back: f64,
    /// Its height.
    pub height: f64,
    /// How far the hub reaches before it.
    pub nose_length: f64,
    /// Half the height of the hub.
    pub nose_radius: f64,
    /// Where the blades are.
    pub blades_at: f64,
}

impl RnaForm {
    /// How many times the radius of the tower's top the unit is that lengths go by.
    pub const UNITS: f64 = 1.4;

    /// The form by its unit; a centre of mass that lies so far above the top is at half the
    /// nacelle's height, if that is neither flat nor higher than `most`.
    pub fn new(unit: f64, center_above: f64, most: f64) -> Self {
        let front = -1.7 * unit;
        let height = (2.0 * center_above).clamp(1.3 * unit, most.max(1.3 * unit));
        Self {
            front,
            back: 2.1 * unit,
            height,
            nose_length: 0.9 * unit,
            nose_radius: 0.42 * height,
            blades_at: front - 0.35 * unit,
        }
    }
}

/// Nacelle and hub as they are drawn.
struct Silhouette {
    left: f64,
    right: f64,
    top: f64,
    height: f64,
    unit: f64,
    form: RnaForm,
}

/// Between nacelle and hub.
const GAP: f64 = 3.0;

impl Silhouette {
    fn new(view: &View, tower: &Tower, scale: f64) -> Self {
        let radius = view.radius(outer_diameter_m(tower, tower.top_m()));
        let unit = (RnaForm::UNITS * radius).clamp(12.0, 22.0) * scale;
        let above = tower.rna().center_m[2] * view.per_m;
        let form = RnaForm::new(unit, above, 42.0 * scale);
        Self {
            left: view.axis_x + form.front,
            right: view.axis_x + form.back,
            top: view.y(tower.top_m()) - form.height,
            height: form.height,
            unit,
            form,
        }
    }

    fn contains(&self, (x, y): (f64, f64)) -> bool {
        (self.left - 0.8 * self.unit..=self.right).contains(&x)
            && (self.top..=self.top + self.height).contains(&y)
    }

    fn draw(&self, drawing: &mut Drawing) {
        let edge = Stroke::new(Colour::Ink, 1.0);
        let middle = self.top + 0.5 * self.height;
        self.draw_blades(drawing, middle, &edge);
        let size = (self.right - self.left, self.height);
        drawing.rectangle((self.left, self.top), size, Colour::Rna, Some(&edge));
        let nose: Vec<(f64, f64)> = (0..=12)
            .map(|k| {
                let angle = std::f64::consts::PI * (0.5 + f64::from(k) / 12.0);
                (
                    self.left - GAP + self.form.nose_length * angle.cos(),
                    middle - self.form.nose_radius * angle.sin(),
                )
            })
            .collect();
        drawing.polygon(&nose, Colour::Rna, Some(&edge));
    }

    /// The roots of two blades.
    fn draw_blades(&self, drawing: &mut Drawing, middle: f64, edge: &Stroke) {
        let x = self.left - self.form.front + self.form.blades_at - GAP;
        let (root, end) = (0.22 * self.unit, 0.14 * self.unit);
        for side in [-1.0, 1.0] {
            let reach = middle + side * 1.6 * self.unit;
            let blade = [
                (x - root, middle),
                (x - end, reach),
                (x + end, reach),
                (x + root, middle),
            ];
            drawing.polygon(&blade, Colour::Paper, Some(edge));
        }
    }
}
