//! The reference beam solution: spectral elements with the physics of a method, where its meshes do
//! not converge regularly.

use super::super::error::SolveError;
use super::super::on_mesh::cut::Cut;
use super::super::on_mesh::model::Model;
use super::super::on_mesh::spectral_cut::{CONVERGED, can_be_finer, finer, first_cut};
use super::super::on_mesh::spectrum::ModeKey;
use super::super::on_mesh::stability::{buckling_load_factor, find_origin_again};
use super::super::progress::Stage;
use super::super::request::cost::Cost;
use super::super::request::options::Options;
use super::super::workspace::Workspace;
use super::tracking::{Level, frequencies};
use crate::Method;
use crate::beam::BeamRecipe;
use crate::tower::Tower;

/// The degree increases until the change of the reference is below this fraction of the error that
/// it determines.
const BESIDE_THE_ERROR: f64 = 0.1;

/// The largest number of increases of the degree; a remaining change is added to the error.
const MOST_RAISES: usize = 6;

/// A reference that is estimated to take longer, s, is not made: the estimate of the meshes stays,
/// with its warning.
const MOST_SECONDS: f64 = 10.0;

/// The frequencies of modes by the reference beam solution.
pub(crate) struct Reference {
    /// Frequencies, Hz; none for modes that are unstable because of self-weight.
    pub(super) frequencies_hz: Level,
    /// Possible error of each frequency, Hz: its change from one degree to the next.
    pub(super) changes_hz: Vec<f64>,
}

impl Reference {
    /// Solves for the modes `keys`, whose frequencies by the method are `found_hz`, until the
    /// reference is known well enough to determine their errors. The model of the workspace is
    /// that of the beam afterwards.
    ///
    /// # Errors
    /// [`SolveError`]: the beam is too large, or its modes cannot be found.
    pub(crate) fn solve(
        tower: &Tower,
        options: &Options,
        keys: &[ModeKey],
        found_hz: &[f64],
        workspace: &mut Workspace,
    ) -> Result<Self, SolveError> {
        let beam = options_of_the_beam(options);
        let origin = workspace.model.origin;
        let mut solve = |cut: &Cut| {
            let Workspace {
                model, spectrum, ..
            } = &mut *workspace;
            assemble(tower, cut, options, model)?;
            find_origin_again(tower, model, origin)?;
            let mut level = Level::new();
            frequencies(keys, model, spectrum, None, &mut level)?;
            Ok::<_, SolveError>(level)
        };
        let mut cut = first_cut(tower, &beam)?;
        let mut frequencies_hz = solve(&cut)?;
        let mut changes_hz = Vec::new();
        for _ in 0..MOST_RAISES {
            cut = finer(cut, &beam);
            let after = solve(&cut)?;
            changes_hz = changes(&frequencies_hz, &after);
            frequencies_hz = after;
            if is_known(found_hz, &frequencies_hz, &changes_hz) || !can_be_finer(&cut, &beam) {
                break;
            }
        }
        Ok(Self {
            frequencies_hz,
            changes_hz,
        })
    }
}

/// The reference solution with the same number of modes, without rotary inertia if the method has
/// none.
fn options_of_the_beam(options: &Options) -> Options {
    Options {
        method: Method::Spectral,
        segments: None,
        borders_m: None,
        degree: None,
        rotary_inertia: options.has_rotary_inertia(),
        ..options.clone()
    }
}

/// Refuses a reference solution that would take too long for an error estimate.
fn check_cost(tower: &Tower, cut: &Cut, options: &Options) -> Result<(), SolveError> {
    let cost = Cost::of(tower, cut, &options_of_the_beam(options));
    cost.check(options.modes)?;
    if cost.seconds > MOST_SECONDS {
        return Err(SolveError::TooSlow {
            modes: options.modes,
            degrees_of_freedom: cost.unknowns as usize,
            seconds: cost.seconds,
        });
    }
    Ok(())
}

/// Assembles the beam model with the effects that the method includes: BModes has no shear
/// deformation.
fn assemble(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    model: &mut Model,
) -> Result<(), SolveError> {
    check_cost(tower, cut, options)?;
    model.monitor.enter(Stage::Reference {
        elements: cut.mesh.segments(),
        degree: cut.degree,
    });
    let recipe = BeamRecipe::Spectral {
        degree: cut.degree,
        rotary_inertia: options.has_rotary_inertia(),
        shear: options.method != Method::Bmodes,
    };
    model.assemble_beams(tower, &cut.mesh, recipe);
    Ok(())
}

/// The buckling load factor of the reference beam solution; none if it cannot be computed.
/// Afterwards the workspace contains the beam model.
fn load_factor_of_the_beam(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
) -> Option<f64> {
    let beam = options_of_the_beam(options);
    let cut = finer(first_cut(tower, &beam).ok()?, &beam);
    assemble(tower, &cut, options, &mut workspace.model).ok()?;
    match buckling_load_factor(tower, &mut workspace.model, None) {
        Ok(load_factor) => load_factor,
        Err(SolveError::Buckles { load_factor }) => Some(load_factor),
        Err(_) => None,
    }
}

/// The error for a discretized tower that buckles: the reference solution shows whether the tower
/// itself buckles, or only the model because it has too few segments.
pub(crate) fn buckles(
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

fn changes(before: &Level, after: &Level) -> Vec<f64> {
    let change = |(a, b): (&Option<f64>, &Option<f64>)| match (a, b) {
        (Some(a), Some(b)) => (a - b).abs(),
        _ => 0.0,
    };
    before.iter().zip(after).map(change).collect()
}

/// Whether the reference is accurate enough: its last change is small relative to the difference
/// between method and reference, or to the frequency.
fn is_known(found_hz: &[f64], beam_hz: &Level, changes_hz: &[f64]) -> bool {
    let mut all = found_hz.iter().zip(beam_hz).zip(changes_hz);
    all.all(|((found_hz, beam_hz), change_hz)| {
        let Some(beam_hz) = beam_hz else { return true };
        let error_hz = (found_hz - beam_hz).abs();
        *change_hz <= (BESIDE_THE_ERROR * error_hz).max(CONVERGED * found_hz)
    })
}
