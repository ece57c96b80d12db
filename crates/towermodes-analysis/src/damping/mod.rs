//! The damping ratios of modes: from the loss factors of the parts of the tower, weighted by their
//! energy, and from the aerodynamic damping of the rotor.
//!
//! A part i with the loss factor ηᵢ and the fraction Uᵢ/U of a mode's strain energy contributes the
//! damping ratio ½ ηᵢ Uᵢ/U; for water, which has no strain energy, its fraction of the kinetic
//! energy is used instead. Self-weight dissipates no energy; it reduces U. Small damping ratios can
//! be added. Source: Ungar & Kerwin (1962), *Loss factors of viscoelastic systems in terms of
//! energy concepts*, J. Acoust. Soc. Am. 34.

mod aerodynamic;
mod given;
mod part;
mod remark;

pub use aerodynamic::{AerodynamicDamping, aerodynamic_damping};
pub use given::{GivenDamping, GivenDampingError};
pub use part::{DampedPart, PartDamping};
pub use remark::DampingRemark;

use thiserror::Error;
use towermodes::{EnergyParts, Family, Mode, Rotor, RotorAerodynamics, Solution, TowerDescription};

/// Why there is no damping of modes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum DampingError {
    /// The solution has no energy by parts.
    #[error("the modes have no energy by parts; solve with energy_parts = true")]
    NoEnergyParts,
}

/// The damping of the modes of a tower.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ModalDamping {
    /// The modes by frequency.
    pub modes: Vec<ModeDamping>,
    /// The data of the aerodynamic damping; none without rotor data or rotor speed.
    pub rotor: Option<RotorAerodynamics>,
    /// Remarks: effects that are not included, data without effect, probable mistakes.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub remarks: Vec<DampingRemark>,
}

/// The damping of one mode.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ModeDamping {
    /// Number in the list of modes, from 1.
    pub number: usize,
    /// The kind of motion.
    pub family: Family,
    /// Order within the family, from 1.
    pub order: usize,
    /// The name of the mode, for example "1st fore-aft bending".
    pub label: String,
    /// Its frequency, extrapolated, Hz.
    pub frequency_hz: f64,
    /// The contribution of each part of the tower: materials, substructure, foundation, soil, guy
    /// wires, water.
    pub parts: Vec<PartDamping>,
    /// The fractions of its energy, including parts without dissipation: self-weight and masses.
    pub energy_parts: EnergyParts,
    /// The sum of the damping ratios of the parts whose loss factor is given; none if no loss
    /// factor is given, or if the motion has no stiffness.
    pub damping_ratio: Option<f64>,
    /// The modal mass for a fore-aft displacement of the tower top of 1, kg; none if the top does
    /// not move fore-aft.
    pub top_mass_kg: Option<f64>,
    /// The aerodynamic damping ratio at the lowest and at the highest operating speed; empty
    /// without rotor data.
    pub aerodynamic: Vec<AerodynamicDamping>,
}

impl ModeDamping {
    /// The sum of the damping ratios of the parts and of the rotor at one of its
    /// [speeds](Self::aerodynamic), by the index of the speed.
    pub fn running(&self, speed: usize) -> Option<f64> {
        let aerodynamic = self.aerodynamic.get(speed)?;
        Some(self.damping_ratio.unwrap_or(0.0) + aerodynamic.damping_ratio)
    }
}

/// Computes the damping ratios of the modes of a tower from its description and its solution, which
/// must contain the energy by parts. `rotor` gives the number of blades and the operating speeds.
///
/// # Errors
/// [`DampingError::NoEnergyParts`].
///
/// # Example
/// A clamped tower of one material: every mode has the damping ratio η/2 of the material.
/// ```
/// use towermodes::{Damping, LossFactors, Material, Options, Station, Tower, TowerDescription};
/// use towermodes::solve;
/// use towermodes_analysis::damping;
///
/// let description = TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     damping: Damping {
///         loss_factors: LossFactors { tower: Some(0.004), ..LossFactors::default() },
///         ..Damping::default()
///     },
///     ..TowerDescription::default()
/// };
/// let tower = Tower::new(description.clone())?;
/// let solution = solve(&tower, &Options { energy_parts: true, ..Options::default() })?;
/// let damping = damping(&description, &solution, None)?;
/// let ratio = damping.modes[0].damping_ratio.expect("a loss factor is given");
/// assert!((ratio - 0.002).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn damping(
    description: &TowerDescription,
    solution: &Solution,
    rotor: Option<&Rotor>,
) -> Result<ModalDamping, DampingError> {
    let of_mode = |mode: &Mode| mode_damping(description, mode, rotor);
    let modes: Result<Vec<ModeDamping>, DampingError> =
        solution.modes.iter().map(of_mode).collect();
    let modes = modes?;
    let remarks = remark::remarks(description, &modes, rotor);
    let aerodynamics = description.damping.rotor.filter(|_| rotor.is_some());
    Ok(ModalDamping {
        modes,
        rotor: aerodynamics,
        remarks,
    })
}

fn mode_damping(
    description: &TowerDescription,
    mode: &Mode,
    rotor: Option<&Rotor>,
) -> Result<ModeDamping, DampingError> {
    let energy = mode.energy_parts.as_ref();
    let energy = energy.ok_or(DampingError::NoEnergyParts)?;
    let parts = part::parts(description, energy);
    let ratios = parts.iter().filter_map(|part| part.damping_ratio);
    let ratios: Vec<f64> = ratios.collect();
    let is_resisted = mode.frequency_hz > 0.0;
    Ok(ModeDamping {
        number: mode.number,
        family: mode.family,
        order: mode.order,
        label: mode.label(),
        frequency_hz: mode.extrapolated_hz,
        energy_parts: energy.clone(),
        damping_ratio: (is_resisted && !ratios.is_empty()).then(|| ratios.iter().sum()),
        parts,
        top_mass_kg: aerodynamic::top_mass_kg(mode),
        aerodynamic: match (rotor, &description.damping.rotor) {
            (Some(rotor), Some(aerodynamics)) if is_resisted => {
                aerodynamic_damping(mode, rotor, aerodynamics)
            }
            _ => Vec::new(),
        },
    })
}
