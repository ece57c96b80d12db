//! The boundaries of the elements of a blade.

use crate::blade::{Blade, BladeSection};

/// Largest ratio of a stiffness, or of the mass, at the ends of an element. The curvature is the
/// moment divided by the stiffness; if the stiffness decreases to a quarter, the error of a
/// polynomial of degree p for it decreases as 3⁻ᵖ.
const STEEPEST: f64 = 4.0;
/// Parts shorter than this fraction of the span are not divided: they contribute little to bending.
const SHORT: f64 = 0.02;

/// The boundaries of the elements of a blade and the positions of its sections, as fractions of the
/// span, with additional boundaries so that neither a stiffness nor the mass changes by more than a
/// factor of 4 over a long element.
pub(crate) fn borders(blade: &Blade) -> Vec<f64> {
    let description = blade.description();
    let sections = description.sections.iter().map(|section| section.span);
    let mut all: Vec<f64> = sections
        .chain(description.borders.iter().copied())
        .collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    let more: Vec<f64> = all
        .windows(2)
        .filter(|ends| ends[1] - ends[0] > SHORT)
        .flat_map(|ends| between(blade, ends[0], ends[1]))
        .collect();
    all.extend(more);
    all.sort_by(f64::total_cmp);
    all
}

/// Positions between two neighbouring boundaries, at which the property with the largest change
/// decreases by equal factors.
fn between(blade: &Blade, from: f64, to: f64) -> impl Iterator<Item = f64> {
    let at = |fraction: f64| blade.section_at(from + fraction * (to - from));
    // Properties are linear between the two: there is no step inside.
    let (near, far) = (at(0.25), at(0.75));
    let ratio = |property: fn(&BladeSection) -> f64| {
        let (near, far) = (property(&near), property(&far));
        (1.5 * far - 0.5 * near) / (1.5 * near - 0.5 * far)
    };
    let ratios = [
        ratio(|section| section.flap_n_m2),
        ratio(|section| section.edge_n_m2),
        ratio(|section| section.torsion_n_m2),
        ratio(|section| section.axial_n),
        ratio(|section| section.mass_kg_per_m),
    ];
    // An infinite stiffness does not change.
    let changes = ratios
        .into_iter()
        .filter(|ratio| *ratio > 0.0 && ratio.is_finite());
    let steepest = changes.fold(1.0, |most: f64, ratio| {
        match ratio.ln().abs() > most.ln().abs() {
            true => ratio,
            false => most,
        }
    });
    let count = (steepest.ln().abs() / STEEPEST.ln() - 1e-9).ceil().max(1.0) as usize;
    (1..count).map(move |k| {
        let fallen = steepest.powf(k as f64 / count as f64);
        from + (to - from) * (fallen - 1.0) / (steepest - 1.0)
    })
}
