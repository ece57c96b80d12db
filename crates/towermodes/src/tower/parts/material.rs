//! Materials.

/// An isotropic, linearly elastic material.
///
/// # Example
/// ```
/// let steel = towermodes::Material::from_poissons_ratio(7850.0, 2.1e11, 0.3);
/// assert!((steel.shear_modulus_pa - 8.0769e10).abs() < 1e6);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Mass density ρ, kg/m³.
    pub density_kg_per_m3: f64,
    /// Young's modulus E, Pa.
    pub youngs_modulus_pa: f64,
    /// Shear modulus G, Pa.
    pub shear_modulus_pa: f64,
    /// Poisson's ratio ν, if it is given in place of the shear modulus: then a
    /// [`Parameter`](crate::Parameter) that changes Young's modulus changes the shear modulus too.
    pub given_poissons_ratio: Option<f64>,
}

impl Material {
    /// A material from density (kg/m³), Young's modulus (Pa) and shear modulus (Pa).
    pub fn from_shear_modulus(
        density_kg_per_m3: f64,
        youngs_modulus_pa: f64,
        shear_modulus_pa: f64,
    ) -> Self {
        Self {
            density_kg_per_m3,
            youngs_modulus_pa,
            shear_modulus_pa,
            given_poissons_ratio: None,
        }
    }

    /// A material from density (kg/m³), Young's modulus (Pa) and Poisson's ratio ν: G = E / (2 (1 +
    /// ν)).
    pub fn from_poissons_ratio(
        density_kg_per_m3: f64,
        youngs_modulus_pa: f64,
        poissons_ratio: f64,
    ) -> Self {
        let shear_modulus_pa = youngs_modulus_pa / (2.0 * (1.0 + poissons_ratio));
        Self {
            given_poissons_ratio: Some(poissons_ratio),
            ..Self::from_shear_modulus(density_kg_per_m3, youngs_modulus_pa, shear_modulus_pa)
        }
    }

    /// Sets Young's modulus E, Pa; the shear modulus follows if Poisson's ratio is given.
    pub(crate) fn set_youngs_modulus(&mut self, youngs_modulus_pa: f64) {
        self.youngs_modulus_pa = youngs_modulus_pa;
        if let Some(ratio) = self.given_poissons_ratio {
            self.shear_modulus_pa = youngs_modulus_pa / (2.0 * (1.0 + ratio));
        }
    }

    /// Poisson's ratio ν = E / (2 G) − 1.
    pub fn poissons_ratio(&self) -> f64 {
        self.youngs_modulus_pa / (2.0 * self.shear_modulus_pa) - 1.0
    }
}
