//! `[[soil]]`, `[[added_mass]]`, `[water]`, `[[wires]]` and `[gravity]`.

use towermodes::{AddedMassRow, SoilRow, TowerDescription, Wires};

use super::inputs::values;
use super::writing::Writing;
use crate::toml::schema;

pub(super) fn surroundings(description: &TowerDescription, writing: &mut Writing) {
    let names = &description.part_names;
    for (index, layer) in description.soil.iter().enumerate() {
        soil(layer, names.soil.get(index), writing);
    }
    for (index, table) in description.added_mass.iter().enumerate() {
        added_mass(table, names.added_mass.get(index), writing);
    }
    if let Some(water) = &description.water {
        writing.section(&schema::WATER);
        values(water, writing);
    }
    for (index, wires) in description.wires.iter().enumerate() {
        self::wires(wires, names.wires.get(index), writing);
    }
    if description.gravity_m_per_s2 != 0.0 {
        writing.section(&schema::GRAVITY);
        writing.number("acceleration", description.gravity_m_per_s2);
    }
}

/// Writes a layer with x and y and as many further columns as are needed for values that are not
/// zero.
fn soil(layer: &[SoilRow], name: Option<&String>, writing: &mut Writing) {
    let values = |row: &SoilRow| {
        let springs = &row.stiffness;
        [
            row.height_m,
            springs.x_n_per_m2,
            springs.y_n_per_m2,
            springs.z_n_per_m2,
            springs.torsion_n,
            springs.rotation_x_n,
            springs.rotation_y_n,
        ]
    };
    let rows: Vec<[f64; 7]> = layer.iter().map(values).collect();
    let is_used = |column: usize| rows.iter().any(|row| row[column] != 0.0);
    let (columns, more) = match (3..7).rev().find(|column| is_used(*column)) {
        Some(5 | 6) => (
            7,
            ", in z (N/m2), in torsion, against rotation about x and y (N)",
        ),
        Some(4) => (5, ", in z (N/m2), in torsion (N)"),
        Some(3) => (4, ", in z (N/m2)"),
        _ => (3, ""),
    };
    writing.section(&schema::SOIL);
    writing.name(name);
    writing.line(format!(
        "rows = [  # height in m, springs in x, in y (N/m2){more}"
    ));
    writing.number_rows(&rows, columns);
    writing.line("]");
}

fn added_mass(table: &[AddedMassRow], name: Option<&String>, writing: &mut Writing) {
    let rows: Vec<[f64; 2]> = table
        .iter()
        .map(|r| [r.height_m, r.mass_kg_per_m])
        .collect();
    writing.section(&schema::ADDED_MASS);
    writing.name(name);
    writing.open_rows("rows");
    writing.number_rows(&rows, 2);
    writing.line("]");
}

fn wires(wires: &Wires, name: Option<&String>, writing: &mut Writing) {
    writing.section(&schema::WIRES);
    writing.name(name);
    values(wires, writing);
}
