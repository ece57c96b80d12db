//! Stability: buckling of a tower on a foundation, rigid-body stability of a floating one.

use super::super::error::SolveError;
use super::model::Model;
use super::spectrum::{Spectrum, count_below};
use crate::eigen::{EigenError, EigenWorkspace, Pencil, least, lowest};
use crate::modes::{RigidTower, Shares};
use crate::subsystem::Eigenproblem;
use crate::tower::{Motion, Tower};

/// Lower end of the range of λ, rad²/s², in which the softest rigid-body motion with stiffness is
/// searched.
const SOFTEST: f64 = 1e-8;
const STIFFEST: f64 = 1e12;
/// A motion whose λ is smaller than that of the softest motion with stiffness by this factor has no
/// stiffness.
const UNRESISTED: f64 = 1e-6;

/// Sets where the spectrum of a floating tower begins: at 0, or below if nothing resists some
/// motion.
///
/// # Errors
/// [`SolveError::Unstable`] if a motion grows by itself.
pub(super) fn find_origin(tower: &Tower, model: &mut Model) -> Result<(), SolveError> {
    model.origin = 0.0;
    if !tower.base().floats {
        return Ok(());
    }
    let at_rest = count_below(model, 0.0);
    if at_rest == 0 {
        return Ok(());
    }
    let softest = softest_resisted(model, at_rest);
    if count_below(model, -UNRESISTED * softest) > 0 {
        return Err(unstable(tower, model, softest)?);
    }
    // Near enough that the slow modes keep their digits, far enough that the modes of the tower
    // keep theirs.
    model.origin = -0.1 * softest;
    Ok(())
}

/// About the lowest λ, rad²/s², below which there are more modes than those without resistance:
/// within a factor of 2.
fn softest_resisted(model: &mut Model, without: usize) -> f64 {
    let mut lambda = SOFTEST;
    while lambda < STIFFEST && count_below(model, lambda) <= without {
        lambda *= 2.0;
    }
    lambda
}

/// Names the motion that grows fastest: a rigid-body motion, or one of the tower on its platform.
fn unstable(tower: &Tower, model: &mut Model, scale: f64) -> Result<SolveError, EigenError> {
    let mut below = -scale;
    while count_below(model, below) > 0 && below > -STIFFEST {
        below *= 2.0;
    }
    model.origin = below;
    let mut workspace = EigenWorkspace::default();
    let mut worst: Option<(f64, usize, Vec<f64>)> = None;
    for index in 0..model.count() {
        lowest(&mut model.vibration(index), 1, &mut workspace)?;
        let Some(lambda) = workspace.eigenvalues().first().map(|e| e.lambda) else {
            continue;
        };
        if worst.as_ref().is_none_or(|(least, ..)| lambda < *least) {
            worst = Some((lambda, index, workspace.vector(0).to_vec()));
        }
    }
    let (lambda, index, vector) = worst.ok_or(EigenError::NotFinite)?;
    let forces = model.modal_forces(index, &vector);
    let force = forces.force.map(|force| force * lambda.sqrt());
    let rigid = RigidTower::new(&model.rigid_inertia(tower, true)).shares(&force);
    let motion = Shares::afloat(&forces.kinetic.shares(), &rigid).largest();
    Ok(SolveError::Unstable { motion })
}

/// A tower with a smaller buckling load factor is on the verge of buckling: its lowest frequencies
/// are below a tenth of those without gravity.
pub(crate) const VERGE: f64 = 1.01;

/// Whether self-weight can buckle a tower: it has gravity and does not float.
pub(super) fn can_buckle(tower: &Tower) -> bool {
    tower.gravity_m_per_s2() != 0.0 && !tower.base().floats
}

/// Refuses a tower that buckles. The buckling load factor is computed only if a count does not
/// prove that it is above that of a tower on the verge of buckling.
///
/// # Errors
/// As [`buckling_load_factor`].
pub(super) fn check_buckling(
    tower: &Tower,
    model: &mut Model,
    modes: &Spectrum,
) -> Result<(), SolveError> {
    if !can_buckle(tower) {
        return Ok(());
    }
    let mut is_near = false;
    for index in 0..model.count() {
        let bends = model.motions(index).iter().any(Motion::bends);
        is_near |= bends
            && model
                .pencil(index, Eigenproblem::Buckling)
                .count_below(VERGE)
                > 0;
    }
    match is_near {
        true => buckling_load_factor(tower, model, Some(modes)).map(|_| ()),
        false => Ok(()),
    }
}

/// If both planes buckle at nearly the same load, this number of modes may be near zero.
const NEAR_ZERO: usize = 4;

/// Sets where the spectrum of a tower on the verge of buckling begins: far enough below zero that
/// the modes near zero keep their digits relative to the others.
pub(super) fn begin_below_zero(model: &mut Model) {
    model.origin = 0.0;
    model.origin = -0.1 * softest_resisted(model, NEAR_ZERO);
}

/// Sets where the spectrum of another mesh of the same tower begins: for a tower that is held at
/// `origin`, as on the first.
pub(crate) fn find_origin_again(
    tower: &Tower,
    model: &mut Model,
    origin: f64,
) -> Result<(), SolveError> {
    find_origin(tower, model)?;
    if !tower.base().floats {
        model.origin = origin;
    }
    Ok(())
}

/// The factor by which self-weight must be multiplied for the tower to buckle; none without
/// gravity, or where it floats. The modes, if they are known, are near the buckling shapes.
///
/// # Errors
/// [`SolveError::Buckles`] if it does.
pub(crate) fn buckling_load_factor(
    tower: &Tower,
    model: &mut Model,
    modes: Option<&Spectrum>,
) -> Result<Option<f64>, SolveError> {
    if !can_buckle(tower) {
        return Ok(None);
    }
    let mut lowest_factor = None;
    let mut workspace = EigenWorkspace::default();
    for index in 0..model.count() {
        let bends = model.motions(index).iter().any(Motion::bends);
        if !bends {
            continue;
        }
        let start = modes.and_then(|modes| modes.near_lowest(index));
        let pencil = model.pencil(index, Eigenproblem::Buckling);
        match least(&mut pencil.starting_from(start.as_deref()), &mut workspace) {
            Ok(factor) => {
                lowest_factor = Some(lowest_factor.map_or(factor, |least: f64| least.min(factor)));
            }
            // Self-weight is negligible relative to the stiffness.
            Err(EigenError::NotFinite) => {}
            Err(error) => return Err(error.into()),
        }
    }
    match lowest_factor {
        Some(load_factor) if load_factor <= 1.0 => Err(SolveError::Buckles { load_factor }),
        factor => Ok(factor),
    }
}
