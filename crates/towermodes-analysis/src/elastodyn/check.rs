//! The limits of the values of ElastoDyn's tower model and its modes.

use super::model::{MAX_NODES, ModelError, PlaneModes, TowerModel};

impl TowerModel {
    /// Refuses models that ElastoDyn refuses, or that its formulas cannot represent.
    pub(super) fn check(&self) -> Result<(), ModelError> {
        let nodes = self.nodes;
        if !(1..=MAX_NODES).contains(&nodes) {
            return Err(ModelError::Nodes { nodes });
        }
        self.check_heights()?;
        let factors = self.stiffness_factors;
        positive("the length of the flexible tower", self.flexible_length_m)?;
        positive("the factor of the masses", self.mass_factor)?;
        positive("a factor of the stiffnesses", factors.fore_aft)?;
        positive("a factor of the stiffnesses", factors.side_side)?;
        not_negative("the mass on top of the tower", self.tower_top_mass_kg)?;
        not_negative("gravity", self.gravity_m_per_s2)?;
        for station in &self.stations {
            positive("a mass per length", station.mass_kg_per_m)?;
            positive("a bending stiffness", station.bending_n_m2.fore_aft)?;
            positive("a bending stiffness", station.bending_n_m2.side_side)?;
        }
        for mass in &self.concentrated_masses {
            not_negative("a concentrated mass", mass.mass_kg)?;
            let value = mass.height_fraction;
            if !(0.0..=1.0).contains(&value) {
                let what = "the height of a concentrated mass";
                return Err(ModelError::Quantity { what, value });
            }
        }
        Ok(())
    }

    fn check_heights(&self) -> Result<(), ModelError> {
        let rows = self.stations.len();
        let mut below = f64::NEG_INFINITY;
        for (row, station) in (1..).zip(&self.stations) {
            let height_fraction = station.height_fraction;
            let is_first = height_fraction == 0.0 || row > 1;
            let is_last = height_fraction == 1.0 || row < rows;
            if !(is_first && is_last && height_fraction > below) {
                return Err(ModelError::Heights {
                    row,
                    height_fraction,
                });
            }
            below = height_fraction;
        }
        match rows {
            0 | 1 => Err(ModelError::Rows { rows }),
            _ => Ok(()),
        }
    }
}

/// Refuses shapes, tuners and damping out of range.
pub(super) fn check_modes(modes: &PlaneModes) -> Result<(), ModelError> {
    for (shape, (tuner, damping)) in
        (modes.shapes.iter()).zip(modes.tuners.into_iter().zip(modes.damping_percent))
    {
        for value in shape.coefficients {
            if !value.is_finite() {
                let what = "a coefficient of a shape";
                return Err(ModelError::Quantity { what, value });
            }
        }
        positive("a stiffness tuner of a mode", tuner)?;
        not_negative("the damping of a mode", damping)?;
    }
    Ok(())
}

fn positive(what: &'static str, value: f64) -> Result<(), ModelError> {
    if value > 0.0 && value.is_finite() {
        Ok(())
    } else {
        Err(ModelError::Quantity { what, value })
    }
}

fn not_negative(what: &'static str, value: f64) -> Result<(), ModelError> {
    if value >= 0.0 && value.is_finite() {
        Ok(())
    } else {
        Err(ModelError::Quantity { what, value })
    }
}
