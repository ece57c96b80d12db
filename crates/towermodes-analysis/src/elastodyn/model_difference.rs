//! Differences of two ElastoDyn tower models in mass and flexibility, and the check that a deck
//! belongs to a tower.

use std::fmt;

use super::model::{TowerModel, TowerStation};
use towermodes::tower::Planes;

/// The relative differences of two tower models in the quantities that ElastoDyn uses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModelDifference {
    /// Difference in the mass of the flexible tower, as a fraction.
    pub mass: f64,
    /// Difference in the deflection of the top due to a force there, as a fraction.
    pub flexibility: Planes<f64>,
}

impl ModelDifference {
    /// The largest absolute value of all differences.
    pub fn largest(&self) -> f64 {
        let Planes {
            fore_aft,
            side_side,
        } = self.flexibility;
        self.mass.abs().max(fore_aft.abs()).max(side_side.abs())
    }
}

/// "its mass differs by +0.12 %, its flexibility by -0.30 % fore-aft and -0.30 % side-side".
impl fmt::Display for ModelDifference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "its mass differs by {:+.2} %, its flexibility by {:+.2} % fore-aft and {:+.2} % side-side",
            100.0 * self.mass,
            100.0 * self.flexibility.fore_aft,
            100.0 * self.flexibility.side_side
        )
    }
}

impl TowerModel {
    /// Differences of another model from this one: other/this − 1 of the mass with concentrated
    /// masses, and of the flexibility ∫ (1 − x)²/EI dx by the trapezoidal rule over the rows.
    pub fn difference_from(&self, other: &Self) -> ModelDifference {
        let relative = |a: f64, b: f64| b / a - 1.0;
        let (own, others) = (self.flexibility(), other.flexibility());
        ModelDifference {
            mass: relative(self.mass_kg(), other.mass_kg()),
            flexibility: Planes {
                fore_aft: relative(own.fore_aft, others.fore_aft),
                side_side: relative(own.side_side, others.side_side),
            },
        }
    }

    /// Mass of the flexible tower, kg.
    fn mass_kg(&self) -> f64 {
        let listed: f64 = self.concentrated_masses.iter().map(|m| m.mass_kg).sum();
        let spread = integral(&self.stations, |station| station.mass_kg_per_m);
        listed + self.mass_factor * self.flexible_length_m * spread
    }

    /// Deflection of the top by a unit force there, m/N.
    fn flexibility(&self) -> Planes<f64> {
        let cube = self.flexible_length_m.powi(3);
        let of = |stiffness: fn(&TowerStation) -> f64| {
            cube * integral(&self.stations, |s| {
                (1.0 - s.height_fraction).powi(2) / stiffness(s)
            })
        };
        let factors = self.stiffness_factors;
        Planes {
            fore_aft: of(|s| s.bending_n_m2.fore_aft) / factors.fore_aft,
            side_side: of(|s| s.bending_n_m2.side_side) / factors.side_side,
        }
    }
}

fn integral(stations: &[TowerStation], value: impl Fn(&TowerStation) -> f64) -> f64 {
    let parts = stations.windows(2).map(|pair| {
        let length = pair[1].height_fraction - pair[0].height_fraction;
        0.5 * length * (value(&pair[0]) + value(&pair[1]))
    });
    parts.sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn uniform(mass_kg_per_m: f64, bending_n_m2: f64, rows: usize) -> TowerModel {
        let row = |k: usize| TowerStation {
            height_fraction: k as f64 / (rows - 1) as f64,
            mass_kg_per_m,
            bending_n_m2: Planes::both(bending_n_m2),
        };
        TowerModel {
            flexible_length_m: 2.0,
            stations: (0..rows).map(row).collect(),
            mass_factor: 1.0,
            stiffness_factors: Planes::both(1.0),
            ..TowerModel::default()
        }
    }

    #[test]
    fn towers_differ_by_mass_and_stiffness() {
        let tower = uniform(10.0, 5.0, 101);
        // L³/3EI, by the trapezoidal rule to 1/(2 n²).
        let flexibility = tower.flexibility().fore_aft;
        assert!((flexibility - 8.0 / 15.0).abs() < 1e-4);
        let other = uniform(11.0, 10.0, 101);
        let difference = tower.difference_from(&other);
        assert!((difference.mass - 0.1).abs() < 1e-12);
        assert!((difference.flexibility.side_side + 0.5).abs() < 1e-12);
        assert!((difference.largest() - 0.5).abs() < 1e-12);
        assert_eq!(tower.difference_from(&tower).largest(), 0.0);
    }
}
