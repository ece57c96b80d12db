//! The discretization error of each mode, from meshes that are coarser or finer by halves.

use super::Workspace;
use super::model::{Cut, Model};
use super::options::{Options, SolveError};
use super::solution::Mode;
use super::spectrum::{Spectrum, count_below};
use crate::elements::Mesh;
use crate::modes::{Family, richardson};
use crate::tower::Tower;

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
    modes: &mut [Mode],
    below: f64,
    workspace: &mut Workspace,
) -> Result<usize, SolveError> {
    let powers_of = |mode: &Mode| match mode.family {
        Family::ForeAft | Family::SideSide => options.method.bending_powers(tower.shears()),
        Family::Torsion | Family::Axial => options.method.axial_powers(),
    };
    // Where borders are irregular two meshes can agree by chance, and one more finds it out; a single piece converges smoothly.
    let more = usize::from(tower.pieces().len() > 1);
    let steps = modes.iter().map(|mode| powers_of(mode).len() + more).max();
    let ladder = Ladder::new(
        &cut.mesh,
        modes,
        options.fewest_seeing(tower),
        steps.unwrap_or(0),
    );
    let (levels, elsewhere) = solve_ladder(tower, &ladder, options, modes, below, workspace)?;
    for (index, mode) in modes.iter_mut().enumerate() {
        let powers = powers_of(mode);
        // As many meshes as the powers need, coarser ones before finer ones.
        let needed = powers.len() + more;
        let finest = ladder.own.min(levels.len() - 1 - needed);
        let meshes_hz = levels[finest..=finest + needed]
            .iter()
            .map(|level| level[index]);
        let estimate = richardson(mode.frequency_hz, meshes_hz.collect(), powers);
        mode.discretization_error_hz = estimate.error_hz;
        mode.extrapolated_hz = estimate.extrapolated_hz;
    }
    Ok(elsewhere)
}

impl Ladder {
    /// `steps` meshes beside `mesh`: coarser ones while every span can be halved, every family still has its modes and there are no
    /// fewer segments than `fewest`, then finer ones.
    fn new(mesh: &Mesh, modes: &[Mode], fewest: usize, steps: usize) -> Self {
        let halves = std::iter::successors(Some(mesh.clone()), |mesh| {
            mesh.halved()
                .filter(|halved| halved.segments() >= fewest && has_all(halved, modes))
        });
        let mut meshes: Vec<Mesh> = halves.take(1 + steps).collect();
        let own = 1 + steps - meshes.len();
        for _ in 0..own {
            meshes.insert(0, meshes[0].doubled());
        }
        Self { meshes, own }
    }
}

/// The frequencies of the same modes (Hz) on every mesh, and how many modes the mesh next to the solution's own has below `below`: the
/// coarser neighbour if there is one.
fn solve_ladder(
    tower: &Tower,
    ladder: &Ladder,
    options: &Options,
    modes: &[Mode],
    below: f64,
    workspace: &mut Workspace,
) -> Result<(Vec<Vec<f64>>, usize), SolveError> {
    let Workspace { model, spectrum } = workspace;
    let mut levels = Vec::with_capacity(ladder.meshes.len());
    let mut elsewhere = 0;
    for (index, mesh) in ladder.meshes.iter().enumerate() {
        if index == ladder.own {
            levels.push(modes.iter().map(|mode| mode.frequency_hz).collect());
            continue;
        }
        let cut = Cut {
            mesh: mesh.clone(),
            degree: 0,
        };
        model.assemble(tower, &cut, options);
        levels.push(frequencies(modes, model, spectrum)?);
        if index.abs_diff(ladder.own) == 1 {
            elsewhere = count_below(model, below);
        }
    }
    Ok((levels, elsewhere))
}

/// Whether a mesh is fine enough to have every mode of the list: every element has at least two joint coordinates a segment in a bending
/// plane, one in torsion and one axially.
fn has_all(mesh: &Mesh, modes: &[Mode]) -> bool {
    modes.iter().all(|mode| match mode.family {
        Family::ForeAft | Family::SideSide => mode.order <= 2 * mesh.segments(),
        Family::Torsion | Family::Axial => mode.order <= mesh.segments(),
    })
}

/// The frequencies of the same modes on the mesh that the model is of, Hz.
fn frequencies(
    modes: &[Mode],
    model: &mut Model,
    spectrum: &mut Spectrum,
) -> Result<Vec<f64>, SolveError> {
    for &family in model.families() {
        let orders = modes.iter().filter(|m| m.family == family).map(|m| m.order);
        let wanted = orders.max().unwrap_or(0);
        if wanted > 0 {
            spectrum.solve_family(model, family, wanted)?;
        }
    }
    let eigenvalues = |family| spectrum.of(model.planes_are_equal(), family).eigenvalues();
    let frequency = |mode: &Mode| eigenvalues(mode.family)[mode.order - 1].frequency_hz();
    Ok(modes.iter().map(frequency).collect())
}
