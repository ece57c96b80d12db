//! What looks like a slip once the modes are known.

use super::options::Options;
use super::solution::Mode;
use super::spectrum::Found;
use crate::Warning;
use crate::elements::Mesh;
use crate::tower::Tower;

/// An estimate above this share of the frequency says that the mode is not resolved.
const RESOLVED: f64 = 0.02;

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
    warnings.extend(unresolved(modes));
    let last = &found[modes.len() - 1];
    if let Some(cut) = found.get(modes.len()).filter(|cut| cut.repeats(last)) {
        warnings.push(Warning::CutPair {
            label: cut.family.label(cut.order),
            frequency_hz: cut.eigenvalue.frequency_hz(),
        });
    }
    warnings
}

fn unresolved(modes: &[Mode]) -> Option<Warning> {
    let relative = |m: &Mode| (m.discretization_error_hz + m.algebraic_error_hz) / m.frequency_hz;
    let unresolved: Vec<&Mode> = modes.iter().filter(|m| relative(m) > RESOLVED).collect();
    Some(Warning::Unresolved {
        number: unresolved.first()?.number,
        others: unresolved.len() - 1,
        worst: unresolved.iter().map(|m| relative(m)).fold(0.0, f64::max),
    })
}
