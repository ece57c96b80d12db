//! The input values of soil, added mass, water, guy wires and gravity.

use super::part::{Indices, Key, Part, fields, is_there};
use super::table::Table;
use crate::inputs::{Inputs, Nature, every_input};
use crate::tower::{Place, Planes, TowerDescription, Water, Wires};

/// `[[soil]]`.
pub(super) static SOIL: Part = Part {
    name: "soil[].rows[]",
    noun: "soil",
    count: |d| d.soil.len(),
    rows: |d, layer| d.soil.get(layer).map_or(0, Vec::len),
    is_symmetric: false,
    keys: fields! {
        get |d, i| d.soil.get(i[0])?.get(i[1])?;
        set |d, i| d.soil.get_mut(i[0])?.get_mut(i[1])?;
        place |i, key| Place::Soil { layer: i[0], row: i[1], key };
        "height" Height "m" "height", "height" height_m;
        "x" Amount "N/m2" "spring in x per length", "x" stiffness.x_n_per_m2;
        "y" Amount "N/m2" "spring in y per length", "y" stiffness.y_n_per_m2;
        "z" Amount "N/m2" "spring in z per length", "z" stiffness.z_n_per_m2;
        "torsion" Amount "N" "spring in torsion per length", "torsion" stiffness.torsion_n;
        "rotation_x" Amount "N" "spring against rotation about x per length", "rotation_x" stiffness.rotation_x_n, listed resists_rotation;
        "rotation_y" Amount "N" "spring against rotation about y per length", "rotation_y" stiffness.rotation_y_n, listed resists_rotation;
    },
};

/// `[[added_mass]]`.
pub(super) static ADDED_MASS: Part = Part {
    name: "added_mass[].rows[]",
    noun: "added mass",
    count: |d| d.added_mass.len(),
    rows: |d, table| d.added_mass.get(table).map_or(0, Vec::len),
    is_symmetric: false,
    keys: fields! {
        get |d, i| d.added_mass.get(i[0])?.get(i[1])?;
        set |d, i| d.added_mass.get_mut(i[0])?.get_mut(i[1])?;
        place |i, key| Place::AddedMass { table: i[0], row: i[1], key };
        "height" Height "m" "height", "height" height_m;
        "mass" Amount "kg/m" "added mass per length in x and y", "mass" mass_kg_per_m;
    },
};

/// `[water]`. Without `bed` the seabed is at the lowest station.
pub(super) static WATER: Table = Table {
    name: "water",
    noun: "water",
    kind: "",
    get: |d, i, _| {
        d.water
            .as_ref()
            .filter(|_| i[0] == 0)
            .map(|of| of as &dyn Inputs)
    },
    get_mut: |d, _, _| d.water.as_mut().map(|of| of as &mut dyn Inputs),
    every: |_| every_input(&Water::blank()),
    place: |_, key| Place::Water { key },
    absent: |d| d.stations.first().map(|station| station.height_m),
};

/// `[[wires]]`.
pub(super) static WIRES: Table = Table {
    name: "wires[]",
    noun: "guy wires",
    kind: "",
    get: |d, i, _| Some(d.wires.get(i[0])?),
    get_mut: |d, i, _| Some(d.wires.get_mut(i[0])?),
    every: |_| every_input(&Wires::blank()),
    place: |i, key| Place::Wires { index: i[0], key },
    absent: |_| None,
};

/// `[gravity]`.
pub(super) static GRAVITY: Part = Part {
    name: "gravity",
    noun: "gravity",
    count: |_| 1,
    rows: |_, _| 1,
    is_symmetric: false,
    keys: &[Key {
        name: "acceleration",
        unit: "m/s2",
        meaning: "acceleration of gravity",
        nature: Nature::Amount,
        place: |_| Place::Gravity,
        get: |d, _| Some(d.gravity_m_per_s2),
        set: |d, _, value| {
            let before = std::mem::replace(&mut d.gravity_m_per_s2, value);
            // The mooring lines of a platform have the same gravity, unless they have a value of
            // their own.
            if let Some(platform) = d.foundation.floating_mut()
                && let Some(lines) = &mut platform.mooring_lines
                && lines.description.gravity_m_per_s2 == before
            {
                lines.description.gravity_m_per_s2 = value;
            }
            Some(())
        },
        is_listed: is_there,
    }],
};

/// Whether the layer of a row has rotational springs, which are rarely given.
fn resists_rotation(description: &TowerDescription, indices: Indices) -> bool {
    let rows = description.soil.get(indices[0]).into_iter().flatten();
    let mut rotations = rows.map(|row| row.stiffness.rotation());
    rotations.any(|springs| springs != Planes::default())
}
