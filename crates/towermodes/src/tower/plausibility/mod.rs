//! Inputs that are possible but look like input mistakes: a wrong unit, a lost digit, a wrong sign,
//! radians.
//!
//! Each quantity is compared with physical limits or with the range of built towers, never
//! with a list of words. Limits are generous: a warning that is mostly wrong is not read. Where
//! rows have a quantity, the row that is furthest off is named.

mod bodies;
mod couplings;
mod floating;
mod foundation;
mod frame;
mod frame_piles;
mod geometry;
mod ground;
mod materials;
mod out_of_line;
mod soil;
mod table;
mod unused;
mod usual;
mod water;
mod wires;

pub(crate) use bodies::inertia as inertia_plausibility;

use super::Place;
use super::foundation::Foundation;
use super::ground::Ground;
use super::parts::damping::Damping;
use super::parts::drivetrain::Drivetrain;
use super::parts::material::Material;
use super::parts::part_names::PartNames;
use super::{AddedMassRow, SoilRow, Tower, TowerDescription, Water, Wires};
use crate::tower::Rotor;
use crate::tower::Warning;
use crate::tower::{Quantity, Site};
use usual::{Usual, check_inputs};

/// The parts of a description that a tower does not keep in their original form.
pub(super) struct Given<'a> {
    pub(super) materials: &'a [Material],
    pub(super) foundation: &'a Foundation,
    pub(super) soil: &'a [Vec<SoilRow>],
    pub(super) ground: Option<&'a Ground>,
    pub(super) added_mass: &'a [Vec<AddedMassRow>],
    pub(super) water: Option<&'a Water>,
    pub(super) wires: &'a [Wires],
    pub(super) damping: &'a Damping,
    pub(super) drivetrain: Option<&'a Drivetrain>,
    pub(super) part_names: &'a PartNames,
    /// Whether the user confirmed that the rotor-nacelle assembly has no inertia.
    pub(super) rna_is_point: bool,
    /// Whether the format of the file has only some of its moments of inertia.
    pub(super) rna_inertia_is_partial: bool,
    /// Whether the matrix of the moorings was computed from lines.
    pub(super) mooring_is_computed: bool,
}

impl<'a> Given<'a> {
    pub(super) fn of(description: &'a TowerDescription) -> Self {
        Self {
            materials: &description.materials,
            foundation: &description.foundation,
            soil: &description.soil,
            ground: description.ground.as_ref(),
            added_mass: &description.added_mass,
            water: description.water.as_ref(),
            wires: &description.wires,
            damping: &description.damping,
            drivetrain: description.drivetrain.as_ref(),
            part_names: &description.part_names,
            rna_is_point: description.rna_is_point,
            rna_inertia_is_partial: description.rna_inertia_is_partial,
            mooring_is_computed: description.mooring_is_computed,
        }
    }
}

/// The warnings that depend only on the input.
pub(super) fn plausibility(tower: &Tower, given: &Given<'_>) -> Vec<Warning> {
    let missing = tower.missing_parts().cloned();
    let mut warnings: Vec<Warning> = missing.map(Warning::PartsMissing).into_iter().collect();
    geometry::check(tower, given, &mut warnings);
    materials::check(tower, given, &mut warnings);
    table::check(tower, &mut warnings);
    bodies::check(tower, given, &mut warnings);
    foundation::check(tower, given, &mut warnings);
    ground::check(tower, given, &mut warnings);
    soil::check(tower, given, &mut warnings);
    wires::check(tower, given.wires, &mut warnings);
    water::check(tower, given, &mut warnings);
    check_inputs(given.damping, |key| Place::Damping { key }, &mut warnings);
    if let Some(drivetrain) = given.drivetrain {
        check_inputs(drivetrain, |key| Place::Drivetrain { key }, &mut warnings);
    }
    if tower.gravity_m_per_s2() != 0.0 {
        let site = Site::at(Place::Gravity);
        GRAVITY.check(tower.gravity_m_per_s2(), site, &mut warnings);
    }
    warnings
}

const GRAVITY: Usual = Usual::new(Quantity::Gravity, 9.7, 9.9);
/// Range for rotors on towers of more than 20 m, except small turbines, which reach hundreds of
/// rpm.
const ROTOR_SPEED: Usual = Usual::new(Quantity::RotorSpeed, 3.0, 100.0);
/// The RNA of a small turbine has at most this mass, kg.
const SMALL_KG: f64 = 5e3;

/// Possible input mistakes in the rotor on a tower.
pub(super) fn rotor_plausibility(tower: &Tower, rotor: &Rotor) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let mass_kg = tower.rna().mass_kg;
    let is_small = mass_kg > 0.0 && mass_kg <= SMALL_KG;
    if tower.height_m() > 20.0 && !is_small {
        let site = Site::at(Place::Rotor { key: "rpm" });
        ROTOR_SPEED.check(rotor.highest_rpm, site, &mut warnings);
    }
    warnings
}

/// Frequency of a mass (kg) on a spring (N/m), Hz.
fn frequency_hz(stiffness_n_per_m: f64, mass_kg: f64) -> f64 {
    (stiffness_n_per_m / mass_kg).sqrt() / std::f64::consts::TAU
}
