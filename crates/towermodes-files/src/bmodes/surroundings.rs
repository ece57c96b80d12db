//! What stands around a tower of a deck: wires, soil, and mass that moves with it.

use towermodes::{AddedMassRow, Place, SoilRow, SoilStiffness, Wires};

use super::deck::{Deck, Distribution, WireSet};
use super::reader::Value;
use super::tower::{Building, Ends, MAIN};
use crate::diagnostic::Diagnostic;
use crate::places::TABLE;

impl Building {
    pub(super) fn wires(&mut self, sets: &[WireSet], borders_m: &[f64], quirks: bool) {
        for (index, set) in sets.iter().enumerate() {
            // A node beyond the last was refused where it stands.
            let node = (set.node.value - 1).min(borders_m.len() - 1);
            self.description
                .wires
                .push(wires(set, borders_m[node], quirks));
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

    pub(super) fn surroundings(&mut self, deck: &Deck) -> Result<(), Diagnostic> {
        let Some(offshore) = &deck.support.offshore else {
            return Ok(());
        };
        let added_mass = self.heights_of(&offshore.added_mass)?;
        for (row, (height, value)) in offshore.added_mass.rows.iter().enumerate() {
            let table = 0;
            let spans = [
                ("height", height),
                ("mass", value),
                (TABLE, height),
                ("rows", height),
            ];
            for (key, value) in spans {
                let place = Place::AddedMass { table, row, key };
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
        self.soil(&offshore.stiffness)
    }

    fn soil(&mut self, stiffness: &Distribution) -> Result<(), Diagnostic> {
        let soil = self.heights_of(stiffness)?;
        for (row, (height, value)) in stiffness.rows.iter().enumerate() {
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
        Ok(())
    }

    /// A table with heights in the datum of the tower.
    fn heights_of(&self, table: &Distribution) -> Result<Vec<(f64, f64)>, Diagnostic> {
        let Ends { base_m, top_m } = self.ends;
        let length_m = top_m - base_m;
        let row = |(z, value): &(Value<f64>, Value<f64>)| {
            if (z.value - length_m).abs() <= 1e-9 * length_m {
                return Ok((top_m, value.value));
            }
            if z.value < length_m {
                return Ok((base_m + z.value, value.value));
            }
            let message = format!(
                "height {} m above the flexible base lies beyond the tower's top, {length_m} m above it",
                z.value
            );
            Err(z.wrong(message))
        };
        table.rows.iter().map(row).collect()
    }
}

/// Wires in the library's terms; as BModes understands them they hold horizontally with n k cos², and not vertically.
fn wires(set: &WireSet, height_m: f64, quirks: bool) -> Wires {
    let cosine = set.angle_deg.value.to_radians().cos();
    let as_written = set.stiffness_n_per_m.value;
    Wires {
        height_m,
        count: set.count.value,
        stiffness_n_per_m: if quirks {
            2.0 * as_written * cosine * cosine
        } else {
            as_written
        },
        angle_deg: if quirks { 0.0 } else { set.angle_deg.value },
    }
}
