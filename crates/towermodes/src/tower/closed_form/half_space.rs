//! A rigid circular footing in an elastic half-space.

use super::super::parts::foundation_springs::FoundationSprings;
use super::common::{
    EMBEDMENT, RADIUS, SOIL_POISSONS_RATIO, SOIL_SHEAR_MODULUS, against_tower, footing, unusual,
};
use super::form::{Buried, ClosedForm, FormKind, SoilBelow};
use crate::inputs::{Inputs, Quantity};
use crate::space::SpatialMatrix;
use crate::tower::error::TowerError;
use crate::tower::warning::Warning;

/// A rigid circular footing in an elastic half-space.
#[derive(Debug, Clone, Copy, PartialEq, Inputs)]
pub struct HalfSpace {
    /// Radius R, m.
    #[input(RADIUS)]
    pub radius_m: f64,
    /// Depth of embedment e, m.
    #[input(EMBEDMENT)]
    pub embedment_m: f64,
    /// Shear modulus G of the soil, Pa.
    #[input(SOIL_SHEAR_MODULUS)]
    pub shear_modulus_pa: f64,
    /// Poisson's ratio ν of the soil.
    #[input(SOIL_POISSONS_RATIO)]
    pub poissons_ratio: f64,
}

impl HalfSpace {
    /// The springs of the footing, static and uncoupled:
    ///
    /// | | surface footing | times, for embedment e |
    /// |---|---|---|
    /// | vertical | 4GR/(1−ν) | 1 + 0.6 (1−ν) e/R |
    /// | lateral | 32(1−ν)GR/(7−8ν) | 1 + 0.55 (2−ν) e/R |
    /// | rocking | 8GR³/(3(1−ν)) | 1 + 1.2 (1−ν) e/R + 0.2 (2−ν) (e/R)³ |
    /// | torsion | 16GR³/3 | 1 |
    ///
    /// Source: Arya, O'Neill & Pincus, *Design of Structures and Foundations for Vibrating
    /// Machines* (1979), ch. 4, after Richart, Hall & Woods (1970) and Whitman (1972).
    pub fn springs(&self) -> FoundationSprings {
        let (g, r, nu) = (self.shear_modulus_pa, self.radius_m, self.poissons_ratio);
        let e = self.embedment_m / r;
        let vertical = 1.0 + 0.6 * (1.0 - nu) * e;
        let lateral = 1.0 + 0.55 * (2.0 - nu) * e;
        let rocking = 1.0 + 1.2 * (1.0 - nu) * e + 0.2 * (2.0 - nu) * e.powi(3);
        FoundationSprings {
            lateral_n_per_m: 32.0 * (1.0 - nu) * g * r / (7.0 - 8.0 * nu) * lateral,
            rocking_n_m: 8.0 * g * r.powi(3) / (3.0 * (1.0 - nu)) * rocking,
            coupling_n: 0.0,
            vertical_n_per_m: 4.0 * g * r / (1.0 - nu) * vertical,
            torsion_n_m: 16.0 * g * r.powi(3) / 3.0,
        }
    }
}

impl ClosedForm for HalfSpace {
    fn kind(&self) -> &'static FormKind {
        &FormKind {
            name: "half-space",
            synonyms: "footing half_space halfspace gravity_base",
            nature: "the stiffness of a half-space follows from the footing and the soil",
            in_words: "circular footing on an elastic half-space",
            contains_soil: false,
            decisive_key: "embedment",
        }
    }

    fn stiffness(&self) -> SpatialMatrix {
        self.springs().matrix()
    }

    fn check(&self) -> Result<(), TowerError> {
        Ok(())
    }

    fn doubt(&self, base_diameter_m: Option<f64>, warnings: &mut Vec<Warning>) {
        let depth = self.embedment_m / self.radius_m;
        warnings.extend(unusual(Quantity::Embedment, "embedment", depth, [0.0, 2.0]));
        let quantity = Quantity::FootingRadius;
        warnings.extend(against_tower(
            quantity,
            "radius",
            self.radius_m,
            base_diameter_m,
        ));
    }

    fn caption(&self) -> String {
        "Rigid circular footing on an elastic half-space".to_owned()
    }

    fn assumption(&self) -> String {
        "The base is a rigid circular footing on an elastic half-space, modelled by static, uncoupled springs (Arya, O'Neill & Pincus, 1979) \
         without damping and soil mass."
            .to_owned()
    }

    fn buried(&self) -> Buried {
        Buried {
            soil: Some(SoilBelow {
                thickness_m: f64::INFINITY,
                shear_modulus_pa: self.shear_modulus_pa,
                poissons_ratio: self.poissons_ratio,
            }),
            ..footing([self.radius_m; 2], self.embedment_m)
        }
    }
}
