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

use super::layer_springs::LayerSprings;
use super::model::SoilModel;
use super::values::{Made, Values};

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
