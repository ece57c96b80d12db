//! The discretization error of each mode, from meshes that are coarser or finer by halves.

use super::cut::Cut;
use super::error::SolveError;
use super::model::Model;
use super::one_mesh::Described;
use super::options::Options;
use super::progress::Stage;
use super::reference::Reference;
use super::solution::{ErrorBasis, Mode};
use super::spectrum::{ModeKey, count_below};
use super::stability::find_origin_again;
use super::tracking::{Ladder, Levels, MORE, frequencies};
use super::workspace::Workspace;
use crate::elements::Mesh;
use crate::tower::{Motion, Tower};

/// The results of other meshes, or of the reference solution, and the error of each mode.
pub(super) struct Estimates {
    /// How many modes another mesh, or the reference, has below the end of the list: if that is
    /// another number than the certificate's, the list ends within the discretization error.
    pub(super) elsewhere: usize,
    /// Places in the list, from 0, of modes that do not converge with the powers of the method.
    pub(super) irregular: Vec<usize>,
    /// Which meshes and modes the errors are from.
    pub(super) basis: ErrorBasis,
}

/// The modes on the meshes of a ladder.
struct Solved {
    levels: Levels,
    /// How many modes the mesh next to their own has below the end of the list.
    elsewhere: usize,
    /// The numbers of segments of the other meshes.
    segments: Vec<usize>,
}

/// Where meshes disagree by less than this fraction of a frequency the larger estimate is enough,
/// and no reference is computed.
const NEGLIGIBLE: f64 = 1e-5;

/// A segment over which a dimension or a stiffness changes by more than this factor is steep.
const STEEP: f64 = 2.0;

/// Solves again with the segments halved, or doubled where they cannot be halved, and extrapolates.
/// Modes that do not converge regularly are compared with the reference beam solution, and so is
/// every mode on elements whose borders are given: no halving of these shows what they miss.
pub(super) fn estimate_errors(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    result: &mut Described,
    workspace: &mut Workspace,
) -> Result<Estimates, SolveError> {
    let (modes, below) = (&mut result.modes, result.below);
    if options.borders_m.is_some() {
        let all: Vec<usize> = (0..modes.len()).collect();
        let compared = compare(tower, options, modes, &all, workspace);
        return Ok(Estimates {
            elsewhere: count_below(&mut workspace.model, below),
            irregular: Vec::new(),
            basis: ErrorBasis {
                segments: Vec::new(),
                compared,
            },
        });
    }
    let powers = powers(tower, options, &workspace.model);
    let solved = solve_meshes(tower, cut, options, (modes, below), &powers, workspace)?;
    let levels = solved.levels;
    // Where a section changes much over one segment meshes can converge regularly to something
    // else.
    let all_are_doubtful = is_steep(tower, &cut.mesh);
    let (mut irregular, mut doubtful) = (Vec::new(), Vec::new());
    for (index, mode) in modes.iter_mut().enumerate() {
        let estimate = levels.extrapolate(index, mode.frequency_hz, powers[mode.key.subsystem]);
        mode.discretization_error_hz = estimate.error_hz;
        mode.extrapolated_hz = estimate.extrapolated_hz;
        if !estimate.is_regular {
            irregular.push(index);
        }
        let matters = estimate.error_hz > NEGLIGIBLE * mode.frequency_hz;
        if all_are_doubtful || (!estimate.is_regular && matters) {
            doubtful.push(index);
        }
    }
    let compared = match doubtful.is_empty() {
        true => Vec::new(),
        false => compare(tower, options, modes, &doubtful, workspace),
    };
    Ok(Estimates {
        elsewhere: solved.elsewhere,
        irregular,
        basis: ErrorBasis {
            segments: solved.segments,
            compared,
        },
    })
}

/// Whether a segment is steep: the first or the last of a span, because what is linear changes most
/// where it is least.
fn is_steep(tower: &Tower, mesh: &Mesh) -> bool {
    mesh.spans_with_borders().any(|(span, borders_m)| {
        let piece = &tower.pieces()[span.piece];
        let ends = [&borders_m[..2], &borders_m[borders_m.len() - 2..]];
        ends.iter()
            .any(|ends_m| piece.steepness(ends_m[0], ends_m[1]) > STEEP)
    })
}

/// Takes the errors of some modes from the reference beam solution, and returns the numbers of
/// these modes. Where that cannot be solved, the estimates stay as they are, or are the whole
/// frequency where there are none.
fn compare(
    tower: &Tower,
    options: &Options,
    modes: &mut [Mode],
    which: &[usize],
    workspace: &mut Workspace,
) -> Vec<usize> {
    let mut compared = Vec::with_capacity(which.len());
    let keys: Vec<ModeKey> = which.iter().map(|&index| modes[index].key).collect();
    let found_hz: Vec<f64> = which.iter().map(|&i| modes[i].frequency_hz).collect();
    let reference = Reference::solve(tower, options, &keys, &found_hz, workspace);
    for (place, &index) in which.iter().enumerate() {
        let mode = &mut modes[index];
        let beam_hz = reference.as_ref().ok().map(|reference| {
            let beam_hz = reference.frequencies_hz[place];
            beam_hz.map(|beam_hz| (beam_hz, reference.changes_hz[place]))
        });
        match beam_hz {
            Some(Some((beam_hz, change_hz))) => {
                mode.discretization_error_hz = (mode.frequency_hz - beam_hz).abs() + change_hz;
                mode.extrapolated_hz = beam_hz;
                compared.push(mode.number);
            }
            // The reference buckles, or nothing is known at all.
            Some(None) => mode.discretization_error_hz = mode.frequency_hz,
            None if mode.discretization_error_hz == 0.0 => {
                mode.discretization_error_hz = mode.frequency_hz;
            }
            None => {}
        }
    }
    compared
}

/// The frequencies of the modes on all meshes of a ladder.
fn solve_meshes(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    (modes, below): (&[Mode], f64),
    powers: &[&[i32]],
    workspace: &mut Workspace,
) -> Result<Solved, SolveError> {
    // Three meshes at least; on a single piece, which converges smoothly, three do for two powers
    // too.
    let is_single = tower.pieces().len() == 1;
    let steps = modes
        .iter()
        .map(|mode| match powers[mode.key.subsystem].len() {
            count if is_single && count > 1 => count,
            count => count + MORE,
        });
    let steps = steps.max().unwrap_or(0);
    let ladder = ladder(&cut.mesh, modes, 1, steps, &workspace.model);
    let solved = solve_ladder(tower, &ladder, options, modes, below, workspace)?;
    if !solved.levels.lacks_coarse() {
        return Ok(solved);
    }
    // A coarser chain buckles where this one does not: only finer ones give an estimate.
    let ladder = self::ladder(
        &cut.mesh,
        modes,
        cut.mesh.segments(),
        steps,
        &workspace.model,
    );
    solve_ladder(tower, &ladder, options, modes, below, workspace)
}

/// `steps` meshes beside `mesh`: coarser ones while every span can be halved, every family still
/// has its modes and there are no fewer segments than `fewest`, then finer ones.
fn ladder(mesh: &Mesh, modes: &[Mode], fewest: usize, steps: usize, model: &Model) -> Ladder<Mesh> {
    let halves = std::iter::successors(Some(mesh.clone()), |mesh| {
        mesh.halved()
            .filter(|halved| halved.segments() >= fewest && has_all(halved, modes, model))
    });
    let mut meshes: Vec<Mesh> = halves.take(1 + steps).collect();
    let own = 1 + steps - meshes.len();
    for _ in 0..own {
        meshes.insert(0, meshes[0].doubled());
    }
    Ladder {
        meshes,
        own: Some(own),
    }
}

/// The frequencies of the same modes on every mesh, and how many modes the mesh next to their own
/// has below `below`: the coarser neighbour if there is one.
fn solve_ladder(
    tower: &Tower,
    ladder: &Ladder<Mesh>,
    options: &Options,
    modes: &[Mode],
    below: f64,
    workspace: &mut Workspace,
) -> Result<Solved, SolveError> {
    let Workspace { model, spectrum } = workspace;
    let origin = model.origin;
    let keys: Vec<ModeKey> = modes.iter().map(|mode| mode.key).collect();
    let own_hz: Vec<f64> = modes.iter().map(|mode| mode.frequency_hz).collect();
    let (mut elsewhere, mut segments) = (0, Vec::new());
    let levels = ladder.solve(&own_hz, |index, mesh| {
        segments.push(mesh.segments());
        model.monitor.enter(Stage::Errors {
            mesh: segments.len(),
            meshes: ladder.meshes.len() - 1,
            segments: mesh.segments(),
        });
        let cut = Cut {
            mesh: mesh.clone(),
            degree: 0,
        };
        model.assemble(tower, &cut, options);
        find_origin_again(tower, model, origin)?;
        let level = frequencies(&keys, model, spectrum)?;
        if ladder.own.is_some_and(|own| index.abs_diff(own) == 1) {
            elsewhere = count_below(model, below);
        }
        Ok(level)
    })?;
    Ok(Solved {
        levels,
        elsewhere,
        segments,
    })
}

/// The powers of 1/n in the errors of the modes of each subsystem: those of bending, or of torsion
/// and axial motion, whichever are more.
fn powers(tower: &Tower, options: &Options, model: &Model) -> Vec<&'static [i32]> {
    let method = options.method;
    let powers_of = |motion: Motion| match motion {
        Motion::Bending(_) => method.bending_powers(tower.shears()),
        Motion::Torsion | Motion::Axial => method.axial_powers(),
    };
    (0..model.count())
        .map(|index| {
            let powers = model.motions(index).iter().map(powers_of);
            powers.max_by_key(|powers| powers.len()).unwrap_or_default()
        })
        .collect()
}

/// Whether a mesh is fine enough to have every mode of the list: every element has at least two
/// joint coordinates per segment in a bending plane, one in torsion and one axially.
fn has_all(mesh: &Mesh, modes: &[Mode], model: &Model) -> bool {
    let coordinates = |motion: Motion| 1 + usize::from(motion.bends());
    modes.iter().all(|mode| {
        let motions = model.motions(mode.key.subsystem).iter();
        mode.key.order <= motions.map(coordinates).sum::<usize>() * mesh.segments()
    })
}
