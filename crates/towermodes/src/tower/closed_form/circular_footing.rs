//! A rigid circular footing in a stratum over rock or over another stratum.

use super::super::parts::foundation_springs::FoundationSprings;
use super::common::{
    COUPLED, EMBEDMENT, RADIUS, SOIL_POISSONS_RATIO, SOIL_SHEAR_MODULUS, against_tower, coupling_n,
    error, footing, outside,
};
use super::form::{Buried, ClosedForm, FormKind, SoilBelow};
use crate::inputs::{Input, Inputs, Limit, Quantity};
use crate::space::SpatialMatrix;
use crate::tower::error::{Problem, TowerError};
use crate::tower::warning::Warning;

/// A rigid circular footing in a stratum of elastic soil over rock, or on a stratum over a
/// half-space of another stiffness. The tower's base is at the underside of the footing.
///
/// # Example
/// Rock at a depth of two radii makes the footing 25 % stiffer against sliding.
/// ```
/// use towermodes::CircularFooting;
///
/// let over_rock = CircularFooting {
///     radius_m: 9.0,
///     embedment_m: 0.0,
///     shear_modulus_pa: 5e7,
///     poissons_ratio: 0.3,
///     stratum_thickness_m: 18.0,
///     lower_shear_modulus_pa: f64::INFINITY,
///     is_coupled: false,
/// };
/// let half_space = CircularFooting {
///     stratum_thickness_m: f64::INFINITY,
///     ..over_rock
/// };
/// let ratio = over_rock.springs().lateral_n_per_m / half_space.springs().lateral_n_per_m;
/// assert_eq!(ratio, 1.25);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Inputs)]
pub struct CircularFooting {
    /// Radius R, m.
    #[input(RADIUS)]
    pub radius_m: f64,
    /// Depth of embedment e, m: depth of the underside below the surface of the soil. It must be 0
    /// if there is a lower stratum that is not rock.
    #[input(EMBEDMENT)]
    pub embedment_m: f64,
    /// Shear modulus G of the stratum, Pa.
    #[input(SOIL_SHEAR_MODULUS.note("of the stratum"))]
    pub shear_modulus_pa: f64,
    /// Poisson's ratio ν of the stratum.
    #[input(SOIL_POISSONS_RATIO)]
    pub poissons_ratio: f64,
    /// Thickness H of the stratum below the surface of the soil, m; infinite: a half-space.
    #[input(Input::length("soil_thickness", "the thickness of the stratum")
        .or(f64::INFINITY)
        .quiet()
        .note("of the stratum below the surface; without it a half-space")
        .also("stratum_thickness layer_thickness depth_to_rock"))]
    pub stratum_thickness_m: f64,
    /// Shear modulus G₂ below the stratum, Pa; infinite: rock.
    #[input(Input::new("lower_shear_modulus", " Pa", Limit::Positive, "the shear modulus below the stratum")
        .or(f64::INFINITY)
        .quiet()
        .note("below the stratum; without it rock")
        .needs("soil_thickness", "add the thickness of the stratum above it, in m")
        .usual_of(Quantity::SoilShearModulus, [1e6, 5e10])
        .of_soil())]
    pub lower_shear_modulus_pa: f64,
    /// Whether the embedment couples sliding and rocking.
    #[input(COUPLED)]
    pub is_coupled: bool,
}

impl CircularFooting {
    /// Authors and year of the formula.
    pub const FORMULA: &str = "DNV-OS-J101, Appendix G";
    /// The least H/R for which the formula holds over rock.
    pub const LEAST_DEPTH_OVER_ROCK: f64 = 2.0;
    /// The least H/R for which the formula holds over another stratum.
    pub const LEAST_DEPTH_OVER_STRATUM: f64 = 1.0;
    /// The largest e/R for which the formula holds.
    pub const MOST_EMBEDMENT: f64 = 2.0;
    /// The largest e/H for which the formula holds.
    pub const MOST_EMBEDMENT_IN_STRATUM: f64 = 0.5;

    /// The static springs at the underside of the footing:
    ///
    /// | | on a half-space | a | times, for embedment e |
    /// |---|---|---|---|
    /// | vertical | 4GR/(1−ν) | 1.28 | (1 + e/(2R)) (1 + (0.85 − 0.28e/R) (e/H)/(1 − e/H)) |
    /// | lateral | 8GR/(2−ν) | 1/2 | (1 + 2e/(3R)) (1 + 5e/(4H)) |
    /// | rocking | 8GR³/(3(1−ν)) | 1/6 | (1 + 2e/R) (1 + 0.7e/H) |
    /// | torsion | 16GR³/3 | 0 | 1 + 8e/(3R) |
    ///
    /// The factor for the stratum is (1 + a R/H)/(1 + a (R/H) G/G₂); over rock 1 + a R/H. The
    /// coupling, if [`is_coupled`](Self::is_coupled), is e/3 times the lateral spring: positive,
    /// because the sides of the footing are held above its underside.
    ///
    /// Over rock it holds for H/R > 2 (vertical), H/R > 1 (lateral and rocking), e/R < 2 and
    /// e/H < 1/2; over another stratum for H/R ≥ 1 (vertical, lateral), 0.75 (rocking) and
    /// G ≤ G₂.
    ///
    /// Source: DNV-OS-J101, Appendix G; coupling after Gazetas (1991). The constants are not
    /// checked against the originals.
    pub fn springs(&self) -> FoundationSprings {
        let (g, r, nu) = (self.shear_modulus_pa, self.radius_m, self.poissons_ratio);
        let (by_radius, by_depth) = (
            self.embedment_m / r,
            self.embedment_m / self.stratum_thickness_m,
        );
        let vertical = (1.0 + 0.5 * by_radius)
            * (1.0 + (0.85 - 0.28 * by_radius) * by_depth / (1.0 - by_depth));
        let lateral = (1.0 + 2.0 / 3.0 * by_radius) * (1.0 + 1.25 * by_depth);
        let rocking = (1.0 + 2.0 * by_radius) * (1.0 + 0.7 * by_depth);
        let cube = g * r.powi(3);
        let lateral_n_per_m = 8.0 * g * r / (2.0 - nu) * self.of_stratum(0.5) * lateral;
        FoundationSprings {
            lateral_n_per_m,
            rocking_n_m: 8.0 * cube / (3.0 * (1.0 - nu)) * self.of_stratum(1.0 / 6.0) * rocking,
            coupling_n: coupling_n(self.is_coupled, self.embedment_m, lateral_n_per_m),
            vertical_n_per_m: 4.0 * g * r / (1.0 - nu) * self.of_stratum(1.28) * vertical,
            torsion_n_m: 16.0 * cube / 3.0 * (1.0 + 8.0 / 3.0 * by_radius),
        }
    }

    /// Whether another stratum is below, and not rock.
    pub fn is_over_stratum(&self) -> bool {
        self.stratum_thickness_m.is_finite() && self.lower_shear_modulus_pa.is_finite()
    }

    fn of_stratum(&self, a: f64) -> f64 {
        let share = a * self.radius_m / self.stratum_thickness_m;
        (1.0 + share) / (1.0 + share * self.shear_modulus_pa / self.lower_shear_modulus_pa)
    }
}

impl ClosedForm for CircularFooting {
    fn kind(&self) -> &'static FormKind {
        &FormKind {
            name: "circular-footing",
            synonyms: "circular round_footing stratum layered_half_space",
            nature: "the stiffness of a circular footing follows from its radius, the stratum and what is below it",
            in_words: "circular footing in a stratum of soil",
            contains_soil: false,
            decisive_key: "embedment",
        }
    }

    fn stiffness(&self) -> SpatialMatrix {
        self.springs().matrix()
    }

    fn check(&self) -> Result<(), TowerError> {
        let (embedment_m, thickness_m) = (self.embedment_m, self.stratum_thickness_m);
        if embedment_m >= thickness_m {
            let problem = Problem::EmbeddedBelowStratum {
                embedment_m,
                thickness_m,
            };
            return error("embedment", problem);
        }
        if embedment_m > 0.0 && self.is_over_stratum() {
            return error("embedment", Problem::EmbeddedInTwoStrata { embedment_m });
        }
        Ok(())
    }

    fn doubt(&self, base_diameter_m: Option<f64>, warnings: &mut Vec<Warning>) {
        let quantity = Quantity::FootingRadius;
        warnings.extend(against_tower(
            quantity,
            "radius",
            self.radius_m,
            base_diameter_m,
        ));
        warnings.extend(self.thin_stratum());
        warnings.extend(self.stratum_on_softer_soil());
        warnings.extend(self.deep());
    }

    fn caption(&self) -> String {
        format!(
            "Rigid circular footing on {}, by {}",
            self.soil(),
            Self::FORMULA
        )
    }

    fn assumption(&self) -> String {
        let coupled = if self.is_coupled {
            "coupled"
        } else {
            "uncoupled"
        };
        format!(
            "The base is a rigid circular footing on {}, modelled by static, {coupled} springs ({}) without damping and soil mass.",
            self.soil(),
            Self::FORMULA
        )
    }

    fn buried(&self) -> Buried {
        Buried {
            soil: Some(SoilBelow {
                thickness_m: self.stratum_thickness_m,
                shear_modulus_pa: self.shear_modulus_pa,
                poissons_ratio: self.poissons_ratio,
            }),
            ..footing([self.radius_m; 2], self.embedment_m)
        }
    }
}

impl CircularFooting {
    /// The soil in words.
    fn soil(&self) -> &'static str {
        match (self.stratum_thickness_m.is_finite(), self.is_over_stratum()) {
            (false, _) => "an elastic half-space",
            (true, false) => "an elastic stratum over rock",
            (true, true) => "an elastic stratum over another one",
        }
    }

    fn thin_stratum(&self) -> Option<Warning> {
        let least = match self.is_over_stratum() {
            true => Self::LEAST_DEPTH_OVER_STRATUM,
            false => Self::LEAST_DEPTH_OVER_ROCK,
        };
        outside(
            "soil_thickness",
            Self::FORMULA,
            "the thickness of the stratum, divided by the radius of the footing,",
            self.stratum_thickness_m / self.radius_m,
            [least, f64::INFINITY],
            "a thin stratum needs a model of the layers, such as finite elements",
        )
    }

    fn stratum_on_softer_soil(&self) -> Option<Warning> {
        if !self.is_over_stratum() {
            return None;
        }
        outside(
            "lower_shear_modulus",
            Self::FORMULA,
            "the shear modulus of the stratum, divided by that below it,",
            self.shear_modulus_pa / self.lower_shear_modulus_pa,
            [f64::NEG_INFINITY, 1.0],
            "a stratum on softer soil needs a model of the layers, such as finite elements",
        )
    }

    fn deep(&self) -> Option<Warning> {
        let too_deep = |quantity: &'static str, length_m: f64, most: f64| {
            let (value, range) = (self.embedment_m / length_m, [f64::NEG_INFINITY, most]);
            let remedy = "check the unit (m), or use type = \"suction-caisson\" or a pile";
            outside("embedment", Self::FORMULA, quantity, value, range, remedy)
        };
        let quantity = "the embedment of the footing, divided by its radius,";
        too_deep(quantity, self.radius_m, Self::MOST_EMBEDMENT).or_else(|| {
            let quantity = "the embedment of the footing, divided by the thickness of the stratum,";
            let most = Self::MOST_EMBEDMENT_IN_STRATUM;
            too_deep(quantity, self.stratum_thickness_m, most)
        })
    }
}
