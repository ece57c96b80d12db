//! One layer of soil as a geotechnical report gives it.

use super::model::SoilModel;
use super::shear_modulus::ShearModulus;

/// One layer of soil.
///
/// Values with two entries are at the top and at the bottom of the layer, and linear in between.
#[derive(Debug, Clone, PartialEq)]
pub struct GroundLayer {
    /// Height of its upper end in the datum of the stations, m.
    pub top_m: f64,
    /// Height of its lower end, m.
    pub bottom_m: f64,
    /// The soil with the values of its kind.
    pub soil: LayerSoil,
    /// How the springs follow from these.
    pub model: SoilModel,
    /// Effective unit weight γ′, N/m³: under water the buoyant one. Needed where strength or
    /// stiffness depend on the weight of the soil above, in this layer or in one below.
    pub effective_unit_weight_n_per_m3: Option<f64>,
    /// The shear modulus at small strains, for the models that need it.
    pub shear_modulus: Option<ShearModulus>,
    /// Poisson's ratio ν, for the models that need it.
    pub poissons_ratio: Option<f64>,
    /// Largest friction on the shaft, t_max, at top and bottom, Pa, for the axial springs of API.
    pub shaft_friction_pa: Option<[f64; 2]>,
    /// Largest pressure under the tip, q, Pa, for the axial springs of API.
    pub end_bearing_pa: Option<f64>,
    /// Multiplies every spring of the layer, those under the tip too; 1 for the springs of the
    /// model.
    pub factor: f64,
}

/// The kind of soil of a layer.
#[derive(Debug, Clone, PartialEq)]
pub enum LayerSoil {
    /// Sand.
    Sand(Sand),
    /// Clay.
    Clay(Clay),
    /// Soil of which only the layer's shear modulus and Poisson's ratio are known.
    Elastic,
    /// Weak rock.
    Rock(Rock),
    /// Measured or given curves: rows by falling height.
    Table(Vec<PyRow>),
}

/// The values of sand.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sand {
    /// Effective friction angle φ′, degrees.
    pub friction_angle_deg: Option<f64>,
    /// Modulus k of the springs k z of API, N/m³, in place of that by the friction angle.
    pub subgrade_modulus_n_per_m3: Option<f64>,
    /// Relative density D_r as a fraction.
    pub relative_density: Option<f64>,
}

/// The values of clay.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Clay {
    /// Undrained shear strength S_u at top and bottom, Pa.
    pub undrained_strength_pa: Option<[f64; 2]>,
    /// ε₅₀: the strain at half the strength in undrained compression.
    pub strain_at_half_strength: Option<f64>,
    /// Matlock's factor J of the strength near the surface: 0.5 for soft, 0.25 for stiff clay.
    pub strength_factor: Option<f64>,
    /// The factor ξ of the initial stiffness of DNV: 10 for normally consolidated clay, 30 for
    /// overconsolidated clay.
    pub stiffness_factor: Option<f64>,
}

/// The values of weak rock.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rock {
    /// Initial Young's modulus E_ir of the rock mass at top and bottom, Pa.
    pub youngs_modulus_pa: Option<[f64; 2]>,
}

/// One row of a table of p-y curves: the secant of one point of the curve at a height.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PyRow {
    /// Height in the datum of the stations, m.
    pub height_m: f64,
    /// Displacement y of the pile, m.
    pub displacement_m: f64,
    /// Reaction p per length, N/m.
    pub reaction_n_per_m: f64,
}

impl LayerSoil {
    /// The rows of a table; none of another kind.
    pub fn rows(&self) -> &[PyRow] {
        match self {
            Self::Table(rows) => rows,
            Self::Sand(_) | Self::Clay(_) | Self::Elastic | Self::Rock(_) => &[],
        }
    }

    /// Its model, if there is only one for it.
    pub fn only_model(&self) -> Option<SoilModel> {
        match self {
            Self::Rock(_) => Some(SoilModel::WeakRock),
            Self::Table(_) => Some(SoilModel::Table),
            Self::Sand(_) | Self::Clay(_) | Self::Elastic => None,
        }
    }

    /// What it is, in a sentence.
    pub fn noun(&self) -> &'static str {
        match self {
            Self::Sand(_) => "sand",
            Self::Clay(_) => "clay",
            Self::Elastic => "elastic soil",
            Self::Rock(_) => "rock",
            Self::Table(_) => "a table of p-y curves",
        }
    }
}
