//! Whether the models of a layer are for its soil, and have the numbers that they need.

use super::{Checked, Layer};
use crate::tower::error::Problem;
use crate::tower::ground::{AxialModel, Clay, LayerSoil, SoilModel};
use crate::tower::validate::scale::error;

impl Layer<'_> {
    /// Whether the model is one for this soil, and has the numbers that it needs.
    pub(super) fn check_model(&self) -> Checked {
        let model = self.own.model;
        match (&self.own.soil, model) {
            (LayerSoil::Sand(sand), SoilModel::Api | SoilModel::Dnv | SoilModel::Kallehave) => {
                let is_there = sand
                    .friction_angle_deg
                    .or(sand.subgrade_modulus_n_per_m3)
                    .is_some();
                self.needs(
                    "friction_angle",
                    "the friction angle or the subgrade modulus",
                    model.name(),
                    is_there,
                )
            }
            (LayerSoil::Sand(sand), SoilModel::Sorensen) => {
                let is_there = sand.friction_angle_deg.is_some();
                self.needs(
                    "friction_angle",
                    "the friction angle",
                    model.name(),
                    is_there,
                )
            }
            (LayerSoil::Sand(sand), SoilModel::PisaDunkirk) => {
                let is_there = sand.relative_density.is_some();
                self.needs(
                    "relative_density",
                    "the relative density",
                    model.name(),
                    is_there,
                )?;
                self.needs_modulus(false)
            }
            (
                LayerSoil::Clay(clay),
                SoilModel::Api | SoilModel::Dnv | SoilModel::ReeseStiffClay,
            ) => self.check_model_of_clay(clay),
            (LayerSoil::Clay(_), SoilModel::PisaCowden | SoilModel::PisaBothkennar) => {
                self.needs_modulus(false)
            }
            (
                LayerSoil::Sand(_) | LayerSoil::Clay(_) | LayerSoil::Elastic,
                SoilModel::Winkler | SoilModel::Vesic,
            ) => self.needs_modulus(true),
            (LayerSoil::Rock(rock), SoilModel::WeakRock) => {
                let is_there = rock.youngs_modulus_pa.is_some();
                self.needs(
                    "youngs_modulus",
                    "Young's modulus of the rock",
                    model.name(),
                    is_there,
                )
            }
            (LayerSoil::Table(_), SoilModel::Table) => Ok(()),
            (soil, _) => {
                let (model, soil) = (model.name(), soil.noun());
                error(self.at("model"), Problem::ModelOfOtherSoil { model, soil })
            }
        }
    }

    fn check_model_of_clay(&self, clay: &Clay) -> Checked {
        let user = self.own.model.name();
        let strength = clay.undrained_strength_pa.is_some();
        self.needs(
            "undrained_strength",
            "the undrained strength",
            user,
            strength,
        )?;
        let strain = clay.strain_at_half_strength.is_some();
        let value = "the strain at half the strength";
        self.needs("strain_at_half_strength", value, user, strain)?;
        let factor = self.own.model == SoilModel::ReeseStiffClay || clay.strength_factor.is_some();
        self.needs(
            "strength_factor",
            "the factor J (0.5 for soft, 0.25 for stiff clay)",
            user,
            factor,
        )?;
        let value = "the factor of the initial stiffness (10 for normally consolidated, 30 for overconsolidated clay)";
        let is_there = self.own.model != SoilModel::Dnv || clay.stiffness_factor.is_some();
        self.needs("stiffness_factor", value, user, is_there)
    }

    fn needs_modulus(&self, and_ratio: bool) -> Checked {
        let user = self.own.model.name();
        let is_there = self.own.shear_modulus.is_some();
        self.needs("shear_modulus", "the shear modulus", user, is_there)?;
        let is_there = !and_ratio || self.own.poissons_ratio.is_some();
        self.needs("poissons_ratio", "Poisson's ratio", user, is_there)
    }

    pub(super) fn check_axial(&self, axial: Option<AxialModel>) -> Checked {
        let Some(model) = axial else {
            return Ok(());
        };
        let user = model.key_and_name();
        match model {
            AxialModel::Api => {
                match &self.own.soil {
                    LayerSoil::Sand(_) | LayerSoil::Clay(_) => {}
                    LayerSoil::Elastic | LayerSoil::Rock(_) | LayerSoil::Table(_) => {
                        let (model, soil) = (user, self.own.soil.noun());
                        return error(self.at("type"), Problem::AxialOfOtherSoil { model, soil });
                    }
                }
                let is_there = self.own.shaft_friction_pa.is_some();
                self.needs("shaft_friction", "the shaft friction", user, is_there)
            }
            AxialModel::Kraft => self.needs_axial_modulus(user, false),
            AxialModel::RandolphWroth => self.needs_axial_modulus(user, true),
        }
    }

    /// That of rock is its Young's modulus over 2 (1 + ν).
    fn needs_axial_modulus(&self, user: &'static str, and_ratio: bool) -> Checked {
        let is_rock = match &self.own.soil {
            LayerSoil::Rock(_) => true,
            LayerSoil::Sand(_) | LayerSoil::Clay(_) | LayerSoil::Elastic | LayerSoil::Table(_) => {
                let is_there = self.own.shear_modulus.is_some();
                self.needs("shear_modulus", "the shear modulus", user, is_there)?;
                false
            }
        };
        let value = match is_rock {
            true => {
                "Poisson's ratio, by which the shear modulus of rock follows from youngs_modulus"
            }
            false => "Poisson's ratio",
        };
        let is_there = !(is_rock || and_ratio) || self.own.poissons_ratio.is_some();
        self.needs("poissons_ratio", value, user, is_there)
    }
}
