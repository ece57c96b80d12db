//! Towers on a platform whose added mass depends on frequency: each mode has the added mass of its
//! own frequency.
//!
//! With the added mass held at ω the tower is an ordinary one, with the eigenvalues μ₁(ω) ≤ μ₂(ω) ≤
//! …; mode k is that of μₖ(ω) = ω². It is taken, with its error and its shape, from the solution
//! of the tower with the added mass at its own frequency.

mod proof;
mod roots;

use super::error::SolveError;
use super::request::options::Options;
use super::results::frequencies::Frequencies;
use super::results::solution::{Certificate, Solution};
use super::workspace::Workspace;
use crate::eigen::Statistics;
use crate::modes::Shares;
use crate::tower::{Tower, Warning};
use proof::prove;
use roots::{Root, roots};

/// The data of modes that a solve of an ordinary tower returns.
trait Listed {
    /// The data of one mode.
    type OfMode: Clone;

    fn modes(&self) -> &[Self::OfMode];
    fn certificate(&self) -> Certificate;
    fn shares(mode: &Self::OfMode) -> Shares;
    /// Changes the data of a mode from fixed added mass to the added mass of its own frequency.
    fn release(mode: &mut Self::OfMode, root: &Root);
}

/// Implements this for a list of modes; the named errors in Hz change with the frequency.
macro_rules! listed {
    ($list:ty, $mode:ty) => {
        impl Listed for $list {
            type OfMode = $mode;

            fn modes(&self) -> &[$mode] {
                &self.modes
            }

            fn certificate(&self) -> Certificate {
                self.certificate
            }

            fn shares(mode: &$mode) -> Shares {
                mode.shares
            }

            fn release(mode: &mut $mode, root: &Root) {
                let change_hz = mode.extrapolated_hz - mode.frequency_hz;
                mode.extrapolated_hz = mode.frequency_hz + change_hz / root.slope;
                mode.discretization_error_hz /= root.slope.abs();
                let residual_hz = 0.5 * root.residual * mode.frequency_hz;
                mode.algebraic_error_hz =
                    (mode.algebraic_error_hz + residual_hz) / root.slope.abs();
            }
        }
    };
}

listed!(Solution, super::results::solution::Mode);
listed!(Frequencies, super::results::frequencies::ModeFrequency);

/// The modes of a tower, each with the added mass of its own frequency, by a function that solves
/// ordinary towers.
pub(super) fn solve(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
    mut solve: impl FnMut(&Tower, &Options, &mut Workspace) -> Result<Solution, SolveError>,
) -> Result<Solution, SolveError> {
    let mut statistics = Statistics::default();
    let counted = |tower: &Tower, options: &Options, workspace: &mut Workspace| {
        let solution = solve(tower, options, workspace)?;
        statistics += solution.statistics;
        Ok(solution)
    };
    let (mut solution, modes, certificate) = each(tower, options, workspace, counted)?;
    solution.modes = modes;
    solution.certificate = certificate;
    solution.statistics = statistics;
    solution.rigid_inertia = tower.rigid_inertia(options.has_rotary_inertia());
    solution.warnings.extend(
        certificate
            .uncertain_hz
            .map(|[from_hz, to_hz]| Warning::UncertainAddedMass { from_hz, to_hz }),
    );
    Ok(solution)
}

/// As [`solve`], for frequencies without shapes.
pub(super) fn frequencies(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
    mut solve: impl FnMut(&Tower, &Options, &mut Workspace) -> Result<(), SolveError>,
) -> Result<(), SolveError> {
    let listed = |tower: &Tower, options: &Options, workspace: &mut Workspace| {
        solve(tower, options, workspace)?;
        Ok(workspace.frequencies.clone())
    };
    let (last, modes, certificate) = each(tower, options, workspace, listed)?;
    workspace.frequencies = Frequencies {
        modes,
        certificate,
        ..last
    };
    Ok(())
}

/// The angular frequency ω of each mode, rad/s, and the slope 1 − dμ/dλ at λ = ω².
pub(crate) fn slopes(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<Vec<(f64, f64)>, SolveError> {
    let roots = roots(tower, options, workspace)?;
    Ok(roots
        .iter()
        .map(|root| (root.frequency, root.slope))
        .collect())
}

/// The last list, the data of all modes, and the proof that no mode is missing.
type Each<L> = (L, Vec<<L as Listed>::OfMode>, Certificate);

fn each<L: Listed>(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
    mut solve: impl FnMut(&Tower, &Options, &mut Workspace) -> Result<L, SolveError>,
) -> Result<Each<L>, SolveError> {
    let roots = roots(tower, options, workspace)?;
    let mut modes: Vec<L::OfMode> = Vec::with_capacity(roots.len());
    let listed = loop {
        let root = &roots[modes.len()];
        // Where the added mass is constant all modes above have it too.
        let last = match root.is_constant {
            true => roots.len(),
            false => modes.len() + 1,
        };
        let up_to = Options {
            modes: last,
            ..options.clone()
        };
        let held = tower.with_added_mass_at(root.frequency);
        // The modes below keep the names that they have with the added mass of their own frequency.
        workspace.naming.known = modes.iter().map(L::shares).collect();
        let list = solve(&held, &up_to, workspace);
        workspace.naming.known.clear();
        let list = list?;
        let next = modes.len()..last;
        for (mode, root) in list.modes()[next.clone()].iter().zip(&roots[next]) {
            let mut mode = mode.clone();
            L::release(&mut mode, root);
            modes.push(mode);
        }
        if modes.len() == roots.len() {
            break list;
        }
    };
    let certificate = prove(tower, options, &roots, &listed.certificate(), workspace)?;
    Ok((listed, modes, certificate))
}
