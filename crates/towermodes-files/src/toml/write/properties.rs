//! `[tower.properties]`.

use towermodes::{Planes, Properties, PropertyStation};

use super::super::tables::properties::shared_out;
use super::writing::Writing;
use crate::toml::schema;

pub(super) fn properties(rows: &[PropertyStation], writing: &mut Writing) {
    writing.section(&schema::PROPERTIES);
    let sections = || rows.iter().map(|row| &row.properties);
    let column = |key: &str, value: fn(&Properties) -> f64, writing: &mut Writing| {
        writing.list(key, sections().map(value));
    };
    writing.line("# Heights of the rows, m; mass, stiffnesses and inertia divided by mass vary linearly between rows.");
    writing.list("z_m", rows.iter().map(|row| row.height_m));
    writing.line("# Mass per length, kg/m.");
    column("mass_kg_per_m", |p| p.mass_kg_per_m, writing);
    writing.line("# Bending stiffness EI, N m2.");
    let keys = ["ei_fore_aft_n_m2", "ei_side_side_n_m2"];
    let bending: Vec<_> = sections().map(|p| p.bending_n_m2).collect();
    pair(keys, &bending, writing);
    writing.line("# Torsional stiffness GJ, N m2, and axial stiffness EA, N; inf is rigid.");
    column("gj_n_m2", |p| p.torsion_n_m2, writing);
    column("ea_n", |p| p.axial_n, writing);
    writing.line("# Inertia per length about the tower's axis, kg m.");
    column("polar_inertia_kg_m", |p| p.polar_inertia_kg_m, writing);
    rotary_inertia(rows, writing);
    shear_stiffness(rows, writing);
}

/// The columns of both planes, or one that applies to both.
fn pair([fore_aft, side_side]: [&str; 2], values: &[Planes<f64>], writing: &mut Writing) {
    writing.list(fore_aft, values.iter().map(|v| v.fore_aft));
    if !values.iter().all(Planes::are_equal) {
        writing.list(side_side, values.iter().map(|v| v.side_side));
    }
}

/// Writes the rotary inertia; nothing if it follows from the polar inertia.
fn rotary_inertia(rows: &[PropertyStation], writing: &mut Writing) {
    let follows = |row: &PropertyStation| {
        let p = &row.properties;
        p.rotary_inertia_kg_m == shared_out(p.polar_inertia_kg_m, p.bending_n_m2)
    };
    if rows.iter().all(follows) {
        return;
    }
    writing.line("# Inertia per length that resists bending, kg m.");
    let keys = [
        "rotary_inertia_fore_aft_kg_m",
        "rotary_inertia_side_side_kg_m",
    ];
    let values = rows.iter().map(|row| row.properties.rotary_inertia_kg_m);
    pair(keys, &values.collect::<Vec<_>>(), writing);
}

fn shear_stiffness(rows: &[PropertyStation], writing: &mut Writing) {
    let values = || rows.iter().map(|row| row.properties.shear_n);
    let given = values().flatten().count();
    if given == 0 {
        return;
    }
    if given < rows.len() {
        let message = format!(
            "{given} of {} rows have a shear stiffness: in the other rows it is written as nan, which the reader refuses",
            rows.len()
        );
        writing.note(message);
    }
    writing.line("# Shear stiffness kappa GA, N.");
    let keys = ["shear_stiffness_fore_aft_n", "shear_stiffness_side_side_n"];
    let missing = Planes::both(f64::NAN);
    let values = values().map(|value| value.unwrap_or(missing));
    pair(keys, &values.collect::<Vec<_>>(), writing);
}
