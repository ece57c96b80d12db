//! The input values of the tower: materials, stations, properties.

use super::part::{Indices, Key, Part, fields, is_there};
use crate::inputs::Nature;
use crate::tower::{Foundation, Material, Place, Properties, Shear, TowerDescription};

/// `[material]`: the only material.
pub(super) static MATERIAL: Part = Part {
    name: "material",
    noun: "material",
    count: |d| usize::from(d.materials.len() == 1),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: &MATERIAL_KEYS,
};

/// `[materials.NAME]`, several.
pub(super) static MATERIALS: Part = Part {
    name: "materials[]",
    noun: "materials",
    count: |d| match d.materials.len() {
        1 => 0,
        several => several,
    },
    rows: |_, _| 1,
    is_symmetric: false,
    keys: &MATERIAL_KEYS,
};

static MATERIAL_KEYS: [Key; 4] = [
    Key {
        name: "density",
        unit: "kg/m3",
        meaning: "density",
        nature: Nature::Size,
        place: |i| of_material(i, "density"),
        get: |d, i| Some(material(d, i)?.density_kg_per_m3),
        set: |d, i, value| {
            d.materials.get_mut(i[0])?.density_kg_per_m3 = value;
            renew_members(d)
        },
        is_listed: is_there,
    },
    Key {
        name: "youngs_modulus",
        unit: "Pa",
        meaning: "Young's modulus",
        nature: Nature::Size,
        place: |i| of_material(i, "youngs_modulus"),
        get: |d, i| Some(material(d, i)?.youngs_modulus_pa),
        set: |d, i, value| {
            d.materials.get_mut(i[0])?.set_youngs_modulus(value);
            renew_members(d)
        },
        is_listed: is_there,
    },
    Key {
        name: "shear_modulus",
        unit: "Pa",
        meaning: "shear modulus",
        nature: Nature::Size,
        place: |i| of_material(i, "shear_modulus"),
        get: |d, i| Some(material(d, i)?.shear_modulus_pa),
        set: |d, i, value| {
            let material = d.materials.get_mut(i[0])?;
            material.shear_modulus_pa = value;
            material.given_poissons_ratio = None;
            renew_members(d)
        },
        is_listed: |d, i| material(d, i).is_some_and(|m| m.given_poissons_ratio.is_none()),
    },
    Key {
        name: "poissons_ratio",
        unit: "",
        meaning: "Poisson's ratio",
        nature: Nature::Signed,
        place: |i| of_material(i, "shear_modulus"),
        get: |d, i| {
            let material = material(d, i)?;
            let given = material.given_poissons_ratio;
            Some(given.unwrap_or_else(|| material.poissons_ratio()))
        },
        set: |d, i, value| {
            let material = d.materials.get_mut(i[0])?;
            material.given_poissons_ratio = Some(value);
            material.set_youngs_modulus(material.youngs_modulus_pa);
            renew_members(d)
        },
        is_listed: |d, i| material(d, i).is_some_and(|m| m.given_poissons_ratio.is_some()),
    },
];

/// Updates the materials of the members of a frame, which are those of the tower.
fn renew_members(description: &mut TowerDescription) -> Option<()> {
    if let Foundation::Frame(foundation) = &mut description.foundation {
        foundation.take_materials(&description.materials);
    }
    Some(())
}

fn material(description: &TowerDescription, indices: Indices) -> Option<&Material> {
    description.materials.get(indices[0])
}

fn of_material(indices: Indices, key: &'static str) -> Place {
    Place::Material {
        index: indices[0],
        key,
    }
}

/// `[tower]`.
pub(super) static TOWER: Part = Part {
    name: "tower",
    noun: "tower",
    count: |_| 1,
    rows: |_, _| 1,
    is_symmetric: false,
    keys: &[
        Key {
            name: "outfitting_factor",
            unit: "",
            meaning: "multiplies the tower's masses per length",
            nature: Nature::Size,
            place: |_| Place::OutfittingFactor,
            get: |d, _| Some(d.outfitting_factor),
            set: |d, _, value| {
                d.outfitting_factor = value;
                Some(())
            },
            is_listed: is_there,
        },
        Key {
            name: "shear",
            unit: "",
            meaning: "shear coefficient",
            nature: Nature::Size,
            place: |_| Place::Shear,
            get: |d, _| match d.shear {
                Shear::Coefficient(coefficient) => Some(coefficient),
                Shear::Rigid | Shear::Cowper => None,
            },
            set: |d, _, value| match &mut d.shear {
                Shear::Coefficient(coefficient) => {
                    *coefficient = value;
                    Some(())
                }
                Shear::Rigid | Shear::Cowper => None,
            },
            is_listed: |d, _| matches!(d.shear, Shear::Coefficient(_)),
        },
    ],
};

/// `stations` of `[tower]`.
pub(super) static STATIONS: Part = Part {
    name: "stations[]",
    noun: "stations",
    count: |d| d.stations.len(),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: fields! {
        get |d, i| d.stations.get(i[0])?;
        set |d, i| d.stations.get_mut(i[0])?;
        place |i, key| Place::Station { index: i[0], key };
        "height" Height "m" "height", "height" height_m;
        "diameter" Size "m" "outer diameter", "diameter" outer_diameter_m;
        "wall" Size "m" "wall thickness", "wall" wall_thickness_m;
    },
};

/// `[tower.properties]`.
pub(super) static PROPERTIES: Part = Part {
    name: "properties[]",
    noun: "table of section properties",
    count: |d| d.properties.len(),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: &PROPERTY_KEYS,
};

/// A column of the table of section properties.
macro_rules! column {
    ($name:literal $unit:literal $meaning:literal, $($field:tt)+) => {
        Key {
            name: $name,
            unit: $unit,
            meaning: $meaning,
            nature: Nature::Amount,
            place: |i| Place::Station { index: i[0], key: $name },
            get: |d, i| Some(section(d, i)?.$($field)+),
            set: |d, i, value| {
                d.properties.get_mut(i[0])?.properties.$($field)+ = value;
                Some(())
            },
            is_listed: is_there,
        }
    };
}

/// A column of shear stiffness, which is optional.
macro_rules! shear_column {
    ($name:literal $meaning:literal, $plane:ident) => {
        Key {
            name: $name,
            unit: "N",
            meaning: $meaning,
            nature: Nature::Amount,
            place: |i| Place::Station {
                index: i[0],
                key: $name,
            },
            get: |d, i| Some(section(d, i)?.shear_n?.$plane),
            set: |d, i, value| {
                let section = &mut d.properties.get_mut(i[0])?.properties;
                section.shear_n.as_mut()?.$plane = value;
                Some(())
            },
            is_listed: |d, i| section(d, i).is_some_and(|section| section.shear_n.is_some()),
        }
    };
}

#[rustfmt::skip]
static PROPERTY_KEYS: [Key; 11] = [
    Key {
        name: "z_m",
        unit: "m",
        meaning: "height",
        nature: Nature::Signed,
        place: |i| Place::Station { index: i[0], key: "height" },
        get: |d, i| Some(d.properties.get(i[0])?.height_m),
        set: |d, i, value| {
            d.properties.get_mut(i[0])?.height_m = value;
            Some(())
        },
        is_listed: is_there,
    },
    column!("mass_kg_per_m" "kg/m" "mass per length", mass_kg_per_m),
    column!("ei_fore_aft_n_m2" "N m2" "fore-aft bending stiffness EI", bending_n_m2.fore_aft),
    column!("ei_side_side_n_m2" "N m2" "side-side bending stiffness EI", bending_n_m2.side_side),
    column!("gj_n_m2" "N m2" "torsional stiffness GJ", torsion_n_m2),
    column!("ea_n" "N" "axial stiffness EA", axial_n),
    column!("polar_inertia_kg_m" "kg m" "inertia per length about the axis", polar_inertia_kg_m),
    column!(
        "rotary_inertia_fore_aft_kg_m" "kg m" "inertia per length in fore-aft bending",
        rotary_inertia_kg_m.fore_aft
    ),
    column!(
        "rotary_inertia_side_side_kg_m" "kg m" "inertia per length in side-side bending",
        rotary_inertia_kg_m.side_side
    ),
    shear_column!("shear_stiffness_fore_aft_n" "fore-aft shear stiffness kappa GA", fore_aft),
    shear_column!("shear_stiffness_side_side_n" "side-side shear stiffness kappa GA", side_side),
];

fn section(description: &TowerDescription, indices: Indices) -> Option<&Properties> {
    Some(&description.properties.get(indices[0])?.properties)
}
