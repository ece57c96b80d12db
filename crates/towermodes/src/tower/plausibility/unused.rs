//! Values of a layer of soil that its models do not use.

use crate::tower::Ineffective;
use crate::tower::ground::{GroundLayer, LayerSoil, Models};

/// The keys that only an axial model uses.
const AXIAL: [&str; 2] = ["shaft_friction", "end_bearing"];

/// What a layer has and its models do not use. Its unit weight loads the layers below.
pub(super) fn of(
    layer: &GroundLayer,
    models: Option<&Models<'_>>,
) -> impl Iterator<Item = (&'static str, Ineffective)> {
    let is_used = move |key: &str| models.is_none_or(|models| models.used.contains(&key));
    let unused = given(layer).into_iter().filter(move |key| !is_used(key));
    unused.map(|key| match AXIAL.contains(&key) {
        true => (key, Ineffective::KeyOfAxialModel(key)),
        false => (key, Ineffective::KeyOfOtherModel(key)),
    })
}

/// The keys of the values that a layer has for its models.
fn given(layer: &GroundLayer) -> Vec<&'static str> {
    let modulus = layer.shear_modulus.as_ref();
    let mut values = vec![
        ("poissons_ratio", layer.poissons_ratio.is_some()),
        (
            modulus.map_or("shear_modulus", |modulus| modulus.key()),
            modulus.is_some(),
        ),
    ];
    match &layer.soil {
        LayerSoil::Sand(sand) => values.extend([
            ("friction_angle", sand.friction_angle_deg.is_some()),
            ("subgrade_modulus", sand.subgrade_modulus_n_per_m3.is_some()),
            ("relative_density", sand.relative_density.is_some()),
        ]),
        LayerSoil::Clay(clay) => values.extend([
            ("undrained_strength", clay.undrained_strength_pa.is_some()),
            (
                "strain_at_half_strength",
                clay.strain_at_half_strength.is_some(),
            ),
            ("strength_factor", clay.strength_factor.is_some()),
            ("stiffness_factor", clay.stiffness_factor.is_some()),
        ]),
        LayerSoil::Elastic | LayerSoil::Rock(_) | LayerSoil::Table(_) => {}
    }
    values.extend([
        ("shaft_friction", layer.shaft_friction_pa.is_some()),
        ("end_bearing", layer.end_bearing_pa.is_some()),
    ]);
    let given = values.into_iter().filter(|(_, is_given)| *is_given);
    given.map(|(key, _)| key).collect()
}
