//! The discretization error of each mode, from meshes that are coarser or finer by halves.

use super::model::{Cut, Model};
use super::options::{Options, SolveError};
use super::solution::Mode;
use super::spectrum::{Spectrum, count_below};
use super::stability::find_origin;
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

/// Solves again with the segments halved, or doubled where they cannot be halved, and extrapolates.
///
/// Returns how many modes the nearest other mesh has below `below` (λ, rad²/s²), where the list was certified complete: if that is
/// another number than the certificate's, the list ends within the error of the segments.
pub(super) fn estimate_errors(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    result: &mut Described,
    workspace: &mut Workspace,
) -> Result<usize, SolveError> {
    let (modes, below) = (&mut result.modes, result.below);
    let powers = part_powers(tower, options, &workspace.model);
    let straddles = options.borders_m.is_some() && straddles_a_step(tower, &cut.mesh);
    // Elements that reach over a step have an error of the first order.
    let powers_of = |mode: &Mode| match straddles {
        true => &STRADDLING[..],
        false => powers[mode.key.part],
    };
    // Where borders are irregular two meshes can agree by chance, and one more finds it out; a single piece converges smoothly.
    let more = usize::from(tower.pieces().len() > 1);
    let steps = modes.iter().map(|mode| powers_of(mode).len() + more).max();
    let ladder_from =
        |fewest, model: &Model| Ladder::new(&cut.mesh, modes, fewest, steps.unwrap_or(0), model);
    let mut ladder = ladder_from(options.fewest_seeing(tower), &workspace.model);
    let (mut levels, mut elsewhere) =
        solve_ladder(tower, &ladder, options, modes, below, workspace)?;
    if levels[ladder.own..].iter().flatten().any(Option::is_none) {
        // A coarser chain buckles where this one stands: only finer ones say something.
        ladder = ladder_from(cut.mesh.segments(), &workspace.model);
        (levels, elsewhere) = solve_ladder(tower, &ladder, options, modes, below, workspace)?;
    }
    for (index, mode) in modes.iter_mut().enumerate() {
        let powers = powers_of(mode);
        // As many meshes as the powers need, coarser ones before finer ones.
        let needed = powers.len() + more;
        let finest = ladder.own.min(levels.len() - 1 - needed);
        let meshes_hz = levels[finest..=finest + needed]
            .iter()
            .map(|level| level[index]);
        // A finer chain that buckles leaves nothing certain of the mode.
        let uncertain = Estimate {
            error_hz: mode.frequency_hz,
            extrapolated_hz: mode.frequency_hz,
        };
        let estimate = meshes_hz.collect::<Option<Vec<f64>>>();
        let estimate = estimate.map_or(uncertain, |meshes_hz| {
            richardson(mode.frequency_hz, meshes_hz, powers)
        });
        mode.discretization_error_hz = estimate.error_hz;
        mode.extrapolated_hz = estimate.extrapolated_hz;
    }
    Ok(elsewhere)
}

/// The powers of 1/n where elements reach over steps.
const STRADDLING: [i32; 2] = [1, 2];

/// Whether an element reaches over a step of the tower.
fn straddles_a_step(tower: &Tower, mesh: &Mesh) -> bool {
    let borders_m = mesh.borders_m();
    let steps = tower
        .pieces()
        .windows(2)
        .filter(|pair| !pair[0].meets(&pair[1]));
    let mut heights_m = steps.map(|pair| pair[1].base_m);
    heights_m.any(|z_m| {
        let above = borders_m.partition_point(|border| *border < z_m);
        borders_m.get(above).is_none_or(|border| *border != z_m)
    })
}

impl Ladder {
    /// `steps` meshes beside `mesh`: coarser ones while every span can be halved, every family still has its modes and there are no
    /// fewer segments than `fewest`, then finer ones.
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

/// The frequencies of the modes on a mesh, Hz; none of those of a part that weights make unstable there.
type Level = Vec<Option<f64>>;

/// The frequencies of the same modes on every mesh, and how many modes the mesh next to the solution's own has below `below`: the
/// coarser neighbour if there is one.
fn solve_ladder(
    tower: &Tower,
    ladder: &Ladder,
    options: &Options,
    modes: &[Mode],
    below: f64,
    workspace: &mut Workspace,
) -> Result<(Vec<Level>, usize), SolveError> {
    let Workspace { model, spectrum } = workspace;
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
        find_origin(tower, model)?;
        levels.push(frequencies(modes, model, spectrum)?);
        if index.abs_diff(ladder.own) == 1 {
            elsewhere = count_below(model, below);
        }
    }
    Ok((levels, elsewhere))
}

/// The powers of 1/n in the errors of each part's modes: those of bending, or of torsion and axial motion, or the more there are.
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

/// Whether a mesh is fine enough to have every mode of the list: every element has at least two joint coordinates a segment in a bending
/// plane, one in torsion and one axially.
fn has_all(mesh: &Mesh, modes: &[Mode], model: &Model) -> bool {
    let coordinates = |motion: Motion| 1 + usize::from(motion.bends());
    modes.iter().all(|mode| {
        let motions = model.motions(mode.key.part).iter();
        mode.key.order <= motions.map(coordinates).sum::<usize>() * mesh.segments()
    })
}

/// The frequencies of the same modes on the mesh that the model is of.
fn frequencies(
    modes: &[Mode],
    model: &mut Model,
    spectrum: &mut Spectrum,
) -> Result<Level, SolveError> {
    let mut is_stable = vec![true; model.parts()];
    for (part, is_stable) in is_stable.iter_mut().enumerate() {
        let own = modes.iter().filter(|mode| mode.key.part == part);
        let Some(wanted) = own.map(|mode| mode.key.order).max() else {
            continue;
        };
        match spectrum.solve_part(model, part, wanted) {
            Err(EigenError::Unstable { .. }) => *is_stable = false,
            result => result?,
        }
    }
    let frequency = |mode: &Mode| {
        let eigenvalue = || spectrum.eigenvalue(model, mode.key);
        is_stable[mode.key.part].then(|| eigenvalue().frequency_hz())
    };
    Ok(modes.iter().map(frequency).collect())
}
