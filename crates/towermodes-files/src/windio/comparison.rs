//! Whether the table of a part agrees with its walls, where the file has both.

use towermodes::Material;

use super::part::Part;
use super::reading::Reading;
use super::structure::Structure;
use crate::note::Note;
use crate::number::Rounded;

/// Masses may differ by this fraction.
const TOLERANCE: f64 = 0.01;

/// Notes where the masses per length or in total disagree; the walls win.
pub(super) fn compare(structure: &Structure, reading: &mut Reading<'_>) {
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
            part.mass_above(low, materials),
            part.mass_below(high, materials),
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
    let total_error = (totals[0] / totals[1] - 1.0).abs();
    if worst.0 > TOLERANCE || total_error > TOLERANCE {
        let (_, z, [table, walls]) = worst;
        let message = format!(
            "elastic properties and layers of the {} disagree: at z = {} m {} and {} kg/m, in total {} and {} kg; the layers are used",
            part.what,
            Rounded(z),
            Rounded(table),
            Rounded(walls),
            Rounded(totals[0]),
            Rounded(totals[1])
        );
        reading.note_at(
            elastic.mass.0[0].spans()[0].start,
            Note::suspicious(message),
        );
    }
}

impl Part {
    fn mass_above(&self, s: f64, materials: &[Material]) -> f64 {
        let walls = self.layers.iter();
        let walls = walls.map(|layer| (layer.thickness.above(s), layer.material));
        let diameter_m = self.diameter.as_ref().map_or(0.0, |d| d.above(s));
        self.mass(diameter_m, walls, materials)
    }

    fn mass_below(&self, s: f64, materials: &[Material]) -> f64 {
        let walls = self.layers.iter();
        let walls = walls.map(|layer| (layer.thickness.below(s), layer.material));
        let diameter_m = self.diameter.as_ref().map_or(0.0, |d| d.below(s));
        self.mass(diameter_m, walls, materials)
    }

    /// Mass per length of concentric walls with their outfitting, kg/m.
    fn mass(
        &self,
        diameter_m: f64,
        walls: impl Iterator<Item = (f64, usize)>,
        materials: &[Material],
    ) -> f64 {
        let mut outer_m = diameter_m;
        let mut mass = 0.0;
        for (wall_m, material) in walls {
            let area = std::f64::consts::PI * wall_m * (outer_m - wall_m);
            mass += materials[material].density_kg_per_m3 * area;
            outer_m -= 2.0 * wall_m;
        }
        self.outfitting.0 * mass
    }
}
