//! The discretization error of each mode, from meshes that are coarser or finer by halves.

use super::model::{Cut, Model};
use super::options::{Options, SolveError};
use super::reference::Reference;
use super::solution::Mode;
use super::spectrum::{ModeKey, Spectrum, count_below};
use super::stability::find_origin_again;
use super::{Described, Stage, Workspace};
use crate::eigen::EigenError;
use crate::elements::Mesh;
use crate::modes::{Estimate, richardson};
use crate::tower::{Motion, Tower};

/// Meshes that halve each other's segments, finest first.
struct Ladder {
    meshes: Vec<Mesh>,
    /// Which of them is the solution's own.
    own: usize,
}

/// What other meshes, or the beam itself, say beside the error of each mode.
pub(super) struct Estimates {
    /// How many modes another mesh, or the beam, has below the end of the list: if that is another
    /// number than the certificate's, the list ends within the error of the segments.
    pub(super) elsewhere: usize,
    /// Places in the list, from 0, of modes whose meshes do not fall as the powers of the method
    /// say.
    pub(super) irregular: Vec<usize>,
}

/// Solves again with the segments halved, or doubled where they cannot be halved, and extrapolates.
/// What the meshes do not agree on is compared with the beam itself, and so is every mode on
/// elements whose borders are given: no halving of these sees what they miss.
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
        compare(tower, options, modes, &all, workspace);
        return Ok(Estimates {
            elsewhere: count_below(&mut workspace.model, below),
            irregular: Vec::new(),
        });
    }
    let powers = part_powers(tower, options, &workspace.model);
    let (levels, own, elsewhere) =
        solve_meshes(tower, cut, options, (modes, below), &powers, workspace)?;
    // Where a section changes much over one segment meshes can fall as they should towards
    // something else.
    let all_are_doubtful = is_steep(tower, &cut.mesh);
    let (mut irregular, mut doubtful) = (Vec::new(), Vec::new());
    for (index, mode) in modes.iter_mut().enumerate() {
        let estimate = extrapolated(mode, index, &levels, own, powers[mode.key.part]);
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
    if !doubtful.is_empty() {
        compare(tower, options, modes, &doubtful, workspace);
    }
    Ok(Estimates {
        elsewhere,
        irregular,
    })
}

/// Where meshes disagree by less than this share of a frequency the larger estimate is enough, and
/// the beam is not asked.
const NEGLIGIBLE: f64 = 1e-5;

/// A segment over which a dimension or a stiffness changes by more than this factor is steep.
const STEEP: f64 = 2.0;

/// Whether a segment is steep: the first or the last of a span, as what is linear changes most
/// where it is least.
fn is_steep(tower: &Tower, mesh: &Mesh) -> bool {
    mesh.spans_with_borders().any(|(span, borders_m)| {
        let piece = &tower.pieces()[span.piece];
        let ends = [&borders_m[..2], &borders_m[borders_m.len() - 2..]];
        ends.iter()
            .any(|ends_m| piece.steepness(ends_m[0], ends_m[1]) > STEEP)
    })
}

/// The error of a mode from as many meshes as its powers need and one more, coarser ones before
/// finer ones.
fn extrapolated(
    mode: &Mode,
    index: usize,
    levels: &[Level],
    own: usize,
    powers: &[i32],
) -> Estimate {
    let needed = (powers.len() + MORE).min(levels.len() - 1);
    let finest = own.min(levels.len() - 1 - needed);
    let meshes_hz = levels[finest..=finest + needed]
        .iter()
        .map(|level| level[index]);
    match meshes_hz.collect::<Option<Vec<f64>>>() {
        Some(meshes_hz) => richardson(mode.frequency_hz, meshes_hz, powers),
        // A finer chain that buckles leaves nothing certain of the mode.
        None => uncertain(mode),
    }
}

/// An estimate where nothing is known.
fn uncertain(mode: &Mode) -> Estimate {
    Estimate {
        error_hz: mode.frequency_hz,
        extrapolated_hz: mode.frequency_hz,
        spread_hz: mode.frequency_hz,
        is_regular: false,
    }
}

/// Takes the errors of some modes from the beam itself. Where that cannot be solved, the estimates
/// stay as they are, or are all of the frequency where there are none.
fn compare(
    tower: &Tower,
    options: &Options,
    modes: &mut [Mode],
    which: &[usize],
    workspace: &mut Workspace,
) {
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
            }
            // The beam itself buckles, or nothing is known at all.
            Some(None) => mode.discretization_error_hz = mode.frequency_hz,
            None if mode.discretization_error_hz == 0.0 => {
                mode.discretization_error_hz = mode.frequency_hz;
            }
            None => {}
        }
    }
}

/// Meshes can agree by chance, and one more than the powers need finds it out.
const MORE: usize = 1;

/// The frequencies of the modes on all meshes of a ladder, which of these is the solution's own,
/// and how many modes the one next to it has below the end of the list.
fn solve_meshes(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    (modes, below): (&[Mode], f64),
    powers: &[&[i32]],
    workspace: &mut Workspace,
) -> Result<(Vec<Level>, usize, usize), SolveError> {
    // Three meshes at least; on a single piece, which converges smoothly, three do for two powers
    // too.
    let is_single = tower.pieces().len() == 1;
    let steps = modes.iter().map(|mode| match powers[mode.key.part].len() {
        count if is_single && count > 1 => count,
        count => count + MORE,
    });
    let steps = steps.max();
    let ladder_from =
        |fewest, model: &Model| Ladder::new(&cut.mesh, modes, fewest, steps.unwrap_or(0), model);
    let mut ladder = ladder_from(1, &workspace.model);
    let (mut levels, mut elsewhere) =
        solve_ladder(tower, &ladder, options, modes, below, workspace)?;
    if levels[ladder.own..].iter().flatten().any(Option::is_none) {
        // A coarser chain buckles where this one stands: only finer ones say something.
        ladder = ladder_from(cut.mesh.segments(), &workspace.model);
        (levels, elsewhere) = solve_ladder(tower, &ladder, options, modes, below, workspace)?;
    }
    Ok((levels, ladder.own, elsewhere))
}

impl Ladder {
    /// `steps` meshes beside `mesh`: coarser ones while every span can be halved, every family
    /// still has its modes and there are no fewer segments than `fewest`, then finer ones.
    fn new(mesh: &Mesh, modes: &[Mode], fewest: usize, steps: usize, model: &Model) -> Self {
        let halves = std::iter::successors(Some(mesh.clone()), |mesh| {
            mesh.halved()
                .filter(|halved| halved.segments() >= fewest && has_all(halved, modes, model))
        });
        let mut meshes: Vec<Mesh> = halves.take(1 + steps).collect();
        let own = 1 + steps - meshes.len();
        for _ in 0..own {
            meshes.insert(0, meshes[0].doubled());
        }
        Self { meshes, own }
    }
}

/// The frequencies of the modes on a mesh, Hz; none of those of a part that weights make unstable
/// there.
pub(super) type Level = Vec<Option<f64>>;

/// The frequencies of the same modes on every mesh, and how many modes the mesh next to the
/// solution's own has below `below`: the coarser neighbour if there is one.
fn solve_ladder(
    tower: &Tower,
    ladder: &Ladder,
    options: &Options,
    modes: &[Mode],
    below: f64,
    workspace: &mut Workspace,
) -> Result<(Vec<Level>, usize), SolveError> {
    let Workspace { model, spectrum } = workspace;
    let origin = model.origin;
    let keys: Vec<ModeKey> = modes.iter().map(|mode| mode.key).collect();
    let mut levels = Vec::with_capacity(ladder.meshes.len());
    let mut elsewhere = 0;
    let mut others = 0;
    for (index, mesh) in ladder.meshes.iter().enumerate() {
        if index == ladder.own {
            levels.push(modes.iter().map(|mode| Some(mode.frequency_hz)).collect());
            continue;
        }
        let cut = Cut {
            mesh: mesh.clone(),
            degree: 0,
        };
        others += 1;
        model.watch.enter(Stage::Errors {
            mesh: others,
            meshes: ladder.meshes.len() - 1,
            segments: mesh.segments(),
        });
        model.assemble(tower, &cut, options);
        find_origin_again(tower, model, origin)?;
        levels.push(frequencies(&keys, model, spectrum)?);
        if index.abs_diff(ladder.own) == 1 {
            elsewhere = count_below(model, below);
        }
    }
    Ok((levels, elsewhere))
}

/// The powers of 1/n in the errors of each part's modes: those of bending, or of torsion and axial
/// motion, or the more there are.
fn part_powers(tower: &Tower, options: &Options, model: &Model) -> Vec<&'static [i32]> {
    let method = options.method;
    let powers_of = |motion: Motion| match motion {
        Motion::Bending(_) => method.bending_powers(tower.shears()),
        Motion::Torsion | Motion::Axial => method.axial_powers(),
    };
    (0..model.parts())
        .map(|part| {
            let powers = model.motions(part).iter().map(powers_of);
            powers.max_by_key(|powers| powers.len()).unwrap_or_default()
        })
        .collect()
}

/// Whether a mesh is fine enough to have every mode of the list: every element has at least two
/// joint coordinates a segment in a bending plane, one in torsion and one axially.
fn has_all(mesh: &Mesh, modes: &[Mode], model: &Model) -> bool {
    let coordinates = |motion: Motion| 1 + usize::from(motion.bends());
    modes.iter().all(|mode| {
        let motions = model.motions(mode.key.part).iter();
        mode.key.order <= motions.map(coordinates).sum::<usize>() * mesh.segments()
    })
}

/// The frequencies of modes on the mesh that the model is of.
pub(super) fn frequencies(
    keys: &[ModeKey],
    model: &mut Model,
    spectrum: &mut Spectrum,
) -> Result<Level, SolveError> {
    let mut is_stable = vec![true; model.parts()];
    for (part, is_stable) in is_stable.iter_mut().enumerate() {
        let own = keys.iter().filter(|key| key.part == part);
        let Some(wanted) = own.map(|key| key.order).max() else {
            continue;
        };
        match spectrum.solve_part(model, part, wanted) {
            Err(EigenError::Unstable { .. }) => *is_stable = false,
            // Near buckling another mesh can be beyond the origin, or its lowest modes below the
            // rounding of the others.
            Err(_) if model.origin < 0.0 => *is_stable = false,
            result => result?,
        }
    }
    let frequency = |key: &ModeKey| {
        let eigenvalue = || spectrum.eigenvalue(model, *key);
        is_stable[key.part].then(|| eigenvalue().frequency_hz())
    };
    Ok(keys.iter().map(frequency).collect())
}
