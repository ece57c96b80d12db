//! The effect of the weight on the first frequencies of a tower described without gravity.

use std::fmt;

use towermodes::modes::Family;
use towermodes::tower::{STANDARD_GRAVITY_M_PER_S2, Tower};
use towermodes::{Method, Options, Solution, Solver};

/// A smaller relative change of the first frequencies is not reported: it is a fifth of the default
/// margin, and other inputs are less accurate.
const WORTH_A_WARNING: f64 = 0.01;

/// The weight of a tower that is described without gravity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WeightLeftOut {
    /// The relative change of the first bending frequency due to the weight, in the plane in which
    /// it changes more; negative if the frequency is lower with gravity.
    pub change: f64,
}

impl WeightLeftOut {
    /// The neglected weight of a tower, if it would change a first bending frequency by more than 1
    /// %. None if the description has gravity, for a floating tower, whose buoyancy includes
    /// gravity, and if the tower would buckle under its weight.
    pub fn of(tower: &Tower) -> Option<Self> {
        if tower.gravity_m_per_s2() != 0.0 || tower.linear_platform().is_some() {
            return None;
        }
        let without = first_bending_hz(tower)?;
        let with = first_bending_hz(&tower.with_gravity(STANDARD_GRAVITY_M_PER_S2))?;
        let changes = without.into_iter().zip(with);
        let changes = changes.filter_map(|(without, with)| Some(with? / without? - 1.0));
        let change = changes.max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
        (change.abs() > WORTH_A_WARNING).then_some(Self { change })
    }
}

/// "the weight, which is left out, would lower the first frequencies by about 3 %".
impl fmt::Display for WeightLeftOut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the model is without gravity; the weight would {} the first frequencies by about {:.1} %; [gravity] in the tower file includes it",
            if self.change < 0.0 { "lower" } else { "raise" },
            100.0 * self.change.abs()
        )
    }
}

/// The first bending frequencies fore-aft and side-side; none if the tower cannot be solved.
fn first_bending_hz(tower: &Tower) -> Option<[Option<f64>; 2]> {
    let mut solver = Solver::new(Options {
        method: Method::Spectral,
        modes: 4,
        points: 2,
        ..Options::default()
    });
    let solution: Solution = solver.solve(tower).ok()?;
    let planes = [Family::ForeAft, Family::SideSide];
    Some(planes.map(|family| Some(solution.mode(family, 1)?.frequency_hz)))
}

#[cfg(test)]
mod tests {
    use super::WeightLeftOut;
    use towermodes::{Material, Rna, Station, Tower, TowerDescription};

    fn change(gravity_m_per_s2: f64, rna_kg: f64) -> Option<f64> {
        let tower = Tower::new(TowerDescription {
            materials: vec![Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10)],
            stations: vec![Station::new(0.0, 5.0, 0.03), Station::new(100.0, 5.0, 0.03)],
            rna: Rna::point(rna_kg),
            gravity_m_per_s2,
            ..TowerDescription::default()
        });
        WeightLeftOut::of(&tower.expect("a tower")).map(|weight| weight.change)
    }

    /// A heavy mass on a uniform clamped column: f decreases relatively by half of the ratio of the
    /// load to the buckling load π² EI/(4 L²). Of the weight of the column 5/16 is effective, for
    /// the deflection curve due to a force at the top.
    #[test]
    fn the_change_is_half_the_ratio_of_load_to_buckling_load() {
        let (modulus, length_m, rna_kg) = (2.1e11_f64, 100.0_f64, 500e3);
        let pi = std::f64::consts::PI;
        let (outer, inner) = (5.0_f64, 4.94_f64);
        let area = pi / 4.0 * (outer * outer - inner * inner);
        let second = pi / 64.0 * (outer.powi(4) - inner.powi(4));
        let euler_n = pi * pi * modulus * second / (4.0 * length_m * length_m);
        let load_n = 9.80665 * (rna_kg + 5.0 / 16.0 * 7850.0 * area * length_m);
        let expected = (1.0 - load_n / euler_n).sqrt() - 1.0;
        let found = change(0.0, rna_kg).expect("a change");
        // The shape of the column is not that of buckling: second order in the difference.
        assert!((found / expected - 1.0).abs() < 0.04, "{found} {expected}");
        assert!(found < -0.01);
    }

    #[test]
    fn a_small_weight_and_gravity_in_the_model_need_no_warning() {
        assert_eq!(change(0.0, 1e3), None);
        assert_eq!(change(9.81, 500e3), None);
    }
}
