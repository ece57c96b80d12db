//! The models of the springs across a pile, one in each file.

mod api;
mod clay;
mod dnv;
mod kallehave;
mod pisa;
mod py_table;
mod reese_stiff_clay;
mod sand;
mod sorensen;
mod vesic;
mod weak_rock;
mod winkler;

use std::sync::LazyLock;

use super::description::Ground;
use super::layer::{GroundLayer, LayerSoil};
use super::layer_springs::LayerSprings;
use super::model::SoilModel;
use super::values::{Made, NoSprings, Values};
use crate::inputs::Named;

/// The springs of a layer by its model.
pub(super) fn springs_of<'l>(values: &mut Values<'l>) -> Made<dyn LayerSprings + 'l> {
    let make = match values.layer.model {
        SoilModel::Api => api::springs,
        SoilModel::Dnv => dnv::springs,
        SoilModel::ReeseStiffClay => reese_stiff_clay::springs,
        SoilModel::Kallehave => kallehave::springs,
        SoilModel::Sorensen => sorensen::springs,
        SoilModel::PisaCowden => pisa::cowden,
        SoilModel::PisaBothkennar => pisa::bothkennar,
        SoilModel::PisaDunkirk => pisa::dunkirk,
        SoilModel::Winkler => winkler::springs,
        SoilModel::Vesic => vesic::springs,
        SoilModel::WeakRock => weak_rock::springs,
        SoilModel::Table => py_table::springs,
    };
    make(values)
}

/// The models that have a formula for each kind of soil: "sand: api, dnv; clay: api".
static BY_SOIL: LazyLock<String> = LazyLock::new(|| {
    let ground = Ground::new(0.0, Vec::new());
    let of_soil = |soil: LayerSoil| {
        let kind = soil.kind();
        let has_formula = |model: &SoilModel| {
            let layer = GroundLayer::new([0.0, -1.0], soil.clone(), *model);
            let springs = springs_of(&mut Values::new(&layer, &ground));
            !matches!(springs, Err(NoSprings::OtherSoil))
        };
        // The model of a table follows from its type, so users do not choose it.
        let models = SoilModel::CHOICES.iter().copied();
        let models = models.filter(|model| *model != SoilModel::Table && has_formula(model));
        let names: Vec<&str> = models.map(SoilModel::name).collect();
        (!names.is_empty()).then(|| format!("{kind}: {}", names.join(", ")))
    };
    let soils: Vec<String> = LayerSoil::blanks()
        .into_iter()
        .filter_map(of_soil)
        .collect();
    soils.join("; ")
});

/// The models that have a formula for each kind of soil, in a sentence.
pub(in crate::tower) fn models_by_soil() -> &'static str {
    &BY_SOIL
}
