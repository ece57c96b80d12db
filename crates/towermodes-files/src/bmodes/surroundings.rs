//! The guy wires, soil and added mass of a tower of a deck.

use towermodes::{AddedMassRow, Place, SoilRow, SoilStiffness, Wires};

use super::building::{Building, Ends, MAIN};
use super::deck::{Deck, Distribution, WireSet};
use super::notes::Notes;
use crate::diagnostic::Diagnostic;
use crate::note::Note;
use crate::number::Rounded;
use crate::places::TABLE;

impl Building {
    pub(super) fn wires(&mut self, sets: &[WireSet], borders_m: &[f64], compatible: bool) {
        for (index, set) in sets.iter().enumerate() {
            // The reader refuses a node beyond the last.
            let node = (set.node.value - 1).min(borders_m.len() - 1);
            self.description
                .wires
                .push(wires(set, borders_m[node], compatible));
            let spans = [
                ("height", &set.node.span),
                ("count", &set.count.span),
                ("stiffness", &set.stiffness_n_per_m.span),
                ("angle", &set.angle_deg.span),
                (TABLE, &set.node.span),
            ];
            for (key, span) in spans {
                self.places
                    .remember(Place::Wires { index, key }, MAIN, span.clone());
            }
        }
    }

    pub(super) fn surroundings(
        &mut self,
        deck: &Deck,
        notes: &mut Notes,
    ) -> Result<(), Diagnostic> {
        let Some(offshore) = &deck.support.offshore else {
            return Ok(());
        };
        let added_mass = self.heights_of(&offshore.added_mass, notes);
        for row in 0..added_mass.len() {
            let (height, value) = &offshore.added_mass.rows[row];
            let spans = [
                ("height", height),
                ("mass", value),
                (TABLE, height),
                ("rows", height),
            ];
            for (key, value) in spans {
                let place = Place::AddedMass { table: 0, row, key };
                self.places.remember(place, MAIN, value.span.clone());
            }
        }
        let row = |(height_m, mass_kg_per_m)| AddedMassRow {
            height_m,
            mass_kg_per_m,
        };
        if !added_mass.is_empty() {
            self.description.added_mass = vec![added_mass.into_iter().map(row).collect()];
        }
        self.soil(&offshore.stiffness, notes);
        Ok(())
    }

    fn soil(&mut self, stiffness: &Distribution, notes: &mut Notes) {
        let soil = self.heights_of(stiffness, notes);
        for row in 0..soil.len() {
            let (height, value) = &stiffness.rows[row];
            let layer = 0;
            let spans = [
                ("height", height),
                ("x", value),
                ("y", value),
                (TABLE, height),
                ("rows", height),
            ];
            for (key, value) in spans {
                let place = Place::Soil { layer, row, key };
                self.places.remember(place, MAIN, value.span.clone());
            }
        }
        let row = |(height_m, per_length)| SoilRow {
            height_m,
            stiffness: SoilStiffness {
                x_n_per_m2: per_length,
                y_n_per_m2: per_length,
                ..SoilStiffness::default()
            },
        };
        if !soil.is_empty() {
            self.description.soil = vec![soil.into_iter().map(row).collect()];
        }
    }

    /// A table with heights in the datum of the tower, up to the tower top: as in BModes, rows
    /// above it have no effect. Empty if no row is along the flexible tower, or all values are
    /// zero.
    fn heights_of(&self, table: &Distribution, notes: &mut Notes) -> Vec<(f64, f64)> {
        let Ends { base_m, top_m } = self.ends;
        let length_m = top_m - base_m;
        let rows: Vec<(f64, f64)> = table.rows.iter().map(|(z, v)| (z.value, v.value)).collect();
        let (Some(first), Some(last)) = (rows.first(), rows.last()) else {
            return Vec::new();
        };
        if rows.iter().all(|(_, value)| *value == 0.0) {
            return Vec::new();
        }
        let height = &table.rows[0].0;
        if last.0 <= 0.0 || first.0 >= length_m {
            let message = format!(
                "this table covers {} m to {} m above the flexible base, outside the flexible tower: it has no effect",
                Rounded(first.0),
                Rounded(last.0)
            );
            notes.on(height, Note::left_out(message));
            return Vec::new();
        }
        let mut within: Vec<(f64, f64)> = Vec::with_capacity(rows.len());
        for &(z, value) in &rows {
            let is_beyond = z > length_m * (1.0 + 1e-9);
            let reaches_top = z >= length_m * (1.0 - 1e-9);
            match within.last() {
                Some((below, at_below)) if is_beyond => {
                    let s = (length_m - below) / (z - below);
                    let at_top = at_below + s * (value - at_below);
                    let message = format!(
                        "the table extends {} m above the tower top, where it has no effect",
                        Rounded(last.0 - length_m)
                    );
                    notes.on(height, Note::left_out(message));
                    within.push((length_m, at_top));
                    break;
                }
                _ => within.push((if reaches_top { length_m } else { z }, value)),
            }
        }
        let in_datum = |(z, value): (f64, f64)| match z == length_m {
            true => (top_m, value),
            false => (base_m + z, value),
        };
        within.into_iter().map(in_datum).collect()
    }
}

/// Wires in the library's terms; with `compatible` they are springs of n k cos² horizontally and
/// none vertically, as in BModes 3.00.
fn wires(set: &WireSet, height_m: f64, compatible: bool) -> Wires {
    let cosine = set.angle_deg.value.to_radians().cos();
    let as_written = set.stiffness_n_per_m.value;
    Wires {
        height_m,
        count: set.count.value,
        stiffness_n_per_m: if compatible {
            2.0 * as_written * cosine * cosine
        } else {
            as_written
        },
        angle_deg: if compatible { 0.0 } else { set.angle_deg.value },
    }
}
