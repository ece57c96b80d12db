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
    warnings.extend(soil_unresolved(tower, mesh, result.degree));
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

/// Says that motions die out in the soil within a part of a segment: those that a tower on an elastic bed has, (4EI/k)^¼ in bending, (EA/k)^½
/// and (GJ/k)^½ along and about the axis. A polynomial of a degree resolves so many parts of its element.
fn soil_unresolved(tower: &Tower, mesh: &Mesh, degree: Option<usize>) -> Option<Warning> {
    let parts = degree.unwrap_or(1) as f64;
    let mut worst: Option<(f64, f64)> = None;
    for border in mesh.borders_m().windows(2) {
        let middle_m = 0.5 * (border[0] + border[1]);
        let piece = tower.piece_at(middle_m);
        if piece.ambient.soil.is_none() {
            continue;
        }
        let section = piece.section_at(middle_m);
        let (soil, bending) = (section.soil, section.bending_n_m2);
        let transverse = soil.transverse();
        let lengths_m = [
            (4.0 * bending.fore_aft / transverse.fore_aft).powf(0.25),
            (4.0 * bending.side_side / transverse.side_side).powf(0.25),
            (section.axial_n / soil.z_n_per_m2).sqrt(),
            (section.torsion_n_m2 / soil.torsion_n).sqrt(),
        ];
        let penetration_m = lengths_m.into_iter().fold(f64::INFINITY, f64::min);
        let segment_m = (border[1] - border[0]) / parts;
        let is_worse = worst.is_none_or(|(p, s)| segment_m / penetration_m > s / p);
        if penetration_m < segment_m && is_worse {
            worst = Some((penetration_m, segment_m));
        }
    }
    let (penetration_m, segment_m) = worst?;
    Some(Warning::SoilUnresolved {
        penetration_m,
        segment_m,
    })
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
