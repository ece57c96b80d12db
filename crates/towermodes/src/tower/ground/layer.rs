//! One layer of soil as a geotechnical report gives it.

use super::model::SoilModel;
use super::shear_modulus::{ShearModulus, YOUNGS_MODULUS};
use crate::inputs::{Given, Input, Inputs, Limit, Named, given_inputs};

/// One layer of soil.
///
/// Values with two entries are at the top and at the bottom of the layer, and linear in between.
#[derive(Debug, Clone, PartialEq, Inputs)]
pub struct GroundLayer {
    /// The model by which the springs follow from the values of the layer.
    #[input(Input::choice("model", "the soil model")
        .optional()
        .note("model of the springs, in place of model in [ground]"))]
    pub model: SoilModel,
    /// Height of its upper end in the datum of the stations, m.
    #[input(Input::height("top", "the height of the top of the layer").note("height").hint(HEIGHT))]
    pub top_m: f64,
    /// Height of its lower end, m.
    #[input(Input::height("bottom", "the height of the bottom of the layer").note("height").hint(HEIGHT))]
    pub bottom_m: f64,
    /// Effective unit weight γ′, N/m³: under water the buoyant one. Needed where strength or
    /// stiffness depend on the weight of the soil above, in this layer or in one below.
    #[input(Input::new("effective_unit_weight", " N/m3", Limit::Positive, "the effective unit weight")
        .optional()
        .symbol("γ′", 1e-3, " kN/m³")
        .note("under water the buoyant one"))]
    pub effective_unit_weight_n_per_m3: Option<f64>,
    /// Factor on every spring of the layer, including those under the tip; 1 by default.
    #[input(Input::new("factor", "", Limit::Positive, "the factor on the springs of the layer")
        .or(1.0)
        .quiet()
        .symbol("springs ×", 1.0, "")
        .note("on the springs of the layer"))]
    pub factor: f64,
    /// The soil with the values of its kind.
    #[inputs]
    pub soil: LayerSoil,
    /// The shear modulus at small strains, for the models that need it.
    #[inputs]
    pub shear_modulus: Option<ShearModulus>,
    /// Poisson's ratio ν, for the models that need it.
    #[input(Input::new("poissons_ratio", "", Limit::PoissonsRatioOfSoil, "Poisson's ratio of the soil")
        .optional()
        .symbol("ν", 1.0, ""))]
    pub poissons_ratio: Option<f64>,
    /// Largest friction on the shaft, t_max, at top and bottom, Pa, for the axial springs of API.
    #[input(Input::new("shaft_friction", " Pa", Limit::Positive, "the shaft friction")
        .optional()
        .note("largest, for axial = \"api\"")
        .also("t_max")
        .symbol("t_max", 1e-3, " kPa")
        .usual([1e3, 5e5], "typical: 1e4 to 1.2e5; the unit is Pa, not kPa"))]
    pub shaft_friction_pa: Option<[f64; 2]>,
    /// Largest pressure under the tip, q, Pa, for the axial springs of API.
    #[input(Input::new("end_bearing", " Pa", Limit::Positive, "the end bearing")
        .optional()
        .note("largest, for axial = \"api\"")
        .symbol("q", 1e-6, " MPa")
        .usual([2e4, 1e8], "typical: 1e5 to 1.2e7; the unit is Pa, not kPa"))]
    pub end_bearing_pa: Option<f64>,
}

/// The hint if a file lacks the height of an end.
const HEIGHT: &str = "height in m, in the datum of the stations";

/// The kind of soil of a layer.
///
/// A new number of a kind is a field of its struct with its description.
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
#[derive(Debug, Clone, Copy, PartialEq, Default, Inputs)]
pub struct Sand {
    /// Effective friction angle φ′, degrees.
    #[input(Input::new("friction_angle", " degrees", Limit::UpTo(60.0), "the friction angle")
        .optional()
        .also("phi phi_deg friction phi_prime")
        .symbol("φ′", 1.0, "°")
        .usual([20.0, 50.0], "loose sand has about 28, very dense sand 42; the unit is degrees (0.6 rad is 34 degrees)"))]
    pub friction_angle_deg: Option<f64>,
    /// Modulus k of the springs k z of API, N/m³, in place of the modulus that follows from the
    /// friction angle.
    #[input(Input::new("subgrade_modulus", " N/m3", Limit::Positive, "the subgrade modulus")
        .optional()
        .note("in place of friction_angle for api")
        .symbol("k", 1e-6, " MN/m³")
        .usual([5e5, 2e8], "loose sand has about 5e6, dense sand 4e7; the unit is N/m3, not kN/m3"))]
    pub subgrade_modulus_n_per_m3: Option<f64>,
    /// Relative density D_r as a fraction.
    #[input(Input::new("relative_density", "", Limit::Within([0.0, 1.0]), "the relative density")
        .optional()
        .note("as a fraction")
        .symbol("D_r", 1.0, ""))]
    pub relative_density: Option<f64>,
}

/// The values of clay.
#[derive(Debug, Clone, Copy, PartialEq, Default, Inputs)]
pub struct Clay {
    /// Undrained shear strength S_u at top and bottom, Pa.
    #[input(Input::new("undrained_strength", " Pa", Limit::Positive, "the undrained shear strength")
        .optional()
        .also("undrained_shear_strength su s_u cu c_u")
        .symbol("S_u", 1e-3, " kPa")
        .usual([1e3, 1e6], "soft clay has 1e4 to 4e4, hard clay 2e5; the unit is Pa, not kPa"))]
    pub undrained_strength_pa: Option<[f64; 2]>,
    /// Strain ε₅₀ at half of the strength in undrained compression.
    #[input(Input::new("strain_at_half_strength", "", Limit::UpTo(1.0), "the strain at half the strength")
        .optional()
        .note("eps50")
        .symbol("ε₅₀", 1.0, "")
        .usual([1e-3, 0.05], "soft clay has about 0.02, stiff clay 0.005; it is a fraction, not percent"))]
    pub strain_at_half_strength: Option<f64>,
    /// Matlock's factor J of the strength near the surface: 0.5 for soft, 0.25 for stiff clay.
    #[input(Input::new("strength_factor", "", Limit::Positive, "the factor J of the strength near the surface")
        .optional()
        .note("J of Matlock, near the surface")
        .symbol("J", 1.0, "")
        .usual([0.1, 1.0], "soft clay has 0.5, stiff clay 0.25"))]
    pub strength_factor: Option<f64>,
    /// The factor ξ of the initial stiffness of DNV: 10 for normally consolidated clay, 30 for
    /// overconsolidated clay.
    #[input(Input::new("stiffness_factor", "", Limit::Positive, "the factor of the initial stiffness")
        .optional()
        .note("for dnv: 10 normally consolidated, 30 overconsolidated")
        .symbol("ξ", 1.0, "")
        .usual([5.0, 60.0], "normally consolidated clay has 10, overconsolidated clay 30"))]
    pub stiffness_factor: Option<f64>,
}

/// The values of weak rock.
#[derive(Debug, Clone, Copy, PartialEq, Default, Inputs)]
pub struct Rock {
    /// Initial Young's modulus E_ir of the rock mass at top and bottom, Pa.
    #[input(YOUNGS_MODULUS
        .optional()
        .note("initial, of the rock mass")
        .symbol("E_ir", 1e-6, " MPa"))]
    pub youngs_modulus_pa: Option<[f64; 2]>,
}

/// One row of a table of p-y curves: one point (y, p) of the curve at a height, whose secant p/y is
/// the spring.
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
    /// One of each kind, with blank values.
    pub fn blanks() -> [Self; 5] {
        [
            Self::Sand(Sand::blank()),
            Self::Clay(Clay::blank()),
            Self::Elastic,
            Self::Rock(Rock::blank()),
            Self::Table(Vec::new()),
        ]
    }

    /// The models that can be given for a whole ground: those that do not belong to a single kind
    /// of soil.
    pub fn models() -> impl Iterator<Item = SoilModel> {
        let of_kinds = Self::blanks().map(|soil| soil.only_model());
        let every = SoilModel::CHOICES.iter().copied();
        every.filter(move |model| !of_kinds.contains(&Some(*model)))
    }

    /// The name of its kind in the tower file.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Sand(_) => "sand",
            Self::Clay(_) => "clay",
            Self::Elastic => "elastic",
            Self::Rock(_) => "rock",
            Self::Table(_) => "py",
        }
    }

    /// Whether a layer of it can have a shear modulus: that of rock follows from its Young's
    /// modulus.
    pub fn may_have_shear_modulus(&self) -> bool {
        match self {
            Self::Sand(_) | Self::Clay(_) | Self::Elastic | Self::Table(_) => true,
            Self::Rock(_) => false,
        }
    }

    /// Its values, if this kind of soil has any.
    fn values(&self) -> Option<&dyn Inputs> {
        match self {
            Self::Sand(sand) => Some(sand),
            Self::Clay(clay) => Some(clay),
            Self::Rock(rock) => Some(rock),
            Self::Elastic | Self::Table(_) => None,
        }
    }

    /// The rows of a table; none of another kind.
    pub fn rows(&self) -> &[PyRow] {
        match self {
            Self::Table(rows) => rows,
            Self::Sand(_) | Self::Clay(_) | Self::Elastic | Self::Rock(_) => &[],
        }
    }

    /// The model of this kind of soil, if there is only one.
    pub fn only_model(&self) -> Option<SoilModel> {
        match self {
            Self::Rock(_) => Some(SoilModel::WeakRock),
            Self::Table(_) => Some(SoilModel::Table),
            Self::Sand(_) | Self::Clay(_) | Self::Elastic => None,
        }
    }

    /// The kind of soil as a noun in a sentence.
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

impl Inputs for LayerSoil {
    fn blank() -> Self {
        Self::Elastic
    }

    fn visit(&self, each: &mut dyn FnMut(&'static Input, Given)) {
        if let Some(values) = self.values() {
            values.visit(each);
        }
    }

    fn update(&mut self, each: &mut dyn FnMut(&'static Input, Given) -> Given) {
        match self {
            Self::Sand(sand) => sand.update(each),
            Self::Clay(clay) => clay.update(each),
            Self::Rock(rock) => rock.update(each),
            Self::Elastic | Self::Table(_) => {}
        }
    }

    fn idle(&self, _: &mut dyn FnMut(&'static Input, Given)) {}
}

impl GroundLayer {
    /// A layer between two heights (m), of which nothing else is known.
    pub fn new([top_m, bottom_m]: [f64; 2], soil: LayerSoil, model: SoilModel) -> Self {
        Self {
            top_m,
            bottom_m,
            soil,
            model,
            ..Self::blank()
        }
    }

    /// The values that layers of some kinds of soil can have, in the order of the tower file.
    pub fn every_input(soils: &[LayerSoil]) -> Vec<(&'static Input, Given)> {
        let mut all: Vec<(&'static Input, Given)> = Vec::new();
        for soil in soils.iter().rev() {
            let moduli = ShearModulus::blanks().map(Some).into_iter().rev();
            let moduli = moduli.filter(|_| soil.may_have_shear_modulus());
            for shear_modulus in moduli.chain([None]) {
                let soil = soil.clone();
                let layer = Self {
                    soil,
                    shear_modulus,
                    ..Self::blank()
                };
                merge(&mut all, &given_inputs(&layer));
            }
        }
        all
    }
}

/// Adds the values of one list that another list does not contain, each after its predecessor.
fn merge(all: &mut Vec<(&'static Input, Given)>, more: &[(&'static Input, Given)]) {
    let mut next = 0;
    for &(input, given) in more {
        match all.iter().position(|(other, _)| other.key == input.key) {
            Some(place) => next = place + 1,
            None => {
                all.insert(next, (input, given));
                next += 1;
            }
        }
    }
}
