//! Shadlou & Bhattacharya (2016): power laws for rigid and for flexible piles.

use super::common::SoilProfile;
use super::head::HeadStiffness;
use super::pile_tube::PileTube;

/// The soil around the pile.
pub(super) struct Soil {
    pub(super) profile: SoilProfile,
    /// Young's modulus at the depth of one diameter, Pa.
    pub(super) modulus_pa: f64,
    pub(super) poissons_ratio: f64,
}

/// Coefficient and exponent of lateral, coupling and rocking stiffness.
type Powers = [(f64, f64); 3];

/// Powers for flexible piles; x is the modulus of the solid pile divided by that of the soil.
fn of_flexible(profile: SoilProfile) -> Powers {
    match profile {
        SoilProfile::Homogeneous => [(2.9, 0.186), (1.2, 0.50), (1.5, 0.73)],
        SoilProfile::Parabolic => [(2.03, 0.27), (1.17, 0.52), (1.42, 0.76)],
        SoilProfile::Linear => [(1.58, 0.34), (1.07, 0.567), (1.38, 0.78)],
    }
}

/// Powers for rigid piles; x is the length divided by the diameter.
fn of_rigid(profile: SoilProfile) -> Powers {
    match profile {
        SoilProfile::Homogeneous => [(6.4, 0.62), (7.1, 1.56), (13.2, 2.5)],
        SoilProfile::Parabolic => [(5.33, 1.07), (7.2, 2.0), (13.0, 3.0)],
        SoilProfile::Linear => [(4.7, 1.53), (7.1, 2.5), (12.7, 3.45)],
    }
}

pub(super) fn flexible(tube: &PileTube, soil: &Soil) -> HeadStiffness {
    let ratio = tube.solid_modulus_pa() / soil.modulus_pa;
    head(tube, soil, of_flexible(soil.profile), ratio)
}

pub(super) fn rigid(tube: &PileTube, soil: &Soil) -> HeadStiffness {
    head(tube, soil, of_rigid(soil.profile), tube.slenderness())
}

fn head(tube: &PileTube, soil: &Soil, powers: Powers, x: f64) -> HeadStiffness {
    let r = 0.5 * tube.diameter_m;
    let factor = 1.0 + 0.6 * (soil.poissons_ratio - 0.25).abs();
    let [lateral, coupling, rocking] =
        powers.map(|(a, b)| factor * soil.modulus_pa * a * x.powf(b));
    HeadStiffness {
        lateral_n_per_m: lateral * r,
        coupling_n: -coupling * r * r,
        rocking_n_m: rocking * r.powi(3),
    }
}
