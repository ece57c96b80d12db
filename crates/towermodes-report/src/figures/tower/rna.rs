//! The rotor-nacelle assembly: a nominal silhouette, its centre of mass to scale.

use towermodes::Rna;

use super::callouts::Callout;
use super::view::View;
use crate::figures::parts::RnaForm;
use crate::figures::symbols::center_of_mass;
use crate::number::{length, mass};
use crate::svg::{Colour, Dash, Drawing, Stroke};

/// Room that the silhouette needs above the tower.
pub(super) const ABOVE: f64 = 62.0;

/// Draws the RNA, if there is one; `scale` is the size of the silhouette, 1 in the picture of
/// the tower.
pub(super) fn draw_rna(drawing: &mut Drawing, view: &View<'_>, scale: f64) {
    let Some(rna) = view.parts.rna() else { return };
    let silhouette = Silhouette::new(view, rna, scale);
    silhouette.draw(drawing);
    let center = center(view, rna);
    if rna.mass_kg > 0.0 && is_in_field(view, center) {
        if !silhouette.contains(center) {
            let arm = Stroke::new(Colour::Ink, 1.0).dashed(Dash::Dashed);
            drawing.line((view.axis_x, view.top()), center, &arm);
        }
        center_of_mass(drawing, center, 3.0 + 3.0 * scale);
    }
}

/// The label of the RNA, if there is one.
pub(super) fn callout(view: &View<'_>) -> Option<Callout> {
    let rna = view.parts.rna()?;
    let [x, y, z] = rna.center_m.map(length);
    let mut lines = vec![format!("RNA {}", mass(rna.mass_kg))];
    if rna.mass_kg > 0.0 {
        let is_drawn = is_in_field(view, center(view, rna));
        let beyond = if is_drawn { "" } else { " (not drawn)" };
        lines.push(format!(
            "centre of mass ({x}, {y}, {z}) m from the tower top{beyond}"
        ));
    }
    let silhouette = Silhouette::new(view, rna, 1.0);
    let at = (silhouette.right, silhouette.top + 0.5 * silhouette.height);
    Some(Callout::whole(at, lines))
}

/// The position of the centre of mass.
fn center(view: &View<'_>, rna: &Rna) -> (f64, f64) {
    let top_m = view.parts.tower.top_m();
    (view.x(rna.center_m[0]), view.y(top_m + rna.center_m[2]))
}

fn is_in_field(view: &View<'_>, (x, y): (f64, f64)) -> bool {
    let frame = view.frame;
    (frame.left + 8.0..=frame.right - 8.0).contains(&x)
        && (frame.top + 7.0..=frame.bottom - 7.0).contains(&y)
}

/// The drawn nacelle and hub.
struct Silhouette {
    left: f64,
    right: f64,
    top: f64,
    height: f64,
    unit: f64,
    form: RnaForm,
}

/// Distance between nacelle and hub.
const GAP: f64 = 3.0;

impl Silhouette {
    fn new(view: &View<'_>, rna: &Rna, scale: f64) -> Self {
        let radius = view.radius_at(view.parts.tower.top_m());
        let unit = (RnaForm::UNITS * radius).clamp(12.0, 22.0) * scale;
        let above = rna.center_m[2] * view.per_m;
        let form = RnaForm::new(unit, above, 42.0 * scale);
        Self {
            left: view.axis_x + form.front,
            right: view.axis_x + form.back,
            top: view.top() - form.height,
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

    /// Draws the roots of two blades.
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
