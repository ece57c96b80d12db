//! A rigid suction caisson.

use super::super::parts::foundation_springs::FoundationSprings;
use super::common::{
    SOIL_POISSONS_RATIO, SOIL_PROFILE, SOIL_YOUNGS_MODULUS, SoilProfile, TORSION, VERTICAL,
    against_diameter, deep, outside,
};
use super::form::{Buried, ClosedForm, FormKind};
use super::head::HeadStiffness;
use crate::inputs::{Input, Inputs};
use crate::space::SpatialMatrix;
use crate::tower::error::TowerError;
use crate::tower::warning::Warning;

/// A rigid suction caisson below the base of the tower: a circular lid at the surface of the soil
/// with a skirt.
///
/// # Example
/// A caisson as deep as it is wide, in soil whose modulus does not change with depth.
/// ```
/// use towermodes::{SoilProfile, SuctionCaisson};
///
/// let caisson = SuctionCaisson {
///     diameter_m: 12.0,
///     skirt_length_m: 12.0,
///     soil_profile: SoilProfile::Homogeneous,
///     soil_youngs_modulus_pa: 4e7,
///     soil_poissons_ratio: 0.0,
///     vertical_n_per_m: f64::INFINITY,
///     torsion_n_m: f64::INFINITY,
/// };
/// let lateral = caisson.head().lateral_n_per_m;
/// assert!((lateral / (1.06 * 2.91 * 12.0 * 4e7) - 1.0).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Inputs)]
pub struct SuctionCaisson {
    /// Diameter D, m.
    #[input(Input::length("diameter", "the diameter of the caisson"))]
    pub diameter_m: f64,
    /// Length L of the skirt, m.
    #[input(Input::length("skirt_length", "the length of the skirt")
        .hint("from the surface of the soil to the tip of the skirt, in m")
        .also("skirt_depth skirt_height"))]
    pub skirt_length_m: f64,
    /// How Young's modulus of the soil grows with depth.
    #[input(SOIL_PROFILE)]
    pub soil_profile: SoilProfile,
    /// Young's modulus E_SO of the soil at the depth of one diameter, Pa.
    #[input(SOIL_YOUNGS_MODULUS)]
    pub soil_youngs_modulus_pa: f64,
    /// Poisson's ratio ν of the soil.
    #[input(SOIL_POISSONS_RATIO)]
    pub soil_poissons_ratio: f64,
    /// Stiffness against translation in z, N/m, which the formula does not give; infinite: rigid.
    #[input(VERTICAL)]
    pub vertical_n_per_m: f64,
    /// Stiffness against rotation about z, N m, which the formula does not give; infinite: rigid.
    #[input(TORSION)]
    pub torsion_n_m: f64,
}

impl SuctionCaisson {
    /// Authors and year of the formula.
    pub const FORMULA: &str = "Jalbi, Shadlou & Bhattacharya (2018)";
    /// The range of L/D for which the formula was derived.
    pub const SLENDERNESS: [f64; 2] = [0.5, 2.0];

    /// Length of the skirt over diameter, L/D.
    pub fn slenderness(&self) -> f64 {
        self.skirt_length_m / self.diameter_m
    }

    /// The stiffness about the centre of the lid: K_L = f a D E_SO (L/D)^b, K_LR = −f a D² E_SO
    /// (L/D)^b, K_R = f a D³ E_SO (L/D)^b with f = 1.1 (0.096 L/D + 0.6) ν² − 0.7ν + 1.06.
    ///
    /// | (a, b) | K_L | K_LR | K_R |
    /// |---|---|---|---|
    /// | homogeneous | 2.91, 0.56 | 1.87, 1.47 | 2.70, 1.92 |
    /// | parabolic | 2.70, 0.96 | 1.99, 1.89 | 2.54, 2.44 |
    /// | linear | 2.53, 1.33 | 2.02, 2.29 | 2.46, 2.90 |
    ///
    /// For 0.5 ≤ L/D ≤ 2. Source: Jalbi, Shadlou & Bhattacharya, *Ocean Eng.* 150 (2018) 21–35.
    /// The parabolic row and f are not checked against the original, the other rows against a
    /// published program.
    pub fn head(&self) -> HeadStiffness {
        let (d, nu, ratio) = (
            self.diameter_m,
            self.soil_poissons_ratio,
            self.slenderness(),
        );
        let factor = 1.1 * (0.096 * ratio + 0.6) * nu * nu - 0.7 * nu + 1.06;
        let [lateral, coupling, rocking] = match self.soil_profile {
            SoilProfile::Homogeneous => [(2.91, 0.56), (1.87, 1.47), (2.70, 1.92)],
            SoilProfile::Parabolic => [(2.70, 0.96), (1.99, 1.89), (2.54, 2.44)],
            SoilProfile::Linear => [(2.53, 1.33), (2.02, 2.29), (2.46, 2.90)],
        }
        .map(|(a, b): (f64, f64)| factor * self.soil_youngs_modulus_pa * a * ratio.powf(b));
        HeadStiffness {
            lateral_n_per_m: lateral * d,
            coupling_n: -coupling * d * d,
            rocking_n_m: rocking * d.powi(3),
        }
    }

    /// The springs at the base of the tower.
    pub fn springs(&self) -> FoundationSprings {
        self.head().with(self.vertical_n_per_m, self.torsion_n_m)
    }
}

impl ClosedForm for SuctionCaisson {
    fn kind(&self) -> &'static FormKind {
        &FormKind {
            name: "suction-caisson",
            synonyms: "caisson bucket suction_bucket suction_caisson skirt",
            nature: "the stiffness of a caisson follows from its dimensions and the elastic soil",
            in_words: "suction caisson in elastic soil",
            contains_soil: true,
            decisive_key: "skirt_length",
        }
    }

    fn stiffness(&self) -> SpatialMatrix {
        self.springs().matrix()
    }

    fn check(&self) -> Result<(), TowerError> {
        Ok(())
    }

    fn doubt(&self, base_diameter_m: Option<f64>, warnings: &mut Vec<Warning>) {
        warnings.extend(against_diameter(self.diameter_m, base_diameter_m));
        warnings.extend(outside(
            "skirt_length",
            Self::FORMULA,
            "the length of the skirt, divided by the diameter,",
            self.slenderness(),
            Self::SLENDERNESS,
            "a longer one is a pile, a shorter one a footing; the unit of both is m",
        ));
    }

    fn caption(&self) -> String {
        format!("Suction caisson in elastic soil, by {}", Self::FORMULA)
    }

    fn assumption(&self) -> String {
        format!(
            "The base is the lid of a rigid suction caisson in elastic soil; its static stiffness follows from {}, without damping and inertia of \
             caisson and soil.",
            Self::FORMULA
        )
    }

    fn derived(&self) -> Vec<(&'static str, f64, usize)> {
        vec![("length/diameter (−)", self.slenderness(), 4)]
    }

    fn buried(&self) -> Buried {
        deep("caisson", self.diameter_m, self.skirt_length_m)
    }
}
