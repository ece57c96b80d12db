//! The quantities that ElastoDyn computes from a tower and its shapes: generalized masses and
//! stiffnesses, frequencies, damping.
//!
//! The formulas are those of the subroutine `Coeff` of ElastoDyn (OpenFAST 5.0): the midpoint rule
//! over equal elements, properties linear between the rows of the tower file. They have
//! no rotary inertia and no shear deformation, and the rotor-nacelle assembly is a point mass.

use std::f64::consts::{PI, TAU};

use thiserror::Error;

use super::check::check_modes;
use super::polynomial::TowerPolynomial;
use super::sums::Sums;
use towermodes::Plain;
use towermodes::tower::{Plane, Planes};

/// The largest number of elements; towers for ElastoDyn have some tens.
pub const MAX_NODES: usize = 1_000_000;

/// The tower model of ElastoDyn.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TowerModel {
    /// Length of the flexible tower, m.
    pub flexible_length_m: f64,
    /// Number of elements, `TwrNodes`.
    pub nodes: usize,
    /// Rows from the base to the top.
    pub stations: Vec<TowerStation>,
    /// Factor of the masses per length, `AdjTwMa`.
    pub mass_factor: f64,
    /// Factors of the bending stiffnesses, `AdjFASt` and `AdjSSSt`.
    pub stiffness_factors: Planes<f64>,
    /// Masses along the tower; each is distributed over its element.
    pub concentrated_masses: Vec<ConcentratedMass>,
    /// Mass of the rotor-nacelle assembly, kg.
    pub tower_top_mass_kg: f64,
    /// Acceleration of gravity, m/s².
    pub gravity_m_per_s2: f64,
}

/// A row of properties of the tower.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TowerStation {
    /// Height as a fraction of the flexible tower, 0 to 1.
    pub height_fraction: f64,
    /// Mass per length, kg/m.
    pub mass_kg_per_m: f64,
    /// Bending stiffness in each plane, N m².
    pub bending_n_m2: Planes<f64>,
}

/// A mass at a height.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ConcentratedMass {
    /// Height as a fraction of the flexible tower, 0 to 1.
    pub height_fraction: f64,
    /// Mass, kg.
    pub mass_kg: f64,
}

/// The two modes of a plane in a tower file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneModes {
    /// The shapes.
    pub shapes: [TowerPolynomial; 2],
    /// Factors of the stiffnesses, `FAStTunr` or `SSStTunr`.
    pub tuners: [f64; 2],
    /// Structural damping, percent of critical, `TwrFADmp` or `TwrSSDmp`.
    pub damping_percent: [f64; 2],
}

/// ElastoDyn's generalized quantities of the two modes of a plane, and their frequencies and
/// damping.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Generalized {
    /// MT = mass on top + Σ m h φ², kg.
    pub mass_kg: [f64; 2],
    /// KTᵢⱼ = √(tunerᵢ tunerⱼ) Σ EI h φᵢ″ φⱼ″, N/m.
    pub stiffness_n_per_m: [[f64; 2]; 2],
    /// KG = −Σ g (mass above) h φ′², N/m.
    pub gravity_stiffness_n_per_m: [f64; 2],
    /// Frequency f(·,1) of the tower without rotor-nacelle assembly and without gravity,
    /// √(KT/(MT − mass on top))/2π, Hz.
    pub frequency_alone_hz: [f64; 2],
    /// Frequency f(·,2) with both, √((KT + KG)/MT)/2π, Hz; none where the geometric stiffness of
    /// gravity exceeds the stiffness.
    pub frequency_loaded_hz: [Option<f64>; 2],
    /// Damping Cᵢⱼ = (ζⱼ/100) KTᵢⱼ/(π fⱼ(·,1)), N s/m.
    pub damping_n_s_per_m: [[f64; 2]; 2],
    /// Mass of the flexible tower by the same rule, kg.
    pub tower_mass_kg: f64,
}

/// Why the quantities of ElastoDyn cannot be computed.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum ModelError {
    /// A quantity is out of its range.
    #[error("{what} cannot be {}", Plain(*.value))]
    Quantity {
        /// The name of the quantity.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// The number of elements is 0 or too large.
    #[error(
        "a tower cannot be cut into {nodes} elements; the number must be from 1 to {MAX_NODES}"
    )]
    Nodes {
        /// The number.
        nodes: usize,
    },
    /// The tower has fewer than 2 rows.
    #[error("a tower needs at least 2 rows of properties, not {rows}")]
    Rows {
        /// How many there are.
        rows: usize,
    },
    /// The heights of the rows do not rise from 0 to 1.
    #[error("the heights of the tower's rows must rise from 0 to 1; row {row} is at {}", Plain(*.height_fraction))]
    Heights {
        /// The row, from 1.
        row: usize,
        /// Its height.
        height_fraction: f64,
    },
    /// The numbers overflowed, or a shape does not move.
    #[error(
        "the masses, stiffnesses and shapes of this tower are too large, too small or zero: ElastoDyn finds no frequency of them"
    )]
    NotFinite,
}

impl TowerModel {
    /// The generalized quantities of the modes of one plane.
    ///
    /// # Errors
    /// [`ModelError`]: the model or the modes are invalid, or a number overflows.
    pub fn generalized(&self, plane: Plane, modes: &PlaneModes) -> Result<Generalized, ModelError> {
        self.check()?;
        check_modes(modes)?;
        let sums = self.sums(plane, &modes.shapes);
        let result = self.results(&sums, modes);
        let numbers = [result.mass_kg, result.gravity_stiffness_n_per_m];
        let matrices = [result.stiffness_n_per_m, result.damping_n_s_per_m];
        let mut all = numbers.iter().chain(matrices.iter().flatten()).flatten();
        let are_frequencies = result.frequency_alone_hz.iter().all(|hz| hz.is_normal());
        if are_frequencies && all.all(|number| number.is_finite()) {
            Ok(result)
        } else {
            Err(ModelError::NotFinite)
        }
    }

    fn results(&self, sums: &Sums, modes: &PlaneModes) -> Generalized {
        let top_kg = self.tower_top_mass_kg;
        let tuners = modes.tuners;
        let stiffness = two_by_two(|i, j| (tuners[i] * tuners[j]).sqrt() * sums.stiffness[i][j]);
        let alone_hz = two(|i| (stiffness[i][i] / sums.mass_kg[i]).sqrt() / TAU);
        let mass_kg = two(|i| top_kg + sums.mass_kg[i]);
        let loaded_hz = |i: usize| {
            let square = (stiffness[i][i] + sums.gravity[i]) / mass_kg[i];
            (square > 0.0).then(|| square.sqrt() / TAU)
        };
        Generalized {
            mass_kg,
            stiffness_n_per_m: stiffness,
            gravity_stiffness_n_per_m: sums.gravity,
            frequency_alone_hz: alone_hz,
            frequency_loaded_hz: [loaded_hz(0), loaded_hz(1)],
            damping_n_s_per_m: two_by_two(|i, j| {
                0.01 * modes.damping_percent[j] * stiffness[i][j] / (PI * alone_hz[j])
            }),
            tower_mass_kg: sums.tower_mass_kg,
        }
    }
}

fn two(value: impl Fn(usize) -> f64) -> [f64; 2] {
    std::array::from_fn(value)
}

fn two_by_two(value: impl Fn(usize, usize) -> f64) -> [[f64; 2]; 2] {
    std::array::from_fn(|i| std::array::from_fn(|j| value(i, j)))
}
