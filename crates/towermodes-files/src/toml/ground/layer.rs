//! `[[ground.layer]]`: one layer of soil.

use towermodes::inputs::Inputs;
use towermodes::{GroundLayer, LayerSoil, Place, SoilModel};

use super::super::text::kind::{TableKind, kind_of, owners};
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::Value;
use super::model_hint;
use super::shear_modulus::shear_modulus;
use super::soil::{KINDS, py_table};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::places::TABLE;
use crate::toml::inputs::read;

/// A layer whose model may be that of the whole ground.
pub(crate) struct Layer {
    layer: GroundLayer,
    model: Option<SoilModel>,
}

impl Layer {
    /// Heights of top and bottom, m.
    pub(super) fn ends_m(&self) -> [f64; 2] {
        [self.layer.top_m, self.layer.bottom_m]
    }
}

/// A layer with its name.
pub(super) fn layer(
    index: usize,
    value: &Value<'_>,
    reading: &mut Reading,
) -> Option<(Layer, String)> {
    let at = |key| Place::GroundLayer { index, key };
    reading.remember(at(TABLE), value.span());
    let kind = kind_of(value, at("type"), &KINDS, reading)?;
    let elsewhere = |key: &str| {
        let owners = owners(key, &KINDS)?;
        Some(format!(
            "{owners}; this layer is of type \"{}\"",
            kind.name()
        ))
    };
    let table = Table::with_elsewhere(value, "[[ground.layer]]", kind.schema, elsewhere, reading)?;
    let name = table.name_of("a layer's name", reading);
    let modulus = shear_modulus(&table, reading);
    let soil = match kind.blank {
        LayerSoil::Table(_) => py_table(&table, index, reading),
        ref blank => Some(blank.clone()),
    };
    let blank = GroundLayer {
        soil: soil.clone().unwrap_or_else(|| kind.blank.clone()),
        shear_modulus: modulus.unwrap_or_default(),
        ..GroundLayer::blank()
    };
    let layer = read(blank, &table, at, reading);
    let (_, _) = (modulus?, soil?);
    let layer = layer?;
    let is_own = table.get("model").is_some();
    let own = is_own.then_some(layer.model);
    let model = own.or(layer.soil.only_model());
    Some((Layer { layer, model }, name?))
}

/// The layers; layers without a model get the model of the whole ground.
pub(super) fn with_models(
    layers: Vec<Layer>,
    common: Option<SoilModel>,
    ground: &Table<'_>,
    reading: &mut Reading,
) -> Option<Vec<GroundLayer>> {
    if common.is_none() && layers.iter().any(|layer| layer.model.is_none()) {
        let kind = DiagnosticKind::missing_key(ground.name(), "model");
        let mistake = Diagnostic::new(ground.span.clone(), kind);
        return reading.refuse(mistake.with_hint(model_hint()));
    }
    // A model that a layer has from the whole ground is wrong there.
    if let Some(value) = ground.get("model") {
        let without = layers
            .iter()
            .enumerate()
            .filter(|(_, layer)| layer.model.is_none());
        for (index, _) in without {
            let key = "model";
            reading.remember(Place::GroundLayer { index, key }, value.span());
        }
    }
    let with_model = |layer: Layer| GroundLayer {
        model: layer.model.or(common).unwrap_or(layer.layer.model),
        ..layer.layer
    };
    Some(layers.into_iter().map(with_model).collect())
}
