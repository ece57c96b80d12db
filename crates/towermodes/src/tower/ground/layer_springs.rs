//! The common interface of the models of springs; the facts about each model are in its own file.

use std::fmt;

use super::spot::Spot;
use crate::tower::warning::{Site, Warning};

/// The springs of one layer on the pile, by a model.
///
/// A new model is a file in `models/` with a struct, this trait and a function that makes the
/// struct from the values of a layer; its name in [`SoilModel`](super::SoilModel), and its function
/// in the list of [`springs_of`](super::models::springs_of). The checks of what it needs, warnings
/// of what it does not use, the reader, the writer and the report follow.
pub(in crate::tower) trait LayerSprings: fmt::Debug {
    /// Springs across the pile per length, N/m².
    fn lateral_n_per_m2(&self, spot: &Spot<'_>) -> f64;

    /// The values on which the springs depend.
    fn nature(&self) -> Nature;

    /// Springs against rotation about x and y per length, N; most models have none.
    fn rotation_n(&self, _: &Spot<'_>) -> f64 {
        0.0
    }

    /// Springs under the tip against sliding, N/m, and rocking, N m; most models have none.
    fn at_tip(&self, _: &Spot<'_>) -> [f64; 2] {
        [0.0; 2]
    }

    /// A value that changes its sign where the formula changes, for each such change (numbered from
    /// 0); none for other numbers. At most [`KINKS`].
    fn kink(&self, _number: usize, _: &Spot<'_>) -> Option<f64> {
        None
    }

    /// The piles for which the model was derived, if these are limited.
    fn piles(&self) -> Option<Piles> {
        None
    }

    /// Warns about values of the layer for which the model was not derived, and about values that
    /// it does not use although other models of its kind do. Limits of single values are checked
    /// elsewhere.
    fn doubt(&self, _at: &dyn Fn(&'static str) -> Site, _: &mut Vec<Warning>) {}
}

/// Largest number of changes of a formula inside a layer.
pub(super) const KINKS: usize = 2;

/// The values on which the springs of a layer depend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::tower) struct Nature {
    /// Whether they are linear in height between the rows of the tower, for all values of the layer
    /// and any taper of the pile.
    pub(in crate::tower) is_linear: bool,
    /// Whether they depend on the weight of the soil above.
    pub(in crate::tower) needs_weight: bool,
    /// Whether they depend on the edition of the standard of API.
    pub(in crate::tower) depends_on_edition: bool,
}

/// The springs of one layer along and about the axis of the pile, by the axial model of the ground.
pub(in crate::tower) trait AxialSprings: fmt::Debug {
    /// Springs per length of the shaft against z, N/m², and against torsion, N.
    fn along(&self, spot: &Spot<'_>) -> [f64; 2];

    /// Springs under the tip against z, N/m, and against torsion, N m.
    fn at_tip(&self, spot: &Spot<'_>) -> [f64; 2];

    /// The values on which the springs depend.
    fn nature(&self) -> Nature;

    /// A value that changes its sign where the formula changes; none if it does not change.
    fn kink(&self, _: &Spot<'_>) -> Option<f64> {
        None
    }
}

/// The piles for which a model was derived.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::tower) struct Piles {
    /// The model, as in "the model of PISA".
    pub(in crate::tower) formula: &'static str,
    /// Smallest and largest diameter, m.
    pub(in crate::tower) diameters_m: [f64; 2],
    /// Smallest and largest embedded length over the diameter.
    pub(in crate::tower) lengths: [f64; 2],
    /// Whether the model requires a pile with shear deformation.
    pub(in crate::tower) need_shear: bool,
    /// Suggestion if the pile is outside these ranges.
    pub(in crate::tower) remedy: &'static str,
}
