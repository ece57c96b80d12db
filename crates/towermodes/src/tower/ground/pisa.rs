//! PISA: initial stiffness of the four reactions on a monopile.

use super::layer::{GroundLayer, LayerSoil};
use super::model::SoilModel;

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
pub(super) struct Pisa {
    /// k_p over the depth in diameters.
    pub(super) lateral: Line,
    /// k_m likewise.
    pub(super) rotation: Line,
    /// k_H over the embedded length in diameters.
    pub(super) shear: Line,
    /// k_M likewise.
    pub(super) moment: Line,
}

/// A constant of a reaction: its value at zero, and its change with the variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Line(f64, f64);

impl Line {
    /// As the line gives it.
    pub(super) fn at(self, variable: f64) -> f64 {
        self.0 + self.1 * variable
    }

    /// The same, zero where the line is negative.
    pub(super) fn positive_at(self, variable: f64) -> f64 {
        let value = self.at(variable);
        // `max` would hide a value that is missing.
        if value < 0.0 { 0.0 } else { value }
    }
}

const COWDEN: Pisa = Pisa {
    lateral: Line(10.6, -1.65),
    rotation: Line(1.42, -0.09643),
    shear: Line(2.717, -0.3575),
    moment: Line(0.2146, -0.002132),
};

const BOTHKENNAR: Pisa = Pisa {
    lateral: Line(12.05, -1.547),
    rotation: Line(1.698, -0.1576),
    shear: Line(3.008, -0.2701),
    moment: Line(0.3409, -0.01995),
};

impl Pisa {
    /// Of a layer with one of the models of PISA.
    pub(super) fn of(layer: &GroundLayer) -> Option<Self> {
        match layer.model {
            SoilModel::PisaCowden => Some(COWDEN),
            SoilModel::PisaBothkennar => Some(BOTHKENNAR),
            SoilModel::PisaDunkirk => match &layer.soil {
                LayerSoil::Sand(sand) => {
                    Some(Self::dunkirk(sand.relative_density.unwrap_or(f64::NAN)))
                }
                LayerSoil::Clay(_)
                | LayerSoil::Elastic
                | LayerSoil::Rock(_)
                | LayerSoil::Table(_) => None,
            },
            SoilModel::Api
            | SoilModel::Dnv
            | SoilModel::ReeseStiffClay
            | SoilModel::Kallehave
            | SoilModel::Sorensen
            | SoilModel::Winkler
            | SoilModel::Vesic
            | SoilModel::WeakRock
            | SoilModel::Table => None,
        }
    }

    /// Sand of relative density D_r (fraction). The springs against rotation of sand grow with the
    /// lateral load and are zero without it.
    fn dunkirk(relative_density: f64) -> Self {
        let density = relative_density;
        Self {
            lateral: Line(8.731 - 0.6982 * density, -0.9178),
            rotation: Line(0.0, 0.0),
            shear: Line(6.505 - 2.985 * density, -(0.007969 + 0.4299 * density)),
            moment: Line(0.3515, 0.0),
        }
    }
}
