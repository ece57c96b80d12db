//! Warnings that depend on the modes.

use super::super::on_mesh::one_mesh::Described;
use super::super::on_mesh::stability::VERGE;
use super::super::request::options::Options;
use super::solution::{Certificate, Mode, RESOLVED};
use crate::elements::Mesh;
use crate::tower::Tower;
use crate::{Method, Warning};

/// Larger errors relative to the frequency, of modes that do not converge regularly, cause a
/// warning.
const IRREGULAR: f64 = 1e-3;

/// A smaller relative change of a quantity within an element is negligible.
const SLIGHT: f64 = 0.05;

/// Relative errors above this limit give a warning about features that given elements miss.
const MISSED: f64 = 5e-3;

/// The warnings of the input and of its modes.
pub(crate) fn warnings(
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
    let near = result.buckling_load_factor.filter(|factor| *factor < VERGE);
    warnings.extend(near.map(|load_factor| Warning::VergeOfBuckling { load_factor }));
    if options.method == Method::Bmodes && tower.shears() {
        warnings.push(Warning::ShearLeftOut);
    }
    let misses = |mode: &Mode| mode.error_hz() > MISSED * mode.frequency_hz;
    if options.borders_m.is_some() && modes.iter().any(misses) {
        warnings.extend(missed(tower, mesh));
    }
    // The method spectral uses more elements if it needs them.
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

/// Warns that the list ends within the error of the segments: another mesh has another count of
/// modes below its end than certified, or a mode is extrapolated beyond it.
pub(crate) fn uncertain_end(
    modes: &[Mode],
    certificate: &Certificate,
    count_elsewhere: usize,
) -> Option<Warning> {
    let extrapolated_hz = modes.iter().map(|mode| mode.extrapolated_hz);
    is_uncertain_end(extrapolated_hz, certificate, count_elsewhere).then(|| Warning::UncertainEnd {
        last_hz: modes.last().map_or(0.0, |mode| mode.frequency_hz),
        below_hz: certificate.below_hz,
    })
}

/// Whether another mesh has another count of modes below the end of the list than certified, or a
/// mode is extrapolated (Hz) beyond it.
pub(crate) fn is_uncertain_end(
    mut extrapolated_hz: impl Iterator<Item = f64>,
    certificate: &Certificate,
    count_elsewhere: usize,
) -> bool {
    count_elsewhere != certificate.count || extrapolated_hz.any(|hz| hz >= certificate.below_hz)
}

/// Warns if the Winkler decay length is below the mesh size: (4EI/k)^¼ in bending, (EA/k)^½ along
/// and (GJ/k)^½ about the axis, (EI/k)^½ for springs against rotation. An element of degree p
/// resolves a p-th of its length.
fn soil_unresolved(tower: &Tower, mesh: &Mesh, degree: Option<usize>) -> Option<Warning> {
    let parts = degree.unwrap_or(1) as f64;
    let mut worst: Option<(f64, f64)> = None;
    for border in mesh.borders_m().windows(2) {
        let middle_m = 0.5 * (border[0] + border[1]);
        let piece = tower.piece_at(middle_m);
        if piece.environment.soil.is_none() {
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
            (bending.fore_aft / soil.rotation_y_n).sqrt(),
            (bending.side_side / soil.rotation_x_n).sqrt(),
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

/// Reports where an element of BModes, which has the section at its middle, reaches over rows of
/// the tower, and which quantity it misses most of there: that which differs most within the
/// element from what is taken for it.
fn missed(tower: &Tower, mesh: &Mesh) -> Option<Warning> {
    let elements = mesh.borders_m().windows(2);
    let worst = elements.filter_map(|ends| {
        let (quantity, change) = most_missed(tower, ends[0], ends[1])?;
        Some((ends, quantity, change))
    });
    let (ends, quantity, change) = worst.max_by(|a, b| a.2.total_cmp(&b.2))?;
    Some(Warning::RowsMissed {
        quantity,
        base_m: ends[0],
        top_m: ends[1],
        change,
    })
}

/// The quantity that differs most from its value at the middle of an element at the ends of pieces
/// within it, and the difference relative to the larger value; none if no piece ends there, or the
/// difference is negligible.
fn most_missed(tower: &Tower, base_m: f64, top_m: f64) -> Option<(&'static str, f64)> {
    let middle_m = 0.5 * (base_m + top_m);
    let taken = tower.piece_at(middle_m).section_at(middle_m).quantities();
    let pieces = tower.pieces();
    let first = pieces.partition_point(|piece| piece.top_m <= base_m);
    let within = pieces[first..]
        .iter()
        .take_while(|piece| piece.base_m < top_m);
    // More than one piece.
    within.clone().nth(1)?;
    let ends = within.flat_map(|piece| {
        let ends_m = [piece.base_m.max(base_m), piece.top_m.min(top_m)];
        ends_m.map(|height_m| piece.section_at(height_m))
    });
    let changes = ends.flat_map(|section| {
        let pairs = section.quantities().into_iter().zip(taken);
        pairs.map(|((name, there), (_, taken))| (name, difference(there, taken)))
    });
    let most = changes.max_by(|a, b| a.1.total_cmp(&b.1))?;
    (most.1 > SLIGHT).then_some(most)
}

/// The difference of two values relative to the larger; 0 if both are zero.
fn difference(a: f64, b: f64) -> f64 {
    let larger = a.abs().max(b.abs());
    if a == b { 0.0 } else { (a - b).abs() / larger }
}

/// Warns that the frequencies of some modes, at `places` in the list, do not converge with the
/// order of the method.
pub(crate) fn irregular(modes: &[Mode], places: &[usize]) -> Option<Warning> {
    let relative = |mode: &Mode| mode.error_hz() / mode.frequency_hz;
    let listed = places.iter().map(|&place| &modes[place]);
    let moving = listed.filter(|mode| mode.frequency_hz > 0.0);
    // For larger errors there is another warning.
    let band = IRREGULAR..=RESOLVED;
    let affected: Vec<&Mode> = moving
        .filter(|mode| band.contains(&relative(mode)))
        .collect();
    Some(Warning::Irregular {
        number: affected.first()?.number,
        others: affected.len() - 1,
        worst: affected
            .iter()
            .map(|mode| relative(mode))
            .fold(0.0, f64::max),
    })
}

fn unresolved(modes: &[Mode]) -> Option<Warning> {
    let relative = |m: &Mode| m.error_hz() / m.frequency_hz;
    let unresolved: Vec<&Mode> = modes.iter().filter(|mode| !mode.is_resolved()).collect();
    Some(Warning::Unresolved {
        number: unresolved.first()?.number,
        others: unresolved.len() - 1,
        worst: unresolved.iter().map(|m| relative(m)).fold(0.0, f64::max),
    })
}
