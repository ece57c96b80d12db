//! The input as a drawing and in tables.

use towermodes::TowerDescription;

use super::super::content::ReportContent;
use super::super::document::Block;
use super::super::table::Table;
use super::bodies::{point_masses, rna};
use super::foundation::foundation;
use super::surroundings::surroundings;
use super::{inputs, own_picture, paragraph, table, tabulated_picture};
use crate::figures;
use crate::number::{NOTHING, digits, given, length, mass};
use crate::wording::speed_range;

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let description = &content.description;
    let mut blocks = vec![
        paragraph(
            "Values with more than six significant digits are rounded: lengths of 1 m and more to the nearest millimetre, other values from \
             10 000 to 1 000 000 to a whole number, all others to four significant digits. The input files at the end of the report have \
             all digits.",
        ),
        tabulated_picture(figures::tower(description, &content.tower), "tower"),
        table(overview(content)),
        Block::Heading("Tower".to_owned()),
    ];
    if description.stations.is_empty() {
        blocks.push(table(properties(description)));
    } else {
        blocks.push(table(materials(description)));
        blocks.push(table(stations(description)));
    }
    if !description.point_masses.is_empty() {
        blocks.push(table(point_masses(description)));
    }
    if !description.rna.is_absent() {
        blocks.push(Block::Heading("Rotor-nacelle assembly".to_owned()));
        blocks.push(table(rna(&description.rna)));
    }
    blocks.push(Block::Heading("Foundation".to_owned()));
    blocks.extend(foundation(description, &content.tower));
    blocks.extend(figures::mooring(description, &content.tower).map(own_picture));
    blocks.extend(surroundings(description, &content.tower));
    blocks
}

fn overview(content: &ReportContent) -> Table {
    let (tower, description) = (&content.tower, &content.description);
    let mut facts = vec![
        ("name", described(tower.name())),
        (
            "base and top (m)",
            format!("{} to {}", length(tower.base_m()), length(tower.top_m())),
        ),
        ("height (m)", length(tower.height_m())),
        (
            "mass of the structure without RNA, including point masses",
            mass(tower.mass_kg()),
        ),
        (
            "mass of the rotor-nacelle assembly (RNA)",
            mass(description.rna.mass_kg),
        ),
        (
            "outfitting factor (−)",
            given(description.outfitting_factor),
        ),
        ("gravity (m/s²)", given(description.gravity_m_per_s2)),
    ];
    if !tower.point_masses().is_empty() {
        let masses_kg = tower.point_masses().iter().map(|one| one.mass_kg);
        facts.insert(4, ("of this, point masses", mass(masses_kg.sum())));
    }
    if let Some(rotor) = &description.rotor {
        facts.push(("number of blades (input file)", rotor.blades.to_string()));
        facts.push((
            "operating rotor speed (input file, rpm)",
            speed_range(rotor),
        ));
    }
    if let Some(missing) = tower.missing_parts() {
        facts.push(("limits of the model", missing.to_string()));
    }
    let mut table = Table::of_facts("Overview", facts);
    for (name, value) in inputs::facts(&description.damping) {
        table.push([name, value]);
    }
    let of_materials = description.damping.loss_factors.materials.iter();
    if let Some(largest) = of_materials.flatten().copied().reduce(f64::max) {
        let name = "largest loss factor of a named material (−)";
        table.push([name.to_owned(), given(largest)]);
    }
    table
}

fn described(name: &str) -> String {
    if name.trim().is_empty() {
        NOTHING.to_owned()
    } else {
        name.to_owned()
    }
}

fn materials(description: &TowerDescription) -> Table {
    let mut table = Table::new(
        "Materials",
        [
            "#material",
            "#density ρ (kg/m³)",
            "#Young's modulus E (Pa)",
            "#shear modulus G (Pa)",
            "#Poisson's ratio ν (−)",
        ],
    );
    for (number, material) in (1..).zip(&description.materials) {
        table.push([
            format!("{number}"),
            given(material.density_kg_per_m3),
            given(material.youngs_modulus_pa),
            given(material.shear_modulus_pa),
            digits(material.poissons_ratio(), 4),
        ]);
    }
    let names = &description.part_names.materials;
    table.named(names).shortened()
}

fn stations(description: &TowerDescription) -> Table {
    let mut table = Table::new(
        "Stations from the base to the top; values are linear between stations; two stations at the same height define a step",
        [
            "#height z (m)",
            "#outer diameter (m)",
            "#wall thickness (mm)",
            "#D/t (−)",
            "#material above",
        ],
    );
    for station in &description.stations {
        table.push([
            length(station.height_m),
            length(station.outer_diameter_m),
            given(1000.0 * station.wall_thickness_m),
            digits(station.outer_diameter_m / station.wall_thickness_m, 4),
            material(description, station.material),
        ]);
    }
    table.shortened()
}

/// The number of a material, with its name if it has one.
fn material(description: &TowerDescription, index: usize) -> String {
    let name = description.part_names.materials.get(index);
    match name.map(|name| name.trim()) {
        None | Some("") => (index + 1).to_string(),
        Some(name) => format!("{}, {name}", index + 1),
    }
}

fn properties(description: &TowerDescription) -> Table {
    let mut table = Table::new(
        "Section properties from the base to the top (FA: fore-aft, SS: side-side)",
        [
            "#height z (m)",
            "#mass (kg/m)",
            "#rotary inertia FA (kg m)",
            "#rotary inertia SS (kg m)",
            "#polar inertia (kg m)",
            "#EI FA (N m²)",
            "#EI SS (N m²)",
            "#GJ (N m²)",
            "#EA (N)",
            "#κGA FA (N)",
            "#κGA SS (N)",
        ],
    );
    for row in &description.properties {
        let p = &row.properties;
        let shear = |value: Option<f64>| value.map_or("rigid".to_owned(), given);
        table.push([
            length(row.height_m),
            given(p.mass_kg_per_m),
            given(p.rotary_inertia_kg_m.fore_aft),
            given(p.rotary_inertia_kg_m.side_side),
            given(p.polar_inertia_kg_m),
            given(p.bending_n_m2.fore_aft),
            given(p.bending_n_m2.side_side),
            given(p.torsion_n_m2),
            given(p.axial_n),
            shear(p.shear_n.map(|shear| shear.fore_aft)),
            shear(p.shear_n.map(|shear| shear.side_side)),
        ]);
    }
    table.without_empty_columns().shortened()
}
