//! The equilibrium of a floating tower, by Newton's method on its six rigid motions.

use super::afloat::{Afloat, Loads};
use super::mistake::{EquilibriumError, MOST_TILT_DEG};
use crate::mooring::{Mooring, MooringError, MooringWorkspace, Pose, cross};
use crate::space::{SpatialMatrix, add_scaled, eigenpairs, times};

/// Steps after which the search has failed.
const MAX_STEPS: usize = 100;
/// The longest displacement of one step, m.
const LONGEST_M: f64 = 10.0;
/// The largest rotation of one step, rad.
const LARGEST_RAD: f64 = 0.2;
/// The search ends with a step smaller than this (m, rad); the remaining error is of the order of
/// its square.
const CLOSE: f64 = 1e-9;
/// Maximum number of halvings of a step.
const HALVINGS: usize = 12;
/// A remaining force below this fraction of the weight is a rounding error.
const ROUNDING: f64 = 1e-7;
/// A scaled stiffness below this is treated as zero.
const FREE: f64 = 1e-12;
const MOTIONS: [&str; 6] = ["surge", "sway", "heave", "roll", "pitch", "yaw"];

/// The pose of the reference point in which weights, buoyancy and lines are in balance.
///
/// Weights and buoyancy change linearly by their stiffness at the reference position; the forces of
/// the lines are exact.
pub(super) fn equilibrium(afloat: &Afloat) -> Result<Pose, EquilibriumError> {
    if afloat.gravity_m_per_s2 == 0.0 {
        return Err(EquilibriumError::NoGravity);
    }
    let loads = afloat.loads().ok_or(EquilibriumError::NoBuoyancy)?;
    let lines = afloat.platform.mooring_lines.as_ref();
    let lines = lines.map(|lines| lines.mooring_about(afloat.reference_m()));
    let mut search = Search {
        loads,
        lines: lines.transpose().map_err(EquilibriumError::Lines)?,
        workspace: MooringWorkspace::default(),
    };
    let masses = [afloat.platform_mass(), afloat.tower, afloat.rna];
    let weight_n = masses.iter().map(|mass| afloat.weight_n(*mass)).sum();
    search.run(weight_n)
}

struct Search {
    loads: Loads,
    lines: Option<Mooring>,
    workspace: MooringWorkspace,
}

impl Search {
    fn run(&mut self, weight_n: f64) -> Result<Pose, EquilibriumError> {
        let mut pose = Pose::default();
        for _ in 0..MAX_STEPS {
            let here = self.at(&pose).map_err(EquilibriumError::Lines)?;
            let step = newton_step(&here).map_err(|motion| unstable(motion, &pose))?;
            if step.iter().all(|part| part.abs() < CLOSE) {
                let pose = pose.moved(step);
                self.check(&pose, weight_n)?;
                return Ok(pose);
            }
            pose = self.advance(&pose, &here, step);
        }
        self.check(&pose, weight_n)?;
        Ok(pose)
    }

    /// All forces at a pose, and their stiffness.
    fn at(&mut self, pose: &Pose) -> Result<Loads, MooringError> {
        let mut sum = self.loads;
        let [dx, dy, dz] = pose.displacement_m;
        let turned @ [rx, ry, rz] = pose.rotation_rad();
        let restoring = times(&self.loads.stiffness, &[dx, dy, dz, rx, ry, rz]);
        for (force, restoring) in sum.force.iter_mut().zip(restoring) {
            *force -= restoring;
        }
        // The moment in fixed axes changes by half of M × θ more than the symmetric stiffness says.
        let [_, _, _, moment @ ..] = self.loads.force;
        for (force, half) in sum.force[3..].iter_mut().zip(cross(moment, turned)) {
            *force -= 0.5 * half;
        }
        if let Some(lines) = &self.lines {
            let load = lines.load(pose, &mut self.workspace)?;
            for (sum, force) in sum.force.iter_mut().zip(load.force) {
                *sum += force;
            }
            add_scaled(&mut sum.stiffness, 1.0, &load.stiffness);
        }
        Ok(sum)
    }

    /// The pose after a step, or after a fraction of it if the whole step is too long.
    fn advance(&mut self, pose: &Pose, here: &Loads, step: [f64; 6]) -> Pose {
        let largest = |part: &[f64]| part.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let limits = [
            LONGEST_M / largest(&step[..3]),
            LARGEST_RAD / largest(&step[3..]),
        ];
        let mut factor = limits.into_iter().fold(1.0, f64::min);
        let mut next = pose.moved(step.map(|part| factor * part));
        for _ in 0..HALVINGS {
            // The work along the step decreases to zero at the best step length and is negative
            // beyond it.
            let is_good = match self.at(&next) {
                Ok(there) => work(&step, &there.force) >= -0.5 * work(&step, &here.force),
                Err(_) => false,
            };
            if is_good {
                break;
            }
            factor *= 0.5;
            next = pose.moved(step.map(|part| factor * part));
        }
        next
    }

    fn check(&mut self, pose: &Pose, weight_n: f64) -> Result<(), EquilibriumError> {
        let left = self.at(pose).map_err(EquilibriumError::Lines)?.force;
        let sizes = left.iter().zip(MOTIONS);
        let (left, motion) = sizes.fold((0.0_f64, ""), |most, (force, motion)| {
            match force.abs() > most.0 {
                true => (force.abs(), motion),
                false => most,
            }
        });
        if left > ROUNDING * weight_n {
            return Err(EquilibriumError::NotHeld { motion, left });
        }
        let tilt_deg = tilt_deg(pose);
        match tilt_deg > MOST_TILT_DEG {
            true => Err(EquilibriumError::Tilts { tilt_deg }),
            false => Ok(()),
        }
    }
}

/// The angle of the axis of a tower at a pose, degrees.
fn tilt_deg(pose: &Pose) -> f64 {
    pose.rotation[2][2].clamp(-1.0, 1.0).acos().to_degrees()
}

/// The error of an unstable motion at a pose.
fn unstable(motion: &'static str, pose: &Pose) -> EquilibriumError {
    let [x, y, z] = pose.displacement_m;
    let (shift_m, tilt_deg) = (x.hypot(y).hypot(z), tilt_deg(pose));
    match *pose == Pose::default() {
        true => EquilibriumError::Unstable { motion },
        false => EquilibriumError::UnstableAway {
            motion,
            shift_m,
            tilt_deg,
        },
    }
}

/// The work of forces along a step, N m.
fn work(step: &[f64; 6], force: &[f64; 6]) -> f64 {
    step.iter()
        .zip(force)
        .map(|(step, force)| step * force)
        .sum()
}

/// K⁻¹ F in units in which the diagonal of K is 1; none in a motion without stiffness, which only
/// weights beside the axis couple with others. Fails with the motion of a negative stiffness.
fn newton_step(loads: &Loads) -> Result<[f64; 6], &'static str> {
    let unit: [f64; 6] = std::array::from_fn(|i| match loads.stiffness[i][i] {
        0.0 => 0.0,
        own => 1.0 / own.abs().sqrt(),
    });
    let scaled: SpatialMatrix =
        std::array::from_fn(|i| std::array::from_fn(|j| loads.stiffness[i][j] * unit[i] * unit[j]));
    let (values, vectors) = eigenpairs(scaled);
    let mut step = [0.0; 6];
    for (value, vector) in values.iter().zip(&vectors) {
        if *value < -FREE {
            let largest = (0..6).fold(0, |most, i| {
                if vector[i].abs() > vector[most].abs() {
                    i
                } else {
                    most
                }
            });
            return Err(MOTIONS[largest]);
        }
        if *value > FREE {
            let scaled: f64 = (0..6).map(|i| vector[i] * unit[i] * loads.force[i]).sum();
            for i in 0..6 {
                step[i] += unit[i] * vector[i] * scaled / value;
            }
        }
    }
    Ok(step)
}
