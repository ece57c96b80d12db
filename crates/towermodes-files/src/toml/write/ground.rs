//! `[ground]` and `[[ground.layer]]`.

use towermodes::{Ground, GroundLayer, PyRow};

use super::inputs::values;
use super::writing::Writing;
use crate::toml::schema;

pub(super) fn ground(ground: &Ground, names: &[String], writing: &mut Writing) {
    writing.section(&schema::GROUND);
    values(ground, writing);
    for (index, layer) in ground.layers.iter().enumerate() {
        self::layer(layer, names.get(index), writing);
    }
}

fn layer(layer: &GroundLayer, name: Option<&String>, writing: &mut Writing) {
    writing.section_called("[[ground.layer]]", schema::layer(&layer.soil));
    writing.name(name);
    writing.commented("type", &format!("\"{}\"", layer.soil.kind()), "");
    values(layer, writing);
    if !layer.soil.rows().is_empty() {
        let row = |row: &PyRow| [row.height_m, row.displacement_m, row.reaction_n_per_m];
        let rows: Vec<[f64; 3]> = layer.soil.rows().iter().map(row).collect();
        writing.open_rows("rows");
        writing.number_rows(&rows, 3);
        writing.line("]");
    }
}
