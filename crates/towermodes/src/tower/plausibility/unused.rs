//! Values of a layer of soil that its models do not use.

use crate::inputs::{Given, given_inputs};
use crate::tower::Ineffective;
use crate::tower::ground::{GroundLayer, Models};

/// The keys that only an axial model uses.
const AXIAL: [&str; 2] = ["shaft_friction", "end_bearing"];
/// The weight of a layer loads the layers below.
const ALWAYS_USED: &str = "effective_unit_weight";

/// The given values of a layer that its models do not use.
pub(super) fn of(layer: &GroundLayer, models: &Models<'_>) -> Vec<(&'static str, Ineffective)> {
    let used = &models.used;
    let unused = given(layer).filter(|key| *key != ALWAYS_USED && !used.contains(key));
    let why = |key| match AXIAL.contains(&key) {
        true => (key, Ineffective::KeyOfAxialModel(key)),
        false => (key, Ineffective::KeyOfOtherModel(key)),
    };
    unused.map(why).collect()
}

/// The keys of the optional values that are given in a layer; of a shear modulus the first key.
fn given(layer: &GroundLayer) -> impl Iterator<Item = &'static str> {
    let modulus = layer.shear_modulus.map(|modulus| modulus.key());
    let is_given = move |key: &str, given: Given| match given {
        Given::Optional(value) => value.is_some(),
        Given::Pair(pair) => pair.is_some(),
        Given::Number(_) => modulus == Some(key),
        Given::Triple(_) | Given::Count(_) | Given::Flag(_) | Given::Name(..) => false,
    };
    let values = given_inputs(layer).into_iter();
    let given = values.filter(move |(input, value)| is_given(input.key, *value));
    given.map(|(input, _)| input.key)
}
