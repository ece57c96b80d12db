//! The numbers of a layer that are given, whether its model needs them or not.

use super::{Checked, Layer};
use crate::tower::error::{Place, Problem};
use crate::tower::ground::{Clay, CorrelatedSoil, LayerSoil, PyRow, Rock, Sand, ShearModulus};
use crate::tower::validate::scale::{coordinate, error, length, not_negative, positive};

impl Layer<'_> {
    fn positive(
        &self,
        key: &'static str,
        what: &'static str,
        value: f64,
        unit: &'static str,
    ) -> Checked {
        positive(self.at(key), what, value, unit)
    }

    /// A value at the top and one at the bottom of the layer, one of which may be zero.
    fn both(
        &self,
        key: &'static str,
        what: &'static str,
        pair: [f64; 2],
        unit: &'static str,
    ) -> Checked {
        // Strength and stiffness can begin with zero, as those of normally consolidated clay do.
        let [top, bottom] = pair;
        if top == 0.0 && bottom > 0.0 {
            return self.positive(key, what, bottom, unit);
        }
        if bottom == 0.0 && top > 0.0 {
            return self.positive(key, what, top, unit);
        }
        pair.into_iter()
            .try_for_each(|value| self.positive(key, what, value, unit))
    }

    fn within(
        &self,
        key: &'static str,
        quantity: &'static str,
        value: f64,
        unit: &'static str,
        [least, most]: [f64; 2],
    ) -> Checked {
        let problem = match value.is_finite() {
            true if (least..=most).contains(&value) => return Ok(()),
            true => Problem::OutOfRange {
                quantity,
                value,
                unit,
                least,
                most,
            },
            false => Problem::NotFinite { quantity, value },
        };
        error(self.at(key), problem)
    }

    /// The numbers that are given, whether the model needs them or not.
    pub(super) fn check_values(&self) -> Checked {
        let own = self.own;
        if let Some(weight) = own.effective_unit_weight_n_per_m3 {
            self.positive(
                "effective_unit_weight",
                "the effective unit weight",
                weight,
                " N/m3",
            )?;
        }
        self.positive("factor", "the factor on the layer", own.factor, "")?;
        if let Some(ratio) = own.poissons_ratio {
            let what = "Poisson's ratio of the soil";
            self.within("poissons_ratio", what, ratio, "", [0.0, 0.5])?;
        }
        if let Some(pair) = own.shaft_friction_pa {
            self.both("shaft_friction", "the shaft friction", pair, " Pa")?;
        }
        if let Some(bearing) = own.end_bearing_pa {
            self.positive("end_bearing", "the end bearing", bearing, " Pa")?;
        }
        if let Some(modulus) = &own.shear_modulus {
            self.check_shear_modulus(modulus)?;
        }
        match &own.soil {
            LayerSoil::Sand(sand) => self.check_sand(sand),
            LayerSoil::Clay(clay) => self.check_clay(clay),
            LayerSoil::Rock(rock) => self.check_rock(rock),
            LayerSoil::Table(rows) => self.check_table(rows),
            LayerSoil::Elastic => Ok(()),
        }
    }

    fn check_sand(&self, sand: &Sand) -> Checked {
        if let Some(angle_deg) = sand.friction_angle_deg {
            let what = "the friction angle";
            self.positive("friction_angle", what, angle_deg, " degrees")?;
            self.within("friction_angle", what, angle_deg, " degrees", [0.0, 60.0])?;
        }
        if let Some(modulus) = sand.subgrade_modulus_n_per_m3 {
            self.positive("subgrade_modulus", "the subgrade modulus", modulus, " N/m3")?;
        }
        match sand.relative_density {
            Some(density) => {
                let what = "the relative density";
                self.within("relative_density", what, density, "", [0.0, 1.0])
            }
            None => Ok(()),
        }
    }

    fn check_clay(&self, clay: &Clay) -> Checked {
        if let Some(pair) = clay.undrained_strength_pa {
            self.both("undrained_strength", "the undrained strength", pair, " Pa")?;
        }
        let factors = [
            (
                "strain_at_half_strength",
                "the strain at half the strength",
                clay.strain_at_half_strength,
            ),
            (
                "strength_factor",
                "the factor J of the strength",
                clay.strength_factor,
            ),
            (
                "stiffness_factor",
                "the factor of the initial stiffness",
                clay.stiffness_factor,
            ),
        ];
        for (key, what, value) in factors {
            if let Some(value) = value {
                self.positive(key, what, value, "")?;
            }
        }
        match clay.strain_at_half_strength {
            Some(strain) => {
                let (key, what) = ("strain_at_half_strength", "the strain at half the strength");
                self.within(key, what, strain, "", [0.0, 1.0])
            }
            None => Ok(()),
        }
    }

    fn check_rock(&self, rock: &Rock) -> Checked {
        let what = "Young's modulus of the rock";
        let modulus = rock.youngs_modulus_pa;
        modulus.map_or(Ok(()), |pair| {
            self.both("youngs_modulus", what, pair, " Pa")
        })
    }

    /// Rows from the top to the bottom of the layer.
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

    /// A correlation of one soil has no meaning for another. What the soil of an elastic layer
    /// and of a table is, only its user knows.
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
        let key = match modulus {
            ShearModulus::Hardin { .. } => "void_ratio",
            ShearModulus::Given { .. }
            | ShearModulus::Youngs { .. }
            | ShearModulus::WaveVelocity { .. }
            | ShearModulus::RixStokoe { .. }
            | ShearModulus::MayneRix { .. }
            | ShearModulus::RobertsonCabal { .. }
            | ShearModulus::BlowCount { .. } => "correlation",
        };
        let soil = self.own.soil.noun();
        let problem = Problem::CorrelationOfOtherSoil {
            correlation,
            own,
            soil,
        };
        error(self.at(key), problem)
    }

    fn check_shear_modulus(&self, modulus: &ShearModulus) -> Checked {
        self.check_correlation(modulus)?;
        let cone = |pair| self.both("cone_resistance", "the cone resistance", pair, " Pa");
        let density = |value| self.positive("density", "the density of the soil", value, " kg/m3");
        match *modulus {
            ShearModulus::Given { shear_modulus_pa } => {
                let what = "the shear modulus of the soil";
                self.both("shear_modulus", what, shear_modulus_pa, " Pa")
            }
            ShearModulus::Youngs { youngs_modulus_pa } => {
                let what = "Young's modulus of the soil";
                self.both("youngs_modulus", what, youngs_modulus_pa, " Pa")?;
                self.needs(
                    "poissons_ratio",
                    "Poisson's ratio",
                    "the shear modulus by Young's modulus",
                    self.own.poissons_ratio.is_some(),
                )
            }
            ShearModulus::WaveVelocity {
                velocity_m_per_s,
                density_kg_per_m3,
            } => {
                let what = "the velocity of shear waves";
                self.both("shear_wave_velocity", what, velocity_m_per_s, " m/s")?;
                density(density_kg_per_m3)
            }
            ShearModulus::RixStokoe { cone_resistance_pa }
            | ShearModulus::MayneRix { cone_resistance_pa } => cone(cone_resistance_pa),
            ShearModulus::RobertsonCabal {
                cone_resistance_pa,
                behaviour_index,
                density_kg_per_m3,
            } => {
                cone(cone_resistance_pa)?;
                let what = "the soil behaviour type index";
                self.within("behaviour_index", what, behaviour_index, "", [0.5, 5.0])?;
                density(density_kg_per_m3)
            }
            ShearModulus::Hardin {
                void_ratio,
                earth_pressure_at_rest,
            } => {
                self.positive("void_ratio", "the void ratio", void_ratio, "")?;
                let what = "the earth pressure coefficient at rest";
                self.positive("earth_pressure_at_rest", what, earth_pressure_at_rest, "")
            }
            ShearModulus::BlowCount {
                blow_count,
                density_kg_per_m3,
            } => {
                self.both("blow_count", "the blow count", blow_count, "")?;
                density(density_kg_per_m3)
            }
        }
    }
}
