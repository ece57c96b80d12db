//! The quantities that ElastoDyn computes from a tower and its shapes: generalized masses and
//! stiffnesses, frequencies, damping.
//!
//! The formulas are those of the subroutine `Coeff` of ElastoDyn (OpenFAST 5.0): the midpoint rule
//! over equal elements, properties linear between the rows of the tower file, no rotary inertia, no
//! shear deformation, and a point mass for the rotor-nacelle assembly.

use std::f64::consts::{PI, TAU};

use super::check::check_modes;
use super::model::{ModelError, PlaneModes, TowerModel};
use super::sums::Sums;
use towermodes::tower::{Plane, Planes};

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
    /// Frequency f(·,2) with both, √((KT + KG)/MT)/2π, Hz; none if the geometric stiffness of
    /// gravity exceeds the stiffness.
    pub frequency_loaded_hz: [Option<f64>; 2],
    /// Damping Cᵢⱼ = (ζⱼ/100) KTᵢⱼ/(π fⱼ(·,1)), N s/m.
    pub damping_n_s_per_m: [[f64; 2]; 2],
    /// Mass of the flexible tower by the same rule, kg.
    pub tower_mass_kg: f64,
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

    /// The generalized quantities of the modes of both planes.
    ///
    /// # Errors
    /// As [`TowerModel::generalized`].
    pub fn both_planes(
        &self,
        modes: &Planes<PlaneModes>,
    ) -> Result<Planes<Generalized>, ModelError> {
        Ok(Planes {
            fore_aft: self.generalized(Plane::ForeAft, &modes.fore_aft)?,
            side_side: self.generalized(Plane::SideSide, &modes.side_side)?,
        })
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
