//! PISA: initial stiffness of the four reactions on a monopile, in three soils.

use crate::tower::ground::layer_springs::{LayerSprings, Nature, Piles};
use crate::tower::ground::modulus::Modulus;
use crate::tower::ground::spot::Spot;
use crate::tower::ground::values::{Made, Values};
use crate::tower::warning::{Site, Warning};

/// Only the range of the length is checked against a source.
const PILES: Piles = Piles {
    formula: "the model of PISA",
    diameters_m: [5.0, 10.0],
    lengths: [2.0, 6.0],
    need_shear: true,
    remedy: "compare with another model and with a factor of 0.5 and 2 on the soil",
};
/// The relative densities of the sand of Dunkirk.
const DENSITIES: [f64; 2] = [0.45, 0.9];

/// The constants of one soil of the PISA project, for reactions at zero load: the lateral springs
/// k_p G₀ [N/m²], the springs against rotation k_m G₀ D² [N m/rad per m], at the tip shear
/// k_H G₀ D and moment k_M G₀ D³. They belong to a pile with shear deformation.
///
/// For 2 ≤ L/D ≤ 6 and 5 m ≤ D ≤ 10 m (the diameters are not checked against the originals). A
/// factor that the lines make negative is zero: k_p below 6.4 D (Cowden), 7.8 D (Bothkennar) and
/// 8.9 D (Dunkirk, D_r = 0.75). The reactions soften from the first load on: at a displacement of
/// 1e-4 D the secant is 0.66 to 0.85 of this tangent.
///
/// Sources: Byrne et al., *PISA design model for monopiles for offshore wind turbines: application
/// to a stiff glacial clay till* (Cowden), and Burd et al., *… application to a marine sand*
/// (Dunkirk), Géotechnique 70 (2020) 1030–1047 and 1048–1066; Burd et al., *Application of the PISA
/// design model to monopiles embedded in layered soils* (Bothkennar), Géotechnique 70 (2020)
/// 1067–1082; the constants as programmed in openpile.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Constants {
    /// k_p as a function of the depth in diameters.
    lateral: Line,
    /// k_m as a function of the depth in diameters.
    rotation: Line,
    /// k_H as a function of the embedded length in diameters.
    shear: Line,
    /// k_M as a function of the embedded length in diameters.
    moment: Line,
}

/// A constant of a reaction: its value at zero, and its change with the variable.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Line(f64, f64);

impl Line {
    /// The value on the line.
    fn at(self, variable: f64) -> f64 {
        self.0 + self.1 * variable
    }

    /// As [`at`](Self::at), but zero where the line is negative.
    fn positive_at(self, variable: f64) -> f64 {
        let value = self.at(variable);
        // `max` would hide a missing value.
        if value < 0.0 { 0.0 } else { value }
    }
}

const COWDEN: Constants = Constants {
    lateral: Line(10.6, -1.65),
    rotation: Line(1.42, -0.09643),
    shear: Line(2.717, -0.3575),
    moment: Line(0.2146, -0.002132),
};

const BOTHKENNAR: Constants = Constants {
    lateral: Line(12.05, -1.547),
    rotation: Line(1.698, -0.1576),
    shear: Line(3.008, -0.2701),
    moment: Line(0.3409, -0.01995),
};

/// Sand of relative density D_r (fraction). The springs against rotation of sand grow with the
/// lateral load and are zero without it.
fn of_sand(density: f64) -> Constants {
    Constants {
        lateral: Line(8.731 - 0.6982 * density, -0.9178),
        rotation: Line(0.0, 0.0),
        shear: Line(6.505 - 2.985 * density, -(0.007969 + 0.4299 * density)),
        moment: Line(0.3515, 0.0),
    }
}

/// A layer with the reactions of PISA.
#[derive(Debug)]
struct Pisa {
    constants: Constants,
    modulus: Modulus,
    /// D_r of sand.
    relative_density: Option<f64>,
}

pub(super) fn cowden<'l>(values: &mut Values<'l>) -> Made<dyn LayerSprings + 'l> {
    of_clay(COWDEN, values)
}

pub(super) fn bothkennar<'l>(values: &mut Values<'l>) -> Made<dyn LayerSprings + 'l> {
    of_clay(BOTHKENNAR, values)
}

fn of_clay<'l>(constants: Constants, values: &mut Values<'l>) -> Made<dyn LayerSprings + 'l> {
    values.clay()?;
    Ok(Box::new(Pisa {
        constants,
        modulus: values.shear_modulus()?,
        relative_density: None,
    }))
}

pub(super) fn dunkirk<'l>(values: &mut Values<'l>) -> Made<dyn LayerSprings + 'l> {
    let given = values.sand()?.relative_density;
    let density = values.needed("relative_density", "the relative density", given)?;
    Ok(Box::new(Pisa {
        constants: of_sand(density),
        modulus: values.shear_modulus()?,
        relative_density: Some(density),
    }))
}

impl LayerSprings for Pisa {
    fn lateral_n_per_m2(&self, spot: &Spot<'_>) -> f64 {
        let depth = spot.depth_m() / spot.diameter_m();
        self.constants.lateral.positive_at(depth) * self.modulus.pa(spot)
    }

    fn nature(&self) -> Nature {
        Nature {
            is_linear: false,
            needs_weight: false,
            depends_on_edition: false,
        }
    }

    fn rotation_n(&self, spot: &Spot<'_>) -> f64 {
        let diameter_m = spot.diameter_m();
        let factor = self.constants.rotation;
        let factor = factor.positive_at(spot.depth_m() / diameter_m);
        match factor > 0.0 {
            true => factor * self.modulus.pa(spot) * diameter_m * diameter_m,
            false => 0.0,
        }
    }

    fn at_tip(&self, spot: &Spot<'_>) -> [f64; 2] {
        let (diameter_m, modulus_pa) = (spot.diameter_m(), self.modulus.pa(spot));
        let length = spot.pile.length_m() / diameter_m;
        [
            self.constants.shear.positive_at(length) * modulus_pa * diameter_m,
            self.constants.moment.positive_at(length) * modulus_pa * diameter_m.powi(3),
        ]
    }

    fn kink(&self, number: usize, spot: &Spot<'_>) -> Option<f64> {
        let depth = spot.depth_m() / spot.diameter_m();
        let lines = [self.constants.lateral, self.constants.rotation];
        lines.get(number).map(|line| line.at(depth))
    }

    fn piles(&self) -> Option<Piles> {
        Some(PILES)
    }

    fn doubt(&self, at: &dyn Fn(&'static str) -> Site, warnings: &mut Vec<Warning>) {
        let [least, most] = DENSITIES;
        let outside = |density: &f64| !(least..=most).contains(density);
        if let Some(value) = self.relative_density.filter(outside) {
            warnings.push(Warning::OutsideFormula {
                site: at("relative_density"),
                formula: PILES.formula,
                quantity: "the relative density",
                value,
                least,
                most,
                remedy: PILES.remedy,
            });
        }
    }
}
