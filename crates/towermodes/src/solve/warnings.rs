//! What looks like a slip once the modes are known.

use super::Described;
use super::options::Options;
use super::solution::{Certificate, Mode};
use crate::elements::Mesh;
use crate::tower::{Piece, Tower};
use crate::{Method, Warning};

/// An estimate above this share of the frequency says that the mode is not resolved.
const RESOLVED: f64 = 0.02;

/// A piece below this share of the element over it is a ramp that the element cannot follow.
const STEEP: f64 = 0.25;

/// A change below this share over a ramp matters little.
const SLIGHT: f64 = 0.05;

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
    if options.method == Method::Bmodes {
        warnings.extend(ramp_unseen(tower, mesh));
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

/// Says that an element of BModes, which has the section at its middle, reaches over a ramp much shorter than itself. Where the ramp lies in
/// the element then decides the error, and meshes that cut it alike agree by chance. The steepest is told.
fn ramp_unseen(tower: &Tower, mesh: &Mesh) -> Option<Warning> {
    let borders_m = mesh.borders_m();
    let ramps = tower.pieces().iter().filter_map(|piece| {
        let middle_m = piece.base_m + 0.5 * piece.length_m();
        let above = borders_m.partition_point(|border| *border <= middle_m);
        let (lower_m, upper_m) = (
            *borders_m.get(above.checked_sub(1)?)?,
            *borders_m.get(above)?,
        );
        let element_m = upper_m - lower_m;
        let is_short = piece.length_m() < STEEP * element_m;
        let is_cut_there = lower_m >= piece.base_m || upper_m <= piece.base_m + piece.length_m();
        let change = change_over(piece);
        let is_unseen = is_short && !is_cut_there && change > SLIGHT;
        is_unseen.then_some((middle_m, piece.length_m(), element_m, change))
    });
    let (height_m, ramp_m, element_m, change) = ramps.max_by(|a, b| a.3.total_cmp(&b.3))?;
    Some(Warning::RampUnseen {
        height_m,
        ramp_m,
        element_m,
        change,
    })
}

/// By how much mass and stiffness at the ends of a piece differ, as a share of the larger.
fn change_over(piece: &Piece) -> f64 {
    let ends = [piece.base_m, piece.base_m + piece.length_m()];
    let [low, high] = ends.map(|height_m| piece.section_at(height_m));
    let pairs = [
        [low.masses.mass_kg_per_m, high.masses.mass_kg_per_m],
        [low.bending_n_m2.fore_aft, high.bending_n_m2.fore_aft],
        [low.bending_n_m2.side_side, high.bending_n_m2.side_side],
    ];
    let changes = pairs.map(|[a, b]| (a - b).abs() / a.abs().max(b.abs()));
    changes.into_iter().fold(0.0, f64::max)
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
