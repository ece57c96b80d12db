//! Whether the table of a part agrees with its walls, if the file has both.

use towermodes::Material;

use super::super::text::reading::Reading;
use super::curve::Curve;
use super::part::Part;
use super::structure::Structure;
use crate::note::Note;
use crate::number::Rounded;

/// Masses may differ by this fraction.
const TOLERANCE: f64 = 0.01;

/// Notes differences of the masses per length or in total; the walls are used.
pub(crate) fn compare(structure: &Structure, reading: &mut Reading<'_>) {
    let materials = structure.materials();
    for part in &structure.parts {
        if !part.layers.is_empty() && part.elastic.is_some() {
            compare_part(part, &materials, reading);
        }
    }
}

fn compare_part(part: &Part, materials: &[Material], reading: &mut Reading<'_>) {
    let Some(elastic) = &part.elastic else { return };
    let mut worst = (0.0, 0.0, [0.0; 2]);
    let mut totals = [0.0; 2];
    for (base, top) in part.stretches() {
        let (low, high) = (base.position.to, top.position.from);
        let walls = [
            part.mass_at(|curve| curve.above(low), materials),
            part.mass_at(|curve| curve.below(high), materials),
        ];
        let table = [elastic.mass.above(low), elastic.mass.below(high)];
        let length_m = top.height_m - base.height_m;
        for (end, height_m) in [base.height_m, top.height_m].into_iter().enumerate() {
            let error = (table[end] / walls[end] - 1.0).abs();
            if error > worst.0 {
                worst = (error, height_m, [table[end], walls[end]]);
            }
            totals[0] += 0.5 * length_m * table[end];
            totals[1] += 0.5 * length_m * walls[end];
        }
    }
    let (error, height_m, masses) = worst;
    if error > TOLERANCE || (totals[0] / totals[1] - 1.0).abs() > TOLERANCE {
        let at = elastic.mass.0[0].spans()[0].start;
        let message = disagreement(part.what, height_m, masses, totals);
        reading.note_at(at, Note::suspicious(message));
    }
}

fn disagreement(what: &str, height_m: f64, masses: [f64; 2], totals: [f64; 2]) -> String {
    let ([table, walls], [all_table, all_walls]) = (masses.map(Rounded), totals.map(Rounded));
    let z = Rounded(height_m);
    format!(
        "elastic properties and layers of the {what} disagree: at z = {z} m {table} and {walls} kg/m, in total {all_table} and {all_walls} kg; the layers are used"
    )
}

impl Part {
    /// Mass per length of the concentric walls with their outfitting, kg/m, for these values of the
    /// curves.
    fn mass_at(&self, value: impl Fn(&Curve) -> f64, materials: &[Material]) -> f64 {
        let mut outer_m = self.diameter.as_ref().map_or(0.0, &value);
        let mut mass = 0.0;
        for layer in &self.layers {
            let wall_m = value(&layer.thickness);
            let area = std::f64::consts::PI * wall_m * (outer_m - wall_m);
            mass += materials[layer.material].density_kg_per_m3 * area;
            outer_m -= 2.0 * wall_m;
        }
        self.outfitting.0 * mass
    }
}
