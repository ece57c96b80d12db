//! Poulos & Davis (1980): rigid and flexible piles on springs.

use super::head::HeadStiffness;
use super::monopile::PileBehaviour;

/// The largest reduced length of a rigid pile and the least of a flexible one, for springs that are
/// constant and for springs that grow with depth.
const LIMITS: [[f64; 2]; 2] = [[1.5, 2.5], [2.0, 4.0]];

/// A pile on springs n z^m, m = 0 or 1.
pub(super) struct Pile {
    pub(super) is_linear: bool,
    pub(super) bending_n_m2: f64,
    pub(super) length_m: f64,
    /// η = (n/EI)^(1/(4+m)), 1/m.
    pub(super) per_m: f64,
}

impl Pile {
    pub(super) fn limits(&self) -> [f64; 2] {
        LIMITS[usize::from(self.is_linear)]
    }

    /// The formula for rigid or for flexible piles by the limits; between the limits the one with
    /// the smaller moment per rotation of a head that is free to translate, because each formula
    /// neglects a part of the motion.
    pub(super) fn head(&self) -> HeadStiffness {
        let [rigid_at_most, flexible_at_least] = self.limits();
        let reduced = self.per_m * self.length_m;
        if reduced <= rigid_at_most {
            return self.form(PileBehaviour::Rigid);
        }
        let flexible = self.form(PileBehaviour::Flexible);
        if reduced >= flexible_at_least {
            return flexible;
        }
        let rigid = self.form(PileBehaviour::Rigid);
        match rigid.free_rocking_n_m() < flexible.free_rocking_n_m() {
            true => rigid,
            false => flexible,
        }
    }

    fn form(&self, behaviour: PileBehaviour) -> HeadStiffness {
        let m = f64::from(u8::from(self.is_linear));
        let reduced = self.per_m * self.length_m;
        let [lateral, coupling, rocking] = match (behaviour, self.is_linear) {
            (PileBehaviour::Rigid, _) => {
                [1.0, 2.0, 3.0].map(|power| reduced.powf(m + power) / (m + power))
            }
            (_, false) => [std::f64::consts::SQRT_2, 1.0, std::f64::consts::SQRT_2],
            (_, true) => [1.074, 0.99, 1.48],
        };
        let (bending_n_m2, eta) = (self.bending_n_m2, self.per_m);
        HeadStiffness {
            lateral_n_per_m: lateral * bending_n_m2 * eta.powi(3),
            coupling_n: -coupling * bending_n_m2 * eta * eta,
            rocking_n_m: rocking * bending_n_m2 * eta,
        }
    }
}
