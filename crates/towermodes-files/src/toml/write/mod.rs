//! A description of a tower as a TOML file.

mod bodies;
mod damping;
mod foundation;
mod ground;
mod inputs;
mod materials;
mod mooring;
mod properties;
mod substructure;
mod surroundings;
mod text;
mod turbine;
mod writing;

use towermodes::turbine::TurbineDescription;
use towermodes::{MissingPart, Shear, Station, TowerDescription};

use super::schema;
use crate::note::Note;
use crate::turbine::is_rigid_body_of;
use materials::MaterialNames;
pub(super) use text::number;
use text::quoted;
use writing::Writing;

/// Writes a description as a TOML file that is read back as the same description, with equal
/// numbers.
///
/// The notes list data that such a file cannot store, and data that its reader will refuse.
pub fn write_toml(description: &TowerDescription) -> (String, Vec<Note>) {
    write_toml_with(description, None)
}

/// Writes a description with the turbine in place of the rotor-nacelle assembly, if the assembly is
/// the turbine as a rigid body, except for rounding.
pub fn write_toml_with(
    description: &TowerDescription,
    turbine: Option<&TurbineDescription>,
) -> (String, Vec<Note>) {
    let turbine = turbine.filter(|turbine| can_be_written(turbine, description));
    let listed = substructure::with_listed_materials(description);
    let description = listed.as_ref().unwrap_or(description);
    let mut writing = Writing::default();
    writing.line("# A tower for towermodes. Lengths in m, masses in kg, forces in N; z is up, x fore-aft (downwind), y side-side.");
    if !description.name.is_empty() {
        writing.line("");
        writing.commented("name", &quoted(&description.name), "");
    }
    missing_parts(&description.missing_parts, &mut writing);
    tower(description, &mut writing);
    match turbine {
        Some(turbine) => turbine::turbine(turbine, &mut writing),
        None => bodies::rna(&description.rna, description.rna_is_point, &mut writing),
    }
    bodies::rotor(description.rotor.as_ref(), &mut writing);
    bodies::drivetrain(description.drivetrain.as_ref(), &mut writing);
    let names = &description.part_names.point_masses;
    bodies::point_masses(&description.point_masses, names, &mut writing);
    foundation::foundation(description, &mut writing);
    if let Some(ground) = &description.ground {
        ground::ground(ground, &description.part_names.ground, &mut writing);
    }
    surroundings::surroundings(description, &mut writing);
    let names = MaterialNames::of(description);
    damping::damping(&description.damping, &names, &mut writing);
    (writing.text, writing.notes)
}

/// Whether a file with the turbine describes the same tower.
pub(crate) fn can_be_written(turbine: &TurbineDescription, description: &TowerDescription) -> bool {
    let rotor = description.rotor.as_ref();
    let is_same_rotor = rotor.is_none_or(|rotor| rotor.blades == turbine.blades);
    let has_own_drivetrain = description.drivetrain.is_some();
    is_same_rotor && !has_own_drivetrain && is_rigid_body_of(turbine, &description.rna)
}

/// Writes the parts that the source of the tower has and the file lacks, with a warning.
fn missing_parts(parts: &[MissingPart], writing: &mut Writing) {
    if parts.is_empty() {
        return;
    }
    let names: Vec<String> = parts.iter().map(|part| quoted(part.name())).collect();
    writing.line("");
    writing.line("# WARNING: the source of this tower has parts that are not in this file. The frequencies are those of the structure without these parts.");
    writing.line("# Remove the next line only after these parts are described below.");
    writing.line(format!("missing_parts = [{}]", names.join(", ")));
}

/// `[material]`, `[materials]` and `[tower]`.
fn tower(description: &TowerDescription, writing: &mut Writing) {
    let has_stations = !description.stations.is_empty() || description.properties.is_empty();
    let names = MaterialNames::of(description);
    if has_stations || description.foundation.frame().is_some() {
        materials::materials(&description.materials, &names, writing);
    }
    if !has_stations {
        unused_beside_properties(description, writing);
    }
    writing.section(&schema::TOWER);
    if has_stations {
        stations(&description.stations, &names, writing);
        shear(description.shear, writing);
    }
    if description.outfitting_factor != 1.0 {
        writing.number("outfitting_factor", description.outfitting_factor);
    }
    if !description.properties.is_empty() {
        if has_stations {
            writing.note("the description has both stations and a table of properties: the file will be refused");
        }
        properties::properties(&description.properties, writing);
    }
}

/// Notes materials and a shear model, which have no effect with a table of properties and are not
/// allowed in such a file.
fn unused_beside_properties(description: &TowerDescription, writing: &mut Writing) {
    let count = description.materials.len();
    // Members are made of them.
    if count > 0 && description.foundation.frame().is_none() {
        writing.note(format!(
            "the materials ({count}) are left out: the table of properties has the masses and the stiffness"
        ));
    }
    if description.shear != Shear::Rigid {
        let message = "the shear model is left out: it is for stations; the table of properties has its own shear stiffness or none";
        writing.note(message);
    }
}

fn stations(stations: &[Station], names: &MaterialNames, writing: &mut Writing) {
    let row = |station: &Station| {
        let numbers = [
            station.height_m,
            station.outer_diameter_m,
            station.wall_thickness_m,
        ];
        let numbers = numbers.into_iter().map(number);
        numbers
            .chain(names.in_row(station.material))
            .collect::<Vec<_>>()
    };
    let cells: Vec<_> = stations.iter().map(row).collect();
    let material = if names.are_needed() { "; material" } else { "" };
    let comment = writing.comment("stations");
    writing.line(format!("stations = [  # {comment}{material}"));
    writing.rows(&cells);
    writing.line("]");
}

fn shear(shear: Shear, writing: &mut Writing) {
    match shear {
        Shear::Rigid => {}
        Shear::Cowper => {
            writing.commented("shear", "true", "Timoshenko, Cowper's coefficient");
        }
        Shear::Coefficient(kappa) => {
            writing.commented("shear", &number(kappa), "Timoshenko, this coefficient");
        }
    }
}
