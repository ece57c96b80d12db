//! The input values of soil in layers.

use super::part::{Part, fields};
use super::table::Table;
use crate::inputs::{Inputs, given_inputs};
use crate::tower::{Ground, GroundLayer, LayerSoil, Place, PyRow, TowerDescription};

/// `[ground]`.
pub(super) static GROUND: Table = Table {
    name: "ground",
    noun: "ground",
    kind: "",
    get: |d, i, _| {
        let ground = d.ground.as_ref().filter(|_| i[0] == 0);
        ground.map(|ground| ground as &dyn Inputs)
    },
    get_mut: |d, _, _| d.ground.as_mut().map(|ground| ground as &mut dyn Inputs),
    every: |_| given_inputs(&Ground::blank()),
    place: |_, key| Place::Ground { key },
    absent: |_| None,
};

/// `[[ground.layer]]`.
pub(super) static LAYERS: Table = Table {
    name: "ground.layer[]",
    noun: "layers of the ground",
    kind: "",
    get: |d, i, _| Some(d.ground.as_ref()?.layers.get(i[0])?),
    get_mut: |d, i, _| Some(d.ground.as_mut()?.layers.get_mut(i[0])?),
    every: |_| GroundLayer::every_input(&LayerSoil::blanks()),
    place: |i, key| Place::GroundLayer { index: i[0], key },
    absent: |_| None,
};

/// The rows of a `[[ground.layer]]` of type `py`.
pub(super) static ROWS: Part = Part {
    name: "ground.layer[].rows[]",
    noun: "layers with p-y curves",
    count: |d| d.ground.as_ref().map_or(0, |ground| ground.layers.len()),
    rows: |d, layer| table(d, layer).map_or(0, <[_]>::len),
    is_symmetric: false,
    keys: fields! {
        get |d, i| table(d, i[0])?.get(i[1])?;
        set |d, i| table_mut(d, i[0])?.get_mut(i[1])?;
        place |i, key| Place::GroundRow { layer: i[0], row: i[1], key };
        "height" Height "m" "height", "height" height_m;
        "displacement" Amount "m" "displacement of the pile", "displacement" displacement_m;
        "reaction" Amount "N/m" "reaction per length", "reaction" reaction_n_per_m;
    },
};

fn table(description: &TowerDescription, layer: usize) -> Option<&[PyRow]> {
    Some(description.ground.as_ref()?.layers.get(layer)?.soil.rows())
}

fn table_mut(description: &mut TowerDescription, layer: usize) -> Option<&mut Vec<PyRow>> {
    match &mut description.ground.as_mut()?.layers.get_mut(layer)?.soil {
        LayerSoil::Table(rows) => Some(rows),
        LayerSoil::Sand(_) | LayerSoil::Clay(_) | LayerSoil::Elastic | LayerSoil::Rock(_) => None,
    }
}
