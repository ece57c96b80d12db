//! The values of a layer for its model.

use super::description::Ground;
use super::layer::{Clay, GroundLayer, LayerSoil, Sand};
use super::modulus::Modulus;
use super::shear_modulus::ShearModulus;

/// Why a layer has no springs by a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::tower) enum NoSprings {
    /// The model has no formula for the kind of soil.
    OtherSoil,
    /// A value is not given.
    Missing {
        /// Its key in the tower file.
        key: &'static str,
        /// Its name in words.
        value: &'static str,
    },
}

/// A model made from the values of a layer.
pub(super) type Made<T> = Result<Box<T>, NoSprings>;

/// The values of a layer, from which a model takes those that it needs.
#[derive(Debug)]
pub(super) struct Values<'l> {
    pub(super) layer: &'l GroundLayer,
    pub(super) ground: &'l Ground,
    /// The keys of the values that were taken.
    pub(super) used: Vec<&'static str>,
}

impl<'l> Values<'l> {
    pub(super) fn new(layer: &'l GroundLayer, ground: &'l Ground) -> Self {
        let used = Vec::new();
        Self {
            layer,
            ground,
            used,
        }
    }

    /// A value that the model uses where it is given.
    pub(super) fn optional<T>(&mut self, key: &'static str, given: Option<T>) -> Option<T> {
        self.used.push(key);
        given
    }

    /// A value that the model needs.
    pub(super) fn needed<T>(
        &mut self,
        key: &'static str,
        value: &'static str,
        given: Option<T>,
    ) -> Result<T, NoSprings> {
        self.optional(key, given)
            .ok_or(NoSprings::Missing { key, value })
    }

    /// The values of sand.
    pub(super) fn sand(&self) -> Result<&'l Sand, NoSprings> {
        match &self.layer.soil {
            LayerSoil::Sand(sand) => Ok(sand),
            _ => Err(NoSprings::OtherSoil),
        }
    }

    /// The values of clay.
    pub(super) fn clay(&self) -> Result<&'l Clay, NoSprings> {
        match &self.layer.soil {
            LayerSoil::Clay(clay) => Ok(clay),
            _ => Err(NoSprings::OtherSoil),
        }
    }

    /// Whether the layer is soil, and neither rock nor a table of measured curves.
    pub(super) fn is_soil(&self) -> bool {
        match &self.layer.soil {
            LayerSoil::Sand(_) | LayerSoil::Clay(_) | LayerSoil::Elastic => true,
            LayerSoil::Rock(_) | LayerSoil::Table(_) => false,
        }
    }

    /// Poisson's ratio.
    pub(super) fn poissons_ratio(&mut self) -> Result<f64, NoSprings> {
        let ratio = self.layer.poissons_ratio;
        self.needed("poissons_ratio", "Poisson's ratio", ratio)
    }

    /// The shear modulus at small strains; that of rock follows from its Young's modulus.
    pub(super) fn shear_modulus(&mut self) -> Result<Modulus, NoSprings> {
        let of_rock = match &self.layer.soil {
            LayerSoil::Rock(rock) => rock.youngs_modulus_pa,
            _ => None,
        };
        let of_rock = of_rock.map(|youngs_modulus_pa| ShearModulus::Youngs { youngs_modulus_pa });
        let given = self.layer.shear_modulus;
        let key = given.map_or("shear_modulus", |modulus| modulus.key());
        let source = self.needed(key, "the shear modulus", given.or(of_rock))?;
        let ShearModulus::Youngs { .. } = source else {
            return Ok(Modulus::new(source, None));
        };
        let value = match given {
            None => {
                "Poisson's ratio, by which the shear modulus of rock follows from youngs_modulus"
            }
            Some(_) => "Poisson's ratio",
        };
        let ratio = self.needed("poissons_ratio", value, self.layer.poissons_ratio)?;
        Ok(Modulus::new(source, Some(ratio)))
    }
}
