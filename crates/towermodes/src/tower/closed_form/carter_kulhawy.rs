//! Carter & Kulhawy (1992): rigid piles and sockets in homogeneous soil or rock.

use super::head::HeadStiffness;
use super::pile_tube::PileTube;

pub(super) fn carter_kulhawy(tube: &PileTube, g_star_pa: f64) -> HeadStiffness {
    let d = tube.diameter_m;
    let x = 2.0 * tube.slenderness();
    HeadStiffness::from_compliance(
        0.4 / (g_star_pa * d) * x.powf(-1.0 / 3.0),
        0.3 / (g_star_pa * d * d) * x.powf(-7.0 / 8.0),
        0.8 / (g_star_pa * d.powi(3)) * x.powf(-5.0 / 3.0),
    )
}
