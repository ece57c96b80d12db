//! Checks that the models of a layer suit its soil and have the values that they need.

use super::{Checked, Layer};
use crate::tower::error::Problem;
use crate::tower::ground::{Ground, Models, NoSprings, Refused, models_by_soil};
use crate::tower::validate::scale::error;

impl<'a> Layer<'a> {
    /// The models of the layer, after these checks.
    pub(super) fn models(&self, ground: &'a Ground) -> Checked<Models<'a>> {
        let soil = self.own.soil.noun();
        let axial = ground.axial.map_or("", |axial| axial.key_and_name());
        let (across, user) = (self.own.model.name(), axial);
        match Models::of(self.own, ground) {
            Ok(models) => Ok(models),
            Err(Refused::Across(NoSprings::OtherSoil)) => {
                let problem = Problem::ModelOfOtherSoil {
                    model: across,
                    soil,
                    suited: models_by_soil(),
                };
                error(self.at("model"), problem)
            }
            Err(Refused::Axial(NoSprings::OtherSoil)) => error(
                self.at("type"),
                Problem::AxialOfOtherSoil { model: user, soil },
            ),
            Err(Refused::Across(NoSprings::Missing { key, value })) => {
                let problem = Problem::SoilValueMissing {
                    value,
                    user: across,
                };
                error(self.at(key), problem)
            }
            Err(Refused::Axial(NoSprings::Missing { key, value })) => {
                error(self.at(key), Problem::SoilValueMissing { value, user })
            }
        }
    }
}
