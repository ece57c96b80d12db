//! Damping data that replace those of a description.

use thiserror::Error;
use towermodes::{RotorAerodynamics, TowerDescription, TowerError};

/// Damping data that replace those of a description; none for data that are not replaced.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GivenDamping {
    /// Loss factors by part: `tower`, `substructure`, `foundation`, `soil`, `wires`, `water` or the
    /// name of a material.
    pub loss_factors: Vec<(String, f64)>,
    /// ∫ c r dr over one blade, m³.
    pub chord_moment_m3: Option<f64>,
    /// Slope of the lift coefficient, 1/rad.
    pub lift_slope: Option<f64>,
    /// Density of air, kg/m³.
    pub air_density_kg_per_m3: Option<f64>,
}

/// Why damping data cannot replace those of a description.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum GivenDampingError {
    /// A loss factor for an unknown part, or for a material that this tower does not have.
    #[error("a loss factor is given for the unknown part `{name}`; {}", parts(.materials))]
    NoPart {
        /// Name of the part or material.
        name: String,
        /// The names of the materials of the tower.
        materials: Vec<String>,
    },
    /// Lift slope or density of air is given, but not the chords of the blades.
    #[error("the lift slope and the density of air have no effect without the chord moment")]
    NoChords,
    /// A value that is impossible for damping data.
    #[error("{}", .0.problem)]
    Value(TowerError),
}

/// The parts that may have a loss factor, as text.
fn parts(materials: &[String]) -> String {
    let named = materials.iter().filter(|name| !name.is_empty());
    let named: Vec<String> = named.take(20).map(|name| format!("`{name}`")).collect();
    let parts = "choose tower, substructure, foundation, soil, wires or water";
    match named.is_empty() {
        true => parts.to_owned(),
        false => format!("{parts}, or one of the materials {}", named.join(", ")),
    }
}

impl GivenDamping {
    /// Sets the data in a description.
    ///
    /// # Errors
    /// [`GivenDampingError`]; the description may then contain some of the data.
    ///
    /// # Example
    /// ```
    /// use towermodes::TowerDescription;
    /// use towermodes_analysis::damping::GivenDamping;
    ///
    /// let mut description = TowerDescription::default();
    /// let given = GivenDamping {
    ///     loss_factors: vec![("soil".to_owned(), 0.02)],
    ///     ..GivenDamping::default()
    /// };
    /// given.set(&mut description)?;
    /// assert_eq!(description.damping.loss_factors.soil, Some(0.02));
    /// # Ok::<(), towermodes_analysis::damping::GivenDampingError>(())
    /// ```
    pub fn set(&self, description: &mut TowerDescription) -> Result<(), GivenDampingError> {
        for (part, value) in &self.loss_factors {
            set_loss_factor(description, part, *value)?;
        }
        let damping = &mut description.damping;
        if let Some(chord_moment_m3) = self.chord_moment_m3 {
            let rotor = damping
                .rotor
                .get_or_insert(RotorAerodynamics::of_chords(0.0));
            rotor.chord_moment_m3 = chord_moment_m3;
        }
        match (
            &mut damping.rotor,
            self.lift_slope.or(self.air_density_kg_per_m3),
        ) {
            (Some(rotor), _) => {
                let RotorAerodynamics {
                    lift_slope,
                    air_density_kg_per_m3,
                    ..
                } = rotor;
                *lift_slope = self.lift_slope.unwrap_or(*lift_slope);
                let given = self.air_density_kg_per_m3;
                *air_density_kg_per_m3 = given.unwrap_or(*air_density_kg_per_m3);
            }
            (None, Some(_)) => return Err(GivenDampingError::NoChords),
            (None, None) => {}
        }
        damping.validate().map_err(GivenDampingError::Value)
    }
}

fn set_loss_factor(
    description: &mut TowerDescription,
    part: &str,
    value: f64,
) -> Result<(), GivenDampingError> {
    let factors = &mut description.damping.loss_factors;
    let own = match part {
        "tower" => &mut factors.tower,
        "substructure" => &mut factors.substructure,
        "foundation" => &mut factors.foundation,
        "soil" => &mut factors.soil,
        "wires" => &mut factors.wires,
        "water" => &mut factors.water,
        name => {
            let materials = &description.part_names.materials;
            let index = materials.iter().position(|own| own == name);
            let index = index.ok_or_else(|| GivenDampingError::NoPart {
                name: name.to_owned(),
                materials: materials.clone(),
            })?;
            let count = factors.materials.len().max(index + 1);
            factors.materials.resize(count, None);
            &mut factors.materials[index]
        }
    };
    *own = Some(value);
    Ok(())
}
