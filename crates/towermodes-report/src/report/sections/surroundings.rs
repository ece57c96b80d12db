//! Soil, water and guy wires in tables.

use towermodes::{AddedMassRow, SoilRow, Tower, TowerDescription};

use super::super::document::Block;
use super::super::table::Table;
use super::inputs::{of_inputs, of_list};
use super::table;
use crate::number::{given, length};

/// The largest number of layers of soil and tables of added mass that are shown.
const MOST_TABLES: usize = 20;

pub(super) fn surroundings(description: &TowerDescription, tower: &Tower) -> Vec<Block> {
    let mut tables = Vec::new();
    let names = &description.part_names;
    let soil = description.soil.iter().enumerate().take(MOST_TABLES);
    let which_layer = |index| which(index, description.soil.len(), &names.soil);
    tables.extend(soil.map(|(index, rows)| soil_layer(&which_layer(index), rows)));
    let ground = description.ground.as_ref();
    if ground.is_none() && !description.soil.is_empty() {
        tables.extend(tower.foundation_head().map(super::ground::pile_head));
    }
    tables.extend(
        ground
            .map(|ground| super::ground::ground(ground, &names.ground, tower))
            .into_iter()
            .flatten(),
    );
    let water = description.water.as_ref();
    let is_scoured = ground.is_some_and(|ground| ground.scoured_surface_m() < ground.surface_m);
    let caption = match is_scoured {
        true => "Water around the tower; the seabed is before scour",
        false => "Water around the tower",
    };
    tables.extend(water.map(|water| of_inputs(caption, water, [])));
    let added = description.added_mass.iter().enumerate().take(MOST_TABLES);
    let which_table = |index| which(index, description.added_mass.len(), &names.added_mass);
    tables.extend(added.map(|(index, rows)| added_mass(&which_table(index), rows)));
    if !description.wires.is_empty() {
        tables.push(of_list("Guy wires", &description.wires, &names.wires));
    }
    if tables.is_empty() {
        return Vec::new();
    }
    let heading = Block::Heading("Soil, water and guy wires".to_owned());
    std::iter::once(heading)
        .chain(tables.into_iter().map(table))
        .collect()
}

/// ", 2 of 3 (clay)"; without number if there is only one, without name if it has none.
fn which(index: usize, count: usize, names: &[String]) -> String {
    let place = match count {
        1 => String::new(),
        count => format!(", {} of {count}", index + 1),
    };
    match names.get(index).map(|name| name.trim()) {
        None | Some("") => place,
        Some(name) => format!("{place} ({name})"),
    }
}

fn soil_layer(which: &str, rows: &[SoilRow]) -> Table {
    let mut table = Table::new(
        format!("Soil springs per unit length{which}; linear between rows"),
        [
            "#height z (m)",
            "#x (N/m²)",
            "#y (N/m²)",
            "#z (N/m²)",
            "#torsion (N)",
            "#rotation about x (N)",
            "#rotation about y (N)",
        ],
    );
    for row in rows {
        let soil = &row.stiffness;
        table.push([
            length(row.height_m),
            given(soil.x_n_per_m2),
            given(soil.y_n_per_m2),
            given(soil.z_n_per_m2),
            given(soil.torsion_n),
            given(soil.rotation_x_n),
            given(soil.rotation_y_n),
        ]);
    }
    table.without_empty_columns().shortened()
}

fn added_mass(which: &str, rows: &[AddedMassRow]) -> Table {
    let mut table = Table::new(
        format!("Added mass{which}; linear between rows"),
        ["#height z (m)", "#mass (kg/m)"],
    );
    for row in rows {
        table.push([length(row.height_m), given(row.mass_kg_per_m)]);
    }
    table.shortened()
}
