//! Whether a tower stands: buckling of one that is held, stability of one that floats.

use super::Workspace;
use super::model::{Cut, Model};
use super::options::{Options, SolveError};
use super::reference::load_factor_of_the_beam;
use super::spectrum::Spectrum;
use crate::eigen::{EigenError, EigenWorkspace, Pencil, least, lowest};
use crate::modes::{ByMotion, Energy, Family, RigidBody};
use crate::parts::Problem;
use crate::tower::{Motion, Tower};

/// Frequencies of rigid motions, rad²/s², among which the softest that something resists is looked
/// for.
const SOFTEST: f64 = 1e-8;
const STIFFEST: f64 = 1e12;
/// A motion slower by this than the softest one that something resists is one that nothing resists.
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
    let at_rest = count(model, 0.0);
    if at_rest == 0 {
        return Ok(());
    }
    let softest = softest_resisted(model, at_rest);
    if count(model, -UNRESISTED * softest) > 0 {
        return Err(unstable(tower, model, softest)?);
    }
    // Near enough that the slow modes keep their digits, far enough that the tower's do.
    model.origin = -0.1 * softest;
    Ok(())
}

/// Number of modes of all parts below λ, rad²/s².
fn count(model: &mut Model, lambda: f64) -> usize {
    super::spectrum::count_below(model, lambda)
}

/// About the lowest λ, rad²/s², below which there are more modes than those without resistance:
/// within a factor of 2.
fn softest_resisted(model: &mut Model, without: usize) -> f64 {
    let mut lambda = SOFTEST;
    while lambda < STIFFEST && count(model, lambda) <= without {
        lambda *= 2.0;
    }
    lambda
}

/// Names the motion that grows fastest: one of the whole, or of the tower on its platform.
fn unstable(tower: &Tower, model: &mut Model, scale: f64) -> Result<SolveError, EigenError> {
    let mut below = -scale;
    while count(model, below) > 0 && below > -STIFFEST {
        below *= 2.0;
    }
    model.origin = below;
    let mut workspace = EigenWorkspace::default();
    let mut worst: Option<(f64, usize, Vec<f64>)> = None;
    for part in 0..model.parts() {
        model.with_pencil(part, |pencil| lowest(pencil, 1, &mut workspace))?;
        let Some(lambda) = workspace.eigenvalues().first().map(|e| e.lambda) else {
            continue;
        };
        if worst.as_ref().is_none_or(|(least, ..)| lambda < *least) {
            worst = Some((lambda, part, workspace.vector(0).to_vec()));
        }
    }
    let (lambda, part, vector) = worst.ok_or(EigenError::NotFinite)?;
    let resultants = model.resultants(tower, part, &vector);
    let force = resultants.force.map(|force| force * lambda.sqrt());
    let shares = RigidBody::new(&tower.rigid_inertia(true)).shares(&force);
    let of_the_tower = || {
        let kinetic = resultants.kinetic.shares();
        let strain = ByMotion::default();
        let motion = Energy { kinetic, strain }.main_motion();
        motion.map_or(Family::Coupled, Family::of)
    };
    let rigid = shares.name(&[false; 6]);
    let motion = rigid.map_or_else(of_the_tower, |motion| Family::RIGID[motion]);
    Ok(SolveError::Unstable { motion })
}

/// A tower that bears less than this times its weights is on the verge of buckling: its lowest
/// frequencies are below a tenth of those without weights.
pub(super) const VERGE: f64 = 1.01;

/// Whether weights press a tower that is held.
pub(super) fn is_pressed(tower: &Tower) -> bool {
    tower.gravity_m_per_s2() != 0.0 && !tower.base().floats
}

/// Both planes buckle at much the same weights: so many modes may be near zero.
const NEAR_ZERO: usize = 4;

/// Sets where the spectrum of a tower on the verge of buckling begins: so far below zero that the
/// modes near zero keep their digits beside the others.
pub(super) fn begin_below_zero(model: &mut Model) {
    model.origin = 0.0;
    model.origin = -0.1 * softest_resisted(model, NEAR_ZERO);
}

/// Sets where the spectrum of another mesh of the same tower begins: for a tower that is held at
/// `origin`, as on the first.
pub(super) fn find_origin_again(
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

/// What is wrong with a tower that buckles when it is cut into segments: the tower, or that these
/// are too few.
pub(super) fn buckles(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    load_factor: f64,
    workspace: &mut Workspace,
) -> SolveError {
    let segments = cut.mesh.segments();
    match load_factor_of_the_beam(tower, options, workspace) {
        Some(of_the_beam) if of_the_beam > 1.0 => SolveError::BucklesOnSegments {
            segments,
            load_factor,
            of_the_beam,
        },
        Some(of_the_beam) => SolveError::Buckles {
            load_factor: of_the_beam,
        },
        None => SolveError::Buckles { load_factor },
    }
}

/// The factor by which weights must be multiplied for the tower to buckle; none without gravity, or
/// where it floats. The modes, if they are known, are near the shapes in which it buckles.
///
/// # Errors
/// [`SolveError::Buckles`] if it does.
pub(super) fn buckling_load_factor(
    tower: &Tower,
    model: &mut Model,
    modes: Option<&Spectrum>,
) -> Result<Option<f64>, SolveError> {
    if !is_pressed(tower) {
        return Ok(None);
    }
    let mut lowest_factor = None;
    let mut workspace = EigenWorkspace::default();
    for part in 0..model.parts() {
        let bends = model.motions(part).iter().any(Motion::bends);
        if !bends {
            continue;
        }
        let first = modes.and_then(|modes| modes.first_of(part));
        let find = |pencil: &mut dyn Pencil| least(pencil, &mut workspace);
        match model.with_problem(part, Problem::Buckling, first, find) {
            Ok(factor) => {
                lowest_factor = Some(lowest_factor.map_or(factor, |least: f64| least.min(factor)));
            }
            // Weights too small beside the stiffness to count.
            Err(EigenError::NotFinite) => {}
            Err(error) => return Err(error.into()),
        }
    }
    match lowest_factor {
        Some(load_factor) if load_factor <= 1.0 => Err(SolveError::Buckles { load_factor }),
        factor => Ok(factor),
    }
}
