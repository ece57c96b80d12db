//! Rigid bodies in tables: point masses and the rotor-nacelle assembly.

use towermodes::{Inertia, Rna, TowerDescription};

use super::super::table::Table;
use crate::number::{given, length};

pub(super) fn point_masses(description: &TowerDescription) -> Table {
    let mut table = Table::new(
        "Point masses on the tower axis; moments of inertia about their centres of mass, Ixz = −∫ x z dm",
        [
            "#height z (m)",
            "#mass (kg)",
            "#Ixx (kg m²)",
            "#Iyy (kg m²)",
            "#Izz (kg m²)",
            "#Ixy (kg m²)",
            "#Ixz (kg m²)",
            "#Iyz (kg m²)",
        ],
    );
    for mass in &description.point_masses {
        let mut row = vec![length(mass.height_m), given(mass.mass_kg)];
        row.extend(inertia(&mass.inertia_kg_m2).map(|(_, value)| value));
        table.push(row);
    }
    let names = &description.part_names.point_masses;
    table.without_empty_columns().named(names).shortened()
}

/// The entries of an inertia tensor with their names.
pub(super) fn inertia(inertia: &Inertia) -> [(&'static str, String); 6] {
    [
        ("Ixx (kg m²)", given(inertia.xx)),
        ("Iyy (kg m²)", given(inertia.yy)),
        ("Izz (kg m²)", given(inertia.zz)),
        ("Ixy (kg m²)", given(inertia.xy)),
        ("Ixz (kg m²)", given(inertia.xz)),
        ("Iyz (kg m²)", given(inertia.yz)),
    ]
}

pub(super) fn rna(rna: &Rna) -> Table {
    let [x, y, z] = rna.center_m;
    let mut facts = vec![
        ("mass (kg)", given(rna.mass_kg)),
        ("centre of mass relative to the tower top, x (m)", length(x)),
        ("centre of mass relative to the tower top, y (m)", length(y)),
        ("centre of mass relative to the tower top, z (m)", length(z)),
    ];
    facts.extend(inertia(&rna.inertia_kg_m2));
    Table::of_facts(
        "Rotor-nacelle assembly; moments of inertia about its centre of mass, Ixz = −∫ x z dm",
        facts,
    )
}
