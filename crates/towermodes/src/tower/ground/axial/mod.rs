//! The models of the springs along and about the axis of a pile, one in each file.

mod api;
mod kraft;
mod randolph_wroth;

use super::description::AxialModel;
use super::layer_springs::AxialSprings;
use super::values::{Made, Values};

/// The axial springs of a layer by the axial model that the layer names; none if it names no model.
pub(super) fn axial_springs_of(values: &mut Values<'_>) -> Option<Made<dyn AxialSprings>> {
    let make = match values.ground.axial? {
        AxialModel::Api => api::springs,
        AxialModel::Kraft => kraft::springs,
        AxialModel::RandolphWroth => randolph_wroth::springs,
    };
    Some(make(values))
}
