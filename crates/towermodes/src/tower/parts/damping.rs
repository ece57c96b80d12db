//! What dissipates the energy of vibrations: loss factors of the parts, and the rotor in the wind.

/// What dissipates the energy of vibrations. It has no effect on frequencies and mode shapes.
///
/// # Example
/// Steel with a damping ratio of 0.2 %, and soil with 1 %:
/// ```
/// use towermodes::{Damping, LossFactors};
///
/// let damping = Damping {
///     loss_factors: LossFactors {
///         tower: Some(2.0 * 0.002),
///         soil: Some(2.0 * 0.01),
///         ..LossFactors::default()
///     },
///     ..Damping::default()
/// };
/// assert_eq!(damping.loss_factors.of_material(0), Some(0.004));
/// assert_eq!(damping.loss_factors.water, None);
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Damping {
    /// The loss factors of the parts.
    pub loss_factors: LossFactors,
    /// The rotor in the wind; none if it is not known.
    pub rotor: Option<RotorAerodynamics>,
}

/// The loss factors η of the parts of a tower, each the energy that is dissipated per radian of a
/// vibration as a fraction of the part's largest strain energy; none where it is not known.
///
/// η = 2ζ = δ/π, with ζ the damping ratio and δ the logarithmic decrement of a vibration in which
/// the part has all the energy.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LossFactors {
    /// Of the materials without a loss factor of their own, and of a table of properties.
    pub tower: Option<f64>,
    /// Of the materials, in their order in the description; it may be shorter.
    pub materials: Vec<Option<f64>>,
    /// Of the foundation.
    pub foundation: Option<f64>,
    /// Of the soil springs along the tower.
    pub soil: Option<f64>,
    /// Of the guy wires.
    pub wires: Option<f64>,
    /// Of the water, as a fraction of its largest kinetic energy.
    pub water: Option<f64>,
}

impl LossFactors {
    /// That of a material, by its index; none if it is not known.
    pub fn of_material(&self, index: usize) -> Option<f64> {
        self.materials.get(index).copied().flatten().or(self.tower)
    }
}

/// A running rotor in attached flow: what its aerodynamic damping follows from.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RotorAerodynamics {
    /// ∫ c r dr over one blade with the chord c at the distance r from the rotor axis, from 0 to
    /// the tip, m³.
    pub chord_moment_m3: f64,
    /// Slope of the lift coefficient dC_L/dα, 1/rad.
    pub lift_slope: f64,
    /// Density of air, kg/m³.
    pub air_density_kg_per_m3: f64,
}

impl RotorAerodynamics {
    /// The lift slope of a thin airfoil, 2π (Glauert 1926, *The Elements of Aerofoil and Airscrew
    /// Theory*).
    pub const THIN_AIRFOIL: f64 = std::f64::consts::TAU;
    /// The density of air at sea level and 15 °C, kg/m³ (ISO 2533:1975, standard atmosphere).
    pub const STANDARD_AIR: f64 = 1.225;

    /// Of blades with this ∫ c r dr, m³, of thin airfoils in the standard atmosphere.
    pub fn of_chords(chord_moment_m3: f64) -> Self {
        Self {
            chord_moment_m3,
            lift_slope: Self::THIN_AIRFOIL,
            air_density_kg_per_m3: Self::STANDARD_AIR,
        }
    }
}
