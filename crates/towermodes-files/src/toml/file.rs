//! The whole file: its sections, and the tower that they describe.

use towermodes::{Foundation, PartNames, TowerDescription};

use super::foundation::foundation;
use super::ground::{default_foundation, ground};
use super::mooring::mooring;
use super::schema;
use super::substructure::substructure;
use super::tables::added_mass::added_mass;
use super::tables::damping::damping;
use super::tables::drivetrain::drivetrain;
use super::tables::gravity::gravity;
use super::tables::masses::{is_point_mass, point_masses, rna};
use super::tables::materials::{Materials, materials};
use super::tables::missing_parts::missing_parts;
use super::tables::properties::properties;
use super::tables::rotor::rotor;
use super::tables::soil::soil;
use super::tables::stations::{outfitting_factor, shear, stations};
use super::tables::water::water;
use super::tables::wires::wires;
use super::text::reading::Reading;
use super::text::table::Table;
use super::text::values::text;
use super::turbine::turbine;

/// The whole file.
pub(super) fn description(root: &Table<'_>, reading: &mut Reading) -> Option<TowerDescription> {
    let name = root.get("name").and_then(|v| text(v, "name", reading));
    let has_properties = root
        .get("tower")
        .and_then(|tower| tower.get_ref().as_table())
        .is_some_and(|tower| tower.contains_key("properties"));
    let has_materials = root.get("material").is_some() || root.get("materials").is_some();
    let on_members = root.get("substructure").is_some();
    // A table of properties needs no material, but members under it may.
    let needs_materials = !has_properties || (on_members && has_materials);
    let materials = needs_materials.then(|| materials(root, reading));
    let around = around(root, reading);
    let names = match &materials {
        Some(materials) => materials.as_ref().map(|materials| &materials.names[..]),
        None => Some(&[][..]),
    };
    let damping = damping(root, names, reading);
    let of_members = materials.as_ref().and_then(Option::as_ref);
    let substructure = substructure(root, of_members, reading);
    let mooring = mooring(
        root,
        around.as_ref().map(|around| around.gravity_m_per_s2),
        reading,
    );
    let hint = "add [tower] with stations = [[height, diameter, wall], ...]";
    let value = root.require("tower", hint, reading)?;
    let tower = Table::of(value, "[tower]", &schema::TOWER, reading)?;
    let body = match (materials, has_properties) {
        (Some(materials), false) => of_tubes(&tower, materials, reading),
        (materials, _) => of_properties(root, &tower, materials, reading),
    };
    let (mut around, body) = (around?, body?);
    if let Some(mut frame) = substructure? {
        if let (Some(restoring), Foundation::Floating(platform)) =
            (&mut frame.restoring, around.foundation)
        {
            restoring.platform = *platform;
        }
        around.foundation = Foundation::Frame(Box::new(frame));
    }
    if let (Some(mooring), Some(platform)) = (mooring?, around.foundation.floating_mut()) {
        let names = &mut around.part_names;
        names.mooring_line_types = mooring.line_type_names;
        names.mooring_points = mooring.point_names;
        names.mooring_lines = mooring.line_names;
        platform.mooring_lines = Some(Box::new(mooring.lines));
    }
    Some(TowerDescription {
        name: name.unwrap_or_default().to_owned(),
        stations: body.stations,
        properties: body.properties,
        materials: body.materials,
        shear: body.shear,
        outfitting_factor: outfitting_factor(&tower, reading)?,
        damping: damping?,
        part_names: PartNames {
            materials: body.part_names.materials,
            ..around.part_names
        },
        ..around
    })
}

/// Everything except the tower itself: its foundation and surroundings, the bodies on it, gravity.
fn around(root: &Table<'_>, reading: &mut Reading) -> Option<TowerDescription> {
    let (foundation, soil) = (foundation(root, reading), soil(root, reading));
    let ground = ground(root, reading);
    let added_mass = added_mass(root, reading);
    let (water, wires) = (water(root, reading), wires(root, reading));
    let (gravity, rotor) = (gravity(root, reading), rotor(root, reading));
    let drivetrain = drivetrain(root, reading);
    let missing_parts = missing_parts(root, reading);
    let turbine = turbine(root, rotor.as_ref().and_then(Option::as_ref), reading);
    let rna = root.get("rna").and_then(|value| rna(value, reading));
    let rna_is_point = is_point_mass(root, rna.as_ref());
    let (point_masses, point_mass_names) = point_masses(root, reading)?;
    let ((soil, soil_names), (wires, wires_names)) = (soil?, wires?);
    let (added_mass, added_mass_names) = added_mass?;
    let (ground, ground_names) = ground?.unzip();
    let rna = match turbine? {
        Some((turbine, as_body)) => {
            reading.turbine = Some(turbine);
            Some(as_body)
        }
        None => rna,
    };
    let of_tip = ground
        .as_ref()
        .and_then(|ground| default_foundation(root, ground, reading));
    Some(TowerDescription {
        rna: rna.unwrap_or_default(),
        rna_is_point,
        point_masses,
        foundation: of_tip.or(foundation)?,
        soil,
        ground,
        added_mass,
        water: water?,
        wires,
        gravity_m_per_s2: gravity?,
        rotor: rotor?,
        drivetrain: drivetrain?,
        missing_parts: missing_parts?,
        part_names: PartNames {
            point_masses: point_mass_names,
            soil: soil_names,
            ground: ground_names.unwrap_or_default(),
            added_mass: added_mass_names,
            wires: wires_names,
            ..PartNames::default()
        },
        ..TowerDescription::default()
    })
}

/// A tower of tubes: materials, stations and shear.
fn of_tubes(
    tower: &Table<'_>,
    materials: Option<Materials>,
    reading: &mut Reading,
) -> Option<TowerDescription> {
    let stations = stations(tower, materials.as_ref(), reading);
    let shear = shear(tower, reading);
    let materials = materials?;
    Some(TowerDescription {
        stations: stations?,
        part_names: PartNames {
            materials: materials.own_names(),
            ..PartNames::default()
        },
        materials: materials.list,
        shear: shear?,
        ..TowerDescription::default()
    })
}

/// Hints on keys of tubes in a file with a table of properties.
const NOT_NEEDED: &str = "remove it: the table has the masses and the stiffness";
const SHEAR_COLUMNS: &str = "give the table the columns shear_stiffness_fore_aft_n and shear_stiffness_side_side_n (kappa GA, N)";

/// A tower with a table of properties; keys of tubes are refused.
fn of_properties(
    root: &Table<'_>,
    tower: &Table<'_>,
    materials: Option<Option<Materials>>,
    reading: &mut Reading,
) -> Option<TowerDescription> {
    let of_tubes = [
        (tower, "stations", "keep one of the two"),
        (tower, "shear", SHEAR_COLUMNS),
        (root, "material", NOT_NEEDED),
        (root, "materials", NOT_NEEDED),
    ];
    // Members are made of them.
    let refused = if materials.is_some() { 2 } else { 4 };
    for (table, key, hint) in of_tubes.into_iter().take(refused) {
        table.refuse_unused(key, "together with [tower.properties]", hint, reading);
    }
    let value = tower.require("properties", "", reading)?;
    let properties = properties(value, reading);
    let materials = materials.unwrap_or_else(|| Some(Materials::default()))?;
    Some(TowerDescription {
        properties: properties?,
        part_names: PartNames {
            materials: materials.own_names(),
            ..PartNames::default()
        },
        materials: materials.list,
        ..TowerDescription::default()
    })
}
