//! The discretization error of each mode, from a second mesh.

use super::Workspace;
use super::options::{Options, SolveError};
use super::solution::Mode;
use crate::eigen::Statistics;
use crate::elements::{Mesh, assemble};
use crate::modes::{Companion, Family, richardson};
use crate::tower::Tower;

/// Solves again with every segment halved or doubled and extrapolates.
pub(super) fn estimate_errors(
    tower: &Tower,
    mesh: &Mesh,
    options: &Options,
    modes: &mut [Mode],
    workspace: &mut Workspace,
) -> Result<(), SolveError> {
    let (companion_mesh, companion) = companion_of(mesh, modes);
    let Workspace {
        chains, spectrum, ..
    } = workspace;
    assemble(
        tower,
        &companion_mesh,
        options.method,
        options.rotary_inertia,
        chains,
    );
    spectrum.statistics = Statistics::default();
    for family in [
        Family::ForeAft,
        Family::SideSide,
        Family::Torsion,
        Family::Axial,
    ] {
        let is_copy = family == Family::SideSide && chains.planes_are_equal();
        let wanted = orders_of(modes, family);
        if wanted > 0 && !is_copy {
            spectrum.solve_family(chains, family, wanted)?;
        }
    }
    for mode in modes {
        let companion_hz =
            spectrum.of(chains, mode.family).eigenvalues()[mode.order - 1].frequency_hz();
        let order = match mode.family {
            Family::ForeAft | Family::SideSide => options.method.bending_order(tower.shear()),
            Family::Torsion | Family::Axial => options.method.axial_order(),
        };
        let estimate = richardson(mode.frequency_hz, companion_hz, companion, order);
        mode.discretization_error_hz = estimate.error_hz;
        mode.extrapolated_hz = estimate.extrapolated_hz;
    }
    Ok(())
}

/// The highest order of a family in the list.
fn orders_of(modes: &[Mode], family: Family) -> usize {
    let orders = modes.iter().filter(|m| m.family == family).map(|m| m.order);
    orders.max().unwrap_or(0)
}

/// Half the segments if every span allows it and every family still has its modes, else twice.
fn companion_of(mesh: &Mesh, modes: &[Mode]) -> (Mesh, Companion) {
    let has_all = |mesh: &Mesh| {
        // Every element has two joint coordinates a segment in a bending plane, one in torsion and one axially.
        let bending = orders_of(modes, Family::ForeAft).max(orders_of(modes, Family::SideSide));
        let axial = orders_of(modes, Family::Torsion).max(orders_of(modes, Family::Axial));
        bending <= 2 * mesh.segments() && axial <= mesh.segments()
    };
    match mesh.halved().filter(has_all) {
        Some(halved) => (halved, Companion::Halved),
        None => (mesh.doubled(), Companion::Doubled),
    }
}
