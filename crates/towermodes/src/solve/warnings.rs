//! What looks like a slip once the modes are known.

use super::Described;
use super::options::Options;
use super::solution::{Certificate, Mode};
use crate::elements::Mesh;
use crate::tower::Tower;
use crate::{Method, Warning};

/// An estimate above this share of the frequency says that the mode is not resolved.
const RESOLVED: f64 = 0.02;

/// The warnings of the input and of its modes.
pub(super) fn warnings(
    tower: &Tower,
    mesh: &Mesh,
    options: &Options,
    result: &Described,
) -> Vec<Warning> {
    let modes = &result.modes;
    let mut warnings = tower.warnings().to_vec();
    let mut elastic = modes.iter().filter(|mode| !mode.family.is_rigid());
    let lowest_hz = elastic.next().map(|mode| mode.frequency_hz);
    if let Some(frequency_hz) = lowest_hz.filter(|hz| !(0.01..=100.0).contains(hz)) {
        warnings.push(Warning::UnusualFrequency { frequency_hz });
    }
    if options.method == Method::Bmodes && tower.shears() {
        warnings.push(Warning::ShearLeftOut);
    }
    let (elements, pieces) = (mesh.segments(), tower.pieces().len());
    if elements < options.fewest_seeing(tower) {
        warnings.push(Warning::PiecesUnseen { elements, pieces });
    }
    // The spectral beam takes more elements when it needs them.
    let asked = options
        .segments
        .filter(|_| options.method != Method::Spectral);
    if let Some(asked) = asked.filter(|&asked| asked != mesh.segments()) {
        let used = mesh.segments();
        warnings.push(Warning::MoreSegments { asked, used });
    }
    warnings.extend(unresolved(modes));
    if let Some((label, frequency_hz)) = result.cut_off.clone() {
        warnings.push(Warning::CutPair {
            label,
            frequency_hz,
        });
    }
    warnings
}

/// Says that the list ends within the error of the segments: another mesh has another count of modes below its end than certified, or
/// a mode is extrapolated beyond it.
pub(super) fn uncertain_end(
    modes: &[Mode],
    certificate: &Certificate,
    count_elsewhere: usize,
) -> Option<Warning> {
    let below_hz = certificate.below_hz;
    let is_uncertain =
        count_elsewhere != certificate.count || modes.iter().any(|m| m.extrapolated_hz >= below_hz);
    is_uncertain.then_some(Warning::UncertainEnd { below_hz })
}

fn unresolved(modes: &[Mode]) -> Option<Warning> {
    let relative = |m: &Mode| m.error_hz() / m.frequency_hz;
    // What nothing resists has frequency 0, and no error is small beside that.
    let moving = modes.iter().filter(|m| m.frequency_hz > 0.0);
    let unresolved: Vec<&Mode> = moving.filter(|m| relative(m) > RESOLVED).collect();
    Some(Warning::Unresolved {
        number: unresolved.first()?.number,
        others: unresolved.len() - 1,
        worst: unresolved.iter().map(|m| relative(m)).fold(0.0, f64::max),
    })
}
