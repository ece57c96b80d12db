//! `[[ground.layer]]`: one layer of soil.

use towermodes::inputs::Named;
use towermodes::{GroundLayer, LayerSoil, Place, SoilModel};

use super::model_hint;
use super::shear_modulus::shear_modulus;
use super::soil::KINDS;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::places::TABLE;
use crate::toml::choice::{choices, chosen};
use crate::toml::kind::{kind_of, owners};
use crate::toml::reading::Reading;
use crate::toml::table::Table;
use crate::toml::values::{Value, list, number, wrong_kind};

/// A layer whose model may still be that of the whole ground.
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
        Some(format!("{owners}; this layer is of type \"{}\"", kind.name))
    };
    let table = Table::with_elsewhere(value, "[[ground.layer]]", kind.schema, elsewhere, reading)?;
    let name = table.name_of("a layer's name", reading);
    let hint = "height in m, in the datum of the stations";
    let top = table.required_number("top", hint, at("top"), reading);
    let bottom = table.required_number("bottom", hint, at("bottom"), reading);
    let mut optional = |key: &'static str| table.optional_number(key, at(key), reading);
    let weight = optional("effective_unit_weight");
    let ratio = optional("poissons_ratio");
    let bearing = optional("end_bearing");
    let factor = table.number_or(1.0, "factor", at("factor"), reading);
    let friction = pair(&table, "shaft_friction", at("shaft_friction"), reading);
    let modulus = match kind.has_shear_modulus {
        true => shear_modulus(&table, at, reading),
        false => Some(None),
    };
    let soil = (kind.read)(&table, index, reading);
    let model = own_model(&table, soil.as_ref(), at("model"), reading);
    let model = model?;
    let layer = GroundLayer {
        top_m: top?,
        bottom_m: bottom?,
        soil: soil?,
        model: model.unwrap_or(SoilModel::CHOICES[0]),
        effective_unit_weight_n_per_m3: weight?,
        shear_modulus: modulus?,
        poissons_ratio: ratio?,
        shaft_friction_pa: friction?,
        end_bearing_pa: bearing?,
        factor: factor?,
    };
    Some((Layer { layer, model }, name?))
}

/// The layers, those without a model with the one of the whole ground.
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

/// The model that a layer names, or the only one of its kind.
fn own_model(
    table: &Table<'_>,
    soil: Option<&LayerSoil>,
    place: Place,
    reading: &mut Reading,
) -> Option<Option<SoilModel>> {
    let Some(value) = table.get("model") else {
        return Some(soil.and_then(LayerSoil::only_model));
    };
    reading.remember(place, value.span());
    chosen(value, "soil model", &choices(), reading).map(Some)
}

/// An optional value that is one number, or one at the top and one at the bottom of the layer:
/// `Some(None)` if it is absent, `None` after a mistake.
pub(super) fn pair(
    table: &Table<'_>,
    key: &'static str,
    place: Place,
    reading: &mut Reading,
) -> Option<Option<[f64; 2]>> {
    let Some(value) = table.get(key) else {
        return Some(None);
    };
    reading.remember(place, value.span());
    pair_of(value, key, reading).map(Some)
}

/// A value that is one number, or `[top, bottom]`.
pub(super) fn pair_of(value: &Value<'_>, key: &str, reading: &mut Reading) -> Option<[f64; 2]> {
    if value.get_ref().as_array().is_none() {
        let is_number = value.get_ref().is_float() || value.get_ref().is_integer();
        if !is_number {
            let mistake = wrong_kind(value, key, "a number, or [top, bottom]");
            return reading.refuse(mistake);
        }
        return number(value, key, reading).map(|both| [both; 2]);
    }
    let values = list(value, key, reading)?;
    if values.len() != 2 {
        let kind = DiagnosticKind::wrong_count(key, values.len(), 2);
        let hint = format!("{key} = [at the top, at the bottom of the layer]");
        return reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint));
    }
    let (top, bottom) = (
        number(&values[0], key, reading),
        number(&values[1], key, reading),
    );
    Some([top?, bottom?])
}

/// Kept here for the kinds that have no values of their own.
pub(super) fn elastic(_: &Table<'_>, _: usize, _: &mut Reading) -> Option<LayerSoil> {
    Some(LayerSoil::Elastic)
}
