//! `[foundation]`.

use towermodes::space::SpatialMatrix;
use towermodes::{
    AddedMassTable, FloatingPlatform, ReferredMatrix, StiffnessFoundation, Support,
    TowerDescription,
};

use super::bodies::inertia_with;
use super::inputs::values;
use super::materials::MaterialNames;
use super::mooring::mooring;
use super::substructure::substructure;
use super::text::{number, triple};
use super::writing::Writing;
use crate::toml::schema::{self, TableSchema};

const NONE: SpatialMatrix = [[0.0; 6]; 6];

/// Writes the foundation; nothing if the base is clamped.
pub(super) fn foundation(description: &TowerDescription, writing: &mut Writing) {
    match description.foundation.support() {
        Support::Clamped => {}
        Support::Stiffness(foundation) => stiffness(foundation, writing),
        Support::Springs(springs) => {
            kind("springs", &schema::SPRINGS, writing);
            values(springs, writing);
        }
        Support::Floating(_) => {}
        Support::Frame(frame) => substructure(frame, &MaterialNames::of(description), writing),
        Support::Form(form) => {
            let name = form.kind().name;
            kind(name, schema::closed_form(name), writing);
            values(form, writing);
        }
    }
    if let Some(platform) = description.foundation.floating() {
        floating(platform, writing);
        if let Some(lines) = &platform.mooring_lines {
            mooring(lines, &description.part_names, writing);
        }
    }
}

fn kind(kind: &str, table: &'static TableSchema, writing: &mut Writing) {
    writing.section_called("[foundation]", table);
    writing.commented("type", &format!("\"{kind}\""), "");
}

fn matrix(key: &str, matrix: &SpatialMatrix, writing: &mut Writing) {
    writing.open_rows(key);
    writing.number_rows(matrix, 6);
    writing.line("]");
}

fn stiffness(foundation: &StiffnessFoundation, writing: &mut Writing) {
    kind("stiffness", &schema::STIFFNESS, writing);
    matrix("matrix", &foundation.stiffness, writing);
    if foundation.inertia != NONE {
        matrix("mass", &foundation.inertia, writing);
    }
}

fn floating(platform: &FloatingPlatform, writing: &mut Writing) {
    kind("floating", &schema::FLOATING, writing);
    writing.number("mass", platform.mass_kg);
    writing.value("center", &triple(platform.center_m));
    inertia_with(&platform.inertia_kg_m2, &["xx", "yy", "zz"], writing);
    let matrices = [
        ("added_mass", &platform.added_mass),
        ("hydrostatic", &platform.hydrostatic),
        ("mooring", &platform.mooring),
    ];
    for (key, referred) in matrices {
        let table = platform.added_mass_by_frequency.as_deref();
        let table = table.filter(|_| key == "added_mass");
        if let Some(table) = table {
            writing.number("added_mass_height", referred.height_m);
            by_frequency(table, writing);
            if referred.matrix != NONE {
                matrix(key, &referred.matrix, writing);
            }
        } else if *referred != ReferredMatrix::default() {
            writing.number(&format!("{key}_height"), referred.height_m);
            matrix(key, &referred.matrix, writing);
        }
    }
    if let Some(buoyancy) = &platform.buoyancy {
        writing.number("buoyancy", buoyancy.force_n);
        let [x, y] = buoyancy.center_m.map(number);
        writing.value("buoyancy_center", &format!("[{x}, {y}]"));
    }
    if platform.at_equilibrium {
        writing.value("at_equilibrium", "true");
    }
}

/// A row for each frequency with the entries on and above the diagonal.
fn by_frequency(table: &AddedMassTable, writing: &mut Writing) {
    let row = |frequency: f64, matrix: &SpatialMatrix| -> [f64; 22] {
        let places = (0..6).flat_map(|i| (i..6).map(move |j| (i, j)));
        let entries = places.map(|(i, j)| 0.5 * (matrix[i][j] + matrix[j][i]));
        let mut values = [frequency; 22];
        for (value, entry) in values[1..].iter_mut().zip(entries) {
            *value = entry;
        }
        values
    };
    let mut rows = vec![row(0.0, &table.zero)];
    rows.extend(
        table
            .rows
            .iter()
            .map(|(frequency, matrix)| row(*frequency, matrix)),
    );
    rows.push(row(f64::INFINITY, &table.infinite));
    writing.open_rows("added_mass_by_frequency");
    writing.number_rows(&rows, 22);
    writing.line("]");
}
