//! PISA: initial stiffness of the four reactions on a monopile.

use super::layer::{GroundLayer, LayerSoil};
use super::model::SoilModel;

/// The constants of one soil of the PISA project, for reactions at zero load: the lateral springs
/// k_p G₀ [N/m²], the springs against rotation k_m G₀ D² [N m/rad per m], at the tip shear
/// k_H G₀ D and moment k_M G₀ D³. They belong to a pile with shear deformation.
///
/// For 2 ≤ L/D ≤ 6 and 5 m ≤ D ≤ 10 m (the diameters are not checked against the originals). A
/// factor that the lines make negative, below about 6 D, is zero.
///
/// Sources: Byrne et al., *PISA design model for monopiles for offshore wind turbines: application
/// to a stiff glacial clay till*, and Burd et al., *… application to a marine sand*, Géotechnique
/// 70 (2020) 1030–1047 and 1048–1066; the constants as programmed in openpile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pisa {
    /// k_p at the surface, and its change per depth in diameters.
    lateral: [f64; 2],
    /// k_m likewise.
    rotation: [f64; 2],
    /// k_H for zero length, and its change per length in diameters.
    shear: [f64; 2],
    /// k_M likewise.
    moment: [f64; 2],
}

const COWDEN: Pisa = Pisa {
    lateral: [10.6, -1.65],
    rotation: [1.42, -0.09643],
    shear: [2.717, -0.3575],
    moment: [0.2146, -0.002132],
};

const BOTHKENNAR: Pisa = Pisa {
    lateral: [12.05, -1.547],
    rotation: [1.698, -0.1576],
    shear: [3.008, -0.2701],
    moment: [0.3409, -0.01995],
};

impl Pisa {
    /// Of a layer with one of the models of PISA.
    pub(super) fn of(layer: &GroundLayer) -> Option<Self> {
        match (layer.model, &layer.soil) {
            (SoilModel::PisaCowden, _) => Some(COWDEN),
            (SoilModel::PisaBothkennar, _) => Some(BOTHKENNAR),
            (SoilModel::PisaDunkirk, LayerSoil::Sand(sand)) => {
                Some(Self::dunkirk(sand.relative_density.unwrap_or(f64::NAN)))
            }
            _ => None,
        }
    }

    /// Sand of relative density D_r (fraction). The springs against rotation of sand grow with the
    /// lateral load and are zero without it.
    fn dunkirk(relative_density: f64) -> Self {
        let density = relative_density;
        Self {
            lateral: [8.731 - 0.6982 * density, -0.9178],
            rotation: [0.0; 2],
            shear: [6.505 - 2.985 * density, -(0.007969 + 0.4299 * density)],
            moment: [0.3515, 0.0],
        }
    }

    /// k_p at a depth in diameters.
    pub(super) fn lateral(&self, depth: f64) -> f64 {
        line(self.lateral, depth)
    }

    /// k_m at a depth in diameters.
    pub(super) fn rotation(&self, depth: f64) -> f64 {
        line(self.rotation, depth)
    }

    /// k_H for an embedded length in diameters.
    pub(super) fn shear(&self, length: f64) -> f64 {
        line(self.shear, length)
    }

    /// k_M for an embedded length in diameters.
    pub(super) fn moment(&self, length: f64) -> f64 {
        line(self.moment, length)
    }
}

fn line([first, slope]: [f64; 2], variable: f64) -> f64 {
    let value = first + slope * variable;
    // `max` would hide a value that is missing.
    if value < 0.0 { 0.0 } else { value }
}
