//! Checks of the given values of a layer, whether its model needs them or not.

use super::{Checked, Layer};
use crate::tower::error::{Place, Problem};
use crate::tower::ground::{CorrelatedSoil, LayerSoil, PyRow, ShearModulus};
use crate::tower::validate::inputs::check_inputs;
use crate::tower::validate::scale::{coordinate, error, length, not_negative};

impl Layer<'_> {
    /// Checks the given values, whether the model needs them or not.
    pub(super) fn check_values(&self) -> Checked {
        check_inputs(self.own, |key| self.at(key))?;
        if let Some(modulus) = &self.own.shear_modulus {
            self.check_correlation(modulus)?;
        }
        if let Some(ShearModulus::Youngs { .. }) = &self.own.shear_modulus {
            let user = "the shear modulus by Young's modulus";
            let is_there = self.own.poissons_ratio.is_some();
            self.needs("poissons_ratio", "Poisson's ratio", user, is_there)?;
        }
        match &self.own.soil {
            LayerSoil::Table(rows) => self.check_table(rows),
            LayerSoil::Sand(_) | LayerSoil::Clay(_) | LayerSoil::Elastic | LayerSoil::Rock(_) => {
                Ok(())
            }
        }
    }

    /// Checks that rows cover the layer from top to bottom.
    fn check_table(&self, rows: &[PyRow]) -> Checked {
        let layer = self.index;
        let at = |row, key| Place::GroundRow { layer, row, key };
        if rows.len() < 2 {
            let (what, count) = ("the table of the layer", rows.len());
            return error(self.at("rows"), Problem::TooFewRows { what, count });
        }
        for (row, own) in rows.iter().enumerate() {
            coordinate(at(row, "height"), "height", own.height_m)?;
            length(
                at(row, "displacement"),
                "the displacement",
                own.displacement_m,
            )?;
            let (what, reaction) = ("the reaction", own.reaction_n_per_m);
            not_negative(at(row, "reaction"), what, reaction, " N/m")?;
            if row > 0 && rows[row - 1].height_m <= own.height_m {
                let problem = Problem::TableRowsRise {
                    height_m: own.height_m,
                    previous_m: rows[row - 1].height_m,
                };
                return error(at(row, "height"), problem);
            }
        }
        let (first_m, last_m) = (rows[0].height_m, rows[rows.len() - 1].height_m);
        let (top_m, bottom_m) = (self.own.top_m, self.own.bottom_m);
        if first_m >= top_m && last_m <= bottom_m {
            return Ok(());
        }
        let problem = Problem::TableShorterThanLayer {
            first_m,
            last_m,
            top_m,
            bottom_m,
        };
        error(at(0, "height"), problem)
    }

    /// Checks that a correlation suits the soil. For an elastic layer and a table the soil is not
    /// known, so every correlation is possible.
    fn check_correlation(&self, modulus: &ShearModulus) -> Checked {
        let (correlation, own, is_right) = match modulus.own_soil() {
            None => return Ok(()),
            Some(CorrelatedSoil::Sand(name)) => {
                (name, "sand", !matches!(self.own.soil, LayerSoil::Clay(_)))
            }
            Some(CorrelatedSoil::Clay(name)) => {
                (name, "clay", !matches!(self.own.soil, LayerSoil::Sand(_)))
            }
        };
        if is_right {
            return Ok(());
        }
        let key = modulus
            .correlation()
            .map_or(modulus.key(), |_| "correlation");
        let soil = self.own.soil.noun();
        let problem = Problem::CorrelationOfOtherSoil {
            correlation,
            own,
            soil,
        };
        error(self.at(key), problem)
    }
}
