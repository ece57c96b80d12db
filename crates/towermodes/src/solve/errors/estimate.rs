//! The discretization error of each mode, from meshes that are coarser or finer by halves.

use std::f64::consts::{PI, TAU};

use super::super::error::SolveError;
use super::super::on_mesh::cut::Cut;
use super::super::on_mesh::model::Model;
use super::super::on_mesh::spectrum::{ModeKey, count_below};
use super::super::on_mesh::stability::find_origin_again;
use super::super::progress::Stage;
use super::super::request::options::Options;
use super::super::results::frequencies::Estimated;
use super::super::workspace::{ErrorWorkspace, Workspace};
use super::pairing::pair_by_name;
use super::reference::Reference;
use super::tracking::{Ladder, MORE, frequencies};
use crate::elements::Mesh;
use crate::tower::{Motion, Tower};

/// The origin of the errors of a list of modes; the errors, and the modes that do not converge with
/// the powers of the method, are in the workspace.
pub(crate) struct Estimates {
    /// How many modes another mesh, or the reference, has below the end of the list: if that is
    /// another number than the certificate's, the list ends within the discretization error.
    pub(crate) elsewhere: usize,
    /// The numbers of the modes that were compared with the reference solution.
    pub(crate) compared: Vec<usize>,
}

/// If meshes differ by less than this fraction of a frequency, the larger estimate is used and no
/// reference is computed.
const NEGLIGIBLE: f64 = 1e-5;

/// A segment over which a dimension or a stiffness changes by more than this factor is steep.
const STEEP: f64 = 2.0;

/// Solves again with the segments halved, or doubled where they cannot be halved, and extrapolates.
/// Modes that do not converge regularly are compared with the reference beam solution, and so is
/// every mode on elements whose borders are given: no halving of these shows what they miss.
///
/// The modes are those of the workspace, where their list was proved to end at λ = `below`,
/// rad²/s².
pub(crate) fn estimate_errors(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    below: f64,
    workspace: &mut Workspace,
) -> Result<Estimates, SolveError> {
    workspace.errors.irregular.clear();
    let of_frame_hz = frame_errors_hz(tower, workspace);
    let add_frame_error = |modes: &mut [Estimated]| {
        for (mode, error_hz) in modes.iter_mut().zip(&of_frame_hz) {
            mode.error_hz += error_hz;
        }
    };
    if options.borders_m.is_some() {
        workspace.errors.ladder.meshes.clear();
        let all: Vec<usize> = (0..workspace.errors.modes.len()).collect();
        let compared = compare(tower, options, &all, workspace)?;
        add_soil_error(tower, &mut workspace.errors.modes);
        add_frame_error(&mut workspace.errors.modes);
        return Ok(Estimates {
            elsewhere: count_below(&mut workspace.model, below),
            compared,
        });
    }
    let elsewhere = solve_meshes(tower, cut, options, below, workspace)?;
    // If a section changes much over one segment, meshes can converge regularly to another value.
    let all_are_doubtful = is_steep(tower, &cut.mesh);
    let Workspace { model, errors, .. } = workspace;
    let mut doubtful = Vec::new();
    for (index, mode) in errors.modes.iter_mut().enumerate() {
        let powers = powers(tower, options, model, mode.key);
        let estimate = errors.levels.extrapolate(index, mode.frequency_hz, powers);
        mode.error_hz = estimate.error_hz;
        mode.extrapolated_hz = estimate.extrapolated_hz;
        if !estimate.is_regular {
            errors.irregular.push(index);
        }
        let matters = estimate.error_hz > NEGLIGIBLE * mode.frequency_hz;
        if all_are_doubtful || (!estimate.is_regular && matters) {
            doubtful.push(index);
        }
    }
    let compared = match doubtful.is_empty() {
        true => Vec::new(),
        false => compare(tower, options, &doubtful, workspace)?,
    };
    add_soil_error(tower, &mut workspace.errors.modes);
    add_frame_error(&mut workspace.errors.modes);
    Ok(Estimates {
        elsewhere,
        compared,
    })
}

/// Errors of the elements of a frame under the tower, which no mesh of the tower shows: the change
/// by finer elements, Hz for each mode; none without a frame.
fn frame_errors_hz(tower: &Tower, workspace: &mut Workspace) -> Vec<f64> {
    if tower.frame().is_none() {
        return Vec::new();
    }
    let Workspace {
        model,
        spectrum,
        errors,
        ..
    } = workspace;
    let error_hz = |mode: &Estimated| {
        let lambda = spectrum.eigenvalue(model, mode.key).lambda;
        let change = model.change_on_finer_frame(lambda, spectrum.vector(mode.key));
        // df = dλ/(8π² f); the whole frequency if it is not larger.
        let slope = 8.0 * PI * PI * mode.frequency_hz;
        (change.abs() / slope).min(change.abs().sqrt() / TAU)
    };
    errors.modes.iter().map(error_hz).collect()
}

/// Adds the error due to linear springs in place of the curved spring profile, which no mesh shows.
fn add_soil_error(tower: &Tower, modes: &mut [Estimated]) {
    for mode in modes {
        mode.error_hz += tower.soil_error() * mode.frequency_hz;
    }
}

/// Whether a segment is steep: only the first and the last segment of a span are checked, because
/// the relative change of a linear quantity is largest there.
fn is_steep(tower: &Tower, mesh: &Mesh) -> bool {
    mesh.spans_with_borders().any(|(span, borders_m)| {
        let piece = &tower.pieces()[span.piece];
        let ends = [&borders_m[..2], &borders_m[borders_m.len() - 2..]];
        ends.iter()
            .any(|ends_m| piece.is_steeper(ends_m[0], ends_m[1], STEEP))
    })
}

/// Takes the errors of some modes from the reference beam solution, and returns the numbers of
/// these modes. Where that cannot be solved, the estimates stay as they are, or are the whole
/// frequency where there are none.
///
/// # Errors
/// [`SolveError::Unstable`]: the beam is unstable, which the meshes hide.
fn compare(
    tower: &Tower,
    options: &Options,
    which: &[usize],
    workspace: &mut Workspace,
) -> Result<Vec<usize>, SolveError> {
    let mut compared = Vec::with_capacity(which.len());
    let modes = &workspace.errors.modes;
    let keys: Vec<ModeKey> = which.iter().map(|&index| modes[index].key).collect();
    let found_hz: Vec<f64> = which.iter().map(|&i| modes[i].frequency_hz).collect();
    let reference = match Reference::solve(tower, options, &keys, &found_hz, workspace) {
        Err(error @ SolveError::Unstable { .. }) => return Err(error),
        reference => reference.ok(),
    };
    let partners = match reference {
        Some(_) => pair_by_name(tower, options, &keys, which, workspace),
        None => Vec::new(),
    };
    for (place, &index) in which.iter().enumerate() {
        let mode = &mut workspace.errors.modes[index];
        let beam_hz = reference.as_ref().map(|reference| {
            let beam_hz = reference.frequencies_hz[partners[place]];
            beam_hz.map(|beam_hz| (beam_hz, reference.changes_hz[partners[place]]))
        });
        match beam_hz {
            Some(Some((beam_hz, change_hz))) => {
                mode.error_hz = (mode.frequency_hz - beam_hz).abs() + change_hz;
                mode.extrapolated_hz = beam_hz;
                compared.push(index + 1);
            }
            // The reference buckles, or there is no estimate.
            Some(None) => mode.error_hz = mode.frequency_hz,
            None if mode.error_hz == 0.0 => mode.error_hz = mode.frequency_hz,
            None => {}
        }
    }
    Ok(compared)
}

/// Computes the frequencies of the modes on all meshes of a ladder; returns how many modes the mesh
/// next to their own has below the end of the list.
fn solve_meshes(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    below: f64,
    workspace: &mut Workspace,
) -> Result<usize, SolveError> {
    let steps = steps(tower, options, workspace);
    let Workspace {
        model,
        spectrum,
        errors,
        ..
    } = &mut *workspace;
    errors.keys.clear();
    errors.keys.extend(errors.modes.iter().map(|mode| mode.key));
    errors.guesses.take(&errors.keys, tower, model, spectrum);
    set_ladder(&mut errors.ladder, &cut.mesh, 1, steps, &errors.keys, model);
    let elsewhere = solve_ladder(tower, options, below, workspace)?;
    let Workspace { model, errors, .. } = &mut *workspace;
    if !errors.levels.lacks_coarse() {
        return Ok(elsewhere);
    }
    // A coarser chain may buckle although this one does not: only finer ones give an estimate.
    let fewest = cut.mesh.segments();
    set_ladder(
        &mut errors.ladder,
        &cut.mesh,
        fewest,
        steps,
        &errors.keys,
        model,
    );
    solve_ladder(tower, options, below, workspace)
}

/// The number of other meshes: three meshes at least; on a single piece, which converges smoothly,
/// three do for two powers too.
fn steps(tower: &Tower, options: &Options, workspace: &Workspace) -> usize {
    let Workspace { model, errors, .. } = workspace;
    let is_single = tower.pieces().len() == 1;
    let modes = errors.modes.iter();
    let steps = modes.map(|mode| match powers(tower, options, model, mode.key).len() {
        count if is_single && count > 1 => count,
        count => count + MORE,
    });
    steps.max().unwrap_or(0)
}

/// Makes a ladder of `steps` meshes beside `mesh`: coarser ones while every span can be halved,
/// every family still has its modes and there are no fewer segments than `fewest`, then finer ones.
fn set_ladder(
    ladder: &mut Ladder<Mesh>,
    mesh: &Mesh,
    fewest: usize,
    steps: usize,
    keys: &[ModeKey],
    model: &Model,
) {
    let most = steps.min(mesh.halvings() as usize);
    let is_enough = |halvings: &usize| {
        let segments = mesh.segments() >> halvings;
        segments >= fewest && has_all(segments, keys, model)
    };
    let coarser = (1..=most).take_while(is_enough).count();
    let own = steps - coarser;
    ladder.own = Some(own);
    ladder.meshes.resize_with(1 + steps, Mesh::default);
    for (index, other) in ladder.meshes.iter_mut().enumerate() {
        match index.checked_sub(own) {
            Some(halvings) => mesh.write_halved(halvings as u32, other),
            None => mesh.write_doubled((own - index) as u32, other),
        }
    }
}

/// Computes the frequencies of the same modes on every mesh, and how many modes the mesh next to
/// their own has below `below`: the coarser neighbour if there is one.
fn solve_ladder(
    tower: &Tower,
    options: &Options,
    below: f64,
    workspace: &mut Workspace,
) -> Result<usize, SolveError> {
    let Workspace {
        model,
        spectrum,
        errors,
        ..
    } = workspace;
    let ErrorWorkspace {
        guesses,
        ladder,
        levels,
        keys,
        modes,
        ..
    } = errors;
    let origin = model.origin;
    let (mut elsewhere, mut solved) = (0, 0);
    let own_hz = modes.iter().map(|mode| mode.frequency_hz);
    ladder.solve(own_hz, levels, |index, mesh, level| {
        solved += 1;
        model.monitor.enter(Stage::Errors {
            mesh: solved,
            meshes: ladder.meshes.len() - 1,
            segments: mesh.segments(),
        });
        model.assemble(tower, mesh, 0, options);
        find_origin_again(tower, model, origin)?;
        frequencies(keys, model, spectrum, Some(guesses), level)?;
        if ladder.own.is_some_and(|own| index.abs_diff(own) == 1) {
            elsewhere = count_below(model, below);
        }
        Ok(())
    })?;
    Ok(elsewhere)
}

/// The numbers of segments of the other meshes that were solved last.
pub(crate) fn other_segments(ladder: &Ladder<Mesh>) -> Vec<usize> {
    let meshes = ladder.meshes.iter().enumerate();
    let others = meshes.filter(|(index, _)| ladder.own != Some(*index));
    others.map(|(_, mesh)| mesh.segments()).collect()
}

/// The powers of 1/n in the errors of a mode: those of bending, or of torsion and axial motion,
/// whichever its subsystem has more of.
pub(crate) fn powers(
    tower: &Tower,
    options: &Options,
    model: &Model,
    key: ModeKey,
) -> &'static [i32] {
    let method = options.method;
    let powers_of = |motion: Motion| match motion {
        Motion::Bending(_) => method.bending_powers(tower.shears()),
        Motion::Torsion | Motion::Axial => method.axial_powers(),
    };
    let powers = model.motions(key.subsystem).iter().map(powers_of);
    powers.max_by_key(|powers| powers.len()).unwrap_or_default()
}

/// Whether a mesh is fine enough to have every mode of the list: every element has at least two
/// joint coordinates per segment in a bending plane, one in torsion and one axially.
fn has_all(segments: usize, keys: &[ModeKey], model: &Model) -> bool {
    let coordinates = |motion: Motion| 1 + usize::from(motion.bends());
    keys.iter().all(|key| {
        let motions = model.motions(key.subsystem).iter();
        key.order <= motions.map(coordinates).sum::<usize>() * segments
    })
}
