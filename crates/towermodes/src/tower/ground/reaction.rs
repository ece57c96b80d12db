//! A pile with the springs of the layers around it.

use super::super::parts::surroundings::SoilStiffness;
use super::axial::axial_springs_of;
use super::description::Ground;
use super::layer::GroundLayer;
use super::layer_springs::{AxialSprings, LayerSprings, Nature};
use super::models::springs_of;
use super::pile::Pile;
use super::spot::Spot;
use super::values::{NoSprings, Values};
use crate::inputs::{Given, given_inputs};
use crate::tower::description::TowerDescription;

/// The springs of one layer by its models.
#[derive(Debug)]
pub(in crate::tower) struct Models<'l> {
    /// The springs across the pile.
    pub(in crate::tower) across: Box<dyn LayerSprings + 'l>,
    /// The springs along the pile; none without an axial model.
    axial: Option<Box<dyn AxialSprings>>,
    /// The keys of the values that the models use.
    pub(in crate::tower) used: Vec<&'static str>,
}

/// The model that has no springs for a layer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::tower) enum Refused {
    /// The model of the layer.
    Across(NoSprings),
    /// The axial model of the ground.
    Axial(NoSprings),
}

impl<'l> Models<'l> {
    /// The models of a layer of the ground.
    pub(in crate::tower) fn of(
        layer: &'l GroundLayer,
        ground: &'l Ground,
    ) -> Result<Self, Refused> {
        let mut values = Values::new(layer, ground);
        let across = springs_of(&mut values).map_err(Refused::Across)?;
        let axial = axial_springs_of(&mut values).transpose();
        Ok(Self {
            across,
            axial: axial.map_err(Refused::Axial)?,
            used: values.used,
        })
    }

    fn natures(&self) -> impl Iterator<Item = Nature> {
        let axial = self.axial.as_ref().map(|axial| axial.nature());
        [Some(self.across.nature()), axial].into_iter().flatten()
    }
}

impl Ground {
    /// Whether springs across the pile depend on the [edition](Self::edition) of the standard of
    /// API: the springs of sand whose modulus k follows from its friction angle.
    pub fn modulus_depends_on_edition(&self) -> bool {
        self.models()
            .any(|models| models.across.nature().depends_on_edition)
    }

    /// Whether springs along the pile depend on the [edition](Self::edition): springs of sand by
    /// API.
    pub fn axial_depends_on_edition(&self) -> bool {
        let mut axial = self.models().filter_map(|models| models.axial);
        axial.any(|axial| axial.nature().depends_on_edition)
    }

    /// Whether a spring depends on the [edition](Self::edition).
    pub fn depends_on_edition(&self) -> bool {
        self.modulus_depends_on_edition() || self.axial_depends_on_edition()
    }

    /// The keys of the given values of a layer that its models do not use. The weight of a layer
    /// is used, because it loads the layers below.
    pub fn unused_values(&self, index: usize) -> Vec<&'static str> {
        let layer = self.layers.get(index);
        let models = layer.and_then(|layer| Models::of(layer, self).ok());
        match layer.zip(models) {
            Some((layer, models)) => layer.unused_values(&models),
            None => Vec::new(),
        }
    }

    /// The models of the layers whose required values are given.
    fn models(&self) -> impl Iterator<Item = Models<'_>> {
        let layers = self.layers.iter();
        layers.filter_map(|layer| Models::of(layer, self).ok())
    }
}

/// The weight of a layer loads the layers below.
const ALWAYS_USED: &str = "effective_unit_weight";

impl GroundLayer {
    /// The keys of the given values that the models of the layer do not use.
    pub(in crate::tower) fn unused_values(&self, models: &Models<'_>) -> Vec<&'static str> {
        let used = &models.used;
        let given = self.given_values();
        let unused = given.filter(|key| *key != ALWAYS_USED && !used.contains(key));
        unused.collect()
    }

    /// The keys of the optional values that are given; of a shear modulus the first key.
    fn given_values(&self) -> impl Iterator<Item = &'static str> {
        let modulus = self.shear_modulus.map(|modulus| modulus.key());
        let is_given = move |key: &str, given: Given| match given {
            Given::Optional(value) => value.is_some(),
            Given::Pair(pair) => pair.is_some(),
            Given::Number(_) => modulus == Some(key),
            Given::Triple(_) | Given::Count(_) | Given::Flag(_) | Given::Name(..) => false,
        };
        let values = given_inputs(self).into_iter();
        let given = values.filter(move |(input, value)| is_given(input.key, *value));
        given.map(|(input, _)| input.key)
    }
}

/// A pile with the models of its layers.
#[derive(Debug)]
pub(super) struct Reactions<'a> {
    pub(super) pile: Pile<'a>,
    /// None for a layer without the required values; the checks refuse such a layer.
    models: Vec<Option<Models<'a>>>,
}

impl<'a> Reactions<'a> {
    /// The pile of a tower with ground.
    pub(super) fn of(description: &'a TowerDescription) -> Option<Self> {
        let pile = Pile::of(description)?;
        let layers = pile.ground.layers.iter();
        let models = layers.map(|layer| Models::of(layer, pile.ground).ok());
        Some(Self {
            models: models.collect(),
            pile,
        })
    }

    fn spot(&self, index: usize, height_m: f64) -> Spot<'_> {
        Spot {
            pile: &self.pile,
            index,
            height_m,
        }
    }

    /// The springs of a layer at a height of the pile, with the factors on the soil; NaN for a
    /// layer that the checks refuse.
    pub(super) fn springs(&self, index: usize, height_m: f64) -> SoilStiffness {
        let Some(models) = &self.models[index] else {
            return SoilStiffness::from_values([f64::NAN; SoilStiffness::SPRINGS]);
        };
        let spot = self.spot(index, height_m);
        let lateral = models.across.lateral_n_per_m2(&spot);
        let rotation = models.across.rotation_n(&spot);
        let axial = models.axial.as_ref();
        let [vertical, torsion] = axial.map_or([0.0; 2], |axial| axial.along(&spot));
        let springs = SoilStiffness {
            x_n_per_m2: lateral,
            y_n_per_m2: lateral,
            z_n_per_m2: vertical,
            torsion_n: torsion,
            rotation_x_n: rotation,
            rotation_y_n: rotation,
        };
        springs.times(self.pile.factor(index))
    }

    /// Stiffness of the soil of a layer under the tip against x, y, z and the rotations about
    /// them: N/m, N m.
    pub(super) fn at_tip(&self, index: usize) -> [f64; 6] {
        let Some(Some(models)) = self.models.get(index) else {
            return [f64::NAN; 6];
        };
        let spot = self.spot(index, self.pile.tip_m);
        let [shear, moment] = models.across.at_tip(&spot);
        let axial = models.axial.as_ref();
        let [vertical, torsion] = axial.map_or([0.0; 2], |axial| axial.at_tip(&spot));
        let springs = [shear, shear, vertical, moment, moment, torsion];
        springs.map(|spring| spring * self.pile.factor(index))
    }

    /// Whether the springs of a layer are linear in height between the rows of the tower, for all
    /// values of the layer and any taper of the pile.
    pub(super) fn are_linear(&self, index: usize) -> bool {
        let models = self.models[index].as_ref();
        models.is_some_and(|models| models.natures().all(|nature| nature.is_linear))
    }

    /// A value that changes its sign where the springs across the pile change their formula.
    pub(super) fn kink(&self, index: usize, number: usize, height_m: f64) -> Option<f64> {
        let models = self.models[index].as_ref()?;
        models.across.kink(number, &self.spot(index, height_m))
    }

    /// A value that changes its sign where the axial springs change their formula.
    pub(super) fn axial_kink(&self, index: usize, height_m: f64) -> Option<f64> {
        let axial = self.models[index].as_ref()?.axial.as_ref()?;
        axial.kink(&self.spot(index, height_m))
    }
}
