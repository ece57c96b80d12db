//! Damping: loss factors of the parts, and the aerodynamic damping of the rotor.

use crate::inputs::{Input, Inputs, Limit};

/// The data from which damping ratios are computed. They have no effect on frequencies and mode
/// shapes.
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
#[derive(Debug, Clone, PartialEq, Default, Inputs)]
pub struct Damping {
    /// The loss factors of the parts.
    #[inputs]
    pub loss_factors: LossFactors,
    /// Data for the aerodynamic damping by the rotor; none if they are not known.
    #[inputs]
    pub rotor: Option<RotorAerodynamics>,
}

/// The loss factors η of the parts of a tower, each the energy that is dissipated per radian of a
/// vibration as a fraction of the part's largest strain energy; none where it is not known.
///
/// η = 2ζ = δ/π, with ζ the damping ratio and δ the logarithmic decrement of a vibration in which
/// the part has all the energy.
#[derive(Debug, Clone, PartialEq, Default, Inputs)]
pub struct LossFactors {
    /// Loss factor of the tower: of the materials without an entry in `materials`, and of a table
    /// of properties.
    #[input(loss_factor("tower_loss_factor", "the loss factor of the tower").note("of the tower's materials: 2 times the damping ratio"))]
    pub tower: Option<f64>,
    /// Loss factors of the materials, in the order of the description; the list may be shorter.
    #[tables]
    pub materials: Vec<Option<f64>>,
    /// Loss factor of the members of a substructure.
    #[input(loss_factor("substructure_loss_factor", "the loss factor of the substructure").note("of the members of the substructure"))]
    pub substructure: Option<f64>,
    /// Loss factor of the foundation, and of the supports of a substructure.
    #[input(loss_factor("foundation_loss_factor", "the loss factor of the foundation").note("of the foundation"))]
    pub foundation: Option<f64>,
    /// Loss factor of the soil springs along the tower and along the piles of a substructure.
    #[input(loss_factor("soil_loss_factor", "the loss factor of the soil").note("of the soil along the tower or the piles"))]
    pub soil: Option<f64>,
    /// Loss factor of the guy wires.
    #[input(loss_factor("wires_loss_factor", "the loss factor of the wires").note("of the guy wires"))]
    pub wires: Option<f64>,
    /// Loss factor of the water, as a fraction of its largest kinetic energy.
    #[input(loss_factor("water_loss_factor", "the loss factor of the water").note("of the water, of its kinetic energy"))]
    pub water: Option<f64>,
}

/// A loss factor, which may be unknown.
pub(in crate::tower) const fn loss_factor(key: &'static str, name: &'static str) -> Input {
    Input::new(key, "", Limit::LossFactor, name).optional()
}

impl LossFactors {
    /// Loss factor of a material by its index; none if it is not known.
    pub fn of_material(&self, index: usize) -> Option<f64> {
        self.materials.get(index).copied().flatten().or(self.tower)
    }
}

/// Data for the aerodynamic damping of an operating rotor in attached flow.
#[derive(Debug, Clone, Copy, PartialEq, Inputs)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RotorAerodynamics {
    /// ∫ c r dr over one blade with the chord c at the distance r from the rotor axis, from 0 to
    /// the tip, m³.
    #[input(Input::new("chord_moment", " m3", Limit::Positive, "the chord moment of a blade")
        .optional()
        .note("integral of chord times radius over one blade"))]
    pub chord_moment_m3: f64,
    /// Slope of the lift coefficient dC_L/dα, 1/rad.
    #[input(Input::new("lift_slope", " per rad", Limit::Positive, "the lift slope of the blades")
        .or(RotorAerodynamics::THIN_AIRFOIL)
        .note("of the blade sections, 2 pi by default")
        .needs("chord_moment", ADD_CHORD_MOMENT))]
    pub lift_slope: f64,
    /// Density of air, kg/m³.
    #[input(Input::new("air_density", " kg/m3", Limit::Positive, "the density of the air")
        .or(RotorAerodynamics::STANDARD_AIR)
        .note("1.225 by default")
        .needs("chord_moment", ADD_CHORD_MOMENT))]
    pub air_density_kg_per_m3: f64,
}

/// Suggestion if the other values of the rotor are given without the chord moment.
const ADD_CHORD_MOMENT: &str =
    "add chord_moment, the integral of chord times radius over one blade, m3";

impl RotorAerodynamics {
    /// The lift slope of a thin airfoil, 2π (Glauert 1926, *The Elements of Aerofoil and Airscrew
    /// Theory*).
    pub const THIN_AIRFOIL: f64 = std::f64::consts::TAU;
    /// The density of air at sea level and 15 °C, kg/m³ (ISO 2533:1975, standard atmosphere).
    pub const STANDARD_AIR: f64 = 1.225;

    /// Data of blades with this ∫ c r dr, m³, thin airfoils and the standard atmosphere.
    pub fn of_chords(chord_moment_m3: f64) -> Self {
        Self {
            chord_moment_m3,
            lift_slope: Self::THIN_AIRFOIL,
            air_density_kg_per_m3: Self::STANDARD_AIR,
        }
    }
}
