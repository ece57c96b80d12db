//! The springs along a pile: given, or computed from the modulus of the soil.

use super::common::{SOIL_POISSONS_RATIO, SOIL_YOUNGS_MODULUS};
use super::pile_tube::PileTube;
use crate::inputs::{Given, Input, Inputs, Limit, Quantity, Value, names};

/// The spring k_D of the soil at the depth of one diameter, per metre of pile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SoilSpring {
    /// The value of k_D is given.
    Given {
        /// k_D, N/m².
        spring_n_per_m2: f64,
    },
    /// k_D = 1.2 E. Source: Gazetas.
    Gazetas {
        /// Young's modulus E of the soil at the depth of one diameter, Pa.
        youngs_modulus_pa: f64,
    },
    /// k_D = 0.65 (E D⁴/EI)^(1/12) E/(1 − ν²). Source: Vesić (1961). Its constants are not checked
    /// against the original.
    Vesic {
        /// Young's modulus E of the soil at the depth of one diameter, Pa.
        youngs_modulus_pa: f64,
        /// Poisson's ratio ν of the soil.
        poissons_ratio: f64,
    },
}

impl SoilSpring {
    /// k_D, N/m².
    pub fn of(&self, tube: &PileTube) -> f64 {
        match *self {
            Self::Given { spring_n_per_m2 } => spring_n_per_m2,
            Self::Gazetas { youngs_modulus_pa } => 1.2 * youngs_modulus_pa,
            Self::Vesic {
                youngs_modulus_pa,
                poissons_ratio,
            } => {
                let stiffness = youngs_modulus_pa * tube.diameter_m.powi(4) / tube.bending_n_m2();
                0.65 * stiffness.powf(1.0 / 12.0) * youngs_modulus_pa
                    / (1.0 - poissons_ratio * poissons_ratio)
            }
        }
    }

    /// The exponent of the depth in the springs. `exponent` is the value of the tower file: the
    /// exponent of the springs if they are given, otherwise the exponent of Young's modulus.
    pub fn exponent(&self, exponent: f64) -> f64 {
        match self {
            Self::Given { .. } | Self::Gazetas { .. } => exponent,
            // The spring grows with E^(13/12).
            Self::Vesic { .. } => 13.0 / 12.0 * exponent,
        }
    }

    /// Authors of the formula; none if the spring is given.
    pub fn formula_name(&self) -> Option<&'static str> {
        match self {
            Self::Given { .. } => None,
            Self::Gazetas { .. } => Some("Gazetas"),
            Self::Vesic { .. } => Some("Vesić (1961)"),
        }
    }
}

/// The formulas that a tower file names.
#[derive(Clone, Copy, PartialEq)]
enum Formula {
    Gazetas,
    Vesic,
}

names!(Formula: Gazetas = "gazetas", Vesic = "vesic");

static FORMULA: Input = Input::choice("spring_formula", "the formula for the springs")
    .optional()
    .note("in place of soil_spring: gazetas or vesic");
static SPRING: Input = Input::new(
    "soil_spring",
    " N/m2",
    Limit::Positive,
    "the soil spring at the depth of one diameter",
)
.optional()
.yields_to("spring_formula")
.note("per metre of pile, at the depth of one diameter")
.hint("N/m2 per metre of pile at the depth of one diameter; or spring_formula with the modulus of the soil")
.usual_of(Quantity::SoilSpring, [5e4, 1e12])
.of_soil();
static MODULUS: Input = SOIL_YOUNGS_MODULUS
    .optional()
    .needs("spring_formula", ALONE);
static RATIO: Input = SOIL_POISSONS_RATIO
    .optional()
    .note("for vesic")
    .needs("spring_formula", ALONE);
const ALONE: &str = "add spring_formula = \"gazetas\" or \"vesic\", or give soil_spring alone";

impl SoilSpring {
    fn formula(&self) -> Option<Formula> {
        match self {
            Self::Given { .. } => None,
            Self::Gazetas { .. } => Some(Formula::Gazetas),
            Self::Vesic { .. } => Some(Formula::Vesic),
        }
    }

    /// With another formula: blank values; with the same formula: unchanged.
    fn with(self, formula: Option<Formula>) -> Self {
        if self.formula() == formula {
            return self;
        }
        match formula {
            None => Self::blank(),
            Some(Formula::Gazetas) => Self::Gazetas {
                youngs_modulus_pa: f64::NAN,
            },
            Some(Formula::Vesic) => Self::Vesic {
                youngs_modulus_pa: f64::NAN,
                poissons_ratio: f64::NAN,
            },
        }
    }

    /// Its input values with their descriptions.
    fn numbers(&mut self) -> Vec<(&'static Input, &mut f64)> {
        match self {
            Self::Given { spring_n_per_m2 } => vec![(&SPRING, spring_n_per_m2)],
            Self::Gazetas { youngs_modulus_pa } => vec![(&MODULUS, youngs_modulus_pa)],
            Self::Vesic {
                youngs_modulus_pa,
                poissons_ratio,
            } => vec![(&MODULUS, youngs_modulus_pa), (&RATIO, poissons_ratio)],
        }
    }
}

impl Inputs for SoilSpring {
    fn blank() -> Self {
        let spring_n_per_m2 = f64::NAN;
        Self::Given { spring_n_per_m2 }
    }

    fn visit(&self, each: &mut dyn FnMut(&'static Input, Given)) {
        each(&FORMULA, self.formula().given());
        let mut own = *self;
        for (input, number) in own.numbers() {
            each(input, number.given());
        }
    }

    fn update(&mut self, each: &mut dyn FnMut(&'static Input, Given) -> Given) {
        let mut formula = self.formula();
        formula.set(each(&FORMULA, formula.given()));
        *self = self.with(formula);
        for (input, number) in self.numbers() {
            number.set(each(input, number.given()));
        }
    }

    fn idle(&self, each: &mut dyn FnMut(&'static Input, Given)) {
        let mut own = *self;
        let own: Vec<&Input> = own.numbers().into_iter().map(|(input, _)| input).collect();
        for input in [&SPRING, &MODULUS, &RATIO] {
            if !own.iter().any(|other| std::ptr::eq(*other, input)) {
                each(input, Given::Number(f64::NAN));
            }
        }
    }
}
