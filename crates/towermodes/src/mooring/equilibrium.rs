//! The equilibrium of the free points, bodies and rods, by Newton's method.

use super::assembly::Assembly;
use super::error::{MooringError, MooringItem};
use super::pose::Placement;
use super::system::{FreePart, Mooring};
use super::vector::{Vector, length};

/// Steps after which the search has failed.
const MAX_STEPS: usize = 300;
/// The longest displacement of one step, m.
const LONGEST_M: f64 = 10.0;
/// The largest rotation of one step, rad.
const LARGEST_RAD: f64 = 0.2;
/// A step with a larger rotation follows a motion without stiffness, such as the rotation of a rod
/// about its axis, rad.
const WILD_RAD: f64 = 2.0;
/// The search ends with a step smaller than this fraction of the depth, or than this angle (rad);
/// the remaining error is of the order of its square.
const CLOSE: f64 = 1e-10;
/// A remaining force below this fraction of the largest tension is a rounding error.
const ROUNDING: f64 = 1e-8;
/// Maximum number of halvings of a step.
const HALVINGS: usize = 12;
/// Fractions of its scale that are added to each stiffness until all pivots are positive. None is
/// 1, with which a negative stiffness would become zero.
const SHIFTS: [f64; 8] = [0.0, 3e-8, 3e-6, 3e-4, 3e-2, 3.0, 3e2, 3e4];

/// The memory of a search; a second search allocates nothing.
#[derive(Debug, Clone, Default)]
pub(super) struct Search {
    pub(super) assembly: Assembly,
    /// The free parts at the equilibrium.
    pub(super) free: Vec<Placement>,
    before: Vec<Placement>,
    step: Vec<f64>,
}

impl Search {
    /// Moves the free parts to their equilibrium, and eliminates them from the stiffness.
    ///
    /// The search begins where the description begins, so that the result does not depend on
    /// results before it.
    pub(super) fn run(
        &mut self,
        mooring: &Mooring,
        platform: &Placement,
    ) -> Result<(), MooringError> {
        self.free.clear();
        self.free.extend(mooring.free.iter().map(|part| part.start));
        self.assembly.hang(mooring, platform, &self.free)?;
        for _ in 0..MAX_STEPS {
            if self.advance(mooring, platform)? {
                return self.settle(mooring, platform);
            }
        }
        Err(self.failure(mooring))
    }

    /// Makes one step; returns whether it was the last one.
    fn advance(&mut self, mooring: &Mooring, platform: &Placement) -> Result<bool, MooringError> {
        if mooring.free.is_empty() {
            return Ok(true);
        }
        let shift = self.direct(mooring, platform)?;
        let (far_m, far_rad) = self.sizes(mooring);
        let work = self.work();
        let mut factor = (LONGEST_M / far_m).min(LARGEST_RAD / far_rad).min(1.0);
        self.before.clear();
        self.before.extend_from_slice(&self.free);
        for _ in 0..HALVINGS {
            self.step_by(mooring, factor);
            self.assembly.hang(mooring, platform, &self.free)?;
            // The work along the step decreases to zero at the best step length and is negative
            // beyond it.
            if self.work() >= -0.5 * work {
                break;
            }
            factor *= 0.5;
        }
        let is_close = far_m <= CLOSE * mooring.description.depth_m && far_rad <= CLOSE;
        if is_close && shift > 0.0 {
            return Err(MooringError::Unstable {
                item: self.item_of(mooring, 0),
            });
        }
        Ok(is_close)
    }

    /// Computes the step of Newton's method with the smallest shift for which the stiffness is
    /// positive and the rotations are moderate; returns the shift.
    fn direct(&mut self, mooring: &Mooring, platform: &Placement) -> Result<f64, MooringError> {
        let mut failed = None;
        for shift in SHIFTS {
            self.assembly.stiffen(mooring, platform, &self.free);
            let Assembly {
                stiffness,
                scales,
                force,
                ..
            } = &mut self.assembly;
            failed = stiffness.factor(scales, shift).err();
            if failed.is_none() {
                self.step.clear();
                self.step.extend_from_slice(&force[..mooring.unknowns]);
                stiffness.solve(&mut self.step);
                if self.sizes(mooring).1 <= WILD_RAD {
                    return Ok(shift);
                }
            }
        }
        match failed {
            None => Ok(SHIFTS[SHIFTS.len() - 1]),
            Some(pivot) => Err(MooringError::Unstable {
                item: self.item_of(mooring, pivot),
            }),
        }
    }

    /// The stiffness of the platform with the free parts in equilibrium.
    fn settle(&mut self, mooring: &Mooring, platform: &Placement) -> Result<(), MooringError> {
        let pulls = self
            .assembly
            .hung
            .iter()
            .flat_map(|hung| hung.forces_n.map(length));
        let most_n = pulls.fold(0.0, f64::max);
        if self.residual(mooring).1 > ROUNDING * most_n {
            return Err(self.failure(mooring));
        }
        self.assembly.stiffen(mooring, platform, &self.free);
        let Assembly {
            stiffness, scales, ..
        } = &mut self.assembly;
        let factored = stiffness.factor(scales, 0.0);
        factored.map_err(|pivot| MooringError::Unstable {
            item: self.item_of(mooring, pivot),
        })
    }

    /// The largest displacement (m) and rotation (rad) of the step.
    fn sizes(&self, mooring: &Mooring) -> (f64, f64) {
        let parts = mooring.free.iter().map(|part| part.motion(&self.step));
        parts.fold(
            (0.0, 0.0),
            |(far_m, far_rad), (displacement_m, rotation_rad)| {
                let both = (length(displacement_m), length(rotation_rad));
                (both.0.max(far_m), both.1.max(far_rad))
            },
        )
    }

    /// The work of the forces along the step, N m.
    fn work(&self) -> f64 {
        let products = self
            .step
            .iter()
            .zip(&self.assembly.force)
            .map(|(u, f)| u * f);
        products.sum()
    }

    fn step_by(&mut self, mooring: &Mooring, factor: f64) {
        let places = self.free.iter_mut().zip(&self.before);
        for ((place, before), part) in places.zip(&mooring.free) {
            let (displacement_m, rotation_rad) = part.motion(&self.step);
            let [displacement_m, rotation_rad] =
                [displacement_m, rotation_rad].map(|motion| motion.map(|u| factor * u));
            *place = before.moved(displacement_m, rotation_rad);
        }
    }

    /// The reason if the search has not ended: a part under the seabed, or a remaining force.
    fn failure(&self, mooring: &Mooring) -> MooringError {
        let depth_m = mooring.description.depth_m;
        for (part, place) in mooring.free.iter().zip(&self.free) {
            let (item, z_m) = (part.item, place.origin_m[2]);
            if z_m < -depth_m {
                return MooringError::Sinks { item, z_m, depth_m };
            }
        }
        let (item, force_n) = self.residual(mooring);
        MooringError::NoEquilibrium {
            item,
            force_n,
            steps: MAX_STEPS,
        }
    }

    /// The free part with the largest remaining force, and this force, N.
    fn residual(&self, mooring: &Mooring) -> (MooringItem, f64) {
        let left = mooring.free.iter().map(|part| {
            let force_n = length(part.motion(&self.assembly.force).0);
            (part.item, force_n)
        });
        left.fold((MooringItem::Site, 0.0), |most, next| {
            if next.1 >= most.1 { next } else { most }
        })
    }

    fn item_of(&self, mooring: &Mooring, unknown: usize) -> MooringItem {
        let after = mooring.free.partition_point(|part| part.first <= unknown);
        mooring.free[after - 1].item
    }
}

impl FreePart {
    /// The displacement and rotation of the part in a vector of all unknowns.
    fn motion(&self, all: &[f64]) -> (Vector, Vector) {
        let of = |first: usize| [all[first], all[first + 1], all[first + 2]];
        let rotation = if self.turns {
            of(self.first + 3)
        } else {
            [0.0; 3]
        };
        (of(self.first), rotation)
    }
}
