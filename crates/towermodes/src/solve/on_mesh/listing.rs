//! The list of the modes found: the proof that none is missing, and their names.

use super::super::error::SolveError;
use super::super::progress::Stage;
use super::super::request::options::Options;
use super::super::results::frequencies::{Estimated, ModeFrequency};
use super::super::results::solution::Certificate;
use super::super::workspace::Workspace;
use super::cut::Cut;
use super::naming::{Wanted, identify};
use super::spectrum::Found;
use super::stability::check_buckling;
use crate::eigen::EigenError;
use crate::tower::Tower;

/// Proves that no mode is missing below those found and lists the modes requested, their
/// discretization errors still unknown; returns where the list ends, λ, rad²/s².
pub(crate) fn list(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    found: &[Found],
    workspace: &mut Workspace,
) -> Result<f64, SolveError> {
    let Workspace {
        model,
        spectrum,
        naming,
        errors,
        frequencies,
        ..
    } = workspace;
    model.monitor.enter(Stage::Certificate);
    let proof = spectrum.prove(model, found, options.modes)?;
    model.monitor.enter(Stage::Buckling);
    check_buckling(tower, model, spectrum)?;
    let listed = &found[..options.modes];
    identify(
        tower,
        options,
        model,
        spectrum,
        (listed, Wanted::Names),
        naming,
    );
    frequencies.modes.clear();
    errors.modes.clear();
    for (found, identity) in listed.iter().zip(&naming.identities) {
        let frequency_hz = found.eigenvalue.frequency_hz();
        if !frequency_hz.is_finite() {
            return Err(EigenError::NotFinite.into());
        }
        frequencies.modes.push(ModeFrequency {
            family: identity.family,
            order: identity.order,
            shares: identity.shares,
            frequency_hz,
            algebraic_error_hz: found.eigenvalue.frequency_error_hz(),
            discretization_error_hz: 0.0,
            extrapolated_hz: frequency_hz,
        });
        errors.modes.push(Estimated::new(found.key, frequency_hz));
    }
    frequencies.certificate = Certificate::of(&proof);
    frequencies.has_uncertain_end = false;
    frequencies.is_near_base = false;
    frequencies.segments = cut.mesh.segments();
    Ok(proof.below)
}
