//! Values of a layer of soil that its models do not use.

use crate::tower::ground::{GroundLayer, Models};
use crate::tower::{Ineffective, Site, Warning};

/// The keys that only an axial model uses.
const AXIAL: [&str; 2] = ["shaft_friction", "end_bearing"];

/// Warns of the given values of a layer that its models do not use: once for all of them, because a
/// layer often has the values of several models.
pub(super) fn check(
    layer: &GroundLayer,
    models: &Models<'_>,
    at: impl Fn(&'static str) -> Site,
    warnings: &mut Vec<Warning>,
) {
    let unused = layer.unused_values(models).into_iter();
    let (axial, other): (Vec<_>, Vec<_>) = unused.partition(|key| AXIAL.contains(key));
    let one = |key, what| {
        let site = at(key);
        Warning::NoEffect { site, what }
    };
    warnings.extend(match other[..] {
        [] => None,
        [key] => Some(one(key, Ineffective::KeyOfOtherModel(key))),
        [first, ..] => Some(Warning::UnusedInLayer {
            site: at(first),
            keys: other,
        }),
    });
    let axial = axial.into_iter();
    warnings.extend(axial.map(|key| one(key, Ineffective::KeyOfAxialModel(key))));
}
