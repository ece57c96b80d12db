//! What looks like a slip once the modes are known.

use super::options::Options;
use super::solution::Mode;
use super::spectrum::Found;
use crate::Warning;
use crate::elements::Mesh;
use crate::tower::Tower;

/// An estimate above this share of the frequency says that the mode is not resolved.
const RESOLVED: f64 = 0.05;

/// The warnings of the input and of its modes.
pub(super) fn warnings(
    tower: &Tower,
    mesh: &Mesh,
    options: &Options,
    modes: &[Mode],
    found: &[Found],
) -> Vec<Warning> {
    let mut warnings = tower.plausibility();
    let frequency_hz = modes[0].frequency_hz;
    if !(0.01..=100.0).contains(&frequency_hz) {
        warnings.push(Warning::UnusualFrequency { frequency_hz });
    }
    if let Some(asked) = options.segments.filter(|&asked| asked != mesh.segments()) {
        let used = mesh.segments();
        warnings.push(Warning::MoreSegments { asked, used });
    }
    let relative = |m: &Mode| m.discretization_error_hz / m.frequency_hz;
    if let Some(mode) = modes.iter().find(|m| relative(m) > RESOLVED) {
        warnings.push(Warning::Unresolved {
            number: mode.number,
            relative_error: relative(mode),
        });
    }
    let last = found[modes.len() - 1].eigenvalue.lambda;
    if let Some(cut) = found
        .get(modes.len())
        .filter(|cut| cut.eigenvalue.lambda == last)
    {
        warnings.push(Warning::CutPair {
            label: cut.family.label(cut.order),
            frequency_hz: cut.eigenvalue.frequency_hz(),
        });
    }
    warnings
}
