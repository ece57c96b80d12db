//! The guy wires, soil and added mass of a tower of a deck.

use towermodes::{AddedMassRow, Place, SoilRow, SoilStiffness, Wires};

use super::super::records::deck::{Deck, Distribution, WireSet};
use super::building::{Building, Ends, MAIN};
use super::notes::Notes;
use crate::note::Note;
use crate::number::Rounded;
use crate::places::TABLE;

impl Building {
    pub(crate) fn wires(&mut self, sets: &[WireSet], borders_m: &[f64], compatible: bool) {
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
                ("angle_deg", &set.angle_deg.span),
                (TABLE, &set.node.span),
            ];
            for (key, span) in spans {
                self.places
                    .remember(Place::Wires { index, key }, MAIN, span.clone());
            }
        }
    }

    pub(super) fn surroundings(&mut self, deck: &Deck, notes: &mut Notes) {
        let Some(offshore) = &deck.support.offshore else {
            return;
        };
        let place = |row, key| Place::AddedMass { table: 0, row, key };
        let rows = self.rows_of(&offshore.added_mass, place, &["mass"], notes);
        let row = |(height_m, mass_kg_per_m)| AddedMassRow {
            height_m,
            mass_kg_per_m,
        };
        if !rows.is_empty() {
            self.description.added_mass = vec![rows.into_iter().map(row).collect()];
        }
        let place = |row, key| Place::Soil { layer: 0, row, key };
        let rows = self.rows_of(&offshore.stiffness, place, &["x", "y"], notes);
        let row = |(height_m, per_length)| SoilRow {
            height_m,
            stiffness: SoilStiffness {
                x_n_per_m2: per_length,
                y_n_per_m2: per_length,
                ..SoilStiffness::default()
            },
        };
        if !rows.is_empty() {
            self.description.soil = vec![rows.into_iter().map(row).collect()];
        }
    }

    /// The rows of a table in the datum of the tower. The places of their heights and values are
    /// stored; `keys` are the names of the value.
    fn rows_of(
        &mut self,
        table: &Distribution,
        place: impl Fn(usize, &'static str) -> Place,
        keys: &[&'static str],
        notes: &mut Notes,
    ) -> Vec<(f64, f64)> {
        let rows = in_datum(table, self.ends, notes);
        for (row, (height, value)) in table.rows.iter().enumerate().take(rows.len()) {
            let heights = ["height", TABLE, "rows"].map(|key| (key, height));
            let values = keys.iter().map(|key| (*key, value));
            for (key, value) in heights.into_iter().chain(values) {
                self.places
                    .remember(place(row, key), MAIN, value.span.clone());
            }
        }
        rows
    }
}

/// The rows of a table with heights in the datum of the tower, up to the tower top: as in BModes,
/// rows above it have no effect. Empty if no row is within the height of the flexible tower, or if
/// all values are zero.
fn in_datum(table: &Distribution, ends: Ends, notes: &mut Notes) -> Vec<(f64, f64)> {
    let Ends { base_m, top_m } = ends;
    let length_m = top_m - base_m;
    let rows: Vec<(f64, f64)> = table.rows.iter().map(|(z, v)| (z.value, v.value)).collect();
    let (Some(&(first_m, _)), Some(&(last_m, _))) = (rows.first(), rows.last()) else {
        return Vec::new();
    };
    if rows.iter().all(|(_, value)| *value == 0.0) {
        return Vec::new();
    }
    let mut left_out = |message| notes.on(&table.rows[0].0, Note::left_out(message));
    if last_m <= 0.0 || first_m >= length_m {
        left_out(format!(
            "this table covers {} m to {} m above the flexible base, outside the flexible tower: it has no effect",
            Rounded(first_m),
            Rounded(last_m)
        ));
        return Vec::new();
    }
    let (within, is_cut) = up_to(length_m, &rows);
    if is_cut {
        left_out(format!(
            "the table extends {} m above the tower top, where it has no effect",
            Rounded(last_m - length_m)
        ));
    }
    let in_datum = |(z, value): (f64, f64)| match z == length_m {
        true => (top_m, value),
        false => (base_m + z, value),
    };
    within.into_iter().map(in_datum).collect()
}

/// The rows up to a length, with the last one interpolated there, and whether rows beyond it are
/// omitted.
fn up_to(length_m: f64, rows: &[(f64, f64)]) -> (Vec<(f64, f64)>, bool) {
    let mut within: Vec<(f64, f64)> = Vec::with_capacity(rows.len());
    for &(z, value) in rows {
        let is_beyond = z > length_m * (1.0 + 1e-9);
        let reaches_end = z >= length_m * (1.0 - 1e-9);
        match within.last() {
            Some((below, at_below)) if is_beyond => {
                let s = (length_m - below) / (z - below);
                within.push((length_m, at_below + s * (value - at_below)));
                return (within, true);
            }
            _ => within.push((if reaches_end { length_m } else { z }, value)),
        }
    }
    (within, false)
}

/// Wires as in the library; with `compatible` they are springs of n k cos² horizontally and none
/// vertically, as in BModes 3.00.
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
