//! A rigid circular footing in a stratum over rock or over another stratum.

use crate::tower::foundation::FoundationSprings;

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
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CircularFooting {
    /// Radius R, m.
    pub radius_m: f64,
    /// Depth of embedment e, m: of the underside below the surface of the soil. It must be 0 if
    /// there is a lower stratum that is not rock.
    pub embedment_m: f64,
    /// Shear modulus G of the stratum, Pa.
    pub shear_modulus_pa: f64,
    /// Poisson's ratio ν of the stratum.
    pub poissons_ratio: f64,
    /// Thickness H of the stratum below the surface of the soil, m; infinite: a half-space.
    pub stratum_thickness_m: f64,
    /// Shear modulus G₂ below the stratum, Pa; infinite: rock.
    pub lower_shear_modulus_pa: f64,
    /// Whether the embedment couples sliding and rocking.
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
    /// coupling, if it is wanted, is e/3 times the lateral spring: positive, because the sides of
    /// the footing are held above its underside.
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

/// Of an embedded footing about its underside: the lateral spring acts a third of the depth above.
pub(super) fn coupling_n(is_coupled: bool, embedment_m: f64, lateral_n_per_m: f64) -> f64 {
    match is_coupled {
        true => embedment_m / 3.0 * lateral_n_per_m,
        false => 0.0,
    }
}
